/// Dense elimination in place for systems of a few up to some hundred unknowns, without allocating
/// memory. Eigen's LU was rejected: it allocates for sizes unknown at compile time, and for a
/// handful of unknowns its bookkeeping takes longer than the arithmetic.
#pragma once
#include <cmath>
#include <utility>

namespace dynamy {

/// S X = Y in place by elimination with row pivoting, S n × n, Y n × m, row after row; false: a
/// pivot is not larger than `least`.
inline bool eliminate(double* S, double* Y, int n, int m, double least = 0.0) {
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    for (int i = k + 1; i < n; ++i)
      if (std::abs(S[i * n + k]) > std::abs(S[pivot * n + k])) pivot = i;
    if (!(std::abs(S[pivot * n + k]) > least)) return false;
    if (pivot != k) {
      for (int j = k; j < n; ++j) std::swap(S[k * n + j], S[pivot * n + j]);
      for (int j = 0; j < m; ++j) std::swap(Y[k * m + j], Y[pivot * m + j]);
    }
    const double inverse = 1.0 / S[k * n + k];
    for (int i = k + 1; i < n; ++i) {
      const double factor = S[i * n + k] * inverse;
      if (factor == 0.0) continue;
      for (int j = k + 1; j < n; ++j) S[i * n + j] -= factor * S[k * n + j];
      for (int j = 0; j < m; ++j) Y[i * m + j] -= factor * Y[k * m + j];
    }
  }
  for (int k = n - 1; k >= 0; --k)
    for (int j = 0; j < m; ++j) {
      double sum = Y[k * m + j];
      for (int i = k + 1; i < n; ++i) sum -= S[k * n + i] * Y[i * m + j];
      Y[k * m + j] = sum / S[k * n + k];
    }
  return true;
}

}  // namespace dynamy
