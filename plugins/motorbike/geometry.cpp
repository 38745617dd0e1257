#include "geometry.hpp"

#include <cmath>

namespace dynamy::motorbike {
namespace {

void declareWheel(Attributes& a, const std::string& of, const char* radius, const char* mass,
                  const char* inertia, const char* tube) {
  const auto number = [&a](const std::string& name, Unit unit, const char* value,
                           const std::string& text) -> Attribute& {
    Attribute& out = a.add(AttributeType::number, name, value, text);
    out.unit = unit;
    return out;
  };
  number(of + "Radius", Unit::length, radius, "radius of the " + of + " wheel with its tyre")
      .positive();
  number(of + "Tube", Unit::length, tube,
         "radius of the tyre's section; 0: an edge, Radius: a ball")
      .nonNegative();
  number(of + "Mass", Unit::mass, mass, "mass of the " + of + " wheel").positive();
  a.vector(of + "Inertia", Unit::inertia, 2, inertia, "about a diameter, about the axle")
      .positive();
}

void declareBody(Attributes& a, const std::string& of, const char* mass, const char* centre,
                 const char* inertia, const std::string& text) {
  Attribute& m = a.add(AttributeType::number, of + "Mass", mass, "mass of " + text);
  m.unit = Unit::mass;
  m.positive();
  a.vector(of + "Centre", Unit::length, 2, centre,
           "its centre of mass: ahead of the rear contact, above the ground");
  a.vector(of + "Inertia", Unit::inertia, 4, inertia,
           "Jxx Jyy Jzz Jxz about it, x forward, z up, the product as entry of the matrix");
}

void declareSuspension(Attributes& a, const std::string& of, double k, double d) {
  a.optional(of + "Stiffness", Unit::stiffness, k, "spring of the " + of + " travel").nonNegative();
  a.optional(of + "Damping", Unit::damping, d, "damper of the " + of + " travel").nonNegative();
  a.optional(of + "Preload", Unit::force, 0.0, "force of the spring at no travel");
}

Wheel readWheel(const Parameters& x, const std::string& of, double at) {
  Wheel out;
  out.m = x[of + "Mass"], out.radius = x[of + "Radius"], out.tube = x[of + "Tube"];
  if (out.tube > out.radius)
    throw x[of + "Tube"].fault("a tyre thicker than its wheel", "at most the radius: a ball", 0,
                               x[of + "Tube"].text.size());
  const Eigen::VectorXd J = x[of + "Inertia"].vector();
  out.J_S = Vec3(J[0], J[1], J[0]).asDiagonal();
  out.r_OS = Vec3(at, 0.0, out.radius);
  return out;
}

Part readBody(const Parameters& x, const std::string& of) {
  Part out;
  out.m = x[of + "Mass"];
  const Eigen::VectorXd centre = x[of + "Centre"].vector(), J = x[of + "Inertia"].vector();
  out.r_OS = Vec3(centre[0], 0.0, centre[1]);
  out.J_S = Vec3(J[0], J[1], J[2]).asDiagonal();
  out.J_S(0, 2) = out.J_S(2, 0) = J[3];
  if (!(J[0] > 0.0 && J[1] > 0.0 && J[0] * J[2] > J[3] * J[3]))
    throw x[of + "Inertia"].fault("the inertia is not positive", "principal moments must be > 0", 0,
                                  x[of + "Inertia"].text.size());
  return out;
}

Suspension readSuspension(const Parameters& x, const std::string& of) {
  return {x[of + "Stiffness"], x[of + "Damping"], x[of + "Preload"]};
}

}  // namespace

void Geometry::declare(Attributes& a) {
  a.optional("wheelbase", Unit::length, 1.40, "distance of the contacts when upright").positive();
  a.optional("trail", Unit::length, 0.09, "front contact behind the foot of the steering axis");
  a.add(AttributeType::number, "caster", "25deg", "how far the steering axis leans back").unit =
      Unit::angle;
  declareWheel(a, "rear", "0.31", "16", "0.36 0.66", "0.05");
  declareWheel(a, "front", "0.30", "12", "0.28 0.50", "0.04");
  declareBody(a, "frame", "240", "0.55 0.62", "22 30 24 -3", "the rear frame with its rider");
  declareBody(a, "fork", "14", "1.22 0.62", "0.9 0.9 0.35 0.25", "the fork with its handlebar");
  a.add(AttributeType::flag, "suspension", "false", "wheels have travel: two more coordinates");
  declareSuspension(a, "rear", 30000.0, 1500.0);
  declareSuspension(a, "front", 18000.0, 1200.0);
  a.optional("steerDamping", Unit::rotationalDamping, 0.0, "damper of the steering").nonNegative();
}

Geometry::Geometry(const Parameters& x)
    : wheelbase(x["wheelbase"]),
      trail(x["trail"]),
      caster(x["caster"]),
      rear(readWheel(x, "rear", 0.0)),
      front(readWheel(x, "front", wheelbase)),
      frame(readBody(x, "frame")),
      fork(readBody(x, "fork")),
      rearSuspension(readSuspension(x, "rear")),
      frontSuspension(readSuspension(x, "front")),
      suspended(x["suspension"].flag()),
      steerDamping(x["steerDamping"]) {}

Vec3 Geometry::steerAxis() const { return {-std::sin(caster), 0.0, std::cos(caster)}; }

}  // namespace dynamy::motorbike
