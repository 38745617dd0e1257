#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy_elements/contacts/shapes/contour.hpp>
#include <limits>
#include <numbers>

namespace dynamy {
namespace {

/// Most steps of Newton's method to a foot; from the nearest of the nodes four are enough.
constexpr int kContourSteps = 20;
/// Step, as a part of the distance of two nodes, below which the foot is found.
constexpr double kContourFound = 1e-13;

/// 120 times the six pieces of the B-spline of degree 5 that are nonzero between two nodes, as
/// polynomials of the fraction b of the interval.
constexpr double kPieces[6][6] = {{1, -5, 10, -10, 5, -1},  {26, -50, 20, 20, -20, 5},
                                  {66, 0, -60, 0, 30, -10}, {26, 50, 20, -20, -20, 10},
                                  {1, 5, 10, 10, 5, -5},    {0, 0, 0, 0, 0, 1}};

/// Coefficients c with c_{i−2} + 26 c_{i−1} + 66 c_i + 26 c_{i+1} + c_{i+2} = 120 r_i,
/// periodic. There are two recursions in each direction, one for each root |z| < 1 of
/// 1 + 26 z + 66 z² + 26 z³ + z⁴ (Unser, Aldroubi, Eden 1993). They begin so early
/// that their start values have no effect.
std::vector<double> coefficients(const std::vector<double>& r) {
  std::vector<double> c = r;
  const auto n = static_cast<std::ptrdiff_t>(r.size());
  for (const double side : {-1.0, 1.0}) {
    // z + 1/z = −13 ± sqrt(105)
    const double half = 0.5 * (-13.0 + side * std::sqrt(105.0));
    const double z = half + std::sqrt(half * half - 1.0);
    const auto early = static_cast<std::ptrdiff_t>(std::ceil(-40.0 / std::log(-z)));
    const auto at = [&](std::ptrdiff_t i) -> double& {
      return c[static_cast<std::size_t>(((i % n) + n) % n)];
    };
    double last = 0.0;
    for (std::ptrdiff_t i = -early; i < 0; ++i) last = at(i) + z * last;
    for (std::ptrdiff_t i = 0; i < n; ++i) at(i) = last = at(i) + z * last;
    last = 0.0;
    for (std::ptrdiff_t i = n + early; i > n; --i) last = z * (last - at(i - 1));
    for (std::ptrdiff_t i = n; i > 0; --i) at(i - 1) = last = z * (last - at(i - 1));
    const double gain = (1.0 - z) * (1.0 - 1.0 / z);
    for (double& value : c) value *= gain;
  }
  return c;
}

}  // namespace

Contour::Contour(std::vector<double> radii) : r_(std::move(radii)), c_(coefficients(r_)) {
  const std::size_t n = r_.size();
  step_ = kTwoPi / static_cast<double>(n);
  least_ = *std::min_element(r_.begin(), r_.end());
  most_ = *std::max_element(r_.begin(), r_.end());
  for (std::size_t i = 0; i < n; ++i) {
    const double phi = step_ * static_cast<double>(i);
    nodes_.push_back(r_[i] * Vec2(std::cos(phi), std::sin(phi)));
  }
  for (std::size_t i = 0; i < 2 * n; ++i)
    convex_ = convex_ && at(0.5 * step_ * static_cast<double>(i)).curvature > 0.0;
}

Vec3 Contour::radius(double phi) const {
  const std::size_t n = r_.size();
  double u = phi / step_;
  u -= static_cast<double>(n) * std::floor(u / static_cast<double>(n));
  const std::size_t i = std::min(static_cast<std::size_t>(u), n - 1);
  const double b = u - static_cast<double>(i);
  double value = 0.0, first = 0.0, second = 0.0;
  for (std::size_t k = 0; k < 6; ++k) {
    const double c = c_[(i + n + k - 2) % n] / 120.0;
    double p = 0.0, dp = 0.0, ddp = 0.0;  // Horner's rule, with ddp half of the second derivative
    for (std::size_t m = 6; m-- > 0;)
      ddp = ddp * b + dp, dp = dp * b + p, p = p * b + kPieces[k][m];
    value += c * p, first += c * dp, second += 2.0 * c * ddp;
  }
  return {value, first / step_, second / (step_ * step_)};
}

Contour::Point Contour::at(double phi) const {
  const Vec3 r = radius(phi);
  const Vec2 e(std::cos(phi), std::sin(phi)), across(-e.y(), e.x());
  const Vec2 along = r[1] * e + r[0] * across;
  const double speed2 = along.squaredNorm();
  Point p;
  p.x = r[0] * e, p.t = along / std::sqrt(speed2), p.n = {p.t.y(), -p.t.x()};
  p.curvature = (r[0] * r[0] + 2.0 * r[1] * r[1] - r[0] * r[2]) / (speed2 * std::sqrt(speed2));
  return p;
}

namespace {

/// Newton's method for f(φ) = 0 between nodes; `value` gives f and f′,
/// and steps stay within `step`.
template <class Value>
double root(double phi, double step, Value&& value) {
  double low = phi - step, high = phi + step;
  for (int i = 0; i < kContourSteps; ++i) {
    const auto [f, df] = value(phi);
    if (std::abs(f) <= kContourFound * step * std::abs(df)) break;
    // f rises through its root: it is a minimum.
    (f > 0.0 ? high : low) = phi;
    const double next = phi - f / df;
    phi = df > 0.0 && next > low && next < high ? next : 0.5 * (low + high);
  }
  return phi;
}

}  // namespace

Contour::Point Contour::nearest(const Vec2& c) const {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < r_.size(); ++i)
    if (const double d = (c - nodes_[i]).squaredNorm(); d < least) least = d, best = i;
  const double phi = root(step_ * static_cast<double>(best), step_, [&](double at) {
    const Vec3 r = radius(at);
    const Vec2 e(std::cos(at), std::sin(at)), across(-e.y(), e.x());
    const Vec2 x1 = r[1] * e + r[0] * across, x2 = (r[2] - r[0]) * e + 2.0 * r[1] * across,
               d = r[0] * e - c;
    return std::pair(d.dot(x1), x1.squaredNorm() + d.dot(x2));
  });
  return at(phi);
}

