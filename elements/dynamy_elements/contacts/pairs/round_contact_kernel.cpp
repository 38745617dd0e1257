#include <cmath>
#include <dynamy_elements/contacts/pairs/disc_body.hpp>
#include <dynamy_elements/contacts/pairs/round_contact.hpp>
#include <dynamy_elements/contacts/pairs/segments.hpp>

namespace dynamy {
namespace {

/// Part of a half length or radius; a point nearer to an edge than this touches a face instead.
constexpr double kOnEdge = 1e-9;

}  // namespace

ContactPoint ballOnCapsule(const Frame& A, const TouchingShape& capsule, const Frame& B,
                           const RoundFeature& ball, const Vec3& plane) {
  const LineSegment a = capsuleAxis(A, capsule);
  const Vec3 rhoB = B.A_IK * ball.c_K, c = B.r_OS_I + rhoB;
  const double s = a.e.dot(c - a.o);
  if (std::abs(s) >= a.half)
    return betweenBalls(A, capsule.features[s < 0.0 ? 0 : 1], B, ball, plane);
  return overSegment(a, capsule.thickness, c, B.velocity(rhoB), ball.radius, plane);
}

int betweenCapsules(const Frame& A, const TouchingShape& a, const Frame& B, const TouchingShape& b,
                    const Vec3& plane, RoundContacts& out) {
  const LineSegment sa = capsuleAxis(A, a), sb = capsuleAxis(B, b);
  std::size_t n = 0;
  if (plane.isZero(0.0))
    if (const SegmentCrossing at(sa, sb); at.inside)
      out[n++] = {0, across(sa, a.thickness, sb, b.thickness, at)};
  for (std::size_t end = 0; end < 2; ++end)
    out[n++] = {1 + static_cast<int>(end), ballOnCapsule(A, a, B, b.features[end], plane)};
  // Contacts of ends with ends have been found before.
  for (std::size_t end = 0; end < 2; ++end) {
    const Vec3 rhoA = A.A_IK * a.features[end].c_K, c = A.r_OS_I + rhoA;
    if (std::abs(sb.e.dot(c - sb.o)) >= sb.half) continue;
    out[n] = {3 + static_cast<int>(end),
              overSegment(sb, b.thickness, c, A.velocity(rhoA), a.thickness, plane)};
    turnRound(out[n++].at);
  }
  return static_cast<int>(n);
}

namespace {

/// Does n, in axes of the box, point out of the edge along `axis` (−1: out of the corner) whose
/// signs are those of p?
bool pointsOut(const Vec3& n, const Vec3& p, int axis) {
  for (int k = 0; k < 3; ++k)
    if (k != axis && n[k] * (p[k] < 0.0 ? -1.0 : 1.0) < -kOnBorder) return false;
  return true;
}

}  // namespace

int capsuleOnBox(const Frame& A, const TouchingShape& box, const Frame& B,
                 const TouchingShape& capsule, RoundContacts& out) {
  const Vec3 none = Vec3::Zero();
  const Mat3 R = A.A_IK * box.A_KB;
  const Vec3 middle = A.r_OS_I + A.A_IK * box.p_K;
  const LineSegment axis = capsuleAxis(B, capsule);
  std::size_t n = 0;
  for (std::size_t end = 0; end < 2; ++end)
    out[n++] = {static_cast<int>(end), ballOnBox(A, box, B, capsule.features[end], none)};
  for (int number = 0; number < 12; ++number) {
    const int k = number / 4, u = (k + 1) % 3, v = (k + 2) % 3;
    Vec3 p = none;
    p[u] = number & 1 ? box.half[u] : -box.half[u], p[v] = number & 2 ? box.half[v] : -box.half[v];
    const LineSegment edge(A, middle + R * p, R.col(k), box.half[k]);
    const SegmentCrossing at(edge, axis);
    if (!at.inside) continue;
    const ContactPoint contact = across(edge, 0.0, axis, capsule.thickness, at);
    if (pointsOut(R.transpose() * contact.d[0], p, k)) out[n++] = {2 + number, contact};
  }
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p = placedBox(A, box).corner(corner), c = middle + R * p;
    if (std::abs(axis.e.dot(c - axis.o)) >= axis.half) continue;
    ContactPoint contact =
        overSegment(axis, capsule.thickness, c, A.velocity(c - A.r_OS_I), 0.0, none);
    turnRound(contact);
    if (pointsOut(R.transpose() * contact.d[0], p, -1)) out[n++] = {14 + corner, contact};
  }
  return static_cast<int>(n);
}

