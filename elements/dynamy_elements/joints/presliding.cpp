#include <algorithm>
#include <cmath>
#include <dynamy_elements/blocks/block_states.hpp>
#include <dynamy_elements/joints/presliding.hpp>

namespace dynamy {

// ---- Presliding --------------------------------------------------------------------------------

void Presliding::declarePresliding(Attributes& a) {
  JointCoordinate::declare(a);
  a.required("stiffness", Unit::any, "stiffness sigma before slip [N/m or N m/rad]").positive();
  a.required("force", Unit::any, "friction F_c of steady slip [N or N m]").positive();
  a.add(AttributeType::expression, "load", std::nullopt,
        "factor >= 0 on the forces of the law and its stiffness, a formula of t and signals: what "
        "presses; default: 1")
      .mayBeAbsent();
  a.add(AttributeType::flag, "stiff", "true",
        "true: fixed steps take the law linearly implicitly, with any length of steps");
}

Presliding::Presliding(const Parameters& x)
    : ExternalForce(x),
      coordinate_(x),
      load_(x, "load", 1),
      stiffness_(x["stiffness"]),
      level_(x["force"]),
      stiff_(x["stiff"].flag()) {
  if (x.name.empty())
    throw ModelError("the friction has no name", "its state is a signal: add name=\"…\"");
  coordinate_.hasUnits(x, "stiffness", Unit::rotationalStiffness, Unit::stiffness);
  coordinate_.hasUnits(x, "force", Unit::torque, Unit::force);
}

std::unique_ptr<PartialMechanicalSystem> Presliding::ownSystem() const {
  Parameters x;
  x.type = type(), x.name = name(), x.place = place();
  return std::make_unique<BlockStates>(x, std::vector<double>(1, 0.0),
                                       std::vector<std::string>{"deflection"});
}

void Presliding::connect(Topology& topology) {
  coordinate_.connect(topology, *this);
  state_ = topology.system(name(), *this);
  load_.connect(topology, *this);
}

double Presliding::loaded(const Kinematics& k) const {
  if (load_.empty()) return 1.0;
  const double load = load_.value(k);
  return load < 0.0 ? 0.0 : load;  // NaN stays NaN
}

double Presliding::force(const Kinematics& k) const {
  const double v = coordinate_.rate(k), s = k.u(state_)[0];
  return -loaded(k) * level_ * s - more(v, flow(v, s, nullptr));
}

void Presliding::addTo(const Kinematics& k, ForceSink& sink) const {
  const double rate = stiffness_ / level_ * flow(coordinate_.rate(k), k.u(state_)[0], nullptr);
  sink.generalised(state_, 0, BlockStates::kMass * rate);
  coordinate_.row().addForce(k, force(k), sink);
}

void Presliding::addStiffness(const Kinematics& k, StiffnessSink& sink) const {
  const double v = coordinate_.rate(k), s = k.u(state_)[0];
  double byState = 0.0;
  const double f = flow(v, s, &byState);
  sink.entry(state_, 0, 0, 0.0, BlockStates::kMass * stiffness_ / level_ * byState);
  // ∂F/∂x of the motion that goes on: ds = (σ/F_c) (flow/v) dx.
  const double part = v != 0.0 ? std::clamp(f / v, 0.0, 1.0) : 1.0;
  coordinate_.row().addStiffness(k, loaded(k) * stiffness_ * part, more(1.0, part), sink);
}

void Presliding::describe(Description& d) const {
  coordinate_.describe(d);
  d.signal("force", Unit::any, "force or moment on B in the coordinate",
           [this](const SignalView& v) { return force(*v.kinematics); });
  SignalFormulas::announce(d, {&load_});
}

// ---- DahlFriction ------------------------------------------------------------------------------

void DahlFriction::declare(Attributes& a) {
  a.about(
      "Dahl's friction in a joint coordinate: a spring that yields, with a hysteresis that depends "
      "on the way alone. s' = sigma/F_c v (1 - s sgn v)^exponent, F = -F_c s. Signals: position, "
      "rate, force, deflection (s).");
  declarePresliding(a);
  a.optional("exponent", Unit::none, 1.0, "shape of the hysteresis").atLeast(1.0);
  a.example(
      "<DahlFriction name=\"f\" between=\"world cart\" coordinate=\"displacement\" axis=\"1 0 0\" "
      "stiffness=\"1e5\" force=\"20\"/>");
}

double DahlFriction::flow(double v, double s, double* byState) const {
  const double sign = v < 0.0 ? -1.0 : 1.0, rest = std::max(0.0, 1.0 - s * sign);
  if (exponent_ == 1.0) {
    if (byState) *byState = -std::abs(v);
    return v * (1.0 - s * sign);
  }
  const double power = std::pow(rest, exponent_ - 1.0);
  if (byState) *byState = -std::abs(v) * exponent_ * power;
  return v * power * rest;
}

// ---- LuGreFriction -----------------------------------------------------------------------------

void LuGreFriction::declare(Attributes& a) {
  a.about(
      "LuGre friction in a joint coordinate: bristles that bend before they slip, with friction "
      "that "
      "falls from F_s to F_c with the speed, and damping. Without damping and with equal forces it "
      "is "
      "Dahl's. Signals: position, rate, force, deflection (s).");
  declarePresliding(a);
  Attribute& most = a.add(AttributeType::number, "staticForce", std::nullopt,
                          "friction F_s at the onset of slip [N or N m]; default: F_c");
  most.unit = Unit::any;
  most.mayBeAbsent().positive();
  a.optional("speed", Unit::any, 0.01, "Stribeck's speed v_s [m/s or rad/s]").positive();
  a.optional("damping", Unit::any, 0.0, "damping of the bristles [N s/m or N m s/rad]")
      .nonNegative();
  a.optional("viscous", Unit::any, 0.0, "viscous friction c [N s/m or N m s/rad]").nonNegative();
  a.example(
      "<LuGreFriction name=\"f\" between=\"world cart\" coordinate=\"displacement\" axis=\"1 0 0\" "
      "stiffness=\"1e5\" force=\"1\" staticForce=\"1.5\" speed=\"1mm/s\" damping=\"300\" "
      "viscous=\"0.4\"/>");
}

LuGreFriction::LuGreFriction(const Parameters& x)
    : Presliding(x),
      static_(x.has("staticForce") ? double(x["staticForce"]) : double(x["force"])),
      speed_(x["speed"]),
      damping_(x["damping"]),
      viscous_(x["viscous"]) {
  hasUnits(x, "staticForce", Unit::torque, Unit::force);
  hasUnits(x, "speed", Unit::angularVelocity, Unit::velocity);
  for (const char* name : {"damping", "viscous"})
    hasUnits(x, name, Unit::rotationalDamping, Unit::damping);
  if (static_ < level())
    throw x["staticForce"].fault("the force at the onset of slip is below that of slip",
                                 "staticForce >= force", 0, x["staticForce"].text.size());
}

double LuGreFriction::flow(double v, double s, double* byState) const {
  const double w = v / speed_, g = 1.0 + (static_ / level() - 1.0) * std::exp(-w * w);
  if (byState) *byState = -std::abs(v) / g;
  return v - std::abs(v) * s / g;
}

}  // namespace dynamy
