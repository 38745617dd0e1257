/// √(Σ x_i²) of numbers of any size. Squares of numbers above 1e154 overflow and squares of numbers
/// below 1e-162 vanish, so that a residual of such numbers would be worthless.
///
/// The plain sum is taken wherever it is good, so that a norm costs two comparisons more than the
/// formula. Rejected: std::hypot, several times slower and for three numbers at most.
#pragma once
#include <cmath>
#include <limits>

namespace dynamy {

/// Sums of squares between these two bounds have lost no digits that matter.
inline constexpr double kLeastSquare = 1e-280, kMostSquare = 1e300;

namespace detail {

/// Norm of numbers scaled by the largest of them; NaN and infinity are passed on.
inline double scaledNorm(const double* x, int n, double sum) {
  double largest = 0.0;
  for (int i = 0; i < n; ++i) largest = std::fmax(largest, std::abs(x[i]));
  if (std::isnan(sum) || !(largest > 0.0) || std::isinf(largest)) return largest + sum;
  sum = 0.0;
  for (int i = 0; i < n; ++i) sum += (x[i] / largest) * (x[i] / largest);
  return largest * std::sqrt(sum);
}

}  // namespace detail

/// |x| of n numbers; `sum`: the sum of their squares, computed before.
inline double safeNorm(const double* x, int n, double sum) {
  return sum > kLeastSquare && sum < kMostSquare ? std::sqrt(sum) : detail::scaledNorm(x, n, sum);
}
/// |x| of n numbers.
inline double safeNorm(const double* x, int n) {
  double sum = 0.0;
  for (int i = 0; i < n; ++i) sum += x[i] * x[i];
  return safeNorm(x, n, sum);
}

/// √(Σ x_i²) of numbers that are added one after the other.
class SafeSum {
 public:
  void add(double x) {
    const double size = std::abs(x);
    if (size > largest_) {
      const double part = largest_ / size;
      squares_ = 1.0 + squares_ * part * part;
      largest_ = size;
    } else if (size > 0.0) {
      squares_ += (size / largest_) * (size / largest_);
    } else if (std::isnan(x)) {
      largest_ = squares_ = x;
    }
  }
  bool zero() const { return largest_ == 0.0; }
  double root() const { return largest_ * std::sqrt(squares_); }
  /// root()/other.root(), also if one of the two roots would overflow. \pre !other.zero()
  double over(const SafeSum& other) const {
    return (largest_ / other.largest_) * std::sqrt(squares_ / other.squares_);
  }

 private:
  double largest_ = 0.0, squares_ = 0.0;
};

}  // namespace dynamy
