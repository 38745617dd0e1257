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
  const double unexplained = e.discretisation + e.joints, elastic = this->elastic(view);
  if (report_.contacts.impacts == sampledImpacts_) {
    const double change = unexplained - sampled_;
    const double damped =
        damps_ ? std::clamp(-change, 0.0, std::max(0.0, elastic_ - elastic)) : 0.0;
    trust.dampedLoss += damped, unexplained_ += change + damped;
  }
  damps_ = false, elastic_ = elastic;
  sampled_ = unexplained, sampledImpacts_ = report_.contacts.impacts;
  const double error = std::abs(unexplained_);
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

/// V of the forces that may act between bodies, not of fields such as gravity [J].
double EnergyWatch::elastic(const StepView& view) {
  const auto& forces = view.model.forces();
  const auto acts = [](const auto& f) { return f->mayCouple(); };
  if (view.scheme.choosesSteps() || std::none_of(forces.begin(), forces.end(), acts)) return 0.0;
  const State& x = view.after;
  kinematics_.resize(view.model.topology());
  kinematics_.evaluate(view.model.topology(), x.t, dynamy::view(x.q), dynamy::view(x.u),
                       dynamy::view(x.memory));
  double V = 0.0;
  for (const auto& f : forces)
    if (acts(f)) V += f->potentialEnergy(kinematics_);
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
  a(inertia_), a(moves_), a(damps_), a(elastic_);
}

}  // namespace dynamy
