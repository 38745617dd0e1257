#include <algorithm>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/report/step_statistics.hpp>

namespace dynamy {

void StepStatistics::step(const StepView& v) {
  RunReport& r = report_;
  ++r.steps;
  r.t = v.after.t;
  if (v.report.simpler && r.simpler.steps++ == 0) r.simpler.firstEnd = r.t;
  const StepCounts& counts = v.report.counts;
  r.rejected += counts.rejected, r.located.switches += counts.switches;
  r.located.islands = std::max(r.located.islands, static_cast<long>(counts.islands));
  r.cost.effort.smooth += counts.effort.smooth, r.cost.effort.rejected += counts.effort.rejected;
  r.cost.effort.switches += counts.effort.switches, r.cost.effort.events += counts.effort.events;
  r.cost.effort.stepping += counts.effort.stepping;
  r.cost.effort.looks += counts.effort.looks, r.cost.effort.gaps += counts.effort.gaps;
  if (counts.stepped) stepped(v);
  if (counts.accumulations > 0) r.located.accumulationEnd = counts.accumulationEnd;
  r.located.accumulations += counts.accumulations, r.located.undecided += counts.undecided;
  if (counts.unseen > r.located.unseen.value)
    r.located.unseen.value = counts.unseen, r.located.unseen.t = v.before.t;
  r.contacts.most = std::max(r.contacts.most, v.report.contacts);
  r.contacts.repairedImpacts += v.report.solved.repaired;
  if (v.report.solved.energyGain > r.contacts.energyGain.value)
    r.contacts.energyGain.value = v.report.solved.energyGain, r.contacts.energyGain.t = v.after.t;
  if (v.report.contacts > 0) {
    ++r.solver.solves;
    r.solver.iterations += v.report.solved.iterations;
    r.solver.iterationsMax = std::max(r.solver.iterationsMax, v.report.solved.iterations);
    if (!v.report.solved.ok()) ++r.solver.unconverged;
    const Residuals& e = v.report.solved.residuals;
    if (e.largest() > r.solver.residual.value) {
      r.solver.residual.value = e.largest(), r.solver.residual.t = v.after.t;
      const ContactSet& c = v.system.slot(0).contacts;
      if (e.worst >= 0 && e.worst < c.size())
        r.solver.residual.contact = c.key[static_cast<std::size_t>(e.worst)];
    }
  }
  // An implicit scheme may miss its equations without any contact.
  if (v.report.contacts == 0 && !v.report.solved.ok()) ++r.solver.unconverged;
  gaps(v);
  statuses(v);
}

void StepStatistics::stepped(const StepView& v) {
  SteppingReport& r = report_.stepping;
  const StepCounts& counts = v.report.counts;
  if (counts.turnedBy != TurnedBy::none) {
    if (++r.periods == 1) r.first.t = v.before.t, r.first.contact = counts.turnedAt;
    r.stalls += counts.turnedBy == TurnedBy::stall ? 1 : 0;
    r.impatient += counts.turnedBy == TurnedBy::patience ? 1 : 0;
  }
  ++r.steps, r.time += v.report.dt;
  r.systems = std::max(r.systems, counts.steppedSystems);
  r.longest = std::max(r.longest, v.report.dt), r.error = std::max(r.error, counts.stepError);
  r.total += counts.stepError;
}

void StepStatistics::gaps(const StepView& v) {
  const ContactSet& c = v.system.slot(0).contacts;
  Worst& worst = report_.gaps.solvedOverlap;
  for (std::size_t i = 0; i < c.g.size(); ++i) {
    if (!(-c.g[i] > worst.value)) continue;
    const int closed = c.closedIndex[i];
    if (closed >= 0 && !c.law[static_cast<std::size_t>(closed)]->unilateral()) continue;
    worst.value = -c.g[i], worst.t = v.system.slot(0).t, worst.contact = c.candidateKey[i];
  }
  if (worst.value > report_.gaps.penetration.value) report_.gaps.penetration = worst;
}

namespace {

/// Status of contact i from the end of the step on.
Status statusAfter(const StepView& v, int i) {
  if (!isReported(v, i)) return contactStatus(v, i);
  const ContactKey key = v.system.slot(0).contacts.key[static_cast<std::size_t>(i)];
  for (const HeldStatus& s : v.report.statuses)
    if (s.key == key) return s.status;
  return Status::open;
}

}  // namespace

void StepStatistics::statuses(const StepView& v) {
  const ContactSet& c = v.system.slot(0).contacts;
  now_.clear();
  now_.reserve(before_.capacity());
  impacts_.look();
  for (int i = 0; i < c.size(); ++i) {
    const ContactKey key = c.key[static_cast<std::size_t>(i)];
    now_.push_back({key, statusAfter(v, i), impacts_(v, i)});
    if (!now_.back().impact || isReported(v, i)) continue;
    ++report_.contacts.impacts;
    if (sink_ == nullptr) continue;
    const int row = c.row0[static_cast<std::size_t>(i)];
    sink_->event({v.after.t, key, Status::open, now_.back().status, true,
                  -v.system.problem().gammaA[static_cast<std::size_t>(row)], v.Lambda[row]});
  }
  for (const LocatedImpact& i : v.report.impacts) {
    ++report_.contacts.impacts;
    if (sink_ != nullptr)
      sink_->event({i.t, i.key, Status::open, i.after, true, i.speed, i.Lambda});
  }
  const auto less = [](const Seen& a, const Seen& b) { return a.key < b.key; };
  if (!std::is_sorted(now_.begin(), now_.end(), less)) std::sort(now_.begin(), now_.end(), less);
  // Merges two sorted lists; a contact in only one of them was or is open.
  const auto open = [](ContactKey key) { return Seen{key, Status::open, false}; };
  auto old = before_.cbegin();
  for (const Seen& s : now_) {
    for (; old != before_.cend() && old->key < s.key; ++old)
      switched(v.after.t, *old, open(old->key));
    const bool known = old != before_.cend() && old->key == s.key;
    if (v.index > 1) switched(v.after.t, known ? *old : open(s.key), s);
    if (known) ++old;
  }
  for (; old != before_.cend(); ++old) switched(v.after.t, *old, open(old->key));
  before_.swap(now_);
}

void StepStatistics::switched(double t, const Seen& from, const Seen& to) {
  if (from.status == to.status) return;
  ++report_.contacts.switches;
  // The event of an impact covers this change already, also if the contact opens right after it;
  // separating counts as open.
  const auto isOpen = [](const Seen& s) {
    return s.status == Status::open || s.status == Status::separating;
  };
  if (sink_ == nullptr || to.impact || (isOpen(to) && (from.impact || isOpen(from)))) return;
  sink_->event({t, to.key, from.status, to.status, false, 0.0, 0.0});
}

/// Moves the contacts with these keys; all lists are sorted by key.
void StepStatistics::move(const std::vector<ContactKey>& contacts, std::vector<Seen>& from,
                          std::vector<Seen>& to) {
  const auto goes = [&](const Seen& s) {
    return std::binary_search(contacts.begin(), contacts.end(), s.key);
  };
  const auto stay = std::stable_partition(from.begin(), from.end(), goes);
  to.insert(to.end(), from.begin(), stay);
  from.erase(from.begin(), stay);
  std::sort(to.begin(), to.end(), [](const Seen& a, const Seen& b) { return a.key < b.key; });
}

void StepStatistics::archive(Archive& a) {
  a.section("statistics");
  a(before_), a(resting_);
  for (const std::vector<Seen>* list : {&before_, &resting_})
    for (const Seen& s : *list)
      if (s.status > Status::locked)
        throw ModelError("the checkpoint holds a contact with a status that does not exist");
}

}  // namespace dynamy
