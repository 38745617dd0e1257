#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/report/energy_watch.hpp>
#include <dynamy/stages/error_norm.hpp>
#include <limits>

namespace dynamy {
namespace {

constexpr double kPositions = 1e-11;  ///< relative error of energies by positions known to g_tol
constexpr double kRises = 0.1;        ///< least share of T + |V| that a rise is
constexpr double kFewSteps = 64.0;    ///< added to the number of steps, for the rounding of one

}  // namespace

void EnergyWatch::start(const StepView& initial) {
  const Model& model = initial.model;
  kinematics_.resize(model.topology());
  const double until = model.simulation.until - initial.after.t;
  const Eigen::Index nu = initial.after.u.size();
  if (!(until > 0.0) || nu == 0) return;
  Eigen::VectorXd positions, scale, momentum(nu);
  unitScales(model.topology(), model.length(), positions, scale);
  initial.system.slot(0).mass.apply(dynamy::view(std::as_const(scale)), dynamy::view(momentum));
  inertia_ = 0.5 * scale.dot(momentum) / (until * until);
}

void EnergyWatch::sample(const StepView& view) {
  const EnergyReport e = ledger_.upTo(view.after);
  RunTrust& trust = report_.trust;
  if (!std::isfinite(e.end())) {  // beyond what numbers hold: squares of velocities overflow first
    trust.energyRise = std::numeric_limits<double>::infinity();
    trust.energyRiseTime = view.after.t, trust.diverged = true;
    return;
  }
  trust.kineticMax = std::max(trust.kineticMax, e.kineticEnd);
  const double unexplained = e.discretisation + e.joints;
  if (report_.contacts.impacts == sampledImpacts_)
    unexplained_ += unexplained - sampled_, damped_ += sampledDamped_;
  sampled_ = unexplained, sampledImpacts_ = report_.contacts.impacts, sampledDamped_ = 0.0;
  trust.dampedLoss = std::max(trust.dampedLoss, damped_);
  const double error = std::abs(unexplained_ + std::max(0.0, damped_));
  if (error > trust.energyError) trust.energyError = error, trust.energyErrorTime = view.after.t;
  rounding(e);
  const double rise = e.end() - e.start() - e.nonPotential - e.boundaries;
  if (rise > trust.energyRise) trust.energyRise = rise, trust.energyRiseTime = view.after.t;
  trust.diverged = trust.diverged || diverges(e, rise);
  // Gains count from the lowest level, so that losses in impacts do not hide later gains. Laws that
  // store energy give it back: only a rise that the scheme's own part shares is a gain.
  const double own = e.discretisation + e.stepped;
  if (rise < least_ || own < leastOwn_) sinceLeast_ = 0.0;
  least_ = std::min(least_, rise), leastOwn_ = std::min(leastOwn_, own);
  trust.regain = std::max(trust.regain, rise - least_);
  RunTrust now = trust;
  now.energyGain = std::min(rise - least_, own - leastOwn_);
  now.energyGainTime = view.after.t, now.gainStep = sinceLeast_;
  if (now.energyGain * trust.gainScale() > trust.energyGain * now.gainScale()) trust = now;
}

void EnergyWatch::damped(const StepView& view) {
  const double change = potential(view, view.after) - potential(view, view.before);
  sampledDamped_ -= view.report.dampedWork + change;
}

/// V of the forces that the step damped [J].
double EnergyWatch::potential(const StepView& view, const State& x) {
  const Topology& topology = view.model.topology();
  kinematics_.evaluate(topology, x.t, dynamy::view(x.q), dynamy::view(x.u), dynamy::view(x.memory));
  const std::span<const char> which = view.system.implicitForces().dampedForces();
  double V = 0.0;
  for (std::size_t i = 0; i < which.size(); ++i)
    if (which[i] != 0) V += view.system.parts().forces[i]->potentialEnergy(kinematics_);
  return V;
}

/// Has T + V risen by far more than all that the run began with and all works? What is left of T and
/// V that balance each other is no rise.
bool EnergyWatch::diverges(const EnergyReport& e, double rise) const {
  if (!(inertia_ > 0.0)) return false;  // no measure of what is little
  const double known = e.kineticStart + std::abs(e.potentialStart) + std::abs(e.nonPotential) +
                       std::abs(e.friction) + std::abs(e.normal) + std::abs(e.joints) +
                       std::abs(e.boundaries) + inertia_;
  return rise > RunTrust::kDiverged * known &&
         rise > kRises * (e.kineticEnd + std::abs(e.potentialEnd));
}

void EnergyWatch::rounding(const EnergyReport& e) {
  moves_ = std::max(moves_, e.kineticEnd + std::abs(e.potentialEnd) + std::abs(e.nonPotential) +
                                std::abs(e.friction) + std::abs(e.normal) + std::abs(e.joints) +
                                std::abs(e.boundaries));
  const double steps = kFewSteps + static_cast<double>(report_.steps);
  report_.trust.rounding = std::max(kEpsilon * steps, kPositions) * moves_ + kEpsilon * inertia_;
}

void EnergyWatch::archive(Archive& a) {
  a.section("energy watch");
  a(sampled_), a(unexplained_), a(sampledImpacts_), a(least_), a(leastOwn_), a(sinceLeast_);
  a(inertia_), a(moves_), a(sampledDamped_), a(damped_);
}

}  // namespace dynamy
