/// TimeGrid: the instants i·Δ, computed from a counter instead of a sum, so that rounding errors do
/// not accumulate.
///
/// If 1/Δ is a whole number n, the instant is i/n: the double nearest to the decimal number a
/// reader expects (300 steps of 1e-3 end at 0.3, not at 0.30000000000000004).
#pragma once
#include <cmath>

namespace dynamy {

class TimeGrid {
 public:
  explicit TimeGrid(double spacing = 1.0) : spacing_(spacing), perUnit_(std::round(1.0 / spacing)) {
    if (!(perUnit_ >= 1.0) || std::abs(1.0 / spacing - perUnit_) > 1e-12 * perUnit_) perUnit_ = 0.0;
  }
  double spacing() const { return spacing_; }
  double at(long i) const {
    const auto n = static_cast<double>(i);
    return perUnit_ > 0.0 ? n / perUnit_ : n * spacing_;
  }

 private:
  double spacing_, perUnit_;
};

}  // namespace dynamy
