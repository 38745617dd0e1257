#include <cmath>
#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/contacts/shapes/contact_geometry.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Rates of tangents(n): the derivative of their formula along ṅ.
void tangentRates(const Vec3& n, const Vec3& ndot, Vec3& t1dot, Vec3& t2dot) {
  const double s = tangentSide(n), a = -1.0 / (s + n.z()), adot = a * a * ndot.z();
  const double bdot = (ndot.x() * n.y() + n.x() * ndot.y()) * a + n.x() * n.y() * adot;
  t1dot = Vec3(s * (2.0 * n.x() * ndot.x() * a + n.x() * n.x() * adot), s * bdot, -s * ndot.x());
  t2dot = Vec3(bdot, 2.0 * n.y() * ndot.y() * a + n.y() * n.y() * adot, -ndot.y());
}

}  // namespace

void setDirections(ContactPoint& out, const Vec3& n, const Vec3& ndot, const Vec3& plane) {
  out.d[0] = n, out.ddot[0] = ndot;
  if (plane.isZero(0.0)) {
    tangents(n, out.d[1], out.d[2]);
    tangentRates(n, ndot, out.ddot[1], out.ddot[2]);
  } else {
    out.d[1] = n.cross(plane), out.ddot[1] = ndot.cross(plane);
    out.d[2] = plane, out.ddot[2].setZero();
  }
}

void intoPlane(const Vec3& n, const Vec3& ndot, const ContactPoint& lowest, ContactPoint& at) {
  const Vec3 r = at.P - lowest.P, rdot = at.Pdot - lowest.Pdot;
  const double along = n.dot(at.d[0]), alongdot = ndot.dot(at.d[0]) + n.dot(at.ddot[0]);
  const double way = n.dot(r) / along;
  const double waydot = (ndot.dot(r) + n.dot(rdot) - way * alongdot) / along;
  at.P -= way * at.d[0];
  at.Pdot -= waydot * at.d[0] + way * at.ddot[0];
}

OverHalfSpace::OverHalfSpace(const Frame& A, const TouchingShape& halfSpace, const Frame& B)
    : A_(A),
      B_(B),
      halfSpace_(halfSpace),
      n_I_(A.A_IK * halfSpace.n_K),
      n_B_(B.A_IK.transpose() * n_I_),
      height_(n_I_.dot(B.r_OS_I - A.r_OS_I - A.A_IK * halfSpace.p_K)) {}

ContactPoint OverHalfSpace::contact(const SupportFeature& feature, const Vec3& plane) const {
  ContactPoint out;
  out.g = gap(feature);
  out.d[0] = n_I_;
  if (plane.isZero(0.0)) {
    Vec3 t1, t2;
    tangents(halfSpace_.n_K, t1, t2);
    out.d[1] = A_.A_IK * t1, out.d[2] = A_.A_IK * t2;
  } else {
    out.d[1] = n_I_.cross(plane), out.d[2] = plane;
  }
  for (int i = 0; i < 3; ++i) out.ddot[i] = A_.Omega_I.cross(out.d[i]);
  if (feature.kind == SupportFeature::Kind::ball) {
    const Vec3 rho_I = B_.A_IK * feature.c_K;
    out.P = B_.r_OS_I + rho_I - feature.radius * n_I_;
    out.Pdot = B_.velocity(rho_I) - feature.radius * out.ddot[0];
    return out;
  }
  // The lowest point moves over the body as the direction to the plane changes.
  const Vec3 rho_I = B_.A_IK * feature.point(-n_B_);
  const Vec3 ddot_B = -B_.A_IK.transpose() * (A_.Omega_I - B_.Omega_I).cross(n_I_);
  out.P = B_.r_OS_I + rho_I;
  out.Pdot = B_.velocity(rho_I) + B_.A_IK * (feature.pointDerivative(-n_B_) * ddot_B);
  return out;
}