Contour::Point Contour::furthest(const Vec2& d) const {
  std::size_t best = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < r_.size(); ++i)
    if (const double s = d.dot(nodes_[i]); s > most) most = s, best = i;
  const double phi = root(step_ * static_cast<double>(best), step_, [&](double at) {
    const Vec3 r = radius(at);
    const Vec2 e(std::cos(at), std::sin(at)), across(-e.y(), e.x());
    const Vec2 x1 = r[1] * e + r[0] * across, x2 = (r[2] - r[0]) * e + 2.0 * r[1] * across;
    return std::pair(-d.dot(x1), -d.dot(x2));
  });
  return at(phi);
}

ContactPoint ballOnContour(const Frame& A, const SupportFeature& contour, const Frame& B,
                           const RoundFeature& ball, const Vec3& plane) {
  const Mat3 R = A.A_IK * contour.square_K;
  const Vec3 o = A.r_OS_I + A.A_IK * contour.c_K;
  const Vec3 rho = B.A_IK * ball.c_K, c = B.r_OS_I + rho, v = B.velocity(rho);
  const Vec3 inPlane = R.transpose() * (c - o);
  const Contour::Point at = contour.contour->nearest(inPlane.head<2>());
  const auto lift = [&](const Contour::Vec2& a) { return Vec3(R.leftCols<2>() * a); };
  const Vec3 n = lift(at.n), t = lift(at.t), p = o + lift(at.x);
  const double D = n.dot(c - p);
  const Vec3 vp = A.velocity(p - A.r_OS_I);
  // w·t relative to A's axes at c: d ⟂ t for all times gives ṡ.
  const Vec3 w = v - A.velocity(c - A.r_OS_I);
  const double sdot = w.dot(t) / (1.0 + at.curvature * D);
  const Vec3 ndot = A.Omega_I.cross(n) + at.curvature * sdot * t;
  ContactPoint out;
  out.g = D - ball.radius;
  setDirections(out, n, ndot, plane);
  out.P = p, out.Pdot = vp + sdot * t;
  return out;
}

}  // namespace dynamy
