#include <algorithm>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/report/run_report.hpp>

namespace dynamy {

void RunTrust::archive(Archive& a) {
  for (double* x :
       {&kineticMax, &stepEnergy, &energyError, &energyErrorTime, &energyRise, &energyRiseTime,
        &energyGain, &energyGainTime, &gainStep, &omegaDt, &turn, &way, &fall, &leap, &rounding})
    a(*x);
}

void RunReport::archive(Archive& a) {
  a.section("report");
  a(t), a(steps), a(rejected), a(parted), a(left), a(firstLeft), a(damped), a(simpler),
      a(firstSimpler), a(evaluations), a(solves), a(iterations), a(iterationsMax);
  a(unconverged), a(unsolved), a(impacts), a(switches), a(contactsMax);
  a(located), a(accumulations), a(accumulationEnd), a(undecided), a(unseen);
  a(effort.smooth), a(effort.rejected), a(effort.switches), a(effort.events), a(effort.stepping);
  a(stepping);
  a(repairedImpacts), a(energyGain);
  a(residual), a(penetration), a(solvedOverlap), a(jointError), a(cpu), a(wall);
  a(trust), a(start);
}

void StepStatistics::step(const StepView& v) {
  RunReport& r = report_;
  ++r.steps;
  r.t = v.after.t;
  if (v.report.simpler && r.simpler++ == 0) r.firstSimpler = r.t;
  const StepCounts& counts = v.report.counts;
  r.rejected += counts.rejected, r.located += counts.switches;
  r.effort.smooth += counts.effort.smooth, r.effort.rejected += counts.effort.rejected;
  r.effort.switches += counts.effort.switches, r.effort.events += counts.effort.events;
  r.effort.stepping += counts.effort.stepping;
  if (counts.stepped) stepped(v);
  if (counts.accumulations > 0) r.accumulationEnd = counts.accumulationEnd;
  r.accumulations += counts.accumulations, r.undecided += counts.undecided;
  if (counts.unseen > r.unseen.value) r.unseen.value = counts.unseen, r.unseen.t = v.before.t;
  r.contactsMax = std::max(r.contactsMax, v.report.contacts);
  r.repairedImpacts += v.report.solved.repaired;
  if (v.report.solved.energyGain > r.energyGain.value)
    r.energyGain.value = v.report.solved.energyGain, r.energyGain.t = v.after.t;
  if (v.report.contacts > 0) {
    ++r.solves;
    r.iterations += v.report.solved.iterations;
    r.iterationsMax = std::max(r.iterationsMax, v.report.solved.iterations);
    if (!v.report.solved.ok()) ++r.unconverged;
    const Residuals& e = v.report.solved.residuals;
    if (e.largest() > r.residual.value) {
      r.residual.value = e.largest(), r.residual.t = v.after.t;
      const ContactSet& c = v.system.slot(0).contacts;
      if (e.worst >= 0 && e.worst < c.size())
        r.residual.contact = c.key[static_cast<std::size_t>(e.worst)];
    }
  }
  // An implicit scheme may miss its equations without any contact.
  if (v.report.contacts == 0 && !v.report.solved.ok()) ++r.unconverged;
  gaps(v);
  statuses(v);
}

void StepStatistics::stepped(const StepView& v) {
  SteppingReport& r = report_.stepping;
  const StepCounts& counts = v.report.counts;
  if (counts.turnedBy != TurnedBy::none) {
    if (++r.periods == 1) r.first.t = v.before.t, r.first.contact = counts.turnedAt;
    r.stalls += counts.turnedBy == TurnedBy::stall ? 1 : 0;
  }
  ++r.steps, r.time += v.report.dt;
  r.systems = std::max(r.systems, counts.steppedSystems);
  r.longest = std::max(r.longest, v.report.dt), r.error = std::max(r.error, counts.stepError);
}

void StepStatistics::gaps(const StepView& v) {
  const ContactSet& c = v.system.slot(0).contacts;
  Worst& worst = report_.solvedOverlap;
  for (std::size_t i = 0; i < c.g.size(); ++i) {
    if (!(-c.g[i] > worst.value)) continue;
    const int closed = c.closedIndex[i];
    if (closed >= 0 && !c.law[static_cast<std::size_t>(closed)]->unilateral()) continue;
    worst.value = -c.g[i], worst.t = v.system.slot(0).t, worst.contact = c.candidateKey[i];
  }
  if (worst.value > report_.penetration.value) report_.penetration = worst;
}

namespace {

/// Status of contact i from the end of the step on.
Status statusAfter(const StepView& v, int i) {
  if (!v.report.ownStatuses) return contactStatus(v, i);
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
    if (!now_.back().impact || v.report.ownStatuses) continue;
    ++report_.impacts;
    if (sink_ == nullptr) continue;
    const int row = c.row0[static_cast<std::size_t>(i)];
    sink_->event({v.after.t, key, Status::open, now_.back().status, true,
                  -v.system.problem().gammaA[static_cast<std::size_t>(row)], v.Lambda[row]});
  }
  for (const LocatedImpact& i : v.report.impacts) {
    ++report_.impacts;
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
  ++report_.switches;
  // The event of an impact covers this change already, also if the contact opens right after it;
  // separating counts as open.
  const auto isOpen = [](const Seen& s) {
    return s.status == Status::open || s.status == Status::separating;
  };
  if (sink_ == nullptr || to.impact || (isOpen(to) && (from.impact || isOpen(from)))) return;
  sink_->event({t, to.key, from.status, to.status, false, 0.0, 0.0});
}

void StepStatistics::archive(Archive& a) {
  a.section("statistics");
  a(before_);
  for (const Seen& s : before_)
    if (s.status > Status::locked)
      throw ModelError("the checkpoint holds a contact with a status that does not exist");
}

}  // namespace dynamy
