/// Hash: FNV-1a, 64 bit, over the bits of numbers: two runs with the same hash recorded the same
/// bits.
///
///   h ← (h xor byte) · 1099511628211,   h₀ = 14695981039346656037
#pragma once
#include <bit>
#include <cstdint>
#include <dynamy/core/archive.hpp>
#include <span>

namespace dynamy {

class Hash {
 public:
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(std::span<const double> values) {
    for (const double x : values) add(x);
  }
  void add(std::uint64_t bits) {
    for (int i = 0; i < 8; ++i) {
      value_ ^= (bits >> (8 * i)) & 0xffu;
      value_ *= 1099511628211u;
    }
  }
  std::uint64_t value() const { return value_; }
  void archive(Archive& a) { a(value_); }

 private:
  std::uint64_t value_ = 14695981039346656037u;
};

}  // namespace dynamy
