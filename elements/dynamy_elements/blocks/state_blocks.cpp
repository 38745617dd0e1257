#include <dynamy_elements/blocks/state_blocks.hpp>

namespace dynamy {
namespace {

/// Mass of a state: its kinetic energy is no part of the energies of the model [kg].
constexpr double kMass = 1e-12;

/// The state of a block: ∫x dt and x.
class BlockState final : public PartialMechanicalSystem {
 public:
  BlockState(const Parameters& x, double initial) : PartialMechanicalSystem(x), initial_(initial) {}
  Blocks blocks() const override { return {.nq = 1, .nu = 1, .constantMass = true}; }
  void initialState(Vec q, Vec u) const override { q[0] = 0.0, u[0] = initial_; }
  void M(double, ConstVec, MassBlocks M) const override { M[0](0, 0) = kMass; }
  void h(double, ConstVec, ConstVec, Vec h) const override { h[0] = 0.0; }
  bool feelsGravity(ConstVec) const override { return false; }
  void describe(Description& d) const override {
    d.velocity("out", Unit::any, 0, "state of the block");
    d.coordinate("integral", Unit::any, 0, "its integral since the start");
  }

 private:
  double initial_;
};

}  // namespace

void StateBlock::declareState(Attributes& a) {
  a.optional("initial", Unit::any, 0.0, "state at the start");
  a.add(AttributeType::flag, "stiff", "false",
        "true: fixed steps take the state linearly implicitly, for rates of change that are faster "
        "than the steps");
}

StateBlock::StateBlock(const Parameters& x)
    : ExternalForce(x), initial_(x["initial"]), stiff_(x["stiff"].flag()) {
  if (x.name.empty())
    throw ModelError("the block has no name", "formulas read it as NAME.out: add name=\"…\"");
}

std::unique_ptr<PartialMechanicalSystem> StateBlock::ownSystem() const {
  Parameters x;
  x.type = type(), x.name = name(), x.place = place();
  return std::make_unique<BlockState>(x, initial_);
}

void StateBlock::connect(Topology& topology) {
  system_ = topology.system(name(), *this);
  of_.connect(topology, *this);
}

void StateBlock::addTo(const Kinematics& k, ForceSink& sink) const {
  sink.generalised(system_, 0, kMass * rate(k, k.u(system_)[0], nullptr));
}

void StateBlock::addStiffness(const Kinematics& k, StiffnessSink& sink) const {
  double byState = 0.0;
  rate(k, k.u(system_)[0], &byState);
  sink.entry(system_, 0, 0, 0.0, kMass * byState);
}

void StateBlock::describe(Description& d) const { SignalFormulas::announce(d, {&of_}); }

void Integrator::declare(Attributes& a) {
  a.about(
      "State x with the rate f: integrals, filters and controllers of any order from several of "
      "them. Under the error control of the scheme. Signals: out (x), integral.");
  a.add(AttributeType::expression, "rate", std::nullopt,
        "x' as a formula of t, of the state x itself and of signals");
  declareState(a);
  a.example("<Integrator name=\"i\" rate=\"0.5 - cart.x\"/>");
}

double Integrator::rate(const Kinematics& k, double x, double* byState) const {
  const double f = of_.value(k, &x);
  if (byState) *byState = of_.partial(0);
  return f;
}

void Filter::declare(Attributes& a) {
  a.about("Low pass of first order: x' = (f - x)/T. Signals: out (x), integral.");
  a.add(AttributeType::expression, "of", std::nullopt, "f as a formula of t and signals");
  a.required("time", Unit::time, "time constant T [s]").positive();
  declareState(a);
  a.example("<Filter name=\"smooth\" of=\"cart.vx\" time=\"20ms\"/>");
}

double Filter::rate(const Kinematics& k, double x, double* byState) const {
  if (byState) *byState = -1.0 / time_;
  return (of_.value(k) - x) / time_;
}

}  // namespace dynamy
