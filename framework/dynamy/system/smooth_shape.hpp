/// SmoothShape: a smooth convex body, known by the point that lies furthest in each direction.
///
///   h(d) = max over its points x of d·x,   x(d) = ∇h(d),   H(d) = ∇²h(d),   |d| = 1
///                                            [Schneider, Convex bodies, 1.7 and 2.5]
///
/// From x and H alone follow its contacts with half spaces, balls, ellipsoids, capsules, cylinders,
/// cones, tori, boxes, polyhedra, meshes and other smooth shapes (theory 38.2), its picture, and
/// with dA = D dσ, D the product of the principal radii, its mass properties:
///
///   ∫ f(x) dV = 1/(3 + k) ∫ f(x(d)) h(d) D(d) dσ(d)   over |d| = 1,   f homogeneous of degree k
///   D = ½ ((tr H)² − tr H²)
#pragma once
#include <dynamy/system/shape.hpp>

namespace dynamy {

class SmoothShape : public Shape {
 public:
  using Shape::Shape;
  /// x(d) [m] in axes of the shape, |d| = 1. The origin of these axes lies inside.
  virtual Vec3 point(const Vec3& d) const = 0;
  /// H(d) [m]: how x turns with d. Symmetric, H d = 0.
  virtual Mat3 pointDerivative(const Vec3& d) const = 0;

  /// Triangles between points x(d), for pictures.
  ShapeGeometry geometry() const override;
  /// By the integrals above, to about 1e-12. Override where they are known. Throws ModelError as
  /// requireConsistent() does.
  MassProperties massProperties() const override;
  const SmoothShape* smooth() const final { return this; }

  /// A ball about the origin of the axes that holds the shape, and a part of it that lies between
  /// any two parallel planes that touch it [m].
  struct Extent {
    double bound = 0.0, halfWidth = 0.0;
  };
  Extent extent() const;
  /// Throws ModelError if x(d) is not furthest along d, if H is not how it turns, or if the origin
  /// lies outside; tried in some directions.
  void requireConsistent() const;
};

}  // namespace dynamy
