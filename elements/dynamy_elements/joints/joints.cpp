#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/joints/joints.hpp>

namespace dynamy {
namespace {

bool planar(const Vec3& plane) { return !plane.isZero(0.0); }

/// (e1, e2, n) of the plane with normal n, or the axes of the world.
Mat3 triad(const Vec3& n) {
  if (!planar(n)) return Mat3::Identity();
  Vec3 t1, t2;
  tangents(n, t1, t2);
  Mat3 out;
  out << t1, t2, n;
  return out;
}

/// The axis of a hinge: between planar bodies the normal of their plane, to the side that the model says.
Vec3 hingeAxis(const JointStart& s) {
  if (!planar(s.plane)) return s.axis_I;
  // Rounding of a direction that the model writes with some figures: 1e-6.
  if (s.axis_I.cross(s.plane).norm() > 1e-6)
    throw ModelError("a hinge between planar bodies turns about the normal of their plane",
                     "leave the axis out, or give that of the plane");
  return s.axis_I.dot(s.plane) < 0.0 ? Vec3(-s.plane) : s.plane;
}

}  // namespace

void Revolute::declare(Attributes& a) {
  a.about(
      "Hinge: two frames share a point and an axis. Planar bodies: 2 rows, in space 5. A friction "
      "law acts about the axis. Signals: angle of B against A (from the value `start`, by the "
      "right "
      "hand about the axis; between -pi and pi), rate.");
  declareJoint(a);
  declareAxis(a,
              "axis at the start, in the world; needed in space; of planar bodies the normal of "
              "their plane, whose side it may choose");
  declareFriction(a, "friction about the axis, e.g. GivenFriction");
  declareStart(a, Unit::angle, "value of the signal angle at the start");
  declareRotor(a, Unit::inertia);
  a.example("<Revolute between=\"world rod\" at=\"0 0 1\" axis=\"0 1 0\"/>");
}

void Revolute::build(JointRows& rows) const {
  const JointStart& s = rows.start;
  const Mat3 e = triad(s.plane);
  rows.addPoint(e.col(0));
  rows.addPoint(e.col(1));
  if (planar(s.plane)) {
    const Vec3 n = hingeAxis(s);
    rows.addFree(JointRow::Kind::spin, n);
    rows.measureTurn(n, e.col(0), "angle", "rate");
    return;
  }
  if (s.axis_I.isZero(0.0))
    throw ModelError("a hinge in space needs an axis", "add axis=\"0 1 0\"");
  rows.addPoint(e.col(2));
  Vec3 t1, t2;
  tangents(s.axis_I, t1, t2);
  rows.addAngle(t1, s.axis_I);
  rows.addAngle(t2, s.axis_I);
  rows.addFree(JointRow::Kind::spin, s.axis_I);
  rows.measureTurn(s.axis_I, t1, "angle", "rate");
}

bool Revolute::freeMotions(const JointStart& s, std::vector<FreeMotion>& out) const {
  out.push_back({FreeMotion::Kind::turn, hingeAxis(s)});
  return true;
}

void Spherical::declare(Attributes& a) {
  a.about("Ball and socket: two frames share a point. Planar bodies: 2 rows, in space 3.");
  declareJoint(a);
  a.example("<Spherical between=\"world rod\" at=\"0 0 1\"/>");
}

void Spherical::build(JointRows& rows) const {
  const JointStart& s = rows.start;
  const Mat3 e = triad(s.plane);
  for (int i = 0; i < (planar(s.plane) ? 2 : 3); ++i) rows.addPoint(e.col(i));
}

bool Spherical::freeMotions(const JointStart& s, std::vector<FreeMotion>& out) const {
  if (planar(s.plane))
    out.push_back({FreeMotion::Kind::turn, s.plane});
  else
    out.push_back({FreeMotion::Kind::ball});
  return true;
}

void Prismatic::declare(Attributes& a) {
  a.about(
      "Slider: B moves along an axis fixed in A and does not turn against it. Planar bodies: 2 "
      "rows, in space 5. A friction law acts along the axis. Signals: displacement of B along the "
      "axis (from the value `start`), rate.");
  declareJoint(a);
  declareAxis(a, "direction at the start, in the world");
  declareFriction(a, "friction along the axis, e.g. GivenFriction");
  declareStart(a, Unit::length, "value of the signal displacement at the start");
  declareRotor(a, Unit::mass);
  a.example("<Prismatic between=\"world cart\" axis=\"1 0 0\"/>");
}

void Prismatic::build(JointRows& rows) const {
  const JointStart& s = rows.start;
  if (s.axis_I.isZero(0.0)) throw ModelError("a slider needs an axis", "add axis=\"1 0 0\"");
  rows.addFree(JointRow::Kind::point, s.axis_I);
  rows.measureShift(s.axis_I, "displacement", "rate");
  if (planar(s.plane)) {
    const Vec3 across = s.plane.cross(s.axis_I);
    // For an axis out of the plane there is nothing to slide along: |across| is the sine of its
    // angle to the normal.
    if (across.norm() < 1.0 - 1e-12)
      throw ModelError("the axis points out of the plane of the bodies",
                       "the plane's normal is perpendicular to the axis of a slider");
    rows.addPoint(across);
    rows.addAngle(s.axis_I, across);
    return;
  }
  Vec3 t1, t2;
  tangents(s.axis_I, t1, t2);
  rows.addPoint(t1);
  rows.addPoint(t2);
  rows.addAngle(t1, t2);
  rows.addAngle(t2, s.axis_I);
  rows.addAngle(s.axis_I, t1);
}

bool Prismatic::freeMotions(const JointStart& s, std::vector<FreeMotion>& out) const {
  out.push_back({FreeMotion::Kind::slide, s.axis_I});
  return true;
}

void Fixed::declare(Attributes& a) {
  a.about("Two frames are one. Planar bodies: 3 rows, in space 6.");
  declareJoint(a);
  a.example("<Fixed between=\"world base\"/>");
}

void Fixed::build(JointRows& rows) const {
  const JointStart& s = rows.start;
  const Mat3 e = triad(s.plane);
  rows.addPoint(e.col(0));
  rows.addPoint(e.col(1));
  rows.addAngle(e.col(0), e.col(1));
  if (planar(s.plane)) return;
  rows.addPoint(e.col(2));
  rows.addAngle(e.col(1), e.col(2));
  rows.addAngle(e.col(2), e.col(0));
}

bool Fixed::freeMotions(const JointStart&, std::vector<FreeMotion>&) const { return true; }

void Distance::declare(Attributes& a) {
  a.about(
      "Two points keep their distance: a massless rod. One row. A string between them, which can "
      "go "
      "slack, is a Rope.");
  FramePair::declare(a);
  a.vector("pointA", Unit::length, 3, "0 0 0", "point on A, in axes of A");
  a.vector("pointB", Unit::length, 3, "0 0 0", "point on B, in axes of B");
  Attribute& length = a.add(AttributeType::number, "length", std::nullopt,
                            "distance; default: the distance at the start");
  length.unit = Unit::length;
  length.mayBeAbsent().positive();
  a.example("<Distance between=\"world bob\"/>");
}

Distance::Distance(const Parameters& x)
    : Joint(x),
      pointOnA_(x["pointA"].vec3()),
      pointOnB_(x["pointB"].vec3()),
      length_(x.has("length") ? double(x["length"]) : 0.0) {}

void Distance::build(JointRows& rows) const { rows.addDistance(pointOnA_, pointOnB_, length_); }

}  // namespace dynamy
