/// Search for the direction that separates two smooth features most, and the contact
/// there. It serves all pairs of ellipsoids: with each other, with round bodies,
/// polyhedra, meshes and in a plane (smooth_contact.hpp).
#pragma once
#include <cmath>
#include <dynamy_elements/contacts/shapes/contact_geometry.hpp>

namespace dynamy::smooth {

/// Most steps of Newton's method; from the line of the centres about six are enough.
inline constexpr int kSteps = 50;
/// Length of a step of the unit vector n below which n is found.
inline constexpr double kFound = 1e-15;
/// Length of a step of the unit vector n that changes f by less than its rounding.
inline constexpr double kFlat = 1e-7;

/// A feature in the world.
struct Placed {
  const Frame& frame;
  const SupportFeature& feature;
  Vec3 centre() const { return frame.r_OS_I + frame.A_IK * feature.c_K; }
  Vec3 point(const Vec3& d) const { return frame.r_OS_I + fromOrigin(d); }
  /// Support point from the origin of its frame; it is as precise far from
  /// the world's origin as near it.
  Vec3 fromOrigin(const Vec3& d) const {
    return frame.A_IK * feature.point(frame.A_IK.transpose() * d);
  }
  Mat3 derivative(const Vec3& d) const {
    const Mat3& R = frame.A_IK;
    return R * feature.pointDerivative(R.transpose() * d) * R.transpose();
  }
  Vec3 velocity(const Vec3& p) const { return frame.velocity(p - frame.r_OS_I); }
};

/// Directions in which n may turn: two across it, or one across it and across `e`, an edge or the
/// normal of the plane of motion.
struct Tangents {
  Eigen::Matrix<double, 3, 2> T;
  int count;
  Tangents(const Vec3& n, const Vec3* e) : count(e ? 1 : 2) {
    const Vec3 t = e ? Vec3(e->cross(n)) : n.unitOrthogonal();
    T << t, n.cross(t);
  }
  /// (Tᵀ H T + f I)⁻¹ Tᵀ r, as a vector in space.
  Vec3 solve(const Mat3& H, double f, const Vec3& r) const {
    Eigen::Matrix2d K = T.transpose() * H * T + f * Eigen::Matrix2d::Identity();
    Eigen::Vector2d rhs = T.transpose() * r;
    if (count == 1) K(0, 1) = K(1, 0) = rhs[1] = 0.0, K(1, 1) = 1.0;
    // For deep overlap f is no longer concave; the step then goes along the gradient.
    if (!(K(0, 0) > 0.0 && K.determinant() > 0.0)) K = K.norm() * Eigen::Matrix2d::Identity();
    return T * (K.inverse() * rhs);
  }
};

/// Search for the n that separates A and B most. If `a` is null, the fixed point `at` takes the
/// place of A.
class Search {
 public:
  Search(const Placed* a, const Vec3& at, const Placed& b, const Vec3* e)
      : a_(a), way_(b.frame.r_OS_I - (a ? a->frame.r_OS_I : at)), b_(b), e_(e) {}
  /// From A's support point to B's, without places in the world: their rounding differs for each n
  /// by more than f changes near its maximum.
  Vec3 y(const Vec3& n) const {
    const Vec3 toB = way_ + b_.fromOrigin(-n);
    return a_ ? Vec3(toB - a_->fromOrigin(n)) : toB;
  }
  Mat3 H(const Vec3& n) const {
    const Mat3 ofB = b_.derivative(-n);
    return a_ ? Mat3(ofB + a_->derivative(n)) : ofB;
  }
  Vec3 best(Vec3 n) const {
    double f = n.dot(y(n));
    for (int i = 0; i < kSteps; ++i) {
      const Vec3 step = Tangents(n, e_).solve(H(n), f, y(n));
      double part = 1.0;
      Vec3 next = (n + step).normalized();
      double g = next.dot(y(next));
      // The step is shortened until it separates more, up to rounding.
      for (; part > 1e-3 && !(g >= f - 1e-15 * std::abs(f)); g = next.dot(y(next)))
        part *= 0.5, next = (n + part * step).normalized();
      if (part <= 1e-3) {
        // Here f does not change by more than its rounding, but its gradient still does.
        if (step.norm() < kFlat) n = (n + step).normalized();
        break;
      }
      n = next, f = g;
      if (step.norm() < kFound) break;
    }
    return n;
  }

