#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/core/declared/attributes.hpp>
#include <dynamy/core/error.hpp>
#include <dynamy/system/smooth_shape.hpp>
#include <limits>

namespace dynamy {
namespace {

// Directions every 15°, for the picture and the extent of a shape.
constexpr int kRings = 12, kAround = 24;
/// Largest angle from any direction to the nearest of these [rad]: half a diagonal of 15° by 15°.
constexpr double kBetween = 0.1852;
/// Circles of the first and the finest quadrature. Integrands are analytic, so that few circles are
/// enough for round bodies.
constexpr int kFirstCircles = 16, kMostCircles = 256;
constexpr double kQuadrature = 1e-13;  ///< circles are doubled until results change by less
/// Angle of the differences that H is compared with [rad], and the tolerance relative to the size.
/// The error of the differences by third derivatives and rounding is about 1e-8 of the size, but
/// the error of a wrong H is as large as H.
constexpr double kAngle = 1e-4, kOff = 1e-5;
/// Rounding of a radius of curvature that is 0, as a part of the size.
constexpr double kHollow = 1e-10;

Vec3 direction(double polar, double azimuth) {
  return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
          std::cos(polar)};
}

template <class Use>
void forDirections(Use&& use) {
  for (int i = 0; i <= kRings; ++i)
    for (int j = 0; j < (i % kRings == 0 ? 1 : kAround); ++j)
      use(direction(kPi * i / kRings, kTwoPi * j / kAround));
}

/// Nodes z and weights of Gauss–Legendre quadrature on −1 … 1: zeros of P_n by Newton's method.
std::vector<std::pair<double, double>> gaussNodes(int n) {
  std::vector<std::pair<double, double>> out;
  for (int i = 0; i < n; ++i) {
    double z = std::cos(kPi * (i + 0.75) / (n + 0.5)), slope = 0.0;
    for (int k = 0; k < 20; ++k) {
      double p = 1.0, before = 0.0;
      for (int m = 1; m <= n; ++m) {
        const double next = ((2.0 * m - 1.0) * z * p - (m - 1.0) * before) / m;
        before = p, p = next;
      }
      slope = n * (z * p - before) / (z * z - 1.0);
      const double step = p / slope;
      z -= step;
      if (std::abs(step) < 1e-15) break;
    }
    out.emplace_back(z, 2.0 / ((1.0 - z * z) * slope * slope));
  }
  return out;
}

/// Volume, ∫ x dV and ∫ x xᵀ dV.
struct Moments {
  double volume = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
};

Moments moments(const SmoothShape& s, int circles) {
  Moments out;
  const int around = 2 * circles;
  for (const auto& [z, weight] : gaussNodes(circles))
    for (int j = 0; j < around; ++j) {
      const Vec3 d = direction(std::acos(z), kTwoPi * (j + 0.5) / around), x = s.point(d);
      const Mat3 H = s.pointDerivative(d);
      const double D = 0.5 * (H.trace() * H.trace() - (H * H).trace());
      const double part = weight * kTwoPi / around * d.dot(x) * D;
      out.volume += part / 3.0;
      out.first += part / 4.0 * x;
      out.second += part / 5.0 * x * x.transpose();
    }
  return out;
}

/// Least radius of curvature of the shape, and the direction in which it lies.
struct Sharpest {
  double radius = std::numeric_limits<double>::infinity();  ///< [m]
  Vec3 d = Vec3::UnitZ();
};

/// Takes the eigenvalues of H on the plane across d: the principal radii of curvature.
void takeRadii(const SmoothShape& s, const Vec3& d, Sharpest& out) {
  const Mat3 H = s.pointDerivative(d);
  const Vec3 e = d.unitOrthogonal(), f = d.cross(e);
  const double a = e.dot(H * e), b = e.dot(H * f), c = f.dot(H * f);
  const double least = 0.5 * (a + c) - std::hypot(0.5 * (a - c), b);
  if (least < out.radius) out = {least, d};
}

/// Looks every 15°, the ends of the axes among them, then around the least radius with ever
/// smaller angles.
Sharpest sharpest(const SmoothShape& s) {
  Sharpest out;
  forDirections([&](const Vec3& d) { takeRadii(s, d, out); });
  for (double angle = kBetween; angle > kAngle; angle *= 0.5) {
    const Vec3 d = out.d, e = d.unitOrthogonal(), f = d.cross(e);
    for (int i = 0; i < 8; ++i)
      takeRadii(s,
                (d + angle * (std::cos(kPi * i / 4) * e + std::sin(kPi * i / 4) * f)).normalized(),
                out);
  }
  return out;
}

}  // namespace

