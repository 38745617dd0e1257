/// Data of a single-track vehicle: four rigid bodies in the upright position with straight
/// steering. x points forward from the rear contact, y to the left, z up from the ground. Trail c
/// and caster angle λ are as usual: the steering axis meets the ground at x = w + c and leans back
/// by λ.
#pragma once
#include <dynamy/dynamy.hpp>

namespace dynamy::motorbike {

/// Data of one body in the upright position.
struct Part {
  double m = 0.0;            ///< [kg]
  Vec3 r_OS = Vec3::Zero();  ///< centre of mass [m]
  Mat3 J_S = Mat3::Zero();   ///< about the centre of mass, axes of the vehicle [kg m²]
};

/// A wheel turns about y. Its tyre is a torus: tube = radius gives a ball, tube = 0 an edge.
struct Wheel : Part {
  double radius = 0.0, tube = 0.0;  ///< [m]
};

/// Spring and damper of a wheel's travel, compression s ≥ 0:  F = k s + d ṡ + P.
struct Suspension {
  double k = 0.0, d = 0.0, preload = 0.0;  ///< [N/m], [N s/m], [N]
};

struct Geometry {
  double wheelbase, trail, caster;  ///< w [m], c [m], λ [rad]
  Wheel rear, front;
  Part frame, fork;  ///< the rider sits on the frame
  Suspension rearSuspension, frontSuspension;
  bool suspended;
  double steerDamping;  ///< [N m s]

  static void declare(Attributes& a);
  explicit Geometry(const Parameters& x);
  /// Unit vector along the steering axis, pointing up.
  Vec3 steerAxis() const;
  /// Point where the steering axis meets the ground.
  Vec3 steerFoot() const { return {wheelbase + trail, 0.0, 0.0}; }
};

}  // namespace dynamy::motorbike
