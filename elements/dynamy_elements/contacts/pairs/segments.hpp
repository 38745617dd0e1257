/// Segments that move with frames: contacts of their insides with points and with each other.
#pragma once
#include <cmath>
#include <dynamy_elements/contacts/shapes/contact_geometry.hpp>

namespace dynamy {

/// Square of the sine below which two segments count as parallel; the contacts
/// of their ends are then sufficient.
inline constexpr double kParallel = 1e-10;
/// A segment that moves with a frame.
struct LineSegment {
  const Frame* frame;
  Vec3 o, e, edot;  ///< middle, unit direction and its rate
  double half;
  LineSegment(const Frame& f, const Vec3& middle_I, const Vec3& direction_I, double halfLength)
      : frame(&f),
        o(middle_I),
        e(direction_I),
        edot(f.Omega_I.cross(direction_I)),
        half(halfLength) {}
  Vec3 velocity(const Vec3& p) const { return frame->velocity(p - frame->r_OS_I); }
};

inline LineSegment capsuleAxis(const Frame& f, const TouchingShape& capsule) {
  return {f, f.r_OS_I + f.A_IK * capsule.p_K, f.A_IK * capsule.A_KB.col(2), capsule.half.z()};
}

/// Contact from the vector d between two points and its rate, and from the point p on A and its
/// rate. `otherwise`: the normal if d is zero.
inline ContactPoint fromWay(const Vec3& d, const Vec3& ddot, double RA, double RB, const Vec3& p,
                            const Vec3& pdot, const Vec3& otherwise, const Vec3& plane) {
  ContactPoint out;
  const double distance = d.norm();
  const Vec3 n = distance > 0.0 ? Vec3(d / distance) : otherwise;
  const Vec3 ndot = distance > 0.0 ? Vec3((ddot - n.dot(ddot) * n) / distance) : Vec3(Vec3::Zero());
  out.g = distance - RA - RB;
  setDirections(out, n, ndot, plane);
  out.P = p + RA * n, out.Pdot = pdot + RA * ndot;
  return out;
}

/// Contact of a ball about c, with velocity v and radius RB, with the
/// inside of a segment of radius RA.
inline ContactPoint overSegment(const LineSegment& a, double RA, const Vec3& c, const Vec3& v,
                                double RB, const Vec3& plane) {
  const double s = a.e.dot(c - a.o);
  const Vec3 p = a.o + s * a.e, d = c - p, vp = a.velocity(p), w = v - vp;
  // d ⟂ e for all times: ḋ·e + d·ė = 0 with ḋ = w − ṡ e.
  const double sdot = w.dot(a.e) + d.dot(a.edot);
  const Vec3 aside = plane.isZero(0.0) ? a.e.unitOrthogonal() : plane.cross(a.e);
  return fromWay(d, w - sdot * a.e, RA, RB, p, vp + sdot * a.e, aside, plane);
}

/// Contact of the point c, with velocity v, with a segment of radius R beside it,
/// in a plane. The normal n ⟂ e points away from c, and the contact's normal from c
/// to the segment. The gap has a sign.
inline ContactPoint besideSegment(const LineSegment& a, double R, const Vec3& n, const Vec3& c,
                                  const Vec3& v, const Vec3& plane) {
  const double s = a.e.dot(c - a.o);
  const Vec3 p = a.o + s * a.e, vp = a.velocity(p), ndot = a.frame->Omega_I.cross(n);
  const double sdot = (v - vp).dot(a.e) + (c - p).dot(a.edot);
  ContactPoint out;
  setDirections(out, n, ndot, plane);
  out.g = n.dot(p - c) - R;
  out.P = p - R * n, out.Pdot = vp + sdot * a.e - R * ndot;
  return out;
}

/// Closest points of the lines of two segments; `inside`: both are between the ends, up to kOnBorder.
struct SegmentCrossing {
  bool inside = false;
  double s = 0.0, t = 0.0, c = 0.0, square = 0.0;
  SegmentCrossing(const LineSegment& a, const LineSegment& b) : c(a.e.dot(b.e)) {
    const Vec3 d = b.o - a.o;
    square = a.e.cross(b.e).squaredNorm();
    if (square < kParallel) return;
    const double da = d.dot(a.e), db = d.dot(b.e);
    s = (da - c * db) / square, t = (c * da - db) / square;
    const double within = 1.0 + kOnBorder;
    inside = std::abs(s) < within * a.half && std::abs(t) < within * b.half;
  }
};

inline ContactPoint across(const LineSegment& a, double RA, const LineSegment& b, double RB,
                           const SegmentCrossing& at) {
  const Vec3 pA = a.o + at.s * a.e, pB = b.o + at.t * b.e, d = pB - pA;
  const Vec3 vA = a.velocity(pA), w = b.velocity(pB) - vA;
  // d ⟂ e_A, e_B for all times: ḋ·e + d·ė = 0 with ḋ = w + ṫ e_B − ṡ e_A gives ṡ and ṫ.
  const double ra = w.dot(a.e) + d.dot(a.edot), rb = w.dot(b.e) + d.dot(b.edot);
  const double tdot = (at.c * ra - rb) / at.square, sdot = ra + at.c * tdot;
  return fromWay(d, w + tdot * b.e - sdot * a.e, RA, RB, pA, vA + sdot * a.e,
                 a.e.cross(b.e).normalized(), Vec3::Zero());
}

/// The same contact seen from the other body.
inline void turnRound(ContactPoint& c) {
  for (const int i : {0, 1}) c.d[i] = -c.d[i], c.ddot[i] = -c.ddot[i];
}

}  // namespace dynamy
