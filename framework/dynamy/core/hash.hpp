/// Hash: 64 bits over the bits of a sequence of numbers. Two sequences with the same hash agree bit
/// for bit, except for a coincidence of one in 2⁶⁴.
///
///   h ← (h xor x) · p,   h ← h xor ⌊h / 2³²⌋,   p = 0x9e3779b97f4a7c15, odd
///
/// for each word x of 64 bits. Both lines are one to one in h and in x: sequences that differ in
/// one word only always have different hashes. Long sequences are distributed over four such
/// hashes, word i to hash i mod 4, whose products do not wait for each other. The four hashes are
/// then added as four words. Rejected: FNV-1a, whose eight products per word take noticeable time
/// in steps of many bodies; cryptographic hashes, because there is no attacker here.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <dynamy/core/archive.hpp>
#include <span>
#include <string_view>

namespace dynamy {

class Hash {
 public:
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(std::span<const double> values) {
    std::size_t i = 0;
    if (values.size() >= 32) {
      std::array<std::uint64_t, 4> lane{value_ ^ 1u, value_ ^ 2u, value_ ^ 3u, value_ ^ 4u};
      for (; i + 4 <= values.size(); i += 4)
        for (std::size_t k = 0; k < 4; ++k)
          lane[k] = mixed(lane[k], std::bit_cast<std::uint64_t>(values[i + k]));
      for (const std::uint64_t h : lane) add(h);
    }
    for (; i < values.size(); ++i) add(values[i]);
  }
  void add(std::uint64_t bits) { value_ = mixed(value_, bits); }
  /// Adds the number of bytes, then the bytes in words of eight; zeros fill up the last word.
  void addBytes(std::string_view bytes) {
    add(std::uint64_t{bytes.size()});
    for (std::size_t at = 0; at < bytes.size(); at += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes.data() + at, std::min<std::size_t>(8, bytes.size() - at));
      add(word);
    }
  }
  std::uint64_t value() const { return value_; }
  void archive(Archive& a) { a(value_); }

 private:
  static std::uint64_t mixed(std::uint64_t h, std::uint64_t bits) {
    h = (h ^ bits) * 0x9e3779b97f4a7c15u;
    return h ^ h >> 32u;
  }
  std::uint64_t value_ = 14695981039346656037u;
};

}  // namespace dynamy
