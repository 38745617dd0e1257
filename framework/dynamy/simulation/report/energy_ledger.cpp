#include <algorithm>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/report/energy_ledger.hpp>
#include <utility>

namespace dynamy {

void EnergyReport::archive(Archive& a) {
  for (double* x : {&kineticStart, &potentialStart, &kineticEnd, &potentialEnd, &nonPotential,
                    &friction, &normal, &joints, &boundaries, &discretisation, &imbalance,
                    &largestGain, &largestGainTime, &stepped})
    a(*x);
}

EnergyMeter::EnergyMeter(const Model& model) : model_(model) {
  kinematics_.resize(model.topology());
  mass_.resize(model.topology());
}

double EnergyMeter::kinetic(const State& x) {
  mass_.evaluate(model_.topology(), x.t, view(x.q));
  return mass_.kineticEnergy(view(x.u));
}

double EnergyMeter::potential(const State& x) {
  double V = 0.0;
  for (std::size_t i = 0; i < model_.systems().size(); ++i) {
    const SystemHandle& s = model_.topology().system(static_cast<int>(i));
    V += model_.systems()[i]->potentialEnergy(x.t, slice(x.q, s.q0, s.nq));
  }
  if (model_.forces().empty()) return V;
  kinematics_.evaluate(model_.topology(), x.t, view(x.q), view(x.u), view(x.memory));
  for (const auto& f : model_.forces()) V += f->potentialEnergy(kinematics_);
  return V;
}

void EnergyLedger::start(const StepView& initial) {
  report_.kineticStart = meter_.kinetic(initial.after);
  report_.potentialStart = meter_.potential(initial.after);
}

void EnergyLedger::step(const StepView& v) {
  if (v.report.resting) return;
  if (const StepWorks& w = v.report.works; w.given) {
    add(w);
    const double gain = w.friction + w.normal;
    if (gain > report_.largestGain) report_.largestGain = gain, report_.largestGainTime = v.after.t;
    return;
  }
  const Evaluation& e = v.system.slot(0);
  const double dt = v.report.dt;
  const Jump* jump = v.report.jump;
  uA_ = jump ? jump->u : v.before.u, uE_ = v.after.u;
  leaveApart(v);
  uMean_ = 0.5 * (uA_ + uE_);
  momentum_.resize(uMean_.size());
  e.mass.apply(view(std::as_const(uMean_)), view(momentum_));
  const double dT = momentum_.dot(uE_) - momentum_.dot(uA_);
  const double workH = dt * e.h.dot(uMean_);
  nonPotential_.add(dt * e.hNonPotential.dot(uMean_));
  if (jump) addJump(v);
  imbalance_.add(dT), imbalance_.add(-workH), imbalance_.add(-contactWork(v));
}

/// Excludes the systems that did not move by the equations of the step: the step reports their
/// works, and their velocities are set to zero.
void EnergyLedger::leaveApart(const StepView& v) {
  apart_.assign(v.report.apart.empty() ? 0 : static_cast<std::size_t>(uA_.size()), 0);
  if (apart_.empty()) return;
  add(v.report.works);
  for (std::size_t i = 0; i < v.report.apart.size(); ++i) {
    const SystemHandle& s = model_.topology().system(static_cast<int>(i));
    if (v.report.apart[i] == 0) continue;
    uA_.segment(s.u0, s.nu).setZero(), uE_.segment(s.u0, s.nu).setZero();
    std::fill_n(apart_.begin() + s.u0, s.nu, 1);
  }
}

bool EnergyLedger::isApart(const ContactSet& c, int contact) const {
  const auto at = static_cast<std::size_t>(contact);
  return !apart_.empty() && c.segment0[at] < c.segment0[at + 1] &&
         apart_[static_cast<std::size_t>(c.segment[static_cast<std::size_t>(c.segment0[at])].u0)] !=
             0;
}

void EnergyLedger::add(const StepWorks& w) {
  nonPotential_.add(w.nonPotential), friction_.add(w.friction), normal_.add(w.normal);
  joints_.add(w.joints), boundaries_.add(w.boundaries);
}

/// Adds the works of contacts in the step itself.
void EnergyLedger::addInStep(const StepView& v, const StepWorks& w) {
  add(w);
  if (v.report.counts.stepped) stepped_.add(w.normal + w.joints);
}

void EnergyLedger::addJump(const StepView& v) {
  const Jump& jump = *v.report.jump;
  if (apart_.empty()) return addInStep(v, jump.works);
  const ContactSet& c = v.system.slot(0).contacts;
  std::vector<double> before(static_cast<std::size_t>(c.rows())), after = before;
  c.gamma(view(v.before.u), {before.data(), c.rows()});
  c.gamma(view(jump.u), {after.data(), c.rows()});
  for (int i = 0; i < c.size(); ++i)
    for (int r = 0; r < c.dim(i) && !isApart(c, i); ++r) {
      const auto k = static_cast<std::size_t>(c.row0[static_cast<std::size_t>(i)] + r);
      StepWorks w;
      w.book(c.law[i]->rowKind(r), jump.Lambda[k], 0.5 * (before[k] + after[k]), c.chi[k]);
      addInStep(v, w);
    }
}

void EnergyLedger::bring(const State& before, const State& after) {
  boundaries_.add(meter_.kinetic(after) + meter_.potential(after));
  boundaries_.add(-meter_.kinetic(before) - meter_.potential(before));
}

/// Books the works of the contacts in the step, after its jump if it had one, and returns their sum
/// [J].
double EnergyLedger::contactWork(const StepView& v) {
  const ContactSet& c = v.system.slot(0).contacts;
  if (c.size() == 0 || v.Lambda.size() != c.rows()) return 0.0;
  const Jump* jump = v.report.jump;
  if (jump) {
    gammaA_.resize(static_cast<std::size_t>(c.rows()));
    c.gamma(view(jump->u), {gammaA_.data(), c.rows()});
  }
  const std::vector<double>& gammaA = jump ? gammaA_ : v.system.problem().gammaA;
  double all = 0.0, gain = 0.0;
  for (int i = 0; i < c.size(); ++i) {
    if (isApart(c, i)) continue;
    const auto at = static_cast<std::size_t>(i);
    for (int r = 0; r < c.dim(i); ++r) {
      const int k = c.row0[at] + r;
      const auto row = static_cast<std::size_t>(k);
      const double Lambda = v.Lambda[k] - (jump ? jump->Lambda[row] : 0.0);
      const double gamma = 0.5 * (gammaA[row] + v.gammaE[k]);
      StepWorks w;
      w.book(c.law[at]->rowKind(r), Lambda, gamma, c.chi[row]);
      addInStep(v, w);
      all += Lambda * gamma - Lambda * c.chi[row];
      gain += w.friction + w.normal;
    }
  }
  if (gain > report_.largestGain) report_.largestGain = gain, report_.largestGainTime = v.after.t;
  return all;
}

EnergyReport EnergyLedger::upTo(const State& x) {
  EnergyReport r = report_;
  r.kineticEnd = meter_.kinetic(x);
  r.potentialEnd = meter_.potential(x);
  r.nonPotential = nonPotential_.value();
  r.friction = friction_.value();
  r.normal = normal_.value();
  r.joints = joints_.value();
  r.boundaries = boundaries_.value();
  r.imbalance = imbalance_.value();
  r.stepped = stepped_.value();
  // ΔT + ΔV − works, small differences last.
  r.discretisation =
      (r.kineticEnd - r.kineticStart) + (r.potentialEnd - r.potentialStart) - r.works();
  return r;
}

void EnergyLedger::finish(const StepView& last) { report_ = upTo(last.after); }

void EnergyLedger::archive(Archive& a) {
  a.section("energy");
  a(report_);
  a(nonPotential_), a(friction_), a(normal_), a(joints_), a(boundaries_), a(imbalance_);
  a(stepped_);
}

}  // namespace dynamy
