/// KeyIndex: finds the place of a contact's key in a list in constant time.
///
/// Open addressing in a table with at least twice as many places as keys; no allocation once the
/// table is large enough. Rejected: a search through the list for each contact. A heap of bodies
/// opens and closes contacts in every step, so that this search was O(n²), most of the time of a
/// step from 2000 contacts on.
#pragma once
#include <bit>
#include <dynamy/core/types.hpp>
#include <span>
#include <vector>

namespace dynamy {

class KeyIndex {
 public:
  /// \pre every key stands once in the list; of two equal keys the first is found
  void build(std::span<const ContactKey> keys) {
    keys_.assign(keys.begin(), keys.end());
    place_.assign(std::bit_ceil(2 * keys.size() + 2), -1);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      std::size_t at = start(keys[i]);
      while (place_[at] >= 0) at = next(at);
      place_[at] = static_cast<int>(i);
    }
  }
  /// Place of `key` in the list, or −1.
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
