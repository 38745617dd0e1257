/// Geometry of contact: what of a shape can touch, and where two of them touch.
#pragma once
#include <dynamy/system/topology.hpp>
#include <vector>

namespace dynamy {

/// A ball of radius R ≥ 0 about a point of the body: a ball, a corner, a point.
struct RoundFeature {
  Vec3 c_K = Vec3::Zero();  ///< in axes of the frame, from its origin [m]
  double radius = 0.0;      ///< [m]
};

/// A shape as contact sees it: a half space, or one or several round features.
struct TouchingShape {
  enum class Kind : std::uint8_t { none, halfSpace, round, corners } kind = Kind::none;
  const Shape* shape = nullptr;
  FrameHandle frame;
  int system = -1;
  std::vector<RoundFeature> features;
  Vec3 n_K = Vec3::Zero(), p_K = Vec3::Zero();  ///< half space: normal and a point of its plane
  Mat3 A_KB = Mat3::Identity();                 ///< box: its axes, about p_K
  Vec3 half = Vec3::Zero();                     ///< box: half edge lengths [m]
};

/// Takes a shape apart. `plane`: normal of the plane of motion in the shape's frame, or zero; a box
/// with an edge along it has four corners there instead of eight. Kind::none: cannot touch.
TouchingShape touchingShape(const ShapeInstance& instance, const Vec3& plane_K);

/// Place, directions and their rates of one contact.
struct ContactPoint {
  double g = 0.0;            ///< gap [m]
  Vec3 P = Vec3::Zero();     ///< point of contact in the world [m]
  Vec3 Pdot = Vec3::Zero();  ///< its velocity, which is not that of a body point [m/s]
  Vec3 d[3], ddot[3];        ///< n, t1, t2 and their rates
};

/// Features of B over the half space of A. The tangents are fixed in A, or lie in the plane.
class OverHalfSpace {
 public:
  OverHalfSpace(const Frame& A, const TouchingShape& halfSpace, const Frame& B);
  /// Of one feature; a few products, as most features of a body are nowhere near.
  double gap(const RoundFeature& feature) const {
    return height_ + n_B_.dot(feature.c_K) - feature.radius;
  }
  ContactPoint contact(const RoundFeature& feature, const Vec3& plane) const;

 private:
  const Frame &A_, &B_;
  const TouchingShape& halfSpace_;
  Vec3 n_I_, n_B_;  ///< the normal in the world and in axes of B
  double height_;   ///< of B's origin [m]
};

/// Two round features.
ContactPoint betweenBalls(const Frame& A, const RoundFeature& a, const Frame& B,
                          const RoundFeature& b, const Vec3& plane);
/// Feature of B on the box of A: g = |c − p| − R, p the point of the box nearest to c; with c
/// inside, the nearest face counts. In a plane of motion the box is its section.
ContactPoint ballOnBox(const Frame& A, const TouchingShape& box, const Frame& B,
                       const RoundFeature& ball, const Vec3& plane);

}  // namespace dynamy
