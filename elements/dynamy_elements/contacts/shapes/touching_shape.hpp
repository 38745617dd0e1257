/// TouchingShape: the parts of a shape that can touch others, its features.
///
/// A feature is a convex part of the shape, given by its support function h(d) = max of d·x over
/// its points x, for |d| = 1 in axes of the frame. Its derivatives give the point x that touches a
/// plane with the outward normal −d, and the velocity of x over the body while d turns:
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
/// A rim that lies flat (s = 0) touches along its whole circle. Four points of the rim that are
/// fixed in the body then represent the circle, in addition to its lowest point.
#pragma once
#include <dynamy/system/topology.hpp>
#include <string>
#include <vector>

namespace dynamy {

/// The unit vector orthogonal to the axis a, |a| = 1, that is nearest to d. If d is nearly parallel
/// to a, the normalized d − (a·d) a has an amplified rounding error along a, which is removed in a
/// second step. Otherwise the lowest point of a rim that lies almost flat would be off the plane of
/// the rim by this error.
inline Vec3 unitAcross(const Vec3& d, const Vec3& a) {
  const Vec3 e = (d - a.dot(d) * a).normalized();
  return (e - a.dot(e) * a).normalized();
}

class Surface;
class Polyhedron;
class Contour;
class SmoothShape;
struct ShapeFamily;

/// A ball of radius R ≥ 0 about a point of the body: a ball, a corner, a point.
struct RoundFeature {
  Vec3 c_K = Vec3::Zero();  ///< centre from the frame's origin, in axes of the frame [m]
  double radius = 0.0;      ///< [m]
};

/// A convex part of a shape.
struct SupportFeature : RoundFeature {
  enum class Kind : std::uint8_t { ball, rim, ellipsoid, contour, smooth } kind = Kind::ball;
  bool flatOnly = false;       ///< touches only while the circle about `axis_K` lies almost flat
  Vec3 axis_K = Vec3::Zero();  ///< rim: a
  /// Rim, and points of it: radius of the circle; `radius` is that of the tube [m].
  double rho = 0.0;
  /// Ellipsoid: D² in axes of the frame [m²]. Contour: its axes, the third normal to its plane.
  /// Smooth shape: the axes of the shape.
  Mat3 square_K = Mat3::Zero();
  const Contour* contour = nullptr;     ///< borrowed
  const SmoothShape* smooth = nullptr;  ///< borrowed
  std::string name;                     ///< for names of contacts; empty: its shape's only one

  double support(const Vec3& d_K) const;        ///< h(d) [m]
  Vec3 point(const Vec3& d_K) const;            ///< x(d) [m]
  Mat3 pointDerivative(const Vec3& d_K) const;  ///< H(d) [m]
  /// Rim, and points of it: ρ s, by which the circle reaches beyond its middle along d [m].
  double lift(const Vec3& d_K) const;
  /// Can it touch a plane with the normal −d? A flat rim cannot, as all
  /// of its points are equally low.
  bool touches(const Vec3& d_K) const;
};

/// The data of a shape for contact: a half space, or a list of features.
struct TouchingShape {
  /// Kind of the shape. In a pair of shapes, A is the one whose kind comes later in this list.
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
    section,  ///< section of a round body, with corners
    polygon,
    box,
    polyhedron,
    surface,
    own,   ///< of a plug-in that computes its contacts (shape_pair.hpp)
    bore,  ///< the wall of a hole, which touches what is inside
    halfSpace
  } kind = Kind::none;
  const Shape* shape = nullptr;
  const ShapeFamily* family = nullptr;  ///< Kind::own: its family; borrowed
  FrameHandle frame;
  int system = -1;
  std::vector<SupportFeature> features;
  Vec3 n_K = Vec3::Zero();      ///< half space: its normal
  Vec3 p_K = Vec3::Zero();      ///< half space: a point of its plane; else the middle
  Vec3 grain_K = Vec3::Zero();  ///< unit vector along which friction differs, or zero
  Mat3 A_KB = Mat3::Identity();
  /// Half edge lengths of a box; for a capsule, cylinder, cone or bore: radius, radius, half length
  /// [m].
  Vec3 half = Vec3::Zero();
  const Surface* surface = nullptr;  ///< of a polyhedron or mesh; borrowed
  /// Is it a ball whose centre is the origin of its frame, so that rotations do not move it?
  bool isBall() const { return kind == Kind::ball && p_K.isZero(0.0); }
  /// Faces, edges and corners of a polyhedron, or of a box that may touch one,
  /// in axes of the shape; borrowed.
  const Polyhedron* polyhedron = nullptr;
  /// Corners of the section in a plane of motion, counterclockwise about its normal; empty if the
  /// section is not convex.
  std::vector<Vec3> polygon_K;
  double bound = 0.0;      ///< radius of a ball about the middle that holds the shape [m]
  double thickness = 0.0;  ///< half of its least width [m]; infinite: a point, or nothing passes it

  /// Is it a point or a line? Two of these have no inside, and thus no
  /// sides on which they could stay.
  bool isThin() const { return bound == 0.0 || thickness == 0.0; }

  bool isBox(std::size_t corners) const { return kind == Kind::box && features.size() == corners; }
};

/// Returns the features of a shape that can touch; Kind::none: it cannot touch. `plane_K`: normal
/// of the plane of motion in the shape's frame, or zero. In a plane of motion a shape is replaced
/// by its section: a box with an edge along the normal has four corners, a cylinder along the
/// normal is a ball.
TouchingShape touchingShape(const ShapeInstance& instance, const Vec3& plane_K);

}  // namespace dynamy
