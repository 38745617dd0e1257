/// SmoothShape: a smooth convex body, given by its furthest point in each direction.
///
///   h(d) = max over its points x of d·x,   x(d) = ∇h(d),   H(d) = ∇²h(d),   |d| = 1
///                                            [Schneider, Convex bodies, 1.7 and 2.5]
///
/// x and H alone determine the contacts of the body with half spaces, balls, ellipsoids, capsules,
/// cylinders, cones, tori, boxes, polyhedra, meshes and other smooth shapes (theory 38.2), and its
/// picture. With dA = D dσ, D the product of the principal radii, they also determine its mass
/// properties:
///
///   ∫ f(x) dV = 1/(3 + k) ∫ f(x(d)) h(d) D(d) dσ(d)   over |d| = 1,   f homogeneous of degree k
///   D = ½ ((tr H)² − tr H²)
#pragma once
#include <dynamy/system/shape.hpp>

namespace dynamy {

class SmoothShape : public Shape {
 public:
  using Shape::Shape;
  /// x(d) [m] in axes of the shape, |d| = 1. The origin of these axes lies inside the shape.
  virtual Vec3 point(const Vec3& d) const = 0;
  /// H(d) [m]: derivative of x with respect to d. Symmetric, H d = 0.
  virtual Mat3 pointDerivative(const Vec3& d) const = 0;

  /// Triangles between points x(d), for pictures.
  ShapeGeometry geometry() const override;
  /// Mass properties from the integrals over |d| = 1, to about 1e-12. Override if they are known.
  /// Throws ModelError like requireConsistent().
  MassProperties massProperties() const override;
  const SmoothShape* smooth() const final { return this; }

  /// Radius `bound` of a ball about the origin of the axes that contains the shape, and half of the
  /// least distance between two parallel planes that touch the shape from both sides [m].
  struct Extent {
    double bound = 0.0, halfWidth = 0.0;
  };
  Extent extent() const;
  /// Throws ModelError if x(d) is not the furthest point along d, if H is not its derivative or has
  /// a negative eigenvalue, or if the origin lies outside. Checked in some directions.
  void requireConsistent() const;
};

}  // namespace dynamy
