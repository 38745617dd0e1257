/// A shape as contact sees it: what of it can touch.
///
/// A feature is a convex part of the shape by its support function: h(d) = max over its points x of
/// d·x, for |d| = 1 in axes of the frame. The point that touches a plane with the outward normal
/// −d, and how it wanders while d turns, are the derivatives:
///
///   x = ∇h(d),   ẋ = H ḋ,   H = ∇²h(d)                      [Schneider, Convex bodies, 1.7
///   and 2.5]
///
///   ball (corner, point: R = 0)   h = d·c + R             H = R (I − d dᵀ)
///   rim: tube of radius r around  h = d·c + ρ s + r       H = ρ (I − a aᵀ − e eᵀ)/s + r (I − d dᵀ)
///     a circle of radius ρ about a                        s = |d − (a·d) a|,  e = (d − (a·d) a)/s
///   ellipsoid, D: semi-axes       h = d·c + |D d|         H = (D² − x xᵀ)/|D d|,   x = D² d/|D d|
///   contour, convex, in a plane   h = d·c + max_φ d·x(φ)  H = t tᵀ/κ
///   smooth shape                  h = d·c + d·x(d)        as the shape says (smooth_shape.hpp)
///
/// A rim that lies flat (s = 0) touches all around: four points of it that are fixed in the body
/// stand for the circle there, beside the lowest one.
#pragma once
#include <dynamy/system/topology.hpp>
#include <string>
#include <vector>

namespace dynamy {

/// The unit vector across the axis a, |a| = 1, nearest to d. d − (a·d) a of a d that is nearly
/// along a is off by its rounding over its length, along a: that part is taken out again, or the
/// lowest point of a rim that lies almost flat would be as far off its plane.
inline Vec3 unitAcross(const Vec3& d, const Vec3& a) {
  const Vec3 e = (d - a.dot(d) * a).normalized();
  return (e - a.dot(e) * a).normalized();
}

class Surface;
class Polyhedron;
class Contour;
class SmoothShape;

/// A ball of radius R ≥ 0 about a point of the body: a ball, a corner, a point.
struct RoundFeature {
  Vec3 c_K = Vec3::Zero();  ///< in axes of the frame, from its origin [m]
  double radius = 0.0;      ///< [m]
};

/// A convex part of a shape.
struct SupportFeature : RoundFeature {
  enum class Kind : std::uint8_t { ball, rim, ellipsoid, contour, smooth } kind = Kind::ball;
  bool flatOnly = false;       ///< touches while the circle about `axis_K` lies almost flat
  Vec3 axis_K = Vec3::Zero();  ///< rim: a
  double rho = 0.0;            ///< rim: radius of the circle; `radius` is that of the tube [m]
  /// Ellipsoid: D² in axes of the frame [m²]. Contour: its axes, the third across its plane. Smooth
  /// shape: its axes.
  Mat3 square_K = Mat3::Zero();
  const Contour* contour = nullptr;     ///< borrowed
  const SmoothShape* smooth = nullptr;  ///< borrowed
  std::string name;                     ///< in names of contacts; empty: the shape has no other

  double support(const Vec3& d_K) const;        ///< h(d) [m]
  Vec3 point(const Vec3& d_K) const;            ///< x(d) [m]
  Mat3 pointDerivative(const Vec3& d_K) const;  ///< H(d) [m]
  /// Whether it can touch a plane with the normal −d: the lowest point of a flat rim is any.
  bool touches(const Vec3& d_K) const;
};

/// A shape as contact sees it: a half space, or its features.
struct TouchingShape {
  /// In a pair the shape of the later kind is A.
  enum class Kind : std::uint8_t {
    none,
    ball,
    capsule,
    cylinder,
    torus,
    cone,
    smooth,  ///< an ellipsoid, or a SmoothShape
    other,
    contour,
    section,  ///< of a round body, with corners
    polygon,
    box,
    polyhedron,
    surface,
    halfSpace
  } kind = Kind::none;
  const Shape* shape = nullptr;
  FrameHandle frame;
  int system = -1;
  std::vector<SupportFeature> features;
  Vec3 n_K = Vec3::Zero();      ///< half space: its normal
  Vec3 p_K = Vec3::Zero();      ///< half space: a point of its plane; else the middle
  Vec3 grain_K = Vec3::Zero();  ///< unit vector along which friction differs, or zero
  Mat3 A_KB = Mat3::Identity();
  /// Half edge lengths of a box; of a capsule, cylinder or cone: radius, radius, half length
  /// [m].
  Vec3 half = Vec3::Zero();
  const Surface* surface = nullptr;  ///< of a polyhedron or mesh; borrowed
  /// A ball that turns about its middle, which is that of its body.
  bool isBall() const { return kind == Kind::ball && p_K.isZero(0.0); }
  /// Of a polyhedron, or of a box that may meet one, in axes of the shape; borrowed.
  const Polyhedron* polyhedron = nullptr;
  /// Corners in a plane of motion if they are convex, counterclockwise about its normal.
  std::vector<Vec3> polygon_K;
  double bound = 0.0;      ///< radius of a ball about the middle that holds the shape [m]
  double thickness = 0.0;  ///< half of its least width; infinite: nothing passes it, or a point [m]

  /// A point or a line: no inside, and no side on which another without one would have to stay.
  bool isThin() const { return bound == 0.0 || thickness == 0.0; }

  bool isBox(std::size_t corners) const { return kind == Kind::box && features.size() == corners; }
};

/// Takes a shape apart. `plane`: normal of the plane of motion in the shape's frame, or zero; in a
/// plane a shape is its section: a box with an edge along the normal has four corners there, a
/// cylinder along it is a ball. Kind::none: cannot touch.
TouchingShape touchingShape(const ShapeInstance& instance, const Vec3& plane_K);

}  // namespace dynamy
