#include <algorithm>
#include <cmath>
#include <dynamy/simulation/run/kept_energy.hpp>
#include <utility>

namespace dynamy {
namespace {

/// Part of T up to which an error is one of the step, and not of a body that just turns back.
constexpr double kMost = 0.5;

}  // namespace

KeptEnergy::KeptEnergy(const Model& model) : model_(model) {
  for (const auto& system : model.systems()) {
    jointed_.push_back(system->abilities().carrier != nullptr ? 1 : 0);
    any_ = any_ || jointed_.back() != 0;
  }
  if (!any_) return;
  kinematics_.resize(model.topology());
  mass_.resize(model.topology());
}

void KeptEnergy::keep(const MechanicalSystem& system, const StepReport& report, const State& before,
                      State& after) {
  error_ = 0.0;
  const ImplicitForces& implicit = system.implicitForces();
  // Forces that are taken at the end of the step do not do the work Δt f·ū.
  const bool other = implicit.any() || implicit.unresolved() || implicit.damped() > 0;
  if (!any_ || other || report.resting || !report.apart.empty() || !after.u.allFinite()) return;
  const Evaluation& at = system.slot(0);
  const double kineticA = kinetic(before, jointed_), kineticE = kinetic(after, jointed_);
  double e = kineticE - kineticAt(at.mass, after.u) - kineticA + kineticAt(at.mass, before.u);
  // V of both places at one time: what changes V with time is work of its own.
  const double tM = 0.5 * (before.t + after.t);
  e += potential(tM, after) - potential(tM, before);
  u_ = 0.5 * ((report.jump != nullptr ? report.jump->u : before.u) + after.u);
  e += report.dt * workOfForces(system, u_);
  if (!(kineticA + kineticE > 0.0)) return;
  error_ = std::abs(e) / (kineticA + kineticE);
  chooseKept(system);
  const double own = kinetic(after, kept_);
  if (std::abs(e) < kMost * own) scale(kept_, true, after.u, std::sqrt((own - e) / own));
}

/// T of some systems [J].
double KeptEnergy::kinetic(const State& x, const std::vector<char>& of) {
  mass_.evaluate(model_.topology(), x.t, view(x.q));
  u_ = x.u;
  scale(of, false, u_, 0.0);
  return mass_.kineticEnergy(view(std::as_const(u_)));
}

double KeptEnergy::kineticAt(const MassMatrix& mass, const Eigen::VectorXd& u) {
  u_ = u;
  scale(jointed_, false, u_, 0.0);
  return mass.kineticEnergy(view(std::as_const(u_)));
}

/// V of all forces [J].
double KeptEnergy::potential(double t, const State& x) {
  kinematics_.evaluate(model_.topology(), t, view(x.q), view(x.u), view(x.memory));
  double V = 0.0;
  for (const auto& f : model_.forces()) V += f->potentialEnergy(kinematics_);
  return V;
}

/// Power at q^M and ū of forces that have a potential, and of the gyroscopic terms of the jointed systems [W].
double KeptEnergy::workOfForces(const MechanicalSystem& system, const Eigen::VectorXd& mean) {
  const Evaluation& at = system.slot(0);
  h_.setZero(mean.size()), hNonPotential_.setZero(mean.size());
  ForceSink sink(view(h_), view(hNonPotential_));
  for (const auto& f : model_.forces()) {
    sink.hasPotential(f->hasPotential());
    f->addTo(at.kinematics, sink);
  }
  const double power = (h_ - hNonPotential_).dot(mean);
  h_ = at.h - h_;
  scale(jointed_, false, h_, 0.0);
  return power + h_.dot(mean);
}

void KeptEnergy::scale(const std::vector<char>& of, bool chosen, Eigen::VectorXd& u,
                       double factor) const {
  for (std::size_t i = 0; i < of.size(); ++i) {
    const SystemHandle& h = model_.topology().system(static_cast<int>(i));
    if ((of[i] != 0) == chosen) u.segment(h.u0, h.nu) *= factor;
  }
}

/// All but those with velocities that a drive or a moving boundary prescribes, which are to hold.
void KeptEnergy::chooseKept(const MechanicalSystem& system) {
  kept_ = jointed_;
  const ContactSet& c = system.slot(0).contacts;
  const auto leave = [&](int u0) {
    for (std::size_t k = 0; k < kept_.size(); ++k) {
      const SystemHandle& h = model_.topology().system(static_cast<int>(k));
      if (h.u0 <= u0 && u0 < h.u0 + h.nu) kept_[k] = 0;
    }
  };
  for (std::size_t i = 0; i < static_cast<std::size_t>(c.size()); ++i) {
    const auto first = c.chi.begin() + c.row0[i], last = c.chi.begin() + c.row0[i + 1];
    if (std::all_of(first, last, [](double chi) { return chi == 0.0; })) continue;
    for (int s = c.segment0[i]; s < c.segment0[i + 1]; ++s)
      leave(c.segment[static_cast<std::size_t>(s)].u0);
  }
}

}  // namespace dynamy
