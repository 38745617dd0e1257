#include <algorithm>
#include <cmath>
#include <dynamy/contact/contact_signals.hpp>
#include <dynamy/core/declared/two_names.hpp>
#include <dynamy_elements/joints/joint_freedom.hpp>
#include <dynamy_elements/joints/transmissions.hpp>
#include <dynamy_elements/laws/friction_of_law.hpp>
#include <tuple>

namespace dynamy {
namespace {

std::pair<std::string, std::string> twoFrames(const ParameterValue& value) {
  return twoNames(value, "two frames", "write two bodies, or the <Ground> and a body: \"A B\"");
}

Attribute& betweenTwo(Attributes& a, const char* text) {
  Attribute& between = a.add(AttributeType::names, "between", std::nullopt, text);
  between.referenceKind = "frame";
  return between;
}

void requireFree(const Topology& topology, FrameHandle A, FrameHandle B,
                 const SoughtCoordinate& x) {
  JointFreedom(jointsBetween(topology, A, B)).requireFree(x, {});
}

Vec3 needed(const Vec3& given, const Vec3& otherwise, const char* what) {
  const Vec3& out = given.isZero(0.0) ? otherwise : given;
  if (out.isZero(0.0))
    throw ModelError(std::string(what) + " is missing",
                     "planar bodies have the normal of their plane");
  return out;
}

}  // namespace

// ---- Coupling ----------------------------------------------------------------------------------

Coupling::Coupling(const Parameters& x)
    : NonSmoothElement(x), law_(x.takeOne<SetValuedForceLaw>()) {
  if (!law_) law_ = std::make_unique<Bilateral>();
  if (hasFriction(*law_))
    throw ModelError("there is no direction in which the friction of the law could act",
                     "take Unilateral; friction of a rope on a sheave is a SheaveRope");
  NotchedForce spring;
  placed_ = law_->unilateral() || law_->rowKind(0) == RowKind::joint ||
            law_->notched({.dim = 1, .dt = 1.0}, spring);
}

void Coupling::declareLaw(Attributes& a, const std::string& text) {
  a.child(Kind::law, 0, 1, text);
}

FrameHandle Coupling::frame(Topology& topology, const std::string& name) {
  const FrameHandle f = topology.frame(name, *this);
  const int system = topology.requestedFrames()[static_cast<std::size_t>(f.index)].first;
  const Blocks blocks = topology.systems()[static_cast<std::size_t>(system)]->blocks();
  if (blocks.nu == 0) return f;
  moves_ = true;
  const bool same = blocks.planeNormal.cross(plane_).norm() < 1e-12;  // unit vectors: rounding
  if (!planeKnown_ || (!same || blocks.planeNormal.isZero(0.0)))
    plane_ = planeKnown_ ? Vec3(Vec3::Zero()) : blocks.planeNormal;
  planeKnown_ = true;
  return f;
}

void Coupling::connect(Topology& topology) {
  parts_.clear();
  planeKnown_ = moves_ = false;
  build(topology);
  if (!moves_)
    throw ModelError("all of the frames stand still or move as given",
                     "one of them has to be of a body with velocities of its own");
  std::vector<double> start;
  const bool turns =
      std::any_of(parts_.begin(), parts_.end(), [](const Part& p) { return p.row.memory() > 0; });
  if (turns) {
    const StartKinematics kinematics(topology);
    for (const Part& p : parts_) p.row.startMemory(kinematics, start);
  }
  if (!start.empty()) memory_ = topology.memory(*this, start);
  terms_.resize(2 * parts_.size());
}

double Coupling::sum(const Kinematics& k) const {
  double sum = 0.0;
  const double* memory = k.memory(memory_).data();
  for (const Part& p : parts_) {
    sum += p.factor * p.row.value(k, memory);
    memory += p.row.memory();
  }
  return sum;
}

void Coupling::remember(const Kinematics& k, Vec memory) const {
  double* next = memory.data();
  for (const Part& p : parts_) p.row.remember(k, next), next += p.row.memory();
}

void Coupling::contacts(const Kinematics& k, ContactSink& sink) const {
  const double g = constant_ + sum(k);
  ContactRows out = sink.add(0, law_->unilateral() ? g : std::abs(g), *law_, 1);
  if (!out) return;
  out.position(0) = placed_ ? g : 0.0;
  for (std::size_t i = 0; i < parts_.size(); ++i)
    parts_[i].row.terms(k, parts_[i].factor, &terms_[2 * i]);
  emitRow(terms_, out);
  if (!out.wantsBias()) return;
  for (const Part& p : parts_) out.bias(0) += p.factor * p.row.bias(k);
}

void Coupling::describe(Description& d) const {
  const bool turns =
      std::all_of(parts_.begin(), parts_.end(), [](const Part& p) { return p.row.turns(); });
  describeContact(d, 0, 1, *law_, {}, turns ? kAllAngular : 0U);
}

// ---- Gear --------------------------------------------------------------------------------------

void Gear::declare(Attributes& a) {
  a.about(
      "Gear, belt or friction drive between two wheels: rate of A = ratio times rate of B, both "
      "against a carrier about axes fixed in it, which need not be parallel. The bearings are "
      "joints of their own; a carrier that moves makes a planetary gear. One row.");
  betweenTwo(a, "wheels A and B: systems, or system.frame");
  a.reference("carrier", "frame", "what carries both bearings: a system, or system.frame");
  a.required(
       "ratio", Unit::none,
       "rate of A over rate of B; negative for wheels that mesh from outside on parallel axes")
      .notZero();
  a.vector("axisA", Unit::none, 3, "0 0 0",
           "axis of A at the start, in the world; default: normal of the plane of the bodies");
  a.vector("axisB", Unit::none, 3, "0 0 0", "axis of B; default: that of A");
  declareLaw(a, "law of the teeth; default: Bilateral. ForceLimit: a drive that slips");
  a.example("<Gear between=\"base cart\" carrier=\"world\" ratio=\"-3\" axisA=\"0 1 0\"/>");
}

Gear::Gear(const Parameters& x)
    : Coupling(x),
      carrier_(x["carrier"].text),
      axisA_(x["axisA"].vec3()),
      axisB_(x["axisB"].vec3()),
      ratio_(x["ratio"]) {
  std::tie(a_, b_) = twoFrames(x["between"]);
}

void Gear::build(Topology& topology) {
  const FrameHandle A = frame(topology, a_), B = frame(topology, b_), C = frame(topology, carrier_);
  const Vec3 axisA = needed(axisA_, plane(), "the axis of A"),
             axisB = needed(axisB_, axisA, "the axis of B");
  const StartKinematics start(topology, {A, B, C});
  requireFree(topology, C, A, {true, axisA, Vec3::Zero(), "axisA", false});
  requireFree(topology, C, B, {true, axisB, Vec3::Zero(), "axisB", false});
  add(CoordinateRow::angle(start, C, A, axisA, Vec3::Zero(), 0.0), 1.0);
  add(CoordinateRow::angle(start, C, B, axisB, Vec3::Zero(), 0.0), -ratio_);
}

// ---- RackAndPinion -----------------------------------------------------------------------------

void RackAndPinion::declare(Attributes& a) {
  a.about(
      "A pinion that drives a rack: displacement of the rack = radius times angle of the pinion, "
      "both against a carrier. Bearing and guide are joints of their own. One row.");
  betweenTwo(a, "pinion and rack: systems, or system.frame");
  a.reference("carrier", "frame", "what carries bearing and guide: a system, or system.frame");
  a.required("radius", Unit::length,
             "pitch radius; negative: a positive turn moves the rack backwards")
      .notZero();
  a.vector("axis", Unit::none, 3, "0 0 0",
           "axis of the pinion at the start, in the world; default: normal of the plane of the "
           "bodies");
  a.requiredVector("direction", Unit::none, 3, "direction of the rack at the start, in the world")
      .notZero();
  declareLaw(a, "law of the teeth; default: Bilateral");
  a.example(
      "<RackAndPinion between=\"base cart\" carrier=\"world\" radius=\"0.1\" axis=\"0 1 0\" "
      "direction=\"1 0 0\"/>");
}

RackAndPinion::RackAndPinion(const Parameters& x)
    : Coupling(x),
      carrier_(x["carrier"].text),
      axis_(x["axis"].vec3()),
      direction_(x["direction"].vec3()),
      radius_(x["radius"]) {
  std::tie(pinion_, rack_) = twoFrames(x["between"]);
}

void RackAndPinion::build(Topology& topology) {
  const FrameHandle P = frame(topology, pinion_), R = frame(topology, rack_),
                    C = frame(topology, carrier_);
  const Vec3 axis = needed(axis_, plane(), "the axis of the pinion");
  const StartKinematics start(topology, {P, R, C});
  requireFree(topology, C, P, {true, axis, Vec3::Zero(), "axis", false});
  requireFree(topology, C, R, {false, direction_, start.frame(R).r_OS_I, "direction", false});
  add(CoordinateRow::displacement(start, C, R, start.frame(R).r_OS_I, direction_, 0.0), 1.0);
  add(CoordinateRow::angle(start, C, P, axis, Vec3::Zero(), 0.0), -radius_);
}

// ---- Rope --------------------------------------------------------------------------------------

void Rope::declare(Attributes& a) {
  a.about(
      "Rope without mass that runs without friction through points of frames, its ends tied to the "
      "first and the last: g = L - sum of the pieces. Bilateral: always taut; Unilateral: it can "
      "go slack. Through two points it is a tether, a string that pulls and does not push; "
      "epsilonN of its law is the restitution of the jerk as it goes taut. Lambda is the tension "
      "times the step. Signals: length of what it spans.");
  Attribute& through = a.add(AttributeType::names, "through", std::nullopt,
                             "two or more frames: systems, or system.frame");
  through.referenceKind = "frame";
  a.vector("points", Unit::length, 0, "",
           "points in axes of these frames, three numbers each; default: their origins");
  Attribute& length = a.add(AttributeType::number, "length", std::nullopt,
                            "length L; default: what it spans at the start");
  length.unit = Unit::length;
  length.mayBeAbsent().positive();
  declareLaw(a, "law of the rope; default: Bilateral");
  a.example(
      "<Rope through=\"bob world world ball\" points=\"0 0 0  -1 0 3  1 0 3  0 0 0\">"
      "<Unilateral/></Rope>");
}

Rope::Rope(const Parameters& x)
    : Coupling(x),
      names_(x["through"].words()),
      length_(x.has("length") ? double(x["length"]) : 0.0) {
  const ParameterValue& through = x["through"];
  if (names_.size() < 2)
    throw through.fault("a rope runs through two frames at least", "first and last are its ends", 0,
                        through.text.size());
  const Eigen::VectorXd p = x["points"].vector();
  const auto n = static_cast<Eigen::Index>(names_.size());
  if (p.size() != 0 && p.size() != 3 * n)
    throw x["points"].fault(
        std::to_string(3 * n) + " numbers are needed, here are " + std::to_string(p.size()),
        "three for each frame it runs through", 0, x["points"].text.size());
  for (Eigen::Index i = 0; i < n; ++i)
    points_.push_back(p.size() == 0 ? Vec3(Vec3::Zero()) : Vec3(p.segment<3>(3 * i)));
}

void Rope::build(Topology& topology) {
  frames_.clear();
  for (const std::string& name : names_) frames_.push_back(frame(topology, name));
  const StartKinematics start(topology, frames_);
  double spanned = 0.0;
  for (std::size_t i = 0; i + 1 < frames_.size(); ++i) {
    const Frame &A = start.frame(frames_[i]), &B = start.frame(frames_[i + 1]);
    const double l = (B.r_OS_I + B.A_IK * points_[i + 1] - A.r_OS_I - A.A_IK * points_[i]).norm();
    // A piece of zero length is allowed in a rope that can go slack: a slack rope has no force and
    // needs no direction.
    if (!(l > 0.0) && !(law().unilateral() && length_ > 0.0))
      throw ModelError("two points of the rope coincide at the start",
                       "leave one of them out, or say the length of a rope that can go slack");
    spanned += l;
    add(CoordinateRow::distance(frames_[i], frames_[i + 1], points_[i], points_[i + 1]), -1.0);
  }
  constant(length_ > 0.0 ? length_ : spanned);
}

void Rope::describe(Description& d) const {
  for (std::size_t i = 0; i + 1 < frames_.size(); ++i)
    d.link({frames_[i].index, frames_[i + 1].index, points_[i], points_[i + 1]});
  d.signal("length", Unit::length, "what the rope spans",
           [this](const SignalView& v) { return -sum(*v.kinematics); });
  Coupling::describe(d);
}

}  // namespace dynamy
