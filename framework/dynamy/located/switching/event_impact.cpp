#include <algorithm>
#include <dynamy/located/switching/event_impact.hpp>
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

/// Sets gamma_. Returns the speed of the contact that approaches fastest, at least zero.
double EventImpact::fastestApproach(const OngoingEvent& at) {
  const ContactSet& c = at.s.slot(0).contacts;
  gamma_.resize(c.rows());
  c.gamma(view(std::as_const(at.p.x.u)), view(gamma_));
  double fastest = 0.0;
  for (int i = 0; i < c.size(); ++i)
    if (c.law[static_cast<std::size_t>(i)]->unilateral())
      fastest = std::max(fastest, -gamma_[c.row0[static_cast<std::size_t>(i)]]);
  return fastest;
}

void EventImpact::take(OngoingEvent& at, const std::vector<ContactKey>& plastic) {
  clear();
  const double fastest = fastestApproach(at);
  leaves_ = std::max(at.restSpeed(), 1e-9 * fastest);
  if (!(fastest > at.restSpeed())) return;
  ContactSet& c = at.s.change(0).contacts;
  wrappers_.clear();
  for (std::size_t i = 0; i < c.law.size(); ++i)
    if (std::find(plastic.begin(), plastic.end(), c.key[i]) != plastic.end()) {
      wrappers_.push_back(std::make_unique<WithoutRebound>(c.law[i]));
      c.law[i] = wrappers_.back().get();
    }
  gammaBefore_ = gamma_;
  solve(at);
  c.gamma(view(std::as_const(at.p.x.u)), view(gamma_));
  note(at.s);
}

bool EventImpact::stop(OngoingEvent& at) {
  if (!(fastestApproach(at) > at.stillSpeed())) return false;
  ContactSet& c = at.s.change(0).contacts;
  wrappers_.clear();
  for (const SetValuedForceLaw*& law : c.law) {
    wrappers_.push_back(std::make_unique<WithoutRebound>(law));
    law = wrappers_.back().get();
  }
  solve(at);
  return true;
}

void EventImpact::solve(OngoingEvent& at) {
  MechanicalSystem& s = at.s;
  State& x = at.p.x;
  x.impulses = {};
  ImpactProblem& problem = s.impactProblem(x, 0.0);
  const SolveReport solved = problem.solve(at.solver);
  SolveReport& report = at.result.solved;
  const bool inVain = report.inVain || solved.inVain;
  if (!solved.ok()) report = solved;
  report.inVain = inVain;
  report.repaired += solved.repaired;
  report.energyGain = std::max(report.energyGain, solved.energyGain);
  problem.velocityFromImpulses(x);
  x.impulses = {};
}

void EventImpact::note(const MechanicalSystem& s) {
  const ContactSet& c = s.slot(0).contacts;
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    Percussion p{
        c.key[at], std::min(c.dim(i), kMostRows), {}, {}, c.law[at]->rowKind(0) == RowKind::normal};
    for (int k = 0; k < p.dim; ++k) {
      const int row = c.row0[at] + k;
      const double Lambda = s.problem().Lambda(row);
      p.Lambda[static_cast<std::size_t>(k)] = Lambda;
      p.gammaMinus[static_cast<std::size_t>(k)] = gammaBefore_[row];
      bookWork(works_, c.law[at]->rowKind(k), Lambda, 0.5 * (gammaBefore_[row] + gamma_[row]),
               c.chi[row]);
    }
    percussions_.push_back(p);
  }
}

}  // namespace dynamy
