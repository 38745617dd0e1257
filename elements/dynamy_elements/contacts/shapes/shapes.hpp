/// Shapes: geometry, volume and inertia for unit density.
///
/// This file has spheres and the shapes with corners, points and planes; round_shapes.hpp has those
/// about an axis. Each class consists of its declaration and closed formulas. Which parts of a
/// shape can touch is defined in contacts/shapes/touching_shape.hpp.
#pragma once
#include <dynamy/system/shape.hpp>

namespace dynamy {

/// Ball of a radius about its origin.
class Sphere final : public Shape {
 public:
  static void declare(Attributes& a);
  explicit Sphere(const Parameters& x);
  ShapeGeometry geometry() const override;
  MassProperties massProperties() const override;

 private:
  double radius_;
};

/// Cuboid with edges along its axes; `points` are the eight corners, or the four of a plane box.
class Box final : public Shape {
 public:
  static void declare(Attributes& a);
  explicit Box(const Parameters& x);
  ShapeGeometry geometry() const override;
  MassProperties massProperties() const override;

 private:
  Vec3 size_;
};

/// { n·(r − position) ≤ 0 }: everything below the plane is matter.
class HalfSpace final : public Shape {
 public:
  static void declare(Attributes& a);
  explicit HalfSpace(const Parameters& x);
  ShapeGeometry geometry() const override;

 private:
  Vec3 normal_;
};

/// A point that can touch, drawn as a dot.
class PointShape final : public Shape {
 public:
  static void declare(Attributes& a);
  explicit PointShape(const Parameters& x);
  ShapeGeometry geometry() const override;

 private:
  double radius_;
};

/// Open line through points; drawn.
class LineShape final : public Shape {
 public:
  static void declare(Attributes& a);
  explicit LineShape(const Parameters& x);
  ShapeGeometry geometry() const override;

 private:
  std::vector<Vec3> points_;
};

/// Closed polygon through points; drawn.
class PolygonShape final : public Shape {
 public:
  static void declare(Attributes& a);
  explicit PolygonShape(const Parameters& x);
  ShapeGeometry geometry() const override;

 private:
  std::vector<Vec3> points_;
};

}  // namespace dynamy
