/// Shapes with plane faces: convex polyhedra, triangle meshes and height fields. Their geometry
/// lists three points per triangle, counterclockwise seen from outside.
#pragma once
#include <dynamy/io/mesh/mesh_file.hpp>

namespace dynamy {

/// Convex hull of points.
class PolyhedronShape final : public Shape {
 public:
  static void declare(Attributes& a);
  explicit PolyhedronShape(const Parameters& x);
  ShapeGeometry geometry() const override;
  MassProperties massProperties() const override { return mass_; }

 private:
  std::vector<Vec3> points_;  ///< points on the hull
  std::vector<Triangle> triangles_;
  MassProperties mass_;
};

/// Triangles that can be touched from one side only: ground of any form, a picture of a body.
class MeshShape final : public Shape {
 public:
  static void declare(Attributes& a);
  explicit MeshShape(const Parameters& x);
  ShapeGeometry geometry() const override;
  MassProperties massProperties() const override { return mass_; }

 private:
  void readTriangles(const Parameters& x);
  TriangleMesh mesh_;
  MassProperties mass_;  ///< none if the triangles do not enclose a volume
};

/// Surface of the heights z over a grid in x and y; the ground lies below it.
class HeightFieldShape final : public Shape {
 public:
  static void declare(Attributes& a);
  explicit HeightFieldShape(const Parameters& x);
  ShapeGeometry geometry() const override;

 private:
  std::vector<Vec3> points_;
  std::vector<Triangle> triangles_;
};

}  // namespace dynamy
