#include <algorithm>
#include <cmath>
#include <dynamy_elements/joints/coordinate_forces.hpp>
#include <limits>

namespace dynamy {

// ---- CoordinateForce ---------------------------------------------------------------------------

CoordinateForce::CoordinateForce(const Parameters& x)
    : ExternalForce(x), coordinate_(x), stiff_(x["stiff"].flag()) {}

void CoordinateForce::declareForce(Attributes& a) {
  JointCoordinate::declare(a);
  a.add(AttributeType::flag, "stiff", "false",
        "true: taken linearly implicitly by the schemes, which keeps its energy where steps are "
        "beyond its period; else it is found, and damped");
}

void CoordinateForce::connect(Topology& topology) {
  coordinate_.connect(topology, *this);
  for (SignalFormulas* f : formulas()) f->connect(topology, *this);
}

void CoordinateForce::addTo(const Kinematics& k, ForceSink& sink) const {
  const double F = force(k, coordinate_.value(k), coordinate_.rate(k), nullptr, nullptr);
  coordinate_.row().addForce(k, F, sink);
}

void CoordinateForce::addStiffness(const Kinematics& k, StiffnessSink& sink) const {
  double c = 0.0, d = 0.0;
  force(k, coordinate_.value(k), coordinate_.rate(k), &c, &d);
  coordinate_.row().addStiffness(k, c, d, sink);
}

void CoordinateForce::describe(Description& d) const {
  coordinate_.describe(d);
  const bool angle = coordinate_.isAngle();
  d.signal("force", angle ? Unit::torque : Unit::force, angle ? "moment on B" : "force on B",
           [this](const SignalView& v) {
             const Kinematics& k = *v.kinematics;
             return force(k, coordinate_.value(k), coordinate_.rate(k), nullptr, nullptr);
           });
  announceInstants(d, [this](double t) { return nextInstant(t); });
}

// ---- JointSpring -------------------------------------------------------------------------------

void JointSpring::declare(Attributes& a) {
  a.about(
      "Spring and damper in a joint coordinate: F = -c (x - x0) - d x', V = c (x - x0)^2/2. "
      "Angles count whole turns. Signals: position, rate, force.");
  declareForce(a);
  a.required("stiffness", Unit::any, "stiffness c [N m/rad or N/m]").nonNegative();
  a.optional("damping", Unit::any, 0.0, "damping d [N m s/rad or N s/m]").nonNegative();
  a.optional("rest", Unit::any, 0.0, "coordinate x0 without force [rad or m]");
  a.example("<JointSpring between=\"world rod\" axis=\"0 0 1\" stiffness=\"5\" damping=\"0.2\"/>");
}

JointSpring::JointSpring(const Parameters& x)
    : CoordinateForce(x), stiffness_(x["stiffness"]), damping_(x["damping"]), rest_(x["rest"]) {
  hasUnits(x, "rest", Unit::angle, Unit::length);
  hasUnits(x, "stiffness", Unit::rotationalStiffness, Unit::stiffness);
  hasUnits(x, "damping", Unit::rotationalDamping, Unit::damping);
}

double JointSpring::force(const Kinematics&, double x, double rate, double* c, double* d) const {
  if (c) *c = stiffness_;
  if (d) *d = damping_;
  return -stiffness_ * (x - rest_) - damping_ * rate;
}

void JointSpring::addTo(const Kinematics& k, ForceSink& sink) const {
  // Spring and damper are added separately, since only the spring has a potential.
  sink.hasPotential(true);
  coordinate().row().addForce(k, -stiffness_ * (coordinate().value(k) - rest_), sink);
  if (damping_ == 0.0) return;
  sink.hasPotential(false);
  coordinate().row().addForce(k, -damping_ * coordinate().rate(k), sink);
}

double JointSpring::potentialEnergy(const Kinematics& k) const {
  const double x = coordinate().value(k) - rest_;
  return 0.5 * stiffness_ * x * x;
}

// ---- JointForce --------------------------------------------------------------------------------

void JointForce::declare(Attributes& a) {
  a.about(
      "Force or moment in a joint coordinate as a formula of the time t, the coordinate x, its "
      "rate "
      "v and signals of the model; derivatives by x and v are exact. Signals: position, rate, "
      "force.");
  declareForce(a);
  a.add(AttributeType::expression, "force", std::nullopt,
        "force or moment on B as a formula of t, x, v and signals [N or N m]");
  a.example("<JointForce between=\"world rod\" axis=\"0 1 0\" force=\"2*sin(t)-0.1*v*abs(v)\"/>");
}

JointForce::JointForce(const Parameters& x)
    : CoordinateForce(x), formula_(x, "force", 1, {"x", "v"}) {
  hasUnits(x, "force", Unit::torque, Unit::force);
}

double JointForce::force(const Kinematics& k, double x, double rate, double* c, double* d) const {
  const double own[2] = {x, rate};
  const double F = formula_.value(k, own);
  if (c) *c = -formula_.partial(0);
  if (d) *d = -formula_.partial(1);
  return F;
}

// ---- PdController ------------------------------------------------------------------------------

void PdController::declare(Attributes& a) {
  a.about(
      "Controller that pulls a joint coordinate to a target: F = k (s - x) + d (s' - x') + f, cut "
      "off at ±limit, with k, d, s, f as formulas of t and signals. Signals: position, rate, "
      "force.");
  declareForce(a);
  a.add(AttributeType::expression, "target", "0",
        "target s as a formula of t [rad or m], or of t and signals with targetRate");
  a.add(AttributeType::expression, "targetRate", std::nullopt,
        "rate s' of a target that reads signals [rad/s or m/s]; default: derivative of target")
      .mayBeAbsent();
  a.add(AttributeType::expression, "stiffness", std::nullopt,
        "gain k of the position as a formula of t [N m/rad or N/m]");
  a.add(AttributeType::expression, "damping", "0",
        "gain d of the rate as a formula of t [N m s/rad or N s/m]");
  a.add(AttributeType::expression, "feedforward", "0", "force f as a formula of t [N m or N]");
  Attribute& limit = a.add(AttributeType::number, "limit", std::nullopt,
                           "largest force or moment [N m or N]; default: none");
  limit.unit = Unit::any;
  limit.mayBeAbsent().nonNegative();
  a.example(
      "<PdController between=\"base rod\" axis=\"0 1 0\" target=\"0.5*sin(t)\" stiffness=\"40\" "
      "damping=\"4\" limit=\"10\"/>");
}

PdController::PdController(const Parameters& x)
    : CoordinateForce(x),
      targetRate_(x, "targetRate", 1),
      stiffness_(x, "stiffness", 1),
      damping_(x, "damping", 1),
      feedforward_(x, "feedforward", 1),
      limit_(x.has("limit") ? double(x["limit"]) : std::numeric_limits<double>::infinity()) {
  if (targetRate_.empty())
    target_ = TimeFormulas(x, "target", 1);
  else
    targetOfSignals_ = SignalFormulas(x, "target", 1);
  hasUnits(x, "target", Unit::angle, Unit::length);
  hasUnits(x, "targetRate", Unit::angularVelocity, Unit::velocity);
  hasUnits(x, "stiffness", Unit::rotationalStiffness, Unit::stiffness);
  hasUnits(x, "damping", Unit::rotationalDamping, Unit::damping);
  hasUnits(x, "feedforward", Unit::torque, Unit::force);
  hasUnits(x, "limit", Unit::torque, Unit::force);
}

std::vector<SignalFormulas*> PdController::formulas() {
  return {&targetOfSignals_, &targetRate_, &stiffness_, &damping_, &feedforward_};
}

double PdController::force(const Kinematics& kinematics, double x, double rate, double* c,
                           double* d) const {
  double s = 0.0, sdot = 0.0;
  target_.eval(kinematics.t(), &s, &sdot);
  targetOfSignals_.eval(kinematics, &s);
  targetRate_.eval(kinematics, &sdot);
  const double k = stiffness_.value(kinematics), gain = damping_.value(kinematics);
  const double F = k * (s - x) + gain * (sdot - rate) + feedforward_.value(kinematics);
  const bool cut = std::abs(F) > limit_;
  if (c) *c = cut ? 0.0 : k;
  if (d) *d = cut ? 0.0 : gain;
  return std::clamp(F, -limit_, limit_);
}

double PdController::nextInstant(double t) const {
  double next = target_.nextInstant(t);
  for (const SignalFormulas* formulas :
       {&targetOfSignals_, &targetRate_, &stiffness_, &damping_, &feedforward_})
    next = std::min(next, formulas->nextInstant(t));
  return next;
}

}  // namespace dynamy
