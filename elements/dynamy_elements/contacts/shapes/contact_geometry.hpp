/// Geometry of contact of two shapes before, while and after they touch: gap, point, directions.
#pragma once
#include <dynamy_elements/contacts/shapes/touching_shape.hpp>

namespace dynamy {

/// Sine, and part of a length, by which a place may be beyond a feature where it passes to the next
/// one. Without it a place between two is on neither by a rounding, and the contact of another
/// feature counts, or none. What is told of it is off by the square of this.
inline constexpr double kOnBorder = 1e-10;

/// Gap, point and directions of one contact, with the rates of point and directions.
struct ContactPoint {
  double g = 0.0;            ///< gap [m]
  Vec3 P = Vec3::Zero();     ///< point of contact in the world [m]
  Vec3 Pdot = Vec3::Zero();  ///< velocity of P, which is not that of a body point [m/s]
  Vec3 d[3], ddot[3];        ///< n, t1, t2 and their rates
};

/// One contact of a pair of shapes, with a number that stays the same while the shapes move.
struct NumberedContact {
  int id = 0;
  ContactPoint at;
};

/// Sets normal, tangents and their rates. In space (`plane` zero) the tangents follow from n; in a
/// plane of motion with the normal `plane`, t1 = n × plane and t2 = plane.
void setDirections(ContactPoint& out, const Vec3& n, const Vec3& ndot, const Vec3& plane);

/// Moves the point of `at` along its own normal into the plane through the point of
/// `lowest` with the normal n. γ_N does not change, and sticking contacts of two faces that
/// close together do not contradict each other. At different heights, a rotation ω of the
/// face would make the points slide by ω times the difference of heights, which stems from
/// the remaining gaps alone (theory 36.1).
void intoPlane(const Vec3& n, const Vec3& ndot, const ContactPoint& lowest, ContactPoint& at);

/// Contacts of the features of B with the half space A. The tangents are fixed in A; in a plane of
/// motion with the normal `plane` they are n × plane and plane.
class OverHalfSpace {
 public:
  OverHalfSpace(const Frame& A, const TouchingShape& halfSpace, const Frame& B);
  /// Gap of one feature [m]. It costs a few products only, as most features of a body are far away.
  double gap(const SupportFeature& feature) const {
    if (feature.kind != SupportFeature::Kind::ball) return height_ - feature.support(-n_B_);
    return height_ + n_B_.dot(feature.c_K) - feature.radius;
  }
  bool touches(const SupportFeature& feature) const {
    const bool always = feature.kind == SupportFeature::Kind::ball && !feature.flatOnly;
    return always || feature.touches(-n_B_);
  }
  /// Of a rim, and of points of it: SupportFeature::lift.
  double lift(const SupportFeature& feature) const { return feature.lift(-n_B_); }
  ContactPoint contact(const SupportFeature& feature, const Vec3& plane) const;

 private:
  const Frame &A_, &B_;
  const TouchingShape& halfSpace_;
  Vec3 n_I_, n_B_;  ///< the normal in the world and in axes of B
  double height_;   ///< height of B's origin over the plane [m]
};

/// Contact of two round features: balls, corners or points.
ContactPoint betweenBalls(const Frame& A, const RoundFeature& a, const Frame& B,
                          const RoundFeature& b, const Vec3& plane);
/// Contact of a round feature of B with the box A: g = |c − p| − R, p the point of
/// the box nearest to the centre c. If c is inside, the nearest face counts. In a
/// plane of motion the box is its section.
ContactPoint ballOnBox(const Frame& A, const TouchingShape& box, const Frame& B,
                       const RoundFeature& ball, const Vec3& plane);

}  // namespace dynamy
