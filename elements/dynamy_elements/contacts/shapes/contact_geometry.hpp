/// Geometry of contact: where two shapes touch, before, while and after they do.
#pragma once
#include <dynamy_elements/contacts/shapes/touching_shape.hpp>

namespace dynamy {

/// Place, directions and their rates of one contact.
struct ContactPoint {
  double g = 0.0;            ///< gap [m]
  Vec3 P = Vec3::Zero();     ///< point of contact in the world [m]
  Vec3 Pdot = Vec3::Zero();  ///< its velocity, which is not that of a body point [m/s]
  Vec3 d[3], ddot[3];        ///< n, t1, t2 and their rates
};

/// A contact of a pair and its number, which stays.
struct NumberedContact {
  int id = 0;
  ContactPoint at;
};

/// Normal and tangents with their rates: the tangents follow from n, or one lies in the plane.
void setDirections(ContactPoint& out, const Vec3& n, const Vec3& ndot, const Vec3& plane);

/// Moves `at` along its own normal into the plane through `lowest` with normal n: γ_N stays what it
/// is, and contacts of two faces that close together do not contradict each other when they stick.
/// At different heights a turn of the face would have them slide by ω times the difference, which
/// is nothing but the gaps that are left.                                       (theory 36.1)
void intoPlane(const Vec3& n, const Vec3& ndot, const ContactPoint& lowest, ContactPoint& at);

/// Features of B over the half space of A. The tangents are fixed in A, or lie in the plane.
class OverHalfSpace {
 public:
  OverHalfSpace(const Frame& A, const TouchingShape& halfSpace, const Frame& B);
  /// Of one feature; a few products, as most features of a body are nowhere near.
  double gap(const SupportFeature& feature) const {
    if (feature.kind != SupportFeature::Kind::ball) return height_ - feature.support(-n_B_);
    return height_ + n_B_.dot(feature.c_K) - feature.radius;
  }
  bool touches(const SupportFeature& feature) const {
    const bool always = feature.kind == SupportFeature::Kind::ball && !feature.flatOnly;
    return always || feature.touches(-n_B_);
  }
  ContactPoint contact(const SupportFeature& feature, const Vec3& plane) const;

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