ContactPoint betweenBalls(const Frame& A, const RoundFeature& a, const Frame& B,
                          const RoundFeature& b, const Vec3& plane) {
  ContactPoint out;
  const Vec3 rhoA = A.A_IK * a.c_K, rhoB = B.A_IK * b.c_K;
  const Vec3 r = B.r_OS_I + rhoB - A.r_OS_I - rhoA, v = B.velocity(rhoB) - A.velocity(rhoA);
  const double distance = r.norm();
  out.g = distance - a.radius - b.radius;
  // Centres that coincide have no normal; any one separates them.
  const Vec3 n = distance > 0.0 ? Vec3(r / distance) : Vec3(Vec3::UnitZ());
  const Vec3 ndot = distance > 0.0 ? Vec3((v - n.dot(v) * n) / distance) : Vec3(Vec3::Zero());
  setDirections(out, n, ndot, plane);
  out.P = A.r_OS_I + rhoA + a.radius * n;
  out.Pdot = A.velocity(rhoA) + a.radius * ndot;
  return out;
}

namespace {

/// Part of the smallest half edge; a point nearer to an edge than this touches the face instead.
constexpr double kOnBoxEdge = 1e-9;

/// Distance and normal of a point from a box, in the box's axes.
struct FromBox {
  double distance = 0.0;  ///< negative inside
  Vec3 n = Vec3::Zero(), ndot = Vec3::Zero();
  /// `x`, `xdot`: the point; `flat`: axis along which the box has no ends, or −1.
  FromBox(const Vec3& x, const Vec3& xdot, const Vec3& half, int flat) {
    Vec3 beyond = x.cwiseAbs() - half;  // of each face
    if (flat >= 0) beyond[flat] = -std::numeric_limits<double>::infinity();
    int face = 0;
    beyond.maxCoeff(&face);
    Vec3 d = Vec3::Zero(), w = Vec3::Zero();
    int outside = 0;
    for (int k = 0; k < 3; ++k)
      if (beyond[k] > 0.0) d[k] = std::copysign(beyond[k], x[k]), w[k] = xdot[k], ++outside;
    const double norm = d.norm();
    if (outside < 2 || norm < kOnBoxEdge * half.minCoeff()) {
      distance = beyond[face], n[face] = std::copysign(1.0, x[face]);
    } else {
      distance = norm, n = d / norm, ndot = (w - n.dot(w) * n) / norm;
    }
  }
};

/// Axis of the box along the normal of the plane of motion; −1: the box moves in space.
int flatAxis(const Mat3& R, const Vec3& plane) {
  int axis = -1;
  if (!plane.isZero(0.0)) (R.transpose() * plane).cwiseAbs().maxCoeff(&axis);
  return axis;
}

}  // namespace

ContactPoint ballOnBox(const Frame& A, const TouchingShape& box, const Frame& B,
                       const RoundFeature& ball, const Vec3& plane) {
  ContactPoint out;
  const Mat3 R = A.A_IK * box.A_KB;
  const Vec3 rhoB = B.A_IK * ball.c_K, c = B.r_OS_I + rhoB, v = B.velocity(rhoB);
  const Vec3 x = R.transpose() * (c - A.r_OS_I - A.A_IK * box.p_K);
  const Vec3 xdot = R.transpose() * (v - A.velocity(c - A.r_OS_I));
  const FromBox at(x, xdot, box.half, flatAxis(R, plane));
  out.g = at.distance - ball.radius;
  const auto rate = [&](const Vec3& d, const Vec3& inBox) {
    return Vec3(R * inBox + A.Omega_I.cross(d));
  };
  out.d[0] = R * at.n, out.ddot[0] = rate(out.d[0], at.ndot);
  if (plane.isZero(0.0)) {
    Vec3 t1, t2, t1dot, t2dot;
    tangents(at.n, t1, t2);
    tangentRates(at.n, at.ndot, t1dot, t2dot);
    out.d[1] = R * t1, out.ddot[1] = rate(out.d[1], t1dot);
    out.d[2] = R * t2, out.ddot[2] = rate(out.d[2], t2dot);
  } else {
    out.d[1] = out.d[0].cross(plane), out.ddot[1] = out.ddot[0].cross(plane);
    out.d[2] = plane, out.ddot[2].setZero();
  }
  out.P = c - ball.radius * out.d[0];
  out.Pdot = v - ball.radius * out.ddot[0];
  return out;
}

}  // namespace dynamy
