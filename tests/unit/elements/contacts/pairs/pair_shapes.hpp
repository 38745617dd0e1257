/// Shapes, sizes and motions that the tests of several pairs of shapes share.
#pragma once
#include <dynamy_elements/contacts/pairs/disc_body.hpp>
#include <dynamy_elements/contacts/shapes/touching_shape.hpp>

#include "unit/elements/contacts/faceted_bodies.hpp"

namespace dynamy::testing {

inline const Vec3 kPlane = Vec3(0.0, -1.0, 0.0);  // x to z, as bodies in a plane move

/// A frame that moves in the plane.
inline Mover inPlane(Random& random, const Vec3& at) {
  return {at, turned(3.0 * random.number() * kPlane), Vec3(random.number(), 0.0, random.number()),
          random.number() * kPlane};
}
/// A frame that moves in space.
inline Mover inSpace(Random& r, const Vec3& at) {
  return {at, turned(2.0 * r.vec()), r.vec(), r.vec()};
}

inline SupportFeature ball(double R, const Vec3& at) {
  SupportFeature f;
  f.radius = R, f.c_K = at;
  return f;
}
inline SupportFeature ellipsoid(const Vec3& semi, const Vec3& at = Vec3::Zero()) {
  SupportFeature f;
  f.kind = SupportFeature::Kind::ellipsoid, f.c_K = at;
  f.square_K = semi.cwiseAbs2().asDiagonal();
  return f;
}
/// How far it reaches along n.
inline double reach(const Frame& f, const SupportFeature& s, const Vec3& n) {
  return n.dot(f.r_OS_I) + s.support(f.A_IK.transpose() * n);
}

inline TouchingShape capsule(double R, double half) {
  TouchingShape s;
  s.kind = TouchingShape::Kind::capsule;
  s.half = {R, R, half}, s.thickness = R, s.bound = R + half;
  s.features.resize(2);
  for (const int i : {0, 1})
    s.features[static_cast<std::size_t>(i)].c_K = (2 * i - 1) * half * Vec3::UnitZ(),
    s.features[static_cast<std::size_t>(i)].radius = R;
  return s;
}

/// Of a cylinder, a torus or a cone.
struct DiscSizes {
  double half, rho, r;
  bool tip = false;
};
inline constexpr DiscSizes kDiscs[] = {{0.5, 0.3, 0.0},       {0.05, 0.4, 0.0},
                                       {0.0, 0.4, 0.1},       {0.7, 0.1, 0.0},
                                       {0.4, 0.3, 0.0, true}, {0.1, 0.5, 0.0, true}};

/// In axes of its frame: the axis is z.
inline DiscBody placedDisc(const Frame& f, double half, double rho, double r, bool tip = false) {
  return {&f, f.r_OS_I, f.A_IK.col(2), f.A_IK.col(0), half, rho, r, tip};
}
inline DiscBody placedDisc(const Frame& f, const DiscSizes& s) {
  return placedDisc(f, s.half, s.rho, s.r, s.tip);
}

}  // namespace dynamy::testing
