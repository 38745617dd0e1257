#include <algorithm>
#include <dynamy/located/step/step_record.hpp>

namespace dynamy {
namespace {

/// Status of held[i].
Status statusOf(const FrozenPhase& phase, std::size_t i) {
  using Form = ForceSet::Form;
  const Form form = phase.rows().set(i).form;
  const Held& held = phase.held[i];
  if (form == Form::joint) return Status::locked;
  if (form == Form::notch)
    return !held.slips ? Status::locked : (held.sign > 0.0 ? Status::lower : Status::upper);
  bool slips = held.slips || form == Form::normal;
  for (std::size_t k = i + 1; k < phase.held.size() && phase.held[k].first > 0; ++k)
    slips = slips || phase.held[k].slips;
  return slips ? Status::slip : Status::stick;
}

}  // namespace

void StepRecord::begin() {
  percussions_.clear(), impacts_.clear(), works = {}, tImpact_ = -1e300;
  noImpulses();
}

void StepRecord::impulsesOf(const FrozenPhase& phase) {
  parts_.clear();
  for (std::size_t i = 0; i < phase.held.size(); ++i)
    parts_.push_back(
        {phase.held[i].key, phase.held[i].first, phase.rows().row0(i), phase.rows().dim(i)});
}

void StepRecord::event(const SwitchEvent& event, const FrozenPhase& phase, double t, bool impact,
                       double floor) {
  if (impact) uBefore_ = event.uBefore(), tImpact_ = t;
  for (const Percussion& q : event.impact().percussions()) {
    percussions_.push_back(q);
    if (!q.unilateral || !(-q.gammaMinus[0] > floor && q.Lambda[0] > 0.0)) continue;
    Status after = Status::open;
    for (std::size_t i = 0; i < phase.held.size(); ++i)
      if (phase.held[i].key == q.key && phase.held[i].first == 0) after = statusOf(phase, i);
    impacts_.push_back({q.key, t, after, -q.gammaMinus[0], q.Lambda[0]});
  }
  addWorks(event.impact().works());
}

/// Evaluates slot 0 again, with contacts that had a percussion in the step and have opened since.
void StepRecord::withStruck(MechanicalSystem& s, const PhaseRequest& request, const State& x) {
  const std::vector<ContactKey>& there = s.slot(0).contacts.key;
  struck_.clear();
  for (const Percussion& q : percussions_)
    if (std::any_of(q.Lambda.begin(), q.Lambda.begin() + q.dim, [](double v) { return v != 0.0; }))
      struck_.push_back(q.key);
  if (std::all_of(struck_.begin(), struck_.end(), [&](ContactKey key) {
        return std::find(there.begin(), there.end(), key) != there.end();
      }))
    return;
  struck_.insert(struck_.end(), request.keys.begin(), request.keys.end());
  std::sort(struck_.begin(), struck_.end());
  struck_.erase(std::unique(struck_.begin(), struck_.end()), struck_.end());
  s.evaluate(x, request.holding(struck_, 0));
}

void clearPercussions(ImpactProblem& p, const State& x) {
  const ContactSet& c = *p.contacts;
  p.Lambda().setZero();
  Eigen::VectorXd gamma(c.rows());
  c.gamma(view(x.u), view(gamma));
  for (int k = 0; k < c.rows(); ++k) p.gammaA[static_cast<std::size_t>(k)] = gamma[k];
  for (int i = 0; i < c.size(); ++i)
    if (c.law[static_cast<std::size_t>(i)]->unilateral())
      p.gammaA[static_cast<std::size_t>(c.row0[static_cast<std::size_t>(i)])] = 0.0;
}

void StepRecord::report(MechanicalSystem& s, const FrozenPhase& phase, State& x,
                        StepReport& report) {
  withStruck(s, phase.request, x);
  ImpactProblem& p = s.impactProblem(x, report.dt);
  const ContactSet& c = *p.contacts;
  clearPercussions(p, x);
  Vec Lambda = p.Lambda();
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const int first = c.row0[at];
    for (const Part& m : parts_)
      for (int r = 0; m.key == c.key[at] && r < m.dim; ++r)
        Lambda[first + m.first + r] += impulse[m.row + r];
    for (const Percussion& q : percussions_)
      for (int r = 0; q.key == c.key[at] && r < q.dim; ++r) {
        const auto k = static_cast<std::size_t>(r);
        Lambda[first + r] += q.Lambda[k];
        p.gammaA[static_cast<std::size_t>(first + r)] = q.gammaMinus[k];
      }
  }
  p.gammaFree = p.gammaA;
  statuses_.clear();
  for (std::size_t i = 0; i < phase.held.size(); ++i)
    if (phase.held[i].first == 0) statuses_.push_back({phase.held[i].key, statusOf(phase, i)});
  report.ownStatuses = true, report.statuses = statuses_, report.impacts = impacts_;
  x.impulses = {};
  report.contacts = c.size();
  report.works = {true, works[0], works[1], works[2], works[3], works[4]};
}

}  // namespace dynamy
