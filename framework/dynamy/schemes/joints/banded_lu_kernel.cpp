#include <algorithm>
#include <cmath>
#include <cstddef>
#include <dynamy/schemes/joints/banded_lu.hpp>

namespace dynamy {

void BandedLu::reset(int n, int b) {
  n_ = n, b_ = b, width_ = 3 * b + 1;
  a_.assign(static_cast<std::size_t>(n) * static_cast<std::size_t>(width_), 0.0);
  pivot_.resize(static_cast<std::size_t>(n));
}

bool BandedLu::factor() {
  last_.resize(static_cast<std::size_t>(n_));
  for (int i = 0; i < n_; ++i) {
    int j = std::min(n_ - 1, i + b_);
    while (j > i && at(i, j) == 0.0) --j;
    last_[static_cast<std::size_t>(i)] = j;
  }
  for (int k = 0; k < n_; ++k) {
    const int last = std::min(n_ - 1, k + b_);
    int p = k;
    for (int i = k + 1; i <= last; ++i)
      if (std::abs(at(i, k)) > std::abs(at(p, k))) p = i;
    pivot_[static_cast<std::size_t>(k)] = p;
    if (!(std::abs(at(p, k)) > 0.0)) return false;
    if (p != k) {
      int &lastP = last_[static_cast<std::size_t>(p)], &lastK = last_[static_cast<std::size_t>(k)];
      for (int j = k; j <= std::max(lastP, lastK); ++j) std::swap(at(p, j), at(k, j));
      std::swap(lastP, lastK);
    }
    const int end = std::max(k, last_[static_cast<std::size_t>(k)]);
    const double inverse = 1.0 / at(k, k);
    const double* pivotRow = &at(k, k);
    for (int i = k + 1; i <= last; ++i) {
      double* row = &at(i, k);
      const double l = row[0] * inverse;
      row[0] = l;
      if (l == 0.0) continue;
      int& lastI = last_[static_cast<std::size_t>(i)];
      lastI = std::max(lastI, end);
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
    for (int j = k + 1; j <= last_[static_cast<std::size_t>(k)]; ++j) sum -= value(k, j) * x[j];
    x[k] = sum / value(k, k);
  }
}

}  // namespace dynamy