ShapeGeometry SmoothShape::geometry() const {
  ShapeGeometry g{ShapeType::polyhedron, {}, {}, colour()};
  const auto at = [&](int i, int j) {
    return point(direction(kPi * i / kRings, i % kRings == 0 ? 0.0 : kTwoPi * j / kAround));
  };
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < kAround; ++j) {
      const Vec3 a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (i + 1 < kRings) g.points.insert(g.points.end(), {a, b, c});
      if (i > 0) g.points.insert(g.points.end(), {a, c, d});
    }
  return g;
}

MassProperties SmoothShape::massProperties() const {
  requireConsistent();
  Moments m = moments(*this, kFirstCircles);
  for (int circles = 2 * kFirstCircles; circles <= kMostCircles; circles *= 2) {
    const Moments finer = moments(*this, circles);
    const double change = std::max(std::abs(finer.volume - m.volume) / finer.volume,
                                   (finer.second - m.second).norm() / finer.second.norm());
    m = finer;
    if (!(change > kQuadrature)) break;
  }
  const Vec3 c = m.first / m.volume;
  const Mat3 central = m.second - m.volume * c * c.transpose();
  return {m.volume, c, central.trace() * Mat3::Identity() - central};
}

SmoothShape::Extent SmoothShape::extent() const {
  // In a direction at an angle to the furthest point, h is at least its distance times the cosine.
  Extent out{0.0, std::numeric_limits<double>::infinity()};
  forDirections([&](const Vec3& d) {
    const double h = d.dot(point(d)), behind = -d.dot(point(-d));
    out.bound = std::max(out.bound, h / std::cos(kBetween));
    out.halfWidth = std::min(out.halfWidth, 0.5 * (h + behind));
  });
  return out;
}

void SmoothShape::requireConsistent() const {
  std::vector<Vec3> all;
  double size = 0.0;
  for (const double polar : {0.0, 0.6, 1.2, 1.8, 2.4, 3.0})
    for (const double azimuth : {0.3, 1.8, 3.3, 4.8}) {
      all.push_back(direction(polar, azimuth));
      size = std::max(size, point(all.back()).norm());
    }
  const auto fault =
      [&](const Vec3& d, const std::string& what,
          const char* hint =
              "point(d) is the point furthest along d, pointDerivative(d) how it turns") {
        Diagnostic said;
        said.place = place(), said.element = type();
        said.text = "d = " + numberText(d[0]) + ' ' + numberText(d[1]) + ' ' + numberText(d[2]) +
                    ": " + what;
        said.hint = hint;
        throw ModelError(said);
      };
  for (const Vec3& d : all) {
    const Vec3 x = point(d);
    const Mat3 H = pointDerivative(d);
    if (!x.allFinite() || !H.allFinite()) fault(d, "point or pointDerivative is not finite");
    if (!(d.dot(x) > 0.0)) fault(d, "the origin of the shape's axes lies outside of it");
    for (const Vec3& e : all)
      if (d.dot(point(e) - x) > kOff * size) fault(d, "another point lies further along it");
    if ((H * d).norm() > kOff * size || (H - H.transpose()).norm() > kOff * size)
      fault(d, "pointDerivative is not symmetric, or changes along d");
    for (const Vec3& t : {Vec3(d.unitOrthogonal()), Vec3(d.cross(d.unitOrthogonal()))}) {
      const double c = std::cos(kAngle), s = std::sin(kAngle);
      const Vec3 slope = (point(c * d + s * t) - point(c * d - s * t)) / (2.0 * kAngle);
      if ((slope - H * t).norm() > kOff * (size + H.norm()))
        fault(d, "pointDerivative is not the derivative of point");
    }
  }
  const Sharpest least = sharpest(*this);
  // Corners have the radius 0, up to rounding.
  if (!(least.radius >= -kHollow * size))
    fault(
        least.d,
        "a radius of curvature is " + numberText(least.radius) + " m: the surface is hollow there",
        "a SmoothShape is convex: pointDerivative(d) has no eigenvalue below 0");
}

}  // namespace dynamy
