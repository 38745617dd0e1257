/// Contour: a closed smooth curve r(φ) about a point, a cam, by a periodic spline of degree 5.
///
///   x = r (cos φ, sin φ),   κ = (r² + 2 r′² − r r″)/(r² + r′²)^{3/2}
///
/// Where a circle touches it and where a plane does, with the curvature: the foot of c wanders by
/// ṡ = w·t/(1 + κ D) while c moves by w, D its distance. A polygon with many edges was rejected:
/// its normals jump, and with them the acceleration of a follower. With a cubic spline its jerk
/// jumps, 720 times a turn, and steps of high order meet each jump.
#pragma once
#include <dynamy_elements/contacts/shapes/contact_geometry.hpp>

namespace dynamy {

class Contour {
 public:
  using Vec2 = Eigen::Vector2d;
  /// `radii`: at equal angles from φ = 0 on, eight or more [m].
  explicit Contour(std::vector<double> radii);

  /// A point with its directions; t runs counterclockwise, n points out.
  struct Point {
    Vec2 x, t, n;
    double curvature = 0.0;  ///< κ [1/m], negative where it goes in
  };
  Point at(double phi) const;
  /// The point nearest to c.
  Point nearest(const Vec2& c) const;
  /// The point furthest along d.
  Point furthest(const Vec2& d) const;
  bool convex() const { return convex_; }
  double least() const { return least_; }  ///< r [m]
  double most() const { return most_; }    ///< r [m]

 private:
  /// r, r′, r″.
  Vec3 radius(double phi) const;
  std::vector<double> r_, c_;  ///< r at the nodes, coefficients of the B-splines
  std::vector<Vec2> nodes_;
  double step_ = 0.0, least_ = 0.0, most_ = 0.0;
  bool convex_ = true;
};

/// Feature of B on the contour of A in the plane of motion. `axes_K`: of the contour's plane, the
/// third is its normal.
ContactPoint ballOnContour(const Frame& A, const SupportFeature& contour, const Frame& B,
                           const RoundFeature& ball, const Vec3& plane);

}  // namespace dynamy
