#include <algorithm>
#include <cmath>
#include <dynamy/contact/contact_signals.hpp>
#include <dynamy/core/constants.hpp>
#include <dynamy_elements/joints/coordinate_laws.hpp>
#include <dynamy_elements/laws/friction_of_law.hpp>
#include <limits>

namespace dynamy {
namespace {

void limit(Attributes& a, const char* name, const char* text) {
  Attribute& x = a.add(AttributeType::number, name, std::nullopt, text);
  x.unit = Unit::any;
  x.mayBeAbsent();
}

void declareScale(Attributes& a) {
  a.add(AttributeType::expression, "scale", std::nullopt,
        "factor on the force of the law as a formula of t and signals, what presses a brake or a "
        "clutch; below 0 it counts as 0; default: 1")
      .mayBeAbsent();
}

void scale(const Kinematics& k, const SignalFormulas& factor, ContactRows& out) {
  if (factor.empty()) return;
  const double s = factor.value(k);
  out.scale(s < 0.0 ? 0.0 : s);  // NaN stays NaN
}

/// The one row of a law that prescribes a position or a speed.
ContactRows oneRow(ContactSink& sink, double g, const SetValuedForceLaw& law) {
  ContactRows out = sink.add(0, std::abs(g), law, 1);
  if (out) out.position(0) = g;
  return out;
}

}  // namespace

// ---- JointStop ---------------------------------------------------------------------------------

void JointStop::declare(Attributes& a) {
  a.about(
      "Stops of a joint coordinate x: x >= lower, x <= upper; both of them: a joint with play, a "
      "slot. Signals: position, rate, and those of both contacts.");
  JointCoordinate::declare(a);
  limit(a, "lower", "least value of the coordinate [rad or m]; default: none");
  limit(a, "upper", "largest value of the coordinate [rad or m]; default: none");
  a.child(Kind::law, 0, 1, "law of the stops; default: Unilateral with epsilonN = 0");
  a.example(
      "<JointStop between=\"world rod\" axis=\"0 0 1\" lower=\"0\" upper=\"100deg\">"
      "<Unilateral epsilonN=\"0.2\"/></JointStop>");
}

JointStop::JointStop(const Parameters& x)
    : CoordinateLaw(x),
      lower_(x.has("lower") ? double(x["lower"]) : -kInfinity),
      upper_(x.has("upper") ? double(x["upper"]) : kInfinity),
      law_(x.takeOne<SetValuedForceLaw>()) {
  if (!law_) law_ = std::make_unique<Unilateral>(0.0);
  for (const char* name : {"lower", "upper"}) hasUnits(x, name, Unit::angle, Unit::length);
  if (!std::isfinite(lower_) && !std::isfinite(upper_))
    throw ModelError("neither lower nor upper is given", "a stop has at least one of them");
  if (!(lower_ <= upper_))
    throw ModelError("the lower stop lies above the upper one", "exchange lower and upper");
  if (!law_->unilateral())
    throw ModelError("the law of a stop is not unilateral",
                     "friction in the joint is a JointFriction");
  if (hasFriction(*law_))
    throw ModelError("a stop has no direction in which the friction of its law could act",
                     "take Unilateral; friction in the joint is a JointFriction, that along a wall "
                     "a contact of shapes");
}

void JointStop::connect(Topology& topology) {
  CoordinateLaw::connect(topology);
  const double x = coordinate().row().start();
  if (x < lower_ || x > upper_)
    throw ModelError("the coordinate is " + numberText(x) + " at the start, beyond the stops",
                     "start=\"…\" says what its value is at the start");
}

void JointStop::contacts(const Kinematics& k, ContactSink& sink) const {
  const double x = coordinate().value(k);
  if (std::isfinite(lower_))
    if (ContactRows out = sink.add(0, x - lower_, *law_, 1))
      coordinate().emit(k, out, 1.0, 0.0, 0.0);
  if (std::isfinite(upper_))
    if (ContactRows out = sink.add(1, upper_ - x, *law_, 1))
      coordinate().emit(k, out, -1.0, 0.0, 0.0);
}

void JointStop::describe(Description& d) const {
  coordinate().describe(d);
  if (std::isfinite(lower_)) describeContact(d, 0, 1, *law_, "lower.", angularRow());
  if (std::isfinite(upper_)) describeContact(d, 1, 1, *law_, "upper.", angularRow());
}

// ---- JointDrive --------------------------------------------------------------------------------

void JointDrive::declare(Attributes& a) {
  a.about(
      "Drive that moves a joint coordinate as told: x = motion(t), whatever force it takes. "
      "lambda_T is the force or moment of the drive on B.");
  JointCoordinate::declare(a);
  a.add(AttributeType::expression, "motion", std::nullopt,
        "the coordinate as a formula of t [rad or m]; motion(0) = start");
  a.example("<JointDrive between=\"world rod\" axis=\"0 1 0\" motion=\"0.5*sin(t)^2\"/>");
}

JointDrive::JointDrive(const Parameters& x) : CoordinateLaw(x), motion_(x, "motion", 1) {
  hasUnits(x, "motion", Unit::angle, Unit::length);
}

void JointDrive::connect(Topology& topology) {
  CoordinateLaw::connect(topology);
  double motion = 0.0;
  motion_.eval(0.0, &motion);
  const double x = coordinate().row().start();
  // The tolerance covers the rounding of a formula; a larger difference would be a jump of the
  // joint in the first step.
  if (!std::isfinite(motion))
    throw ModelError("the motion has no finite value at t = 0", "correct the formula of motion");
  if (!(std::abs(motion - x) <= 1e-9 * (1.0 + std::abs(x))))
    throw ModelError(
        "the motion begins at " + numberText(motion) + ", the coordinate at " + numberText(x),
        "start=\"…\" says what its value is at the start");
}

void JointDrive::contacts(const Kinematics& k, ContactSink& sink) const {
  double motion = 0.0, speed = 0.0, acceleration = 0.0;
  motion_.eval(k.t(), &motion, &speed, &acceleration);
  if (ContactRows out = oneRow(sink, coordinate().value(k) - motion, bilateral_))
    coordinate().emit(k, out, 1.0, -speed, -acceleration);
}

void JointDrive::describe(Description& d) const {
  coordinate().describe(d);
  describeContact(d, 0, 1, bilateral_, {}, angularRow());
  TimeFormulas::announce(d, {&motion_});
}

// ---- JointMotor --------------------------------------------------------------------------------

void JointMotor::declare(Attributes& a) {
  a.about(
      "Motor that keeps the rate of a joint coordinate at a speed as long as its force stays below "
      "a limit: speed as told while |F| < limit, F = ±limit while it is slower or faster. Speed 0: "
      "a brake.");
  JointCoordinate::declare(a);
  a.add(AttributeType::expression, "speed", "0",
        "speed as a formula of t [rad/s or m/s], or of t and signals with speedRate");
  a.add(AttributeType::expression, "speedRate", std::nullopt,
        "rate of a speed that reads signals, 0 for signals that are held from sample to sample "
        "[rad/s^2 or m/s^2]; default: derivative of speed")
      .mayBeAbsent();
  a.required("limit", Unit::any, "largest force or moment [N or N m]").nonNegative();
  declareScale(a);
  a.example("<JointMotor between=\"world rod\" axis=\"0 1 0\" speed=\"10\" limit=\"2\"/>");
}

JointMotor::JointMotor(const Parameters& x)
    : CoordinateLaw(x),
      speedRate_(x, "speedRate", 1),
      scale_(x, "scale", 1),
      law_(-double(x["limit"]), double(x["limit"])) {
  if (speedRate_.empty())
    speed_ = TimeFormulas(x, "speed", 1);
  else
    speedOfSignals_ = SignalFormulas(x, "speed", 1);
  hasUnits(x, "speed", Unit::angularVelocity, Unit::velocity);
  hasUnits(x, "limit", Unit::torque, Unit::force);
}

void JointMotor::connect(Topology& topology) {
  CoordinateLaw::connect(topology);
  for (SignalFormulas* f : {&speedOfSignals_, &speedRate_, &scale_}) f->connect(topology, *this);
}

void JointMotor::contacts(const Kinematics& k, ContactSink& sink) const {
  double speed = 0.0, acceleration = 0.0;
  speed_.eval(k.t(), &speed, &acceleration);
  speedOfSignals_.eval(k, &speed);
  speedRate_.eval(k, &acceleration);
  if (ContactRows out = oneRow(sink, 0.0, law_)) {
    scale(k, scale_, out);
    coordinate().emit(k, out, 1.0, -speed, -acceleration);
  }
}

void JointMotor::describe(Description& d) const {
  coordinate().describe(d);
  describeContact(d, 0, 1, law_, {}, angularRow());
  announceInstants(d, [this](double t) {
    double next = speed_.nextInstant(t);
    for (const SignalFormulas* f : {&speedOfSignals_, &speedRate_, &scale_})
      next = std::min(next, f->nextInstant(t));
    return next;
  });
}

// ---- JointFriction -----------------------------------------------------------------------------

void JointFriction::declare(Attributes& a) {
  a.about(
      "A law on the rate of a joint coordinate: dry friction, brakes, clutches, for joints of any "
      "kind.");
  JointCoordinate::declare(a);
  a.child(Kind::law, 1, 1, "the law, e.g. GivenFriction or ForceLimit");
  declareScale(a);
  a.example(
      "<JointFriction between=\"world rod\" coordinate=\"displacement\" axis=\"0 0 1\">"
      "<GivenFriction force=\"3\"/></JointFriction>");
}

JointFriction::JointFriction(const Parameters& x)
    : CoordinateLaw(x), law_(x.takeOne<SetValuedForceLaw>()), scale_(x, "scale", 1) {
  if (!law_) throw ModelError("the law is missing", "add <GivenFriction force=\"1\"/>");
  requireLawOfRates(*law_);
  if (!scale_.empty() && !law_->scales())
    throw x["scale"].fault("the law has no size of its own that could be scaled",
                           "GivenFriction, ForceLimit, StribeckFriction, PreloadedSpring have", 0,
                           x["scale"].text.size());
}

void JointFriction::connect(Topology& topology) {
  CoordinateLaw::connect(topology);
  scale_.connect(topology, *this);
}

void JointFriction::contacts(const Kinematics& k, ContactSink& sink) const {
  if (ContactRows out = oneRow(sink, 0.0, *law_)) {
    scale(k, scale_, out);
    coordinate().emit(k, out, 1.0, 0.0, 0.0);
  }
}

void JointFriction::describe(Description& d) const {
  coordinate().describe(d);
  describeContact(d, 0, 1, *law_, {}, angularRow());
  SignalFormulas::announce(d, {&scale_});
}

}  // namespace dynamy
