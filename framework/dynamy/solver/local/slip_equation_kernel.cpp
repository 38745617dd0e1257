#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/solver/local/slip_equation.hpp>
#include <limits>

namespace dynamy {
namespace {

constexpr int kMostSlipSteps = 100;
/// A Newton step below this part of a leaves an error of its square.
constexpr double kLastStep = 1e-9;
/// |F| above which an interval without change of sign holds no root.
constexpr double kRoot = 1e-8;

/// Control points of a quartic on [low, high].
struct Bernstein {
  double b[5];
  double low, high;

  int signChanges() const {
    int changes = 0;
    double last = 0.0;
    for (const double x : b) {
      if (x == 0.0) continue;
      if (last != 0.0 && (x > 0.0) != (last > 0.0)) ++changes;
      last = x;
    }
    return changes;
  }
  /// Halves by de Casteljau's scheme; this becomes the left half.
  Bernstein split() {
    Bernstein right{{b[0], b[1], b[2], b[3], b[4]}, 0.5 * (low + high), high};
    high = right.low;
    for (int level = 0; level < 4; ++level) {
      b[level] = right.b[0];
      for (int k = 0; k < 4 - level; ++k) right.b[k] = 0.5 * (right.b[k] + right.b[k + 1]);
    }
    b[4] = right.b[0];
    return right;
  }
};

}  // namespace

double SlipEquation::F(double a, double sign, double& slope) const {
  const double x = p0[0] + p1[0] * a, y = p0[1] + p1[1] * a;
  const double q = sign * (q0 + (q1 + q2 * a) * a), dq = sign * (q1 + 2.0 * q2 * a);
  const double square = x * x + y * y, factor = s / std::sqrt(square);
  slope = factor * (dq - q * (x * p1[0] + y * p1[1]) / square);
  return factor * q - 1.0;
}

double SlipEquation::onlyRoot() const {
  double low = 0.0, high = kInfinity, a = 0.0;
  for (int step = 0; step < kMostSlipSteps; ++step) {
    double slope;
    const double value = F(a, 1.0, slope);
    (value < 0.0 ? low : high) = a;
    double next = a - value / slope;
    if (!(next > low && next < high)) {
      if (std::abs(next - a) <= kLastStep * a) return a;
      next = high < kInfinity ? 0.5 * (low + high) : 4.0 * a + d1;
    }
    const double change = std::abs(next - a);
    a = next;
    if (!(change > kLastStep * a)) break;
  }
  return a;
}

double SlipEquation::refine(double low, double high, double a) const {
  // The root lies on the branch of q at the end where s|q| > |p|.
  double slope;
  const double atLow = 1.0 + F(low, 1.0, slope), atHigh = 1.0 + F(high, 1.0, slope);
  const bool rising = !(std::abs(atLow) > std::abs(atHigh));
  const double sign = (rising ? atHigh : atLow) < 0.0 ? -1.0 : 1.0;
  for (int step = 0; step < kMostSlipSteps; ++step) {
    const double value = F(a, sign, slope);
    ((value < 0.0) == rising ? low : high) = a;
    double next = a - value / slope;
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double change = std::abs(next - a);
    a = next;
    if (!(change > kLastStep * a)) break;
  }
  return std::abs(F(a, sign, slope)) <= kRoot ? a : -1.0;
}

int SlipEquation::roots(double* a) const {
  // |p|² − s² q² = Σ c_k a^k.
  const double s2 = s * s;
  const double c[5] = {p0[0] * p0[0] + p0[1] * p0[1] - s2 * q0 * q0,
                       2.0 * (p0[0] * p1[0] + p0[1] * p1[1] - s2 * q0 * q1),
                       p1[0] * p1[0] + p1[1] * p1[1] - s2 * (q1 * q1 + 2.0 * q0 * q2),
                       -2.0 * s2 * q1 * q2, -s2 * q2 * q2};
  // a = w t/(1 − t) maps t ∈ (0, 1) to (0, ∞); the control points are w^k c_k over the binomials. w
  // is the largest scale of roots, from D̂ or from b̂ over the pressing force; smaller roots are
  // resolved by halving.
  double w = std::abs(d1) + std::sqrt(std::abs(d0));
  const double far = std::hypot(p1[0], p1[1]) / std::abs(s * q2);
  if (std::isfinite(far)) w += far;
  constexpr int kBinomial[5] = {1, 4, 6, 4, 1};
  constexpr int kDepth = 124, kMostParts = 1000;
  Bernstein stack[kDepth + 4];
  stack[0] = {{}, 0.0, 1.0};
  double power = 1.0;
  for (int k = 0; k < 5; ++k, power *= w) stack[0].b[k] = c[k] * power / kBinomial[k];
  int waiting = 1, found = 0;
  for (int part = 0; waiting > 0 && part < kMostParts && found < kMaxRoots; ++part) {
    Bernstein x = stack[--waiting];
    const int changes = x.signChanges();
    if (changes == 0) continue;
    if (changes > 1 && waiting < kDepth && x.high - x.low > 1e-13 * x.high) {
      const Bernstein right = x.split();
      stack[waiting++] = right, stack[waiting++] = x;  // the left part first: roots ascend
      continue;
    }
    const auto at = [&](double t) { return w * t / (1.0 - t); };
    const double high = x.high < 1.0 ? at(x.high) : 1e16 * w;
    const double root = refine(at(x.low), high, at(0.5 * (x.low + x.high)));
    const double size = (q0 + (q1 + q2 * root) * root) * d(root);
    if (size >= 0.0 && root > 0.0) a[found++] = root;
  }
  return found;
}

}  // namespace dynamy
