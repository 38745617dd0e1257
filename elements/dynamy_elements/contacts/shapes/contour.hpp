/// Contour: a closed smooth curve r(φ) about a point (a cam), given by
/// a periodic spline of degree 5.
///
///   x = r (cos φ, sin φ),   κ = (r² + 2 r′² − r r″)/(r² + r′²)^{3/2}
///
/// A contour finds where a circle and where a plane touches it, with the curvature κ there. The
/// foot of a point c on the curve moves by ṡ = w·t/(1 + κ D) while c, at the distance D, moves by
/// w. A polygon with many edges was rejected: its normals jump, and with them the acceleration of a
/// follower. A cubic spline was rejected, too: the follower's jerk jumps 720 times per turn, and
/// steps of high order meet each jump.
#pragma once
#include <dynamy_elements/contacts/shapes/contact_geometry.hpp>

namespace dynamy {

class Contour {
 public:
  using Vec2 = Eigen::Vector2d;
  /// `radii`: r at equal angles from φ = 0 on, eight values or more [m].
  explicit Contour(std::vector<double> radii);

  /// A point of the curve with its directions; t runs counterclockwise, n points outwards.
  struct Point {
    Vec2 x, t, n;
    double curvature = 0.0;  ///< κ [1/m], negative where the curve is concave
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
  /// Returns r, r′ and r″ at φ.
  Vec3 radius(double phi) const;
  std::vector<double> r_, c_;  ///< r at the nodes, coefficients of the B-splines
  std::vector<Vec2> nodes_;
  double step_ = 0.0, least_ = 0.0, most_ = 0.0;
  bool convex_ = true;
};

/// Contact of a round feature of B with the contour of A in the plane of motion.
/// `contour.square_K`: axes of the contour, the third of which is the normal of its plane.
ContactPoint ballOnContour(const Frame& A, const SupportFeature& contour, const Frame& B,
                           const RoundFeature& ball, const Vec3& plane);

}  // namespace dynamy
