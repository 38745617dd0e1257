/// Short scalar products of rows of W with velocities.
#pragma once
#include <dynamy/core/types.hpp>

namespace dynamy {

/// Six velocities: unrolled and vectorised, where most of the work of a stack is.
using SixVelocities = Eigen::Map<const Eigen::Matrix<double, 6, 1>>;

/// Σ a_j b_j over n numbers.
inline double dotProduct(const double* a, const double* b, int n) {
  if (n == 6) return SixVelocities(a).dot(SixVelocities(b));
  double s = 0.0;
  for (int j = 0; j < n; ++j) s += a[j] * b[j];
  return s;
}

}  // namespace dynamy
