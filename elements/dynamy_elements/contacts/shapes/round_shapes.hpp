/// Round shapes: geometry, volume and inertia for unit density, closed forms.
#pragma once
#include <dynamy/system/shape.hpp>

namespace dynamy {

/// Circle about the shape's z axis; it touches others in its own plane only.
class CircleShape final : public Shape {
 public:
  static void declare(Attributes& a);
  explicit CircleShape(const Parameters& x);
  ShapeGeometry geometry() const override;

 private:
  double radius_;
};

/// Cylinder along the shape's z axis, solid or a tube.
class CylinderShape final : public Shape {
 public:
  static void declare(Attributes& a);
  explicit CylinderShape(const Parameters& x);
  ShapeGeometry geometry() const override;
  MassProperties massProperties() const override;

 private:
  double radius_, length_, bore_;
};

/// Wall of a hole about the shape's z axis; it touches what is inside of it.
class BoreShape final : public Shape {
 public:
  static void declare(Attributes& a);
  explicit BoreShape(const Parameters& x);
  ShapeGeometry geometry() const override;

 private:
  double radius_, length_;
};

/// Cylinder along z with half balls on both ends; `length` between their centres.
class CapsuleShape final : public Shape {
 public:
  static void declare(Attributes& a);
  explicit CapsuleShape(const Parameters& x);
  ShapeGeometry geometry() const override;
  MassProperties massProperties() const override;

 private:
  double radius_, length_;
};

/// Cone along z, solid or hollow: base circle at z = 0, tip at z = `length`.
class ConeShape final : public Shape {
 public:
  static void declare(Attributes& a);
  explicit ConeShape(const Parameters& x);
  ShapeGeometry geometry() const override;
  MassProperties massProperties() const override;

 private:
  double radius_, length_, bore_;
};

/// Torus about z: a tube around a circle.
class TorusShape final : public Shape {
 public:
  static void declare(Attributes& a);
  explicit TorusShape(const Parameters& x);
  ShapeGeometry geometry() const override;
  MassProperties massProperties() const override;

 private:
  double radius_, tube_;
};

/// Ellipsoid about its origin with semi-axes along its axes.
class EllipsoidShape final : public Shape {
 public:
  static void declare(Attributes& a);
  explicit EllipsoidShape(const Parameters& x);
  ShapeGeometry geometry() const override;
  MassProperties massProperties() const override;

 private:
  Vec3 semiAxes_;
};

}  // namespace dynamy
