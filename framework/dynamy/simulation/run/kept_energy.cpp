#include <algorithm>
#include <cmath>
#include <dynamy/simulation/run/kept_energy.hpp>
#include <utility>

namespace dynamy {
namespace {

/// Part of T up to which an error is one of the step, and not of a body that just turns back.
constexpr double kMost = 0.5;

/// T of a system of one block [J].
double kinetic(const MassMatrix& mass, const Eigen::VectorXd& u, const SystemHandle& h) {
  const auto own = u.segment(h.u0, h.nu);
  return 0.5 * own.dot(mass.M(h.block0) * own);
}

}  // namespace

KeptEnergy::KeptEnergy(const Model& model) : model_(model) {
  for (std::size_t i = 0; i < model.systems().size(); ++i) {
    const PartialMechanicalSystem& system = *model.systems()[i];
    if (system.abilities().carrier != nullptr && !system.blocks().constantMass)
      jointed_.push_back({.system = static_cast<int>(i)});
  }
  if (!jointed_.empty()) mass_.resize(model.topology());
}

void KeptEnergy::keep(const MechanicalSystem& system, const StepReport& report, const State& before,
                      State& after) {
  error_ = 0.0;
  // Forces that are taken at the end of the step are no part of h.
  const ImplicitForces& implicit = system.implicitForces();
  const bool other = implicit.any() || implicit.unresolved() || implicit.damped() > 0;
  if (jointed_.empty() || other || report.resting || !report.apart.empty() || !after.u.allFinite())
    return;
  const Evaluation& at = system.slot(0);
  addEnds(before, after);
  setGyroscopic(at);
  findDriven(at.contacts);
  const Eigen::VectorXd& start = report.jump != nullptr ? report.jump->u : before.u;
  double errors = 0.0, energy = 0.0;
  for (Jointed& j : jointed_) {
    const SystemHandle& h = model_.topology().system(j.system);
    const auto u = after.u.segment(h.u0, h.nu);
    j.e = j.kineticE - kinetic(at.mass, after.u, h) - j.kineticA + kinetic(at.mass, before.u, h) +
          0.5 * report.dt * gyroscopic_.segment(h.u0, h.nu).dot(start.segment(h.u0, h.nu) + u);
    errors += std::abs(j.e), energy += j.kineticA + j.kineticE;
    if (!j.driven && std::abs(j.e) < kMost * j.kineticE)
      after.u.segment(h.u0, h.nu) *= std::sqrt(1.0 - j.e / j.kineticE);
  }
  if (energy > 0.0) error_ = errors / energy;
}

/// T of all jointed systems at both ends of the step.
void KeptEnergy::addEnds(const State& before, const State& after) {
  for (const State* x : {&before, &after}) {
    mass_.evaluate(model_.topology(), x->t, view(x->q));
    for (Jointed& j : jointed_)
      (x == &before ? j.kineticA : j.kineticE) =
          kinetic(mass_, x->u, model_.topology().system(j.system));
  }
}

/// What h holds besides the forces of elements, at q^M.
void KeptEnergy::setGyroscopic(const Evaluation& at) {
  gyroscopic_.setZero(at.h.size()), unused_.setZero(at.h.size());
  ForceSink sink(view(gyroscopic_), view(unused_));
  for (const auto& f : model_.forces()) f->addTo(at.kinematics, sink);
  gyroscopic_ = at.h - gyroscopic_;
}

void KeptEnergy::findDriven(const ContactSet& c) {
  for (Jointed& j : jointed_) j.driven = false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(c.size()); ++i) {
    const auto first = c.chi.begin() + c.row0[i], last = c.chi.begin() + c.row0[i + 1];
    if (std::all_of(first, last, [](double chi) { return chi == 0.0; })) continue;
    for (int s = c.segment0[i]; s < c.segment0[i + 1]; ++s)
      for (Jointed& j : jointed_) {
        const SystemHandle& h = model_.topology().system(j.system);
        const int u0 = c.segment[static_cast<std::size_t>(s)].u0;
        j.driven = j.driven || (h.u0 <= u0 && u0 < h.u0 + h.nu);
      }
  }
}

}  // namespace dynamy
