#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy_elements/contacts/shapes/round_shapes.hpp>
#include <numbers>

namespace dynamy {
namespace {

Mat3 roundInertia(double a, double b, double c) { return Vec3(a, b, c).asDiagonal(); }

}  // namespace

void CircleShape::declare(Attributes& a) {
  a.about(
      "Circle about the shape's z axis. Where bodies move in its plane it touches what a ball does "
      "there (doc/shape_pairs.md).");
  a.required("radius", Unit::length, "radius").positive();
  a.example("<Circle radius=\"0.1\"/>");
}
CircleShape::CircleShape(const Parameters& x) : Shape(x), radius_(x["radius"]) {}
ShapeGeometry CircleShape::geometry() const { return {ShapeType::circle, {radius_}, {}, colour()}; }

void CylinderShape::declare(Attributes& a) {
  a.about(
      "Cylinder along z with sharp rims, a disc if it is short, a tube if it has a bore b: "
      "V = π (r² − b²) l, J_z = m (r² + b²)/2, J_x = m (3 (r² + b²) + l²)/12. Touches all shapes "
      "in "
      "space, all but contours and tori in a plane (doc/shape_pairs.md); nothing enters the bore.");
  a.required("radius", Unit::length, "radius").positive();
  a.required("length", Unit::length, "length along z").positive();
  a.optional("bore", Unit::length, 0.0, "radius of a hole along z; counts for the mass alone")
      .nonNegative();
  a.example("<Cylinder radius=\"0.1\" length=\"0.5\" mass=\"2\"/>");
}
CylinderShape::CylinderShape(const Parameters& x)
    : Shape(x), radius_(x["radius"]), length_(x["length"]), bore_(x["bore"]) {
  if (!(bore_ < radius_))
    throw ModelError(Diagnostic{.place = x["bore"].place,
                                .element = "Cylinder",
                                .text = "the bore is as wide as the cylinder",
                                .hint = "both are radii: bore < radius"});
}
ShapeGeometry CylinderShape::geometry() const {
  return {ShapeType::cylinder, {radius_, length_}, {}, colour()};
}
MassProperties CylinderShape::massProperties() const {
  const double r2 = radius_ * radius_, b2 = bore_ * bore_, V = kPi * (r2 - b2) * length_;
  const double Jx = V * (3.0 * (r2 + b2) + length_ * length_) / 12.0;
  return {V, Vec3::Zero(), roundInertia(Jx, Jx, 0.5 * V * (r2 + b2))};
}

void BoreShape::declare(Attributes& a) {
  a.about(
      "Wall of a hole along z: a bearing with play, a tube. In its own plane it touches circles, "
      "spheres, capsules and the corners of boxes and polygons inside, in space spheres and "
      "cylinders (doc/shape_pairs.md). It has no mass; nothing is outside of it.");
  a.required("radius", Unit::length, "radius of the hole").positive();
  Attribute& length = a.add(AttributeType::number, "length", std::nullopt,
                            "length along z; bodies in space need it");
  length.unit = Unit::length;
  length.mayBeAbsent().positive();
  a.example("<Bore radius=\"0.0501\" length=\"0.08\" material=\"bronze\"/>");
}
BoreShape::BoreShape(const Parameters& x)
    : Shape(x), radius_(x["radius"]), length_(x.has("length") ? double(x["length"]) : 0.0) {}
ShapeGeometry BoreShape::geometry() const {
  // Drawn from inside: the wall, and a narrow ring at both ends, which is seen along the axis.
  constexpr int kSides = 48;
  constexpr double kRing = 1.06;  // outer radius of the rings, of the radius
  ShapeGeometry g{ShapeType::bore, {radius_, length_}, {}, colour()};
  const double half = length_ > 0.0 ? 0.5 * length_ : 0.1 * radius_;
  const auto at = [&](int i, double size, double z) {
    const double phi = 2.0 * kPi * i / kSides;
    return Vec3(size * radius_ * std::cos(phi), size * radius_ * std::sin(phi), z);
  };
  // Two triangles between two edges of a strip, counterclockwise seen from the open side.
  const auto strip = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    for (const Vec3& p : {a, b, c, a, c, d}) g.points.push_back(p);
  };
  for (int i = 0; i < kSides; ++i) {
    strip(at(i, 1.0, -half), at(i, 1.0, half), at(i + 1, 1.0, half), at(i + 1, 1.0, -half));
    strip(at(i, 1.0, half), at(i, kRing, half), at(i + 1, kRing, half), at(i + 1, 1.0, half));
    strip(at(i, kRing, -half), at(i, 1.0, -half), at(i + 1, 1.0, -half), at(i + 1, kRing, -half));
  }
  return g;
}

void CapsuleShape::declare(Attributes& a) {
  a.about(
      "Cylinder along z with half balls on its ends: V = π r² l + 4/3 π r³. Touches all shapes in "
      "space, all but contours and tori in a plane (doc/shape_pairs.md).");
  a.required("radius", Unit::length, "radius").positive();
  a.required("length", Unit::length, "distance of the centres of the two half balls").positive();
  a.example("<Capsule radius=\"0.1\" length=\"0.5\" mass=\"2\"/>");
}
CapsuleShape::CapsuleShape(const Parameters& x)
    : Shape(x), radius_(x["radius"]), length_(x["length"]) {}
