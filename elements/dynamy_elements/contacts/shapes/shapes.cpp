#include <dynamy/core/constants.hpp>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy_elements/contacts/shapes/shapes.hpp>
#include <numbers>

namespace dynamy {
namespace {

Mat3 diagonal(double a, double b, double c) { return Vec3(a, b, c).asDiagonal(); }

/// Points of three numbers each. Throws ModelError for another count or fewer than `least` points.
std::vector<Vec3> readPoints(const Parameters& x, std::size_t least) {
  const ParameterValue& value = x["points"];
  const std::size_t n = value.numbers.size();
  if (n % 3 != 0 || n < 3 * least)
    throw value.fault(
        "a list of at least " + std::to_string(least) + " points with three numbers each is needed",
        "here are " + std::to_string(n) + " numbers", 0, value.text.size());
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < n; i += 3)
    out.emplace_back(value.numbers[i], value.numbers[i + 1], value.numbers[i + 2]);
  return out;
}

}  // namespace

// ---- Sphere ------------------------------------------------------------------------------------

void Sphere::declare(Attributes& a) {
  a.about(
      "Ball: V = 4/3 π r³, J = 2/5 m r². Touches all shapes but tori in a "
      "plane (doc/shape_pairs.md).");
  a.required("radius", Unit::length, "radius").positive();
  a.example("<Sphere radius=\"0.1\" mass=\"1\" material=\"rubber\"/>");
}
Sphere::Sphere(const Parameters& x) : Shape(x), radius_(x["radius"]) {}
ShapeGeometry Sphere::geometry() const { return {ShapeType::sphere, {radius_}, {}, colour()}; }
MassProperties Sphere::massProperties() const {
  const double V = 4.0 / 3.0 * kPi * radius_ * radius_ * radius_, J = 0.4 * V * radius_ * radius_;
  return {V, Vec3::Zero(), diagonal(J, J, J)};
}

// ---- Box ---------------------------------------------------------------------------------------

void Box::declare(Attributes& a) {
  a.about(
      "Cuboid about its origin with edges along its axes: V = a b c, J_x = m (b² + c²)/12, … "
      "Touches all shapes but lines in space, all but contours and tori in a plane "
      "(doc/shape_pairs.md).");
  a.requiredVector("size", Unit::length, 3, "edge lengths along x, y, z").positive();
  a.example("<Box size=\"0.4 0.2 0.1\" density=\"2700\" material=\"steel\"/>");
}
Box::Box(const Parameters& x) : Shape(x), size_(x["size"].vec3()) {}
ShapeGeometry Box::geometry() const {
  ShapeGeometry g{ShapeType::box, {size_.x(), size_.y(), size_.z()}, {}, colour()};
  for (int corner = 0; corner < 8; ++corner)
    g.points.emplace_back((corner & 1 ? 0.5 : -0.5) * size_.x(),
                          (corner & 2 ? 0.5 : -0.5) * size_.y(),
                          (corner & 4 ? 0.5 : -0.5) * size_.z());
  return g;
}
MassProperties Box::massProperties() const {
  const double V = size_.prod(), x = size_.x() * size_.x(), y = size_.y() * size_.y(),
               z = size_.z() * size_.z();
  return {V, Vec3::Zero(), diagonal(V * (y + z) / 12.0, V * (x + z) / 12.0, V * (x + y) / 12.0)};
}

// ---- HalfSpace ---------------------------------------------------------------------------------

void HalfSpace::declare(Attributes& a) {
  a.about(
      "All matter below the plane through `position` with the outward normal n: gap of a point P "
      "is "
      "g = n·(r_OP − position).");
  a.vector("normal", Unit::none, 3, "0 0 1", "outward normal in the shape's axes, normalised here")
      .notZero();
  a.example("<HalfSpace normal=\"0 0 1\" material=\"concrete\"/>");
}
HalfSpace::HalfSpace(const Parameters& x) : Shape(x), normal_(x["normal"].vec3()) {
  if (!(normal_.norm() > 0.0))
    throw x["normal"].fault("a normal of length 0 says no direction", "", 0,
                            x["normal"].text.size());
  normal_.normalize();
}
ShapeGeometry HalfSpace::geometry() const {
  return {ShapeType::halfSpace, {}, {normal_}, colour()};
}

// ---- shapes of points --------------------------------------------------------------------------

void PointShape::declare(Attributes& a) {
  a.about(
      "A point that touches all shapes but points, lines, meshes and height fields, and tori in a "
      "plane; drawn as a dot (doc/shape_pairs.md).");
  a.optional("radius", Unit::length, 0.0, "radius of the dot in the picture; no part of contact")
      .nonNegative();
  a.example("<Point position=\"0 0 -0.1\" material=\"steel\"/>");
}
PointShape::PointShape(const Parameters& x) : Shape(x), radius_(x["radius"]) {}
ShapeGeometry PointShape::geometry() const {
  return {ShapeType::point, {radius_}, {Vec3::Zero()}, colour()};
}

void LineShape::declare(Attributes& a) {
  a.about(
      "Open line through points. One of two points touches what a capsule does, but no points, "
      "lines and, in space, shapes with edges (doc/shape_pairs.md); others are drawn only.");
  a.requiredVector("points", Unit::length, 0, "x y z of two or more points");
  a.example("<Line points=\"0 0 0  0 0 -1\"/>");
}
LineShape::LineShape(const Parameters& x) : Shape(x), points_(readPoints(x, 2)) {}
ShapeGeometry LineShape::geometry() const { return {ShapeType::line, {}, points_, colour()}; }

void PolygonShape::declare(Attributes& a) {
  a.about(
      "Closed polygon through points. Where bodies move in its plane its corners touch half "
      "spaces, and, if it is convex, it touches all shapes but contours and tori "
      "(doc/shape_pairs.md).");
  a.requiredVector("points", Unit::length, 0, "x y z of three or more points");
  a.example("<Polygon points=\"0 0 0  1 0 0  0 0 1\"/>");
}
PolygonShape::PolygonShape(const Parameters& x) : Shape(x), points_(readPoints(x, 3)) {}
ShapeGeometry PolygonShape::geometry() const { return {ShapeType::polygon, {}, points_, colour()}; }

}  // namespace dynamy
