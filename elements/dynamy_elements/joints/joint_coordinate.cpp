#include <cmath>
#include <dynamy/core/declared/mirror_plane.hpp>
#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/joints/joint_coordinate.hpp>
#include <dynamy_elements/joints/joint_freedom.hpp>
#include <numbers>

namespace dynamy {

// ---- CoordinateRow -----------------------------------------------------------------------------

CoordinateRow CoordinateRow::angle(const StartKinematics& k, FrameHandle A, FrameHandle B,
                                   const Vec3& axis_I, const Vec3& reference_I, double start) {
  const Vec3 axis = axis_I.normalized();
  Vec3 e, unused;
  tangents(axis, e, unused);
  if (!reference_I.isZero(0.0)) e = (reference_I - axis.dot(reference_I) * axis).normalized();
  const Mat3 A_IA = k.frame(A).A_IK, A_IB = k.frame(B).A_IK;
  CoordinateRow out;
  out.A_ = A, out.B_ = B, out.start_ = start;
  out.row_ = {JointRow::Kind::turn, A_IA.transpose() * axis, A_IB.transpose() * e, 0.0,
              A_IA.transpose() * e};
  return out;
}

CoordinateRow CoordinateRow::displacement(const StartKinematics& k, FrameHandle A, FrameHandle B,
                                          const Vec3& at_I, const Vec3& direction_I, double start) {
  const Frame &a = k.frame(A), &b = k.frame(B);
  CoordinateRow out;
  out.A_ = A, out.B_ = B, out.start_ = start;
  out.pointA_ = a.A_IK.transpose() * (at_I - a.r_OS_I);
  out.pointB_ = b.A_IK.transpose() * (at_I - b.r_OS_I);
  out.row_ = {JointRow::Kind::point, a.A_IK.transpose() * direction_I.normalized(), Vec3::Zero(),
              0.0};
  return out;
}

CoordinateRow CoordinateRow::distance(FrameHandle A, FrameHandle B, const Vec3& pointA,
                                      const Vec3& pointB) {
  CoordinateRow out;
  out.A_ = A, out.B_ = B, out.pointA_ = pointA, out.pointB_ = pointB;
  out.row_.kind = JointRow::Kind::distance;
  return out;
}

void CoordinateRow::startMemory(const StartKinematics& k, std::vector<double>& out) const {
  if (turns()) out.insert(out.end(), {start_, rate(k.kinematics()), 0.0});
}

double CoordinateRow::value(const Kinematics& k, const double* memory) const {
  const double x = start_ + rowPosition(pose(k), row_);
  if (!turns()) return x;
  const double near = memory[0] + 0.5 * (k.t() - memory[2]) * (memory[1] + rate(k));
  return near + std::remainder(x - near, 2.0 * std::numbers::pi);
}

void CoordinateRow::remember(const Kinematics& k, double* memory) const {
  if (!turns()) return;
  const double x = value(k, memory);
  memory[0] = x, memory[1] = rate(k), memory[2] = k.t();
}

double CoordinateRow::rate(const Kinematics& k) const {
  const JointPose p = pose(k);
  return rowRate(p, rowWrench(p, row_));
}

double CoordinateRow::bias(const Kinematics& k) const { return rowBias(pose(k), row_); }

void CoordinateRow::terms(const Kinematics& k, double factor, RateTerm* two) const {
  const JointPose p = pose(k);
  const RowWrench w = rowWrench(p, row_);
  two[0] = {&p.A, p.rhoAQ_I(), w, -factor};
  two[1] = {&p.B, p.rhoB_I, w, factor};
}

void CoordinateRow::addForce(const Kinematics& k, double F, ForceSink& sink) const {
  RateTerm two[2];
  terms(k, F, two);
  for (const RateTerm& x : two) {
    if (x.wrench.force) sink.force(*x.frame, x.rho_I, x.sign * x.wrench.f);
    if (x.wrench.moment) sink.moment(*x.frame, x.sign * x.wrench.m);
  }
}

void CoordinateRow::addStiffness(const Kinematics& k, double c, double d,
                                 StiffnessSink& sink) const {
  const JointPose p = pose(k);
  const RowWrench w = rowWrench(p, row_);
  if (w.force) sink.spring(p.A, p.rhoAQ_I(), p.B, p.rhoB_I, w.f, c, d);
  if (w.moment) sink.torsion(p.A, p.B, w.m, c, d);
}

Vec3 CoordinateRow::place(const Kinematics& k) const {
  const JointPose p = pose(k);
  return p.B.r_OS_I + p.rhoB_I;
}

// ---- JointCoordinate ---------------------------------------------------------------------------

namespace {

Place placeOf(const ParameterValue& value) {
  return value.locate ? value.locate(0, value.text.size()) : value.place;
}

}  // namespace

void JointCoordinate::declare(Attributes& a) {
  FramePair::declare(a);
  Attribute& kind = a.add(AttributeType::choice, "coordinate", std::nullopt,
                          "angle of B against A about the axis, or displacement along it; default: "
                          "what a joint between the two bodies leaves free, else angle");
  kind.choices = {"angle", "displacement"};
  kind.mayBeAbsent();
  a.vector("axis", Unit::none, 3, "0 0 0",
           "axis, fixed in A, at the start in the world; needed in space, an angle of planar "
           "bodies has the "
           "normal of their plane");
  Attribute& at = a.add(AttributeType::vector, "at", std::nullopt,
                        "place of the joint at the start, in the world; default: origin of B");
  at.unit = Unit::length;
  at.size = 3;
  at.mayBeAbsent();
  a.vector("reference", Unit::none, 3, "0 0 0",
           "direction across the axis that B carries and whose turn is the angle, at the start in "
           "the world; default: any, which is the same in a hinge");
  a.optional("start", Unit::any, 0.0, "value of the coordinate at the start [rad or m]");
}

JointCoordinate::JointCoordinate(const Parameters& x)
    : frames_(x),
      kindGiven_(x.has("coordinate")),
      angle_(x["coordinate"].text != "displacement"),
      atGiven_(x.has("at")),
      axis_(x["axis"].vec3()),
      reference_(x["reference"].vec3()),
      start_(x["start"]) {
  if (atGiven_) at_ = x["at"].vec3();
  for (const char* name : {"axis", "coordinate"})
    if (const ParameterValue& value = x[name]; value.given) place_ = placeOf(value);
  hasUnits(x, "start", Unit::angle, Unit::length);
}

void JointCoordinate::hasUnits(const Parameters& x, const char* name, Unit ofAngle,
                               Unit ofDisplacement) {
  const ParameterValue& value = x[name];
  if (!value.given) return;
  Mixed out{*value.declaration, value, ofAngle, ofDisplacement};
  // The file may be gone when the kind is known.
  if (value.locate)
    out.value.locate = [place = placeOf(value)](std::size_t, std::size_t) { return place; };
  mixed_.push_back(std::move(out));
}

void JointCoordinate::checkUnits() {
  for (Mixed& m : mixed_) {
    m.attribute.unit = angle_ ? m.ofAngle : m.ofDisplacement;
    m.value.declaration = &m.attribute;
    if (const auto fault = readValue(m.attribute, m.value))
      throw m.value.fault(m.value.locate ? m.attribute.name + ' ' + fault->text : fault->text,
                          fault->hint, 0, m.value.text.size());
  }
}

bool JointCoordinate::isMirrored(const MirrorPlane& plane, const Element& owner) const {
  if (axis_.isZero(0.0)) return false;
  FramePair frames = frames_;
  frames.find(*plane.topology, owner);
  const JointFreedom joints(jointsBetween(*plane.topology, frames.A, frames.B));
  if (kindGiven_ ? angle_ : joints.suggestsAngle(axis_)) return plane.isNormal(axis_);
  if (!plane.isAlong(axis_)) return false;
  if (atGiven_) return plane.contains(at_);
  return plane.contains(StartKinematics(*plane.topology, {frames.B}).frame(frames.B).r_OS_I);
}

void JointCoordinate::connect(Topology& topology, const Element& owner) {
  frames_.connect(topology, owner);
  const JointFreedom joints(jointsBetween(topology, frames_.A, frames_.B));
  if (!kindGiven_) angle_ = joints.suggestsAngle(axis_);
  checkUnits();
  const Vec3 axis = axis_.isZero(0.0) && angle_ ? frames_.planeNormal : axis_;
  if (axis.isZero(0.0))
    throw ModelError("the coordinate needs an axis",
                     "add axis=\"…\", that of the joint between the two bodies");
  if (axis.cross(reference_).norm() < 1e-6 * axis.norm() * reference_.norm())
    throw ModelError("the reference lies along the axis", "it has to have a part across it");
  const StartKinematics start(topology, {frames_.A, frames_.B});
  const Vec3 at = atGiven_ ? at_ : start.frame(frames_.B).r_OS_I;
  joints.requireFree({angle_, axis, at}, place_);
  if (angle_) {
    row_ = CoordinateRow::angle(start, frames_.A, frames_.B, axis, reference_, start_);
    std::vector<double> memory;
    row_.startMemory(start, memory);
    memory_ = topology.memory(owner, memory);
    return;
  }
  row_ = CoordinateRow::displacement(start, frames_.A, frames_.B, at, axis, start_);
}

void JointCoordinate::describe(Description& d) const {
  d.signal("position", angle_ ? Unit::angle : Unit::length, "coordinate of the joint",
           [this](const SignalView& v) { return value(*v.kinematics); });
  d.signal("rate", angle_ ? Unit::angularVelocity : Unit::velocity, "its rate",
           [this](const SignalView& v) { return rate(*v.kinematics); });
  for (std::size_t i = d.signals.size() - 2; i < d.signals.size(); ++i) d.signals[i].ofState = true;
}

void JointCoordinate::emit(const Kinematics& k, ContactRows& out, double sign, double chi,
                           double chiRate) const {
  RateTerm two[2];
  row_.terms(k, sign, two);
  emitRow(two, out);
  out.chi(0) += chi;
  if (out.wantsBias()) out.bias(0) += sign * row_.bias(k) + chiRate;
  out.place(row_.place(k), Vec3::Zero());
}

}  // namespace dynamy