ShapeGeometry CapsuleShape::geometry() const {
  return {ShapeType::capsule, {radius_, length_}, {}, colour()};
}
MassProperties CapsuleShape::massProperties() const {
  // Cylinder and two half balls; each half ball has its centre of mass 3/8 r beyond its plane.
  const double r = radius_, r2 = r * r, l = length_;
  const double cylinder = kPi * r2 * l, ball = 4.0 / 3.0 * kPi * r2 * r;
  const double Jz = 0.5 * cylinder * r2 + 0.4 * ball * r2;
  const double Jx =
      cylinder * (3.0 * r2 + l * l) / 12.0 + ball * (0.4 * r2 + 0.375 * r * l + 0.25 * l * l);
  return {cylinder + ball, Vec3::Zero(), roundInertia(Jx, Jx, Jz)};
}

void ConeShape::declare(Attributes& a) {
  a.about(
      "Cone along z, base circle at z = 0, tip at z = l, hollow if it has a bore b at its base: V "
      "= "
      "π (r² − b²) l/3, centre of mass at l/4, J_z = 3/10 m (r² + b²), J_x = 3/80 m (4 (r² + b²) + "
      "l²). Touches all shapes in space, all but contours and tori in a plane "
      "(doc/shape_pairs.md); nothing enters the bore.");
  a.required("radius", Unit::length, "radius of the base").positive();
  a.required("length", Unit::length, "height of the tip").positive();
  a.optional("bore", Unit::length, 0.0,
             "radius at the base of a conical hole with the same tip; counts for the mass alone")
      .nonNegative();
  a.example("<Cone radius=\"0.1\" length=\"0.3\" mass=\"1\" material=\"wood\"/>");
}
ConeShape::ConeShape(const Parameters& x)
    : Shape(x), radius_(x["radius"]), length_(x["length"]), bore_(x["bore"]) {
  if (!(bore_ < radius_))
    throw x["bore"].fault("the bore is as wide as the cone", "both are radii: bore < radius", 0,
                          x["bore"].text.size());
}
ShapeGeometry ConeShape::geometry() const {
  return {ShapeType::cone, {radius_, length_}, {}, colour()};
}
MassProperties ConeShape::massProperties() const {
  // Both cones have the same height, thus the same centre; r⁴ − b⁴ = (r² − b²)(r² + b²).
  const double r2 = radius_ * radius_, b2 = bore_ * bore_, V = kPi * (r2 - b2) * length_ / 3.0;
  const double Jx = 3.0 / 80.0 * V * (4.0 * (r2 + b2) + length_ * length_);
  return {V, Vec3(0.0, 0.0, 0.25 * length_), roundInertia(Jx, Jx, 0.3 * V * (r2 + b2))};
}

void TorusShape::declare(Attributes& a) {
  a.about(
      "Tube of radius r around a circle of radius R about z, a tyre: V = 2 π² R r², J_z = m (R² + "
      "3/4 r²), J_x = m (R²/2 + 5/8 r²). Touches all shapes in space, none of which passes through "
      "its hole, and half spaces in a plane (doc/shape_pairs.md).");
  a.required("radius", Unit::length, "radius R of the circle in the middle of the tube").positive();
  a.required("tube", Unit::length,
             "radius r of the tube; 0: a circle, which touches half spaces and spheres")
      .nonNegative();
  a.example("<Torus radius=\"0.3\" tube=\"0.05\" mass=\"2\" material=\"rubber\"/>");
}
TorusShape::TorusShape(const Parameters& x) : Shape(x), radius_(x["radius"]), tube_(x["tube"]) {
  if (tube_ > radius_)
    throw x["tube"].fault("a tube of this radius overlaps itself",
                          "at most the radius of the circle", 0, x["tube"].text.size());
}
ShapeGeometry TorusShape::geometry() const {
  return {ShapeType::torus, {radius_, tube_}, {}, colour()};
}
MassProperties TorusShape::massProperties() const {
  const double R2 = radius_ * radius_, r2 = tube_ * tube_, V = 2.0 * kPi * kPi * radius_ * r2;
  const double Jx = V * (0.5 * R2 + 0.625 * r2);
  return {V, Vec3::Zero(), roundInertia(Jx, Jx, V * (R2 + 0.75 * r2))};
}

void EllipsoidShape::declare(Attributes& a) {
  a.about(
      "Ellipsoid about its origin: V = 4/3 π a b c, J_x = m (b² + c²)/5, … Touches all shapes in "
      "space, all but contours and tori in a plane (doc/shape_pairs.md).");
  a.requiredVector("semiAxes", Unit::length, 3, "half of its lengths along x, y, z").positive();
  a.example("<Ellipsoid semiAxes=\"0.3 0.2 0.1\" mass=\"1\" material=\"stone\"/>");
}
EllipsoidShape::EllipsoidShape(const Parameters& x) : Shape(x), semiAxes_(x["semiAxes"].vec3()) {}
ShapeGeometry EllipsoidShape::geometry() const {
  return {ShapeType::ellipsoid, {semiAxes_.x(), semiAxes_.y(), semiAxes_.z()}, {}, colour()};
}
MassProperties EllipsoidShape::massProperties() const {
  const Vec3 s = semiAxes_.cwiseAbs2();
  const double V = 4.0 / 3.0 * kPi * semiAxes_.prod();
  return {V, Vec3::Zero(),
          roundInertia(V * (s.y() + s.z()) / 5.0, V * (s.x() + s.z()) / 5.0,
                       V * (s.x() + s.y()) / 5.0)};
}

}  // namespace dynamy
