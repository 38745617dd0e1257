#include <algorithm>
#include <cmath>
#include <cstddef>
#include <dynamy/integrator/banded_lu.hpp>

namespace dynamy {

void BandedLu::reset(int n, int b) {
  n_ = n, b_ = b, width_ = 3 * b + 1;
  a_.assign(static_cast<std::size_t>(n) * static_cast<std::size_t>(width_), 0.0);
  pivot_.resize(static_cast<std::size_t>(n));
}

bool BandedLu::factor() {
  for (int k = 0; k < n_; ++k) {
    const int last = std::min(n_ - 1, k + b_), end = std::min(n_ - 1, k + 2 * b_);
    int p = k;
    for (int i = k + 1; i <= last; ++i)
      if (std::abs(at(i, k)) > std::abs(at(p, k))) p = i;
    pivot_[static_cast<std::size_t>(k)] = p;
    if (!(std::abs(at(p, k)) > 0.0)) return false;
    if (p != k)
      for (int j = k; j <= end; ++j) std::swap(at(p, j), at(k, j));
    const double inverse = 1.0 / at(k, k);
    const double* pivotRow = &at(k, k);
    for (int i = k + 1; i <= last; ++i) {
      double* row = &at(i, k);
      const double l = row[0] * inverse;
      row[0] = l;
      if (l == 0.0) continue;
      for (int j = 1; j <= end - k; ++j) row[j] -= l * pivotRow[j];
    }
  }
  return true;
}

void BandedLu::solve(double* x) const {
  const auto value = [this](int i, int j) {
    return a_[static_cast<std::size_t>(i) * static_cast<std::size_t>(width_) +
              static_cast<std::size_t>(j - i + b_)];
  };
  for (int k = 0; k < n_; ++k) {
    std::swap(x[k], x[pivot_[static_cast<std::size_t>(k)]]);
    for (int i = k + 1; i <= std::min(n_ - 1, k + b_); ++i) x[i] -= value(i, k) * x[k];
  }
  for (int k = n_ - 1; k >= 0; --k) {
    double sum = x[k];
    for (int j = k + 1; j <= std::min(n_ - 1, k + 2 * b_); ++j) sum -= value(k, j) * x[j];
    x[k] = sum / value(k, k);
  }
}

}  // namespace dynamy
