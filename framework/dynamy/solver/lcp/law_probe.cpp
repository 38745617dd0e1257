#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/lcp/law_probe.hpp>
#include <limits>

namespace dynamy {
namespace {

constexpr double kFarInterval = 1e150;  ///< a clamp is exact at any distance
constexpr double kFar = 1e12;           ///< projections of more rows square it

}  // namespace

void LawProbe::project(int first, int k, double* x) const {
  double r[kMostRows], xi[kMostRows] = {}, Lambda[kMostRows] = {};
  for (double& value : r) value = 1.0;
  if (law_.unilateral()) Lambda[0] = 1.0;
  for (int i = 0; i < k; ++i) Lambda[first + i] = x[i];
  law_.prox(in_, r, xi, Lambda);
  for (int i = 0; i < k; ++i) x[i] = Lambda[first + i];
}

void LawProbe::interval(int row, double& lower, double& upper) const {
  lower = -kFarInterval, upper = kFarInterval;
  project(row, 1, &lower);
  project(row, 1, &upper);
  if (lower <= -kFarInterval) lower = -kInfinity;
  if (upper >= kFarInterval) upper = kInfinity;
}

bool LawProbe::extreme(int first, int k, const double* direction, double* point) const {
  double far = 0.0, size = 0.0;
  for (int i = 0; i < k; ++i) point[i] = kFar * direction[i], far += point[i] * point[i];
  project(first, k, point);
  for (int i = 0; i < k; ++i) size += point[i] * point[i];
  return size < 0.25 * far;
}

double LawProbe::discRadius(int first) const {
  // Five directions without symmetry: every extreme point must lie along its direction, all at one
  // distance.
  double radius = -1.0;
  for (int j = 0; j < 5; ++j) {
    const double angle = 0.1 + 1.3 * j, d[2] = {std::cos(angle), std::sin(angle)};
    double x[2];
    if (!extreme(first, 2, d, x)) return -1.0;
    const double along = d[0] * x[0] + d[1] * x[1], across = d[0] * x[1] - d[1] * x[0];
    if (j == 0) radius = along;
    const double rounding = 1e-10 * std::abs(radius);
    if (std::abs(along - radius) > rounding || std::abs(across) > rounding) return -1.0;
  }
  return radius;
}

}  // namespace dynamy
