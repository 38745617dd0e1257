#include <algorithm>
#include <cmath>
#include <dynamy/simulation/run/energy_gain.hpp>

namespace dynamy {
namespace {

/// Share of T above which a gain is taken back, a half of what the run warns of.
constexpr double kTakenBack = 0.005;

}  // namespace

EnergyGain::Rise EnergyGain::rise(const MechanicalSystem& system, const State& before,
                                  const State& after, double dt) {
  Rise r;
  r.kineticStart = meter_.kinetic(before), r.kineticEnd = meter_.kinetic(after);
  // V of both places at one time: what changes V with time is work of its own.
  const double tM = 0.5 * (before.t + after.t);
  r.energy = r.kineticEnd - r.kineticStart + potentialAt(tM, after) - potentialAt(tM, before);
  r.energy -= 0.5 * dt * system.slot(0).hNonPotential.dot(before.u + after.u);
  const ContactSet& c = system.slot(0).contacts;
  const ConstVec Lambda = system.problem().Lambda();
  for (int k = 0; k < c.rows() && Lambda.size() == c.rows(); ++k)  // moving ground, driven joints
    r.energy += Lambda[k] * c.chi[static_cast<std::size_t>(k)];
  return r;
}

double EnergyGain::potentialAt(double t, const State& x) {
  at_.q = x.q, at_.u = x.u, at_.memory = x.memory, at_.t = t;
  return meter_.potential(at_);
}

double EnergyGain::takeBack(const MechanicalSystem& system, const StepReport& report,
                            const State& before, State& after) {
  if (report.resting || (report.solved.ok() && system.implicitForces().damped() == 0)) return 0.0;
  const Rise r = rise(system, before, after, report.dt);
  if (!(r.share() > kTakenBack)) return 0.0;
  // Islands with clocks of their own have not taken this step.
  at_.q = after.q, at_.u = after.u, at_.memory = after.memory, at_.t = after.t;
  const Topology& topology = *system.parts().topology;
  const auto each = [&](bool apart, Eigen::VectorXd& u, double factor) {
    for (std::size_t i = 0; i < topology.systems().size(); ++i) {
      const SystemHandle& h = topology.system(static_cast<int>(i));
      const bool own = i < report.apart.size() && report.apart[i] != 0;
      if (own == apart) u.segment(h.u0, h.nu) *= factor;
    }
  };
  each(true, at_.u, 0.0);
  const double kinetic = meter_.kinetic(at_), taken = std::min(r.energy, kinetic);
  if (!(taken > 0.0)) return 0.0;
  each(false, after.u, std::sqrt((kinetic - taken) / kinetic));
  return taken;
}

}  // namespace dynamy
