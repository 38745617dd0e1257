#include <cmath>
#include <dynamy_elements/contacts/pairs/curve_contact.hpp>
#include <dynamy_elements/contacts/pairs/facets.hpp>
#include <dynamy_elements/contacts/pairs/segments.hpp>

namespace dynamy {
namespace {

/// Most steps of Newton's method; from a good start about four are enough.
constexpr int kCurveSteps = 30;
/// Step, as a part of the sizes, below which the closest points are found.
constexpr double kCurveFound = 1e-15;

/// The linear equations for the displacements s_A, s_B along both curves.
struct Ways {
  double a11, c, a22, det;
  Ways(const BodyCurve& A, const BodyCurve& B, const Vec3& d)
      : a11(1.0 - d.dot(A.curvature())),
        c(A.t.dot(B.t)),
        a22(1.0 + d.dot(B.curvature())),
        det(a11 * a22 - c * c) {}
  /// a11 s_A − c s_B = p,   c s_A − a22 s_B = q
  void solve(double p, double q, double& sA, double& sB) const {
    sA = (a22 * p - c * q) / det, sB = (c * p - a11 * q) / det;
  }
};

}  // namespace

BodyCurve BodyCurve::circle(const Frame& f, const Vec3& middle, const Vec3& axis, double radius,
                            double tube, const Vec3& d) {
  const Vec3 e = unitAcross(d, axis);
  return {&f, middle + radius * e, axis.cross(e), middle, axis, radius, tube};
}

void BodyCurve::go(double way) {
  if (rho == 0.0) {
    x += way * t;
    return;
  }
  const Vec3 e = (x - c) / rho;
  const double angle = way / rho;
  x = c + rho * (std::cos(angle) * e + std::sin(angle) * t);
  t = a.cross(x - c).normalized();
}

bool toClosest(BodyCurve& A, BodyCurve& B) {
  for (int i = 0; i < kCurveSteps; ++i) {
    const Vec3 d = B.x - A.x;
    const Ways ways(A, B, d);
    if (!(ways.det > kParallel)) return false;
    double sA = 0.0, sB = 0.0;
    ways.solve(d.dot(A.t), d.dot(B.t), sA, sB);
    // A step on a circle is at most half a radius.
    double part = 1.0;
    for (const auto& [curve, s] : {std::pair{&A, sA}, std::pair{&B, sB}})
      if (curve->rho > 0.0 && std::abs(s) > 0.5 * curve->rho)
        part = std::min(part, 0.5 * curve->rho / std::abs(s));
    A.go(part * sA), B.go(part * sB);
    const double size = A.rho + B.rho + std::abs(sA) + std::abs(sB) + d.norm();
    if (std::abs(sA) + std::abs(sB) <= kCurveFound * size) return true;
  }
  const Vec3 d = B.x - A.x;
  // The points are also found if steps go to and fro by a rounding error.
  return std::abs(d.dot(A.t)) + std::abs(d.dot(B.t)) <= 1e-12 * (A.rho + B.rho + d.norm());
}

ContactPoint curveOnCurve(const BodyCurve& A, const BodyCurve& B, const Vec3& towardsB) {
  const Vec3 d = B.x - A.x, vA = A.velocity(), vB = B.velocity(), w = vB - vA;
  const Vec3 tAdot = A.frame->Omega_I.cross(A.t), tBdot = B.frame->Omega_I.cross(B.t);
  double sA = 0.0, sB = 0.0;
  Ways(A, B, d).solve(w.dot(A.t) + d.dot(tAdot), w.dot(B.t) + d.dot(tBdot), sA, sB);
  const Vec3 ddot = w + sB * B.t - sA * A.t, cross = A.t.cross(B.t);
  const double square = cross.squaredNorm();
  Vec3 n = towardsB, ndot = Vec3::Zero();
  if (square > kCross * kCross) {
    const Vec3 rate =
        (tAdot + sA * A.curvature()).cross(B.t) + A.t.cross(tBdot + sB * B.curvature());
    const double scale = (cross.dot(towardsB) < 0.0 ? -1.0 : 1.0) / std::sqrt(square);
    n = scale * cross;
    ndot = scale * rate;
    ndot -= n.dot(ndot) * n;
  } else if (const double distance = d.norm(); distance > 0.0) {
    n = (d.dot(towardsB) < 0.0 ? -1.0 : 1.0) / distance * d;
    ndot = (d.dot(towardsB) < 0.0 ? -1.0 : 1.0) / distance * ddot;
    ndot -= n.dot(ndot) * n;
  }
  ContactPoint out;
  out.g = n.dot(d) - A.r - B.r;
  setDirections(out, n, ndot, Vec3::Zero());
  out.P = B.x - B.r * n, out.Pdot = vB + sB * B.t - B.r * ndot;
  return out;
}

ContactPoint pointOnCurve(const BodyCurve& A, const Frame& B, const Vec3& p, double R,
                          const Vec3& towardsB) {
  BodyCurve at = A;
  if (A.rho == 0.0)
    at.go(A.t.dot(p - A.x));
  else
    at = BodyCurve::circle(*A.frame, A.c, A.a, A.rho, A.r, p - A.c);
  const Vec3 d = p - at.x, v = at.velocity(), w = B.velocity(p - B.r_OS_I) - v;
  const double way =
      (w.dot(at.t) + d.dot(A.frame->Omega_I.cross(at.t))) / (1.0 - d.dot(at.curvature()));
  return fromWay(d, w - way * at.t, A.r, R, at.x, v + way * at.t, towardsB, Vec3::Zero());
}

}  // namespace dynamy