 private:
  const Placed* a_;
  Vec3 way_;  // to the origin of B's frame from that of A's, or from `at`
  const Placed& b_;
  const Vec3* e_;
};

/// Terms that A's motion adds: velocity of its point, H_A (Ω_A × n), and the rate of n that keeps
/// it across an edge.
struct OfA {
  Vec3 v, wander = Vec3::Zero(), ndot0 = Vec3::Zero();
};

/// The contact with the normal n. `plane`: normal of the plane of motion, or zero.
inline ContactPoint contactAt(const Vec3& n, const Vec3& y, const Mat3& H, const Mat3& HB,
                              const OfA& A, const Placed& B, const Tangents& t, const Vec3& plane) {
  ContactPoint out;
  out.g = n.dot(y), out.P = B.point(-n);
  const Vec3 turn = B.frame.Omega_I.cross(n), vB = B.velocity(out.P);
  const Vec3 ndot = A.ndot0 + t.solve(H, out.g, vB - A.v + HB * turn + A.wander - H * A.ndot0);
  setDirections(out, n, ndot, plane);
  out.Pdot = vB - HB * (ndot - turn);
  return out;
}

/// Contact of a feature of B with the point p, which moves with A: a corner
/// or, with `e`, an edge through it.
inline ContactPoint onPoint(const Frame& A, const Vec3& p, const Placed& B, const Vec3* e,
                            const Vec3& plane = Vec3::Zero()) {
  const Vec3 way = B.centre() - p;
  const Vec3 start = e ? Vec3(way - way.dot(*e) * *e) : way;
  const Vec3 n = Search(nullptr, p, B, e).best(start.normalized());
  // The point of the edge that is opposite to B's support point.
  const Vec3 foot = e ? Vec3(p + (B.point(-n) - p).dot(*e) * *e) : p;
  OfA ofA{A.velocity(foot - A.r_OS_I)};
  if (e) ofA.ndot0 = -n.dot(A.Omega_I.cross(*e)) * *e;
  const Mat3 HB = B.derivative(-n);
  return contactAt(n, B.point(-n) - foot, HB, HB, ofA, B, Tangents(n, e), plane);
}

/// Contact of two features; the search begins with n = `start`. In a plane of motion n stays in it.
inline ContactPoint betweenFrom(const Placed& A, const Placed& B, const Vec3& start,
                                const Vec3& plane = Vec3::Zero()) {
  const Vec3* e = plane.isZero(0.0) ? nullptr : &plane;
  const Search search(&A, Vec3::Zero(), B, e);
  const Vec3 n = search.best(start);
  const Mat3 HA = A.derivative(n), HB = B.derivative(-n);
  const OfA ofA{A.velocity(A.point(n)), HA * A.frame.Omega_I.cross(n)};
  return contactAt(n, search.y(n), HA + HB, HB, ofA, B, Tangents(n, e), plane);
}

/// Contact of a feature of B with the plane of A through o with the normal n, which is fixed in A.
inline ContactPoint overPlane(const Frame& A, const Vec3& n, const Vec3& o, const Placed& B,
                              const Vec3& plane = Vec3::Zero()) {
  ContactPoint out;
  out.P = B.point(-n), out.g = n.dot(out.P - o);
  const Vec3 ndot = A.Omega_I.cross(n);
  setDirections(out, n, ndot, plane);
  out.Pdot = B.velocity(out.P) - B.derivative(-n) * (ndot - B.frame.Omega_I.cross(n));
  return out;
}

}  // namespace dynamy::smooth
