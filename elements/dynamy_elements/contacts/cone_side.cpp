#include <cmath>
#include <dynamy_elements/contacts/cone_side.hpp>
#include <dynamy_elements/contacts/facets.hpp>
#include <dynamy_elements/contacts/segments.hpp>

namespace dynamy {
namespace {

/// Of the radius: nearer than this to the rim, the base takes its place.
constexpr double kOnEdge = 1e-9;

}  // namespace

ContactPoint pointOnSide(const DiscBody& B, const Frame& frame, const Vec3& p, double R,
                         double& s) {
  const Vec3 way = p - B.middle(0), beside = B.acrossAxis(way);
  const double out = beside.norm(), z = way.dot(B.a), sine = B.sine(), cosine = B.cosine();
  const Vec3 e = out > 0.0 ? Vec3(beside / out) : B.x;
  const Vec3 v = frame.velocity(p - frame.r_OS_I), w = v - B.frame->velocity(p - B.frame->r_OS_I);
  Vec3 edot = B.frame->Omega_I.cross(e);
  if (out > 0.0) edot += (B.acrossAxis(w) - w.dot(e) * e) / out;
  const Vec3 m = cosine * e + sine * B.a;
  const Vec3 mdot = cosine * edot + sine * B.frame->Omega_I.cross(B.a);
  s = z * cosine - (out - B.rho) * sine;
  ContactPoint at;
  at.g = (out - B.rho) * cosine + z * sine - B.r - R;
  setDirections(at, m, mdot, Vec3::Zero());
  at.P = p - R * m, at.Pdot = v - R * mdot;
  return at;
}

ContactPoint ballOnCone(const DiscBody& A, const Frame& B, const RoundFeature& ball) {
  const Vec3 c = B.r_OS_I + B.A_IK * ball.c_K, way = c - A.middle(0);
  const double z = way.dot(A.a), out = A.acrossAxis(way).norm();
  double s = 0.0;
  ContactPoint beside = pointOnSide(A, B, c, ball.radius, s);
  // Over the base, or inside and nearest to it.
  const bool outside = out > A.rho, below = z <= 0.0;
  if (below ? !outside || out - A.rho < kOnEdge * A.rho : -z > beside.g + ball.radius) {
    const PlacedFace base(*A.frame, -A.a, A.middle(0), 0.0, A.x, 1.0, true);
    ContactPoint at;
    base.contact(B, c, at);
    const Vec3 n = at.d[0], ndot = at.ddot[0];
    at.g -= ball.radius, at.P -= ball.radius * n, at.Pdot -= ball.radius * ndot;
    return at;
  }
  if (s <= 0.0) return pointOnCurve(A.rim(0, way), B, c, ball.radius, way);
  if (s < A.slant()) return beside;
  const Vec3 tip = A.middle(1), v = A.frame->velocity(tip - A.frame->r_OS_I);
  return fromWay(c - tip, B.velocity(c - B.r_OS_I) - v, 0.0, ball.radius, tip, v, A.a,
                 Vec3::Zero());
}

bool lineOnSide(const DiscBody& B, const Frame& frame, const Vec3& o, const Vec3& t,
                const Vec3& towards, double& s, double& sLine, ContactPoint& out) {
  const double sine = B.sine(), cosine = B.cosine(), along = t.dot(B.a);
  // m = x a' + y b, a' the part of a across t, b ⟂ both.
  const Vec3 across = B.a - along * t, b = t.cross(across);
  const double square = across.squaredNorm(), x = sine / square;
  const double y2 = (1.0 - x * x * square) / square;
  if (!(square > 0.0 && y2 * square > kCross * kCross)) return false;
  const double y = std::copysign(std::sqrt(y2), towards.dot(b));
  const Vec3 m = x * across + y * b;
  const Vec3 e = (m - sine * B.a) / cosine, g = cosine * B.a - sine * e;
  const double c = t.dot(g);
  if (!(1.0 - c * c > kCross * kCross)) return false;

  // How the normal turns, and with it the line of the side.
  const Vec3 &Omega = B.frame->Omega_I, adot = Omega.cross(B.a), tdot = frame.Omega_I.cross(t);
  Mat3 K;
  K << B.a.transpose(), t.transpose(), m.transpose();
  const Vec3 mdot = K.inverse() * Vec3(-m.dot(adot), -m.dot(tdot), 0.0);
  const Vec3 edot = (mdot - sine * adot) / cosine, gdot = cosine * adot - sine * edot;
  const Vec3 middle = B.middle(0), p = middle + B.rho * e;
  const Vec3 pdot = B.frame->velocity(middle - B.frame->r_OS_I) + B.rho * edot;

  // d ⟂ t, g: closest points of both lines.
  const Vec3 way = p - o;
  const double ofLine = way.dot(t), ofSide = way.dot(g), det = 1.0 - c * c;
  sLine = (ofLine - c * ofSide) / det, s = (c * ofLine - ofSide) / det;
  const Vec3 xA = o + sLine * t, xB = p + s * g, d = xB - xA;
  // … for all times: ḋ·t + d·ṫ = 0, ḋ·g + d·ġ = 0 with ḋ = w + ṡ g − ṡ_line t.
  const Vec3 w = pdot + s * gdot - frame.velocity(xA - frame.r_OS_I);
  const double ra = w.dot(t) + d.dot(tdot), rb = w.dot(g) + d.dot(gdot);
  const double sdot = (c * ra - rb) / det;
  out.g = -m.dot(d) - B.r;
  setDirections(out, -m, -mdot, Vec3::Zero());
  out.P = xB + B.r * m, out.Pdot = pdot + s * gdot + sdot * g + B.r * mdot;
  return true;
}

}  // namespace dynamy
