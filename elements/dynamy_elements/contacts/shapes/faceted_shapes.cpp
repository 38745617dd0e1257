#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy_elements/contacts/shapes/faceted_shapes.hpp>
#include <dynamy_elements/contacts/shapes/shape_file.hpp>

namespace dynamy {
namespace {

ShapeGeometry faceted(ShapeType type, const std::vector<Vec3>& points,
                      const std::vector<Triangle>& triangles, const std::string& colour) {
  ShapeGeometry g{type, {}, {}, colour};
  for (const Triangle& t : triangles)
    for (const int i : t) g.points.push_back(points[static_cast<std::size_t>(i)]);
  return g;
}

}  // namespace

void PolyhedronShape::declare(Attributes& a) {
  a.about(
      "Convex hull of points, or of a mesh file; mass properties from its volume. Touches all "
      "shapes "
      "in space but lines (doc/shape_pairs.md). Its cost grows with its corners: `dynamy import` "
      "makes convex pieces with few of a mesh.");
  declareShapeFile(a, "x y z of four or more points");
  a.example(
      "<Polyhedron points=\"0 0 0  1 0 0  0 1 0  0 0 1\" density=\"2500\" material=\"stone\"/>");
}

PolyhedronShape::PolyhedronShape(const Parameters& x) : Shape(x) {
  TriangleMesh mesh;
  const ParameterValue& given = x[readShapeFile(x, mesh) ? "file" : "points"];
  const std::vector<Vec3> all = x.has("file") ? mesh.points : triples(given, "points", 4);
  triangles_ = convexHull(all);
  if (triangles_.empty())
    throw given.fault("the points lie in one plane", "they enclose no volume", 0,
                      given.text.size());
  // Points inside the hull are left out.
  std::vector<int> number(all.size(), -1);
  for (Triangle& t : triangles_)
    for (int& i : t) {
      int& at = number[static_cast<std::size_t>(i)];
      if (at < 0)
        at = static_cast<int>(points_.size()), points_.push_back(all[static_cast<std::size_t>(i)]);
      i = at;
    }
  mass_ = enclosed(points_, triangles_);
}

ShapeGeometry PolyhedronShape::geometry() const {
  return faceted(ShapeType::polyhedron, points_, triangles_, colour());
}

void MeshShape::declare(Attributes& a) {
  a.about(
      "Ground of triangles with one side, the one from which their corners run counterclockwise. "
      "All shapes but points, lines, half spaces and meshes touch its faces, and edges and corners "
      "that stand out. Without a material it is a picture. It has a volume if its triangles "
      "enclose "
      "one.");
  declareShapeFile(a, "x y z of three or more points");
  Attribute& triangles = a.add(AttributeType::vector, "triangles", std::nullopt,
                               "with points: i j k, numbers of three points, from 0, each");
  triangles.size = 0;
  triangles.mayBeAbsent();
  a.example("<Mesh points=\"0 0 0  1 0 0  0 1 0\" triangles=\"0 1 2\" material=\"stone\"/>");
}

MeshShape::MeshShape(const Parameters& x) : Shape(x) {
  if (!readShapeFile(x, mesh_))
    readTriangles(x);
  else if (x.has("triangles"))
    throw x["triangles"].fault("belongs to points; the file has its own", "", 0,
                               x["triangles"].text.size());
  if (closed(mesh_)) mass_ = enclosed(mesh_);
  if (!(mass_.volume > 0.0)) mass_ = {};
}

void MeshShape::readTriangles(const Parameters& x) {
  mesh_.points = triples(x["points"], "points", 3);
  if (!x.has("triangles"))
    throw x["points"].fault("triangles are missing", "triangles=\"0 1 2\"", 0,
                            x["points"].text.size());
  const ParameterValue& given = x["triangles"];
  for (const Vec3& t : triples(given, "triangles", 1)) {
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double i = t[static_cast<Eigen::Index>(k)];
      if (i < 0.0 || i >= static_cast<double>(mesh_.points.size()) || i != std::floor(i))
        throw given.fault("no point number " + numberText(i),
                          "there are 0 to " + std::to_string(mesh_.points.size() - 1), 0,
                          given.text.size());
      triangle[k] = static_cast<int>(i);
    }
    const auto at = [&](std::size_t k) {
      return mesh_.points[static_cast<std::size_t>(triangle[k])];
    };
    if (!((at(1) - at(0)).cross(at(2) - at(0)).norm() > 0.0))
      throw given.fault("triangle " + std::to_string(mesh_.triangles.size()) + " has no area", "",
                        0, given.text.size());
    mesh_.triangles.push_back(triangle);
  }
}

ShapeGeometry MeshShape::geometry() const {
  return faceted(ShapeType::mesh, mesh_.points, mesh_.triangles, colour());
}

void HeightFieldShape::declare(Attributes& a) {
  a.about(
      "Ground of heights z over a grid in x and y, two triangles to a cell; matter is below. All "
      "shapes but points, lines, half spaces and meshes touch it. It carries no mass.");
  a.add(AttributeType::integer, "columns", std::nullopt, "points along x").atLeast(2);
  a.requiredVector("heights", Unit::length, 0, "z of the points, row by row along x");
  a.vector("spacing", Unit::length, 2, "1 1", "of the points along x and y").positive();
  a.example(
      "<HeightField columns=\"3\" heights=\"0 0 0  0 0.1 0  0 0 0\" spacing=\"0.5 0.5\" "
      "material=\"sand\"/>");
}

HeightFieldShape::HeightFieldShape(const Parameters& x) : Shape(x) {
  const std::vector<double>& z = x["heights"].numbers;
  const auto columns = static_cast<std::size_t>(x["columns"].integer()), rows = z.size() / columns;
  if (rows < 2 || rows * columns != z.size())
    throw x["heights"].fault(
        "whole rows of " + std::to_string(columns) + " heights are needed, two or more",
        "here are " + std::to_string(z.size()) + " numbers", 0, x["heights"].text.size());
  const Eigen::VectorXd spacing = x["spacing"].vector();
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i)
      points_.emplace_back(static_cast<double>(i) * spacing[0], static_cast<double>(j) * spacing[1],
                           z[j * columns + i]);
  for (std::size_t j = 0; j + 1 < rows; ++j)
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const int a = static_cast<int>(j * columns + i), b = a + 1, c = a + static_cast<int>(columns),
                d = c + 1;
      triangles_.push_back({a, b, d}), triangles_.push_back({a, d, c});
    }
}

ShapeGeometry HeightFieldShape::geometry() const {
  return faceted(ShapeType::mesh, points_, triangles_, colour());
}

}  // namespace dynamy