namespace {

/// Contact of a ball about c, with velocity v, with the flat side of a round body at the height
/// `half` over the middle of its axis, on the side ±1.
ContactPoint overCap(const LineSegment& axis, double side, double half, const Vec3& c,
                     const Vec3& v, double R) {
  ContactPoint out;
  const Vec3 n = side * axis.e;
  setDirections(out, n, side * axis.edot, Vec3::Zero());
  out.g = side * axis.e.dot(c - axis.o) - half - R;
  out.P = c - R * n, out.Pdot = v - R * side * axis.edot;
  return out;
}

/// Contact of such a ball with a rim of radius rho around `middle`, with a tube of radius r.
/// `beside`: its contact with the axis.
ContactPoint overRim(const LineSegment& axis, const Vec3& middle, double rho, double r,
                     const ContactPoint& beside, const Vec3& c, const Vec3& v, double R) {
  // The rim's point p turns with the direction from the axis to c.
  const Vec3 e = beside.d[0], p = middle + rho * e;
  const Vec3 pdot = axis.velocity(middle) + rho * beside.ddot[0];
  return fromWay(c - p, v - pdot, r, R, p, pdot, e, Vec3::Zero());
}

}  // namespace

ContactPoint ballOnCylinder(const Frame& A, const TouchingShape& cylinder, const Frame& B,
                            const RoundFeature& ball) {
  const double R = cylinder.half.x(), half = cylinder.half.z();
  const LineSegment axis = capsuleAxis(A, cylinder);
  const Vec3 rhoB = B.A_IK * ball.c_K, c = B.r_OS_I + rhoB, v = B.velocity(rhoB);
  const double z = axis.e.dot(c - axis.o), side = z < 0.0 ? -1.0 : 1.0;
  const double beyond = std::abs(z) - half;
  const Vec3 none = Vec3::Zero(), foot = axis.o + z * axis.e;
  const double r = (c - foot).norm();
  const bool outside = r > R, above = beyond > 0.0;
  // The ball is over a face, or inside and nearest to a face.
  if (above ? !outside || r - R < kOnEdge * R : !outside && beyond > r - R)
    return overCap(axis, side, half, c, v, ball.radius);
  ContactPoint beside = overSegment(axis, R, c, v, ball.radius, none);
  if (!above || beyond < kOnEdge * half) return beside;
  const Vec3 top = axis.o + side * half * axis.e;
  return overRim(axis, top, R, 0.0, beside, c, v, ball.radius);
}

ContactPoint ballOnTorus(const Frame& A, const TouchingShape& torus, const Frame& B,
                         const RoundFeature& ball) {
  const DiscBody disc = discBody(A, torus);
  const LineSegment axis(A, disc.c, disc.a, 0.0);
  const Vec3 rhoB = B.A_IK * ball.c_K, c = B.r_OS_I + rhoB, v = B.velocity(rhoB);
  const Vec3 way = c - axis.o;
  if (disc.acrossAxis(way).norm() <= disc.rho)
    return overCap(axis, axis.e.dot(way) < 0.0 ? -1.0 : 1.0, disc.r, c, v, ball.radius);
  const ContactPoint beside = overSegment(axis, 0.0, c, v, ball.radius, Vec3::Zero());
  return overRim(axis, axis.o, disc.rho, disc.r, beside, c, v, ball.radius);
}

}  // namespace dynamy
