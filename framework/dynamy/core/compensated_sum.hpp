/// CompensatedSum: Neumaier's summation, error ≤ 2 ε |sum| + O(n ε²) Σ|x| instead of n ε Σ|x|: a
/// ledger over 10⁷ steps balances to rounding.
#pragma once
#include <cmath>
#include <dynamy/core/archive.hpp>

namespace dynamy {

class CompensatedSum {
 public:
  void add(double x) {
    const double sum = sum_ + x;
    carry_ += std::abs(sum_) >= std::abs(x) ? (sum_ - sum) + x : (x - sum) + sum_;
    sum_ = sum;
  }
  double value() const { return sum_ + carry_; }
  void archive(Archive& a) { a(sum_), a(carry_); }

 private:
  double sum_ = 0.0, carry_ = 0.0;
};

}  // namespace dynamy
