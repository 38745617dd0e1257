#include <algorithm>
#include <cmath>
#include <dynamy_elements/contacts/contour.hpp>
#include <limits>
#include <numbers>

namespace dynamy {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
/// Newton's steps to a foot; from the nearest of the nodes four are enough.
constexpr int kSteps = 20;
/// Of the way between two nodes: a step below which the foot is found.
constexpr double kFound = 1e-13;

}  // namespace

Contour::Contour(std::vector<double> radii) : r_(std::move(radii)) {
  const std::size_t n = r_.size();
  step_ = kTurn / static_cast<double>(n);
  least_ = *std::min_element(r_.begin(), r_.end());
  most_ = *std::max_element(r_.begin(), r_.end());
  // r″ at the nodes: M_{i−1} + 4 M_i + M_{i+1} = 6 (r_{i−1} − 2 r_i + r_{i+1})/h². The sweeps of
  // Gauss and Seidel halve their error at least, each.
  second_.assign(n, 0.0);
  for (int sweep = 0; sweep < 60; ++sweep)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
      const double rhs = 6.0 * (r_[before] - 2.0 * r_[i] + r_[after]) / (step_ * step_);
      second_[i] = 0.25 * (rhs - second_[before] - second_[after]);
    }
  for (std::size_t i = 0; i < 2 * n; ++i)
    convex_ = convex_ && at(0.5 * step_ * static_cast<double>(i)).curvature > 0.0;
}

Vec3 Contour::radius(double phi) const {
  const auto n = static_cast<double>(r_.size());
  double u = phi / step_;
  u -= n * std::floor(u / n);
  const auto i = std::min(static_cast<std::size_t>(u), r_.size() - 1), j = (i + 1) % r_.size();
  const double b = u - static_cast<double>(i), a = 1.0 - b, h = step_;
  const double M = second_[i], N = second_[j];
  return {a * r_[i] + b * r_[j] + h * h / 6.0 * ((a * a * a - a) * M + (b * b * b - b) * N),
          (r_[j] - r_[i]) / h + h / 6.0 * ((3.0 * b * b - 1.0) * N - (3.0 * a * a - 1.0) * M),
          a * M + b * N};
}

Contour::Vec2 Contour::node(std::size_t i) const {
  const double phi = step_ * static_cast<double>(i);
  return r_[i] * Vec2(std::cos(phi), std::sin(phi));
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

/// Newton for f(φ) = 0 between nodes; `value` gives f and f′, and steps stay within `step`.
template <class Value>
double root(double phi, double step, Value&& value) {
  double low = phi - step, high = phi + step;
  for (int i = 0; i < kSteps; ++i) {
    const auto [f, df] = value(phi);
    if (std::abs(f) <= kFound * step * std::abs(df)) break;
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
    if (const double d = (c - node(i)).squaredNorm(); d < least) least = d, best = i;
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
    if (const double s = d.dot(node(i)); s > most) most = s, best = i;
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
