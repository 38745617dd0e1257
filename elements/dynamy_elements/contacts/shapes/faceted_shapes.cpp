#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy_elements/contacts/shapes/faceted_shapes.hpp>

namespace dynamy {
namespace {

/// Vectors of three numbers each. Throws ModelError for another count or fewer than `least`.
std::vector<Vec3> triples(const ParameterValue& value, const char* what, std::size_t least) {
  const std::size_t n = value.numbers.size();
  if (n % 3 != 0 || n < 3 * least)
    throw value.fault("a list of at least " + std::to_string(least) + " " + what +
                          " with three numbers each is needed",
                      "here are " + std::to_string(n) + " numbers", 0, value.text.size());
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < n; i += 3)
    out.emplace_back(value.numbers[i], value.numbers[i + 1], value.numbers[i + 2]);
  return out;
}

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
      "Convex hull of points; mass properties from its volume. Touches all shapes in space "
      "but lines (doc/shape_pairs.md).");
  a.requiredVector("points", Unit::length, 0, "x y z of four or more points");
  a.example(
      "<Polyhedron points=\"0 0 0  1 0 0  0 1 0  0 0 1\" density=\"2500\" material=\"stone\"/>");
}

PolyhedronShape::PolyhedronShape(const Parameters& x) : Shape(x) {
  const std::vector<Vec3> all = triples(x["points"], "points", 4);
  triangles_ = convexHull(all);
  if (triangles_.empty())
    throw x["points"].fault("the points lie in one plane", "they enclose no volume", 0,
                            x["points"].text.size());
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
      "that stand out. It carries no mass.");
  a.requiredVector("points", Unit::length, 0, "x y z of three or more points");
  a.requiredVector("triangles", Unit::none, 0, "i j k: numbers of three points, from 0, each");
  a.example("<Mesh points=\"0 0 0  1 0 0  0 1 0\" triangles=\"0 1 2\" material=\"stone\"/>");
}

MeshShape::MeshShape(const Parameters& x) : Shape(x), points_(triples(x["points"], "points", 3)) {
  const ParameterValue& given = x["triangles"];
  for (const Vec3& t : triples(given, "triangles", 1)) {
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double i = t[static_cast<Eigen::Index>(k)];
      if (i < 0.0 || i >= static_cast<double>(points_.size()) || i != std::floor(i))
        throw given.fault("no point number " + numberText(i),
                          "there are 0 to " + std::to_string(points_.size() - 1), 0,
                          given.text.size());
      triangle[k] = static_cast<int>(i);
    }
    const auto at = [&](std::size_t k) { return points_[static_cast<std::size_t>(triangle[k])]; };
    if (!((at(1) - at(0)).cross(at(2) - at(0)).norm() > 0.0))
      throw given.fault("triangle " + std::to_string(triangles_.size()) + " has no area", "", 0,
                        given.text.size());
    triangles_.push_back(triangle);
  }
}

ShapeGeometry MeshShape::geometry() const {
  return faceted(ShapeType::mesh, points_, triangles_, colour());
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
