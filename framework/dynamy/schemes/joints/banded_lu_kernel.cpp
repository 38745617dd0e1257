#include <algorithm>
#include <cmath>
#include <cstddef>
#include <dynamy/schemes/joints/banded_lu.hpp>
#include <utility>

namespace dynamy {

void BandedLu::reset(int n, int b, std::span<const int> ends) {
  n_ = n, b_ = b, width_ = 3 * b + 1;
  const auto rows = static_cast<std::size_t>(n);
  a_.assign(rows * static_cast<std::size_t>(width_), 0.0);
  l_.resize(rows * static_cast<std::size_t>(b));
  pivot_.resize(rows), last_.resize(rows), below_.resize(rows), end_.resize(rows);
  int first = 0;
  for (const int end : ends) std::fill(end_.begin() + first, end_.begin() + end, end), first = end;
}

bool BandedLu::factor() {
  for (int i = 0; i < n_; ++i) {
    int j = std::min(end_[static_cast<std::size_t>(i)] - 1, i + b_);
    while (j > i && at(i, j) == 0.0) --j;
    last_[static_cast<std::size_t>(i)] = j;
  }
  for (int k = 0; k < n_; ++k) {
    const auto column = static_cast<std::size_t>(k);
    const int last = std::min(end_[column] - 1, k + b_);
    int p = k;
    for (int i = k + 1; i <= last; ++i)
      if (std::abs(at(i, k)) > std::abs(at(p, k))) p = i;
    pivot_[column] = p;
    if (!(std::abs(at(p, k)) > 0.0)) return false;
    if (p != k) {
      int &lastP = last_[static_cast<std::size_t>(p)], &lastK = last_[column];
      for (int j = k; j <= std::max(lastP, lastK); ++j) std::swap(at(p, j), at(k, j));
      std::swap(lastP, lastK);
    }
    const int end = std::max(k, last_[column]);
    const double inverse = 1.0 / at(k, k);
    const double* pivotRow = &at(k, k);
    double* l = l_.data() + column * static_cast<std::size_t>(b_);
    below_[column] = 0;
    for (int i = k + 1; i <= last; ++i) {
      double* row = &at(i, k);
      const double factor = l[i - k - 1] = row[0] * inverse;
      if (factor == 0.0) continue;
      below_[column] = i - k;
      int& lastI = last_[static_cast<std::size_t>(i)];
      lastI = std::max(lastI, end);
      for (int j = 1; j <= end - k; ++j) row[j] -= factor * pivotRow[j];
    }
    multiplications_ += static_cast<double>(below_[column]) * (end - k);
  }
  return true;
}

void BandedLu::solve(double* X, int first, int last, int columns) const {
  switch (columns) {
    case 1:
      return solveColumns<1>(X, first, last, columns);
    case 3:
      return solveColumns<3>(X, first, last, columns);
    default:
      return solveColumns<0>(X, first, last, columns);
  }
}

/// N = 0: any number of columns.
template <int N>
void BandedLu::solveColumns(double* X, int first, int last, int columns) const {
  const int n = N > 0 ? N : columns;
  long entries = 0;
  for (int k = first; k < last; ++k) {
    const auto column = static_cast<std::size_t>(k);
    double* const xk = X + column * static_cast<std::size_t>(n);
    if (pivot_[column] != k)
      std::swap_ranges(xk, xk + n, X + static_cast<std::ptrdiff_t>(pivot_[column]) * n);
    const double* l = l_.data() + column * static_cast<std::size_t>(b_);
    double* xi = xk + n;
    entries += below_[column];
    for (int i = 0; i < below_[column]; ++i, xi += n)
      for (int c = 0; c < n; ++c) xi[c] -= l[i] * xk[c];
  }
  for (int k = last - 1; k >= first; --k) {
    const double* u = a_.data() + static_cast<std::size_t>(k) * static_cast<std::size_t>(width_) +
                      static_cast<std::size_t>(b_);
    double* const xk = X + static_cast<std::ptrdiff_t>(k) * n;
    const int right = last_[static_cast<std::size_t>(k)] - k;
    entries += right;
    const double* xj = xk + n;
    for (int j = 1; j <= right; ++j, xj += n)
      for (int c = 0; c < n; ++c) xk[c] -= u[j] * xj[c];
    for (int c = 0; c < n; ++c) xk[c] /= u[0];
  }
  multiplications_ += static_cast<double>(entries * n);
}

}  // namespace dynamy
