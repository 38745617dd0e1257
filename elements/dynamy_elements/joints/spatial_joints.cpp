#include <cmath>
#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/joints/spatial_joints.hpp>
#include <numbers>

namespace dynamy {
namespace {

const Vec3& neededAxis(const Vec3& axis_I, const char* what) {
  if (axis_I.isZero(0.0))
    throw ModelError(std::string(what) + " needs an axis", "add axis=\"0 0 1\"");
  return axis_I;
}

/// The axis of B for build(), exactly perpendicular to that of A.
Vec3 perpendicular(const Vec3& b, const Vec3& a) { return (b - a.dot(b) * a).normalized(); }

}  // namespace

// ---- Universal ---------------------------------------------------------------------------------

void Universal::declare(Attributes& a) {
  a.about(
      "Universal (Cardan) joint: two frames share a point, and an axis fixed in A stays "
      "perpendicular to an axis fixed in B. 4 rows. Signals: alpha, the angle of B's axis about "
      "that of A, beta, the angle of B about its own, and their rates.");
  declareJoint(a);
  declareAxis(a, "axis fixed in A at the start, in the world");
  a.requiredVector("axisB", Unit::none, 3,
                   "axis fixed in B at the start, in the world, perpendicular to the other");
  a.example("<Universal between=\"world rod\" axis=\"0 1 0\" axisB=\"0 0 1\"/>");
}

Universal::Universal(const Parameters& x) : Joint(x), axisB_(x["axisB"].vec3()) {}

void Universal::build(JointRows& rows) const {
  const JointStart& s = rows.start;
  if (!s.plane.isZero(0.0)) refusePlane("planar bodies have the Revolute");
  const Vec3 &a = neededAxis(s.axis_I, "a universal joint"), b = axisB_.normalized();
  // Axes written with four digits are off by 1e-4: the tolerance accepts
  // them and rejects wrong axes.
  if (!(std::abs(a.dot(b)) < 1e-3))
    throw ModelError("the two axes are not perpendicular",
                     "axis is fixed in A, axisB in B; the cross joins them at a right angle");
  const Vec3 across = perpendicular(b, a);
  for (int i = 0; i < 3; ++i) rows.addPoint(Vec3::Unit(i));
  rows.addAngle(a, across);
  rows.measureTurn(a, across, "alpha", "alphaRate");
  rows.measureTurn(across, a, "beta", "betaRate", true);
}

bool Universal::freeMotions(const JointStart& s, std::vector<FreeMotion>& out) const {
  out.push_back({FreeMotion::Kind::turn, s.axis_I});
  out.push_back({FreeMotion::Kind::turn, perpendicular(axisB_.normalized(), s.axis_I)});
  return true;
}

// ---- Cylindrical, Screw ------------------------------------------------------------------------

void Cylindrical::declare(Attributes& a) {
  a.about(
      "B turns about an axis fixed in A and moves along it. 4 rows. Signals: displacement, angle "
      "(between -pi and pi), and their rates.");
  declareJoint(a);
  declareAxis(a, "axis at the start, in the world");
  a.example("<Cylindrical between=\"world rod\" axis=\"0 0 1\"/>");
}

void Cylindrical::build(JointRows& rows) const {
  const JointStart& s = rows.start;
  if (!s.plane.isZero(0.0)) refusePlane("planar bodies have the Revolute and the Prismatic");
  const Vec3& axis = neededAxis(s.axis_I, "a cylindrical joint");
  Vec3 t1, t2;
  tangents(axis, t1, t2);
  for (const Vec3& t : {t1, t2}) rows.addPoint(t);
  for (const Vec3& t : {t1, t2}) rows.addAngle(t, axis);
  rows.measureShift(axis, "displacement", "speed");
  rows.measureTurn(axis, t1, "angle", "rate");
}

bool Cylindrical::freeMotions(const JointStart& s, std::vector<FreeMotion>& out) const {
  out.push_back({FreeMotion::Kind::slide, s.axis_I});
  out.push_back({FreeMotion::Kind::turn, s.axis_I});
  return true;
}

void Screw::declare(Attributes& a) {
  a.about(
      "B turns about an axis fixed in A and moves along it by the pitch in each turn: displacement "
      "= pitch angle/(2 pi). 5 rows. A friction law acts about the axis. Signals: displacement, "
      "angle (between -pi and pi), and their rates.");
  declareJoint(a);
  declareAxis(a, "axis at the start, in the world");
  a.required("pitch", Unit::length, "advance in a turn, negative: left-handed").notZero();
  declareFriction(a, "friction about the axis, e.g. GivenFriction");
  a.example("<Screw between=\"world rod\" axis=\"0 0 1\" pitch=\"0.01\"/>");
}

Screw::Screw(const Parameters& x) : Joint(x), pitch_(x["pitch"]) {}

void Screw::build(JointRows& rows) const {
  const JointStart& s = rows.start;
  if (!s.plane.isZero(0.0)) refusePlane("in one plane a rack and a pinion do what a screw does");
  const Vec3& axis = neededAxis(s.axis_I, "a screw");
  Vec3 t1, t2;
  tangents(axis, t1, t2);
  for (const Vec3& t : {t1, t2}) rows.addPoint(t);
  for (const Vec3& t : {t1, t2}) rows.addAngle(t, axis);
  rows.addScrew(axis, pitch_ / (2.0 * std::numbers::pi));
  rows.addFree(JointRow::Kind::spin, axis);
  rows.measureShift(axis, "displacement", "speed");
  rows.measureTurn(axis, t1, "angle", "rate");
}

bool Screw::freeMotions(const JointStart& s, std::vector<FreeMotion>& out) const {
  out.push_back({FreeMotion::Kind::screw, s.axis_I, pitch_ / (2.0 * std::numbers::pi)});
  return true;
}

// ---- PlanarJoint -------------------------------------------------------------------------------

void PlanarJoint::declare(Attributes& a) {
  a.about(
      "B moves in a plane fixed in A and turns about its normal. 3 rows. A friction law acts on "
      "the velocity in the plane. Signals: x, y along two directions fixed in A, angle (between "
      "-pi and pi), and their rates.");
  declareJoint(a);
  declareAxis(a, "normal of the plane at the start, in the world");
  declareFriction(a, "friction in the plane, e.g. GivenFriction");
  a.example("<PlanarJoint between=\"world rod\" axis=\"0 0 1\"/>");
}

void PlanarJoint::build(JointRows& rows) const {
  const JointStart& s = rows.start;
  if (!s.plane.isZero(0.0)) refusePlane("bodies that move in this plane are PlanarBody");
  const Vec3& n = neededAxis(s.axis_I, "a plane");
  Vec3 t1, t2;
  tangents(n, t1, t2);
  rows.addPoint(n);
  for (const Vec3& t : {t1, t2}) rows.addAngle(t, n);
  for (const Vec3& t : {t1, t2}) rows.addFree(JointRow::Kind::point, t);
  rows.measureShift(t1, "x", "xRate");
  rows.measureShift(t2, "y", "yRate");
  rows.measureTurn(n, t1, "angle", "rate");
}

bool PlanarJoint::freeMotions(const JointStart& s, std::vector<FreeMotion>& out) const {
  Vec3 t1, t2;
  tangents(s.axis_I, t1, t2);
  out.push_back({FreeMotion::Kind::slide, t1});
  out.push_back({FreeMotion::Kind::slide, t2});
  out.push_back({FreeMotion::Kind::turn, s.axis_I});
  return true;
}

}  // namespace dynamy
