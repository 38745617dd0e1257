/// Contacts of lines and circles with tubes around them: edges, axes of cylinders, rims, tyres.
///
/// With the closest points x_A, x_B of two curves, their unit tangents t and curvatures k = dt/ds,
///
///   d = x_B − x_A,   d·t_A = d·t_B = 0,   n = ±t_A × t_B/|t_A × t_B|,   g = n·d − r_A − r_B
///
/// which is exact before and after touching. The closest points move along the curves by ṡ_A, ṡ_B.
/// These follow from d·t = 0 for all times, with w = v_B(x_B) − v_A(x_A) and c = t_A·t_B:
///
///   (1 − d·k_A) ṡ_A − c ṡ_B = w·t_A + d·(Ω_A × t_A)
///   c ṡ_A − (1 + d·k_B) ṡ_B = w·t_B + d·(Ω_B × t_B)                              (theory 38.2)
///
/// n = d/|d| alone was rejected: sharp edges and rims have d = 0 where they touch. This n is used
/// only for tangents that are nearly parallel.
#pragma once
#include <dynamy_elements/contacts/shapes/contact_geometry.hpp>

namespace dynamy {

/// A point of a line or circle that moves with a frame.
struct BodyCurve {
  const Frame* frame = nullptr;
  Vec3 x = Vec3::Zero(), t = Vec3::Zero();  ///< point [m] and unit tangent
  Vec3 c = Vec3::Zero(), a = Vec3::Zero();  ///< circle: its middle [m] and axis
  double rho = 0.0;                         ///< circle: its radius; 0: a line [m]
  double r = 0.0;                           ///< radius of the tube around the curve [m]

  static BodyCurve line(const Frame& f, const Vec3& o, const Vec3& e, double tube) {
    return {&f, o, e, o, e, 0.0, tube};
  }
  /// A circle, at its outermost point along the direction `d`, which is not along the axis.
  static BodyCurve circle(const Frame& f, const Vec3& middle, const Vec3& axis, double radius,
                          double tube, const Vec3& d);
  Vec3 curvature() const { return rho > 0.0 ? Vec3((c - x) / (rho * rho)) : Vec3(Vec3::Zero()); }
  /// Moves the point along the curve by `way` [m].
  void go(double way);
  Vec3 velocity() const { return frame->velocity(x - frame->r_OS_I); }
};

/// Moves the points of both curves to the closest points near them; false: there are none.
bool toClosest(BodyCurve& A, BodyCurve& B);
/// Contact of two curves at their closest points; `towardsB`: approximate direction of the normal.
ContactPoint curveOnCurve(const BodyCurve& A, const BodyCurve& B, const Vec3& towardsB);
/// Contact of a ball of radius R about the point p of B with A, at the closest point of A.
/// `towardsB`: the normal if p is on A.
ContactPoint pointOnCurve(const BodyCurve& A, const Frame& B, const Vec3& p, double R,
                          const Vec3& towardsB);

}  // namespace dynamy
