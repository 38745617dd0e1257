/// Data of a single-track vehicle: four rigid bodies in their places when it stands upright with
/// straight steering. x forward from the rear contact, y to the left, z up from the ground; trail
/// and caster angle as usual: the steering axis meets the ground at x = w + c and leans back by λ.
#pragma once
#include <dynamy/dynamy.hpp>

namespace dynamy::motorbike {

/// A body when upright.
struct Part {
  double m = 0.0;            ///< [kg]
  Vec3 r_OS = Vec3::Zero();  ///< centre of mass [m]
  Mat3 J_S = Mat3::Zero();   ///< about it, axes of the vehicle [kg m²]
};

/// A wheel turns about y; its tyre is a tube around a circle: tube = radius is a ball, 0 an edge.
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
  /// Unit vector along the steering axis, up.
  Vec3 steerAxis() const;
  /// Where the axis meets the ground.
  Vec3 steerFoot() const { return {wheelbase + trail, 0.0, 0.0}; }
};

}  // namespace dynamy::motorbike
