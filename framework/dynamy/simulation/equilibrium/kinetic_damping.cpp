#include <fmt/format.h>

#include <dynamy/simulation/equilibrium/kinetic_damping.hpp>
#include <dynamy/simulation/run/simulation.hpp>

namespace dynamy {

KineticDamping::KineticDamping(Model& model, const State& from, double longest)
    : model_(model), at_(from), longest_(longest) {
  at_.u.setZero();
}

bool KineticDamping::next() {
  const double t0 = at_.t;
  model_.simulation.until = t0 + longest_;
  StepPlan plan;
  plan.from = &at_;
  Simulation simulation(model_, &plan);
  MechanicalSystem system = model_.mechanicalSystem();
  double before = 0.0;
  while (simulation.step()) {
    ++steps_;
    const State& x = simulation.state();
    const double T = system.evaluate(x).mass.kineticEnergy(view(x.u));
    if (T < before) {
      peak_ = before, at_ = x;
      // Forces that depend on time stay near those at the start.
      at_.t = t0, at_.u.setZero();
      return true;
    }
    before = T;
  }
  const RunReport& report = simulation.report();
  why_ = report.ended == RunReport::Ended::finished
             ? fmt::format("the motion still gets faster after {:.3g} s", longest_)
             : report.reason;
  at_ = simulation.state(), at_.t = t0;
  return false;
}

}  // namespace dynamy
