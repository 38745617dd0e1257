// Attributes of all shapes: place in their frame, material, colour, mass.
#include <algorithm>
#include <cmath>
#include <dynamy/core/css_colour.hpp>
#include <dynamy/core/declared/mirror_plane.hpp>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/rotation.hpp>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/system/shape.hpp>
#include <dynamy/system/smooth_shape.hpp>
#include <limits>
#include <numbers>

namespace dynamy {
namespace {

/// True for texts that browsers draw: names and numbers, also with an opacity, or "" for none given.
bool isColour(const std::string& text) {
  if (text.empty() || text == "transparent" || cssColour(text)) return true;
  const std::size_t other = text.find_first_not_of("0123456789abcdefABCDEF", 1);
  if (text[0] == '#') return other == std::string::npos && (text.size() == 5 || text.size() == 9);
  return (text.starts_with("rgb") || text.starts_with("hsl")) && text.ends_with(')');
}

double furthest(const std::vector<Vec3>& points) {
  double out = 0.0;
  for (const Vec3& p : points) out = std::max(out, p.norm());
  return out;
}

}  // namespace

void declarePose(Attributes& a, const std::string& of) {
  a.vector("position", Unit::length, 3, "0 0 0", "origin of the " + of);
  a.vector("orientation", Unit::none, 4, "1 0 0 0",
           "axes of the " + of + ": quaternion w x y z, normalised here; angles stand in euler");
  a.vector("euler", Unit::angle, 3, "0 0 0",
           "instead of orientation: turns about the fixed axes x, then y, then z");
}

std::array<double, 4> orientation(const Parameters& x) {
  const ParameterValue &quaternion = x["orientation"], &euler = x["euler"];
  if (quaternion.given && euler.given)
    throw euler.fault("orientation is given twice", "give either orientation or euler", 0,
                      euler.text.size());
  std::array<double, 4> p{1.0, 0.0, 0.0, 0.0};
  if (euler.given) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (std::abs(euler.numbers[axis]) > 2.0 * std::numbers::pi)
        throw euler.fault("euler is in radians and turns more than once around",
                          "90deg is an angle in degrees", 0, euler.text.size());
    for (int axis = 0; axis < 3; ++axis) {
      double turn[4];
      axisQuaternion(Vec3::Unit(axis), euler.numbers[static_cast<std::size_t>(axis)], turn);
      quaternionProduct(turn, p.data(), p.data());
    }
    return p;
  }
  const Eigen::VectorXd v = quaternion.vector();
  if (!(v.norm() > 0.0))
    throw quaternion.fault("a quaternion of length 0 says no orientation",
                           "write 1 0 0 0 for axes that are not turned", 0, quaternion.text.size());
  for (int i = 0; i < 4; ++i) p[static_cast<std::size_t>(i)] = v[i] / v.norm();
  return p;
}

void Shape::declareCommon(Attributes& a) {
  declarePose(a, "shape in the frame that carries it");
  a.add(AttributeType::name, "material", "",
        "material; shapes with a material take part in contact, others are drawn only");
  a.vector(
      "grain", Unit::none, 3, "0 0 0",
      "direction along which friction differs (of a runner, of wood), in the shape's axes: the "
      "first tangent of its contacts");
  a.add(AttributeType::text, "colour", "",
        "colour of the picture: a name of CSS, or #rrggbb; default: by body");
  a.optional("mass", Unit::mass, 0.0, "mass of the shape; 0: not given").nonNegative();
  a.optional("density", Unit::density, 0.0, "instead of mass; 0: not given").nonNegative();
}

Shape::Shape(const Parameters& x)
    : Element(x),
      material_(x["material"].text),
      colour_(x["colour"].text),
      r_SB_K_(x["position"].vec3()),
      A_KB_(rotationMatrix(orientation(x).data())),
      mass_(x["mass"]),
      density_(x["density"]) {
  if (!isColour(colour_)) {
    const std::string near = nearestColour(colour_);
    throw x["colour"].fault(
        "\"" + colour_ + "\" is no colour of CSS",
        near.empty() ? "write a name such as \"red\", or \"#c8553d\"" : didYouMean(near), 0,
        colour_.size());
  }
  if (const Vec3 grain = x["grain"].vec3(); !grain.isZero(0.0)) grain_B_ = grain.normalized();
  if (mass_ > 0.0 && density_ > 0.0)
    throw x["density"].fault("mass and density are both given", "give one of them", 0,
                             x["density"].text.size());
}

bool Shape::isMirrored(const MirrorPlane& plane_B) const {
  if (material_.empty()) return true;
  const Vec3& n = plane_B.n;
  const bool within = plane_B.contains(Vec3::Zero());
  const bool acrossZ = plane_B.isNormal(Vec3::UnitZ()), alongZ = plane_B.isAlong(Vec3::UnitZ());
  if (smooth() != nullptr || ownContact().family != nullptr || !grain_B_.isZero(0.0)) return false;
  const ShapeGeometry g = geometry();
  switch (g.type) {
    case ShapeType::point:
    case ShapeType::sphere:
      return within;
    case ShapeType::box:
    case ShapeType::ellipsoid:
      for (int i = 0; i < 3; ++i)
        if (plane_B.isNormal(Vec3::Unit(i))) return within;
      return false;
    case ShapeType::cylinder:
    case ShapeType::capsule:
      return within && (acrossZ || alongZ);
    case ShapeType::cone:
      return within && alongZ;
    case ShapeType::halfSpace:
      return std::abs(n.dot(g.points.front())) <= 16.0 * kEpsilon;
    default:
      return false;
  }
}

double boundOf(const ShapeGeometry& g) {
  switch (g.type) {
    case ShapeType::point:
      return 0.0;
    case ShapeType::sphere:
    case ShapeType::circle:
      return g.size[0];
    case ShapeType::box:
      return 0.5 * Vec3(g.size[0], g.size[1], g.size[2]).norm();
    case ShapeType::cylinder:
    case ShapeType::bore:
      return std::hypot(g.size[0], 0.5 * g.size[1]);
    case ShapeType::capsule:
      return g.size[0] + 0.5 * g.size[1];
    case ShapeType::cone:
      return std::max(g.size[0], g.size[1]);
    case ShapeType::torus:
      return g.size[0] + g.size[1];
    case ShapeType::ellipsoid:
      return std::max({g.size[0], g.size[1], g.size[2]});
    case ShapeType::line:
    case ShapeType::polygon:
    case ShapeType::contour:
    case ShapeType::polyhedron:
    case ShapeType::mesh:
      return furthest(g.points);
    case ShapeType::halfSpace:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

double boundOf(const Shape& shape) {
  if (const OwnContact own = shape.ownContact(); own.family != nullptr) return own.bound;
  if (const SmoothShape* smooth = shape.smooth()) return smooth->extent().bound;
  return boundOf(shape.geometry());
}

}  // namespace dynamy
