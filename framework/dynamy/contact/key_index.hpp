/// KeyIndex: where a contact's key stands in a list, in constant time.
///
/// Open addressing in a table of at least twice as many places as keys. Heaps lose and make
/// contacts in every step; a search through the list for each of them was O(n²), most of the time
/// of a step from 2000 contacts on. No allocation once large enough.
#pragma once
#include <bit>
#include <dynamy/core/types.hpp>
#include <span>
#include <vector>

namespace dynamy {

class KeyIndex {
 public:
  /// \pre every key stands once in the list; of two equal ones the first is found
  void build(std::span<const ContactKey> keys) {
    keys_.assign(keys.begin(), keys.end());
    place_.assign(std::bit_ceil(2 * keys.size() + 2), -1);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      std::size_t at = start(keys[i]);
      while (place_[at] >= 0) at = next(at);
      place_[at] = static_cast<int>(i);
    }
  }
  /// Its place, or −1.
  int find(ContactKey key) const {
    if (place_.empty()) return -1;
    for (std::size_t at = start(key); place_[at] >= 0; at = next(at))
      if (keys_[static_cast<std::size_t>(place_[at])] == key) return place_[at];
    return -1;
  }

 private:
  std::size_t next(std::size_t at) const { return (at + 1) & (place_.size() - 1); }
  std::size_t start(ContactKey key) const {
    const std::uint64_t h = key.value * 0x9E3779B97F4A7C15u;  // its high bits are mixed best
    return static_cast<std::size_t>(h >> 32) & (place_.size() - 1);
  }
  std::vector<ContactKey> keys_;
  std::vector<int> place_;
};

}  // namespace dynamy
