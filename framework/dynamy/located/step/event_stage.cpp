#include <algorithm>
#include <cmath>
#include <dynamy/located/step/event_stage.hpp>
#include <dynamy/located/step/located_constants.hpp>

namespace dynamy {

Refusal EventStage::event(LocatedStep& step, PhasePoint& p, const std::vector<HeldKey>& stopped) {
  const EventPolicy& policy = parts_.settings.events;
  PhaseMotion& motion = parts_.motion;
  const double unit =
      policy.looksAhead ? parts_.pace.lookAhead * parts_.span() : parts_.norm.time();
  // Where a long search has found no solution, the next ones seldom do.
  SearchPauses& searches = parts_.pace.searches;
  const Effort effort = step.s.limits.effort;
  if (effort == Effort::full) step.s.limits.effort = searches.next();
  const EventResult r = parts_.event.process(step.s, step.solver, parts_.probe, motion.phase, p,
                                             motion.step, unit, stopped);
  step.s.limits.effort = effort;
  if (r.impact || !r.solved.ok()) searches.done(r.solved.ok() && !r.solved.inVain);
  if (!r.fault.empty()) return step.fault(r.fault, r.lost);
  StepReport& report = step.report;
  if (!r.solved.ok()) report.solved = r.solved;
  report.solved.repaired += r.solved.repaired;
  report.solved.energyGain = std::max(report.solved.energyGain, r.solved.energyGain);
  report.counts.impacts += r.impact ? 1 : 0;
  report.counts.accumulations += r.accumulations;
  if (r.accumulations > 0) report.counts.accumulationEnd = r.accumulationEnd;
  report.counts.undecided += r.undecided ? 1 : 0;
  step.record.event(parts_.event, motion.phase, p.x.t, r.impact,
                    EventConstants::impactFloor * parts_.norm.length());
  noteEmpty(r, p.x.t);
  // A slip that did not end was ignored because of the old statuses: it is watched again.
  for (Held& h : motion.phase.held)
    if (r.changed && h.slips) h.mutedUntil = std::min(h.mutedUntil, p.x.t);
  if (!policy.passesAccumulations && parts_.pace.empty == EventConstants::mostEmpty)
    return step.stall();
  motion.forgetJacobian(), parts_.search.forget();
  const bool anew = parts_.bias.find(step.s, p.x, parts_.norm, motion.phase.request, false);
  motion.rekey();
  PhaseMotion::energies(step.s, 0, p);
  return anew ? event(step, p) : Refusal{};
}

void EventStage::release(const Switch& w) {
  // A contact whose sticking friction has reached its bound slips against this friction. Without a
  // look ahead no decision would find that.
  parts_.event.release({}, 0.0);
  if (parts_.settings.events.looksAhead || !w || !w.force) return;
  const FrozenPhase& phase = parts_.motion.phase;
  const ContactKey key = parts_.search.contact(phase, w);
  for (std::size_t i = 0; i < phase.held.size(); ++i)
    if (const Held& h = phase.held[i];
        h.key == key && h.first == 0 && !h.slips && phase.rows().slipRows(i) == 1)
      parts_.event.release(key, phase.lambda()[phase.rows().slip0(i)] > 0.0 ? -1.0 : 1.0);
}

void EventStage::noteEmpty(const EventResult& r, double t) {
  Pace& pace = parts_.pace;
  if (!parts_.settings.events.passesAccumulations) {  // only a count of events at once
    const bool rapid = t - pace.lastEvent <= EventConstants::rapid * parts_.norm.time();
    pace.empty = rapid ? pace.empty + 1 : 0;
    pace.lastEvent = t;
    return;
  }
  const bool atOnce = t - pace.lastEvent <= EventConstants::atOnce * parts_.span();
  pace.lastEvent = t;
  if (r.changed || r.impact || !atOnce) {
    if (!atOnce) pace.lookAhead = EventConstants::lookAhead, pace.empty = 0;
    return;
  }
  pace.lookAhead = std::min(10.0 * pace.lookAhead, EventConstants::mostLookAhead);
  if (++pace.empty < EventConstants::mostEmpty) return;
  for (Held& h : parts_.motion.phase.held)
    h.mutedUntil = t + EventConstants::ignored * parts_.span();
  pace.empty = 0;
}

Refusal EventStage::decideAnew(LocatedStep& step, PhasePoint& p) {
  release({});
  return event(step, p);
}

Refusal EventStage::start(LocatedStep& step, PhasePoint& p) {
  parts_.event.start();
  return decideAnew(step, p);
}

Refusal EventStage::decide(LocatedStep& step, PhasePoint& p, const Switch& w) {
  release(w);
  SwitchSearch& search = parts_.search;
  if (search.leaves(w)) parts_.event.leave(search.contact(parts_.motion.phase, w));
  if (w.kind == Switch::Kind::atStart && search.is(w, KinematicMonitor::Kind::gap))
    parts_.event.close(search.contact(parts_.motion.phase, w));
  if (search.latches(w))
    if (Refusal r = throwLatch(step, p)) return r;
  return event(step, p);
}

double EventStage::untilInstant(const LocatedStep& step) {
  const double t = step.from.x.t;
  const double after = std::max(t - InstantConstants::passed * std::abs(t), parts_.pace.lastEvent);
  if (after < instantAfter_ || after >= instant_)
    instantAfter_ = after, instant_ = parts_.probe.announcements().nextInstant(after);
  return instant_ - InstantConstants::beside * std::abs(instant_) - t;
}

Refusal EventStage::passInstant(LocatedStep& step, PhasePoint& p, double end) {
  const double behind = std::min(instant_ + InstantConstants::beside * std::abs(instant_), end);
  velocity_ = p.x.u;
  if (p.x.t < behind) step.s.move(p.x, velocity_, behind - p.x.t);
  step.s.remember(p.x);  // what is sampled there counts from there on
  ++step.report.counts.switches;
  release({});
  relist(p.x);
  return event(step, p);
}

/// Moves p from the root of a latch to right after it, where its element switches.
Refusal EventStage::throwLatch(LocatedStep& step, PhasePoint& p) {
  const auto thrown = [&] {
    const std::vector<double>& x = parts_.probe.switching();
    return std::any_of(x.begin(), x.end(), [](double v) { return v > 0.0; });
  };
  const double span = parts_.span();
  for (double d = InstantConstants::beside * std::max(std::abs(p.x.t), span);
       d < InstantConstants::nudge * span; d *= 4.0) {
    if (!parts_.probe.look(p.x)) return step.unfollowed();
    if (thrown()) break;
    velocity_ = p.x.u + 0.5 * d * p.a;
    step.s.move(p.x, velocity_, d);
    p.x.u += d * p.a;
  }
  step.s.remember(p.x);
  relist(p.x);
  return {};
}

bool EventStage::relist(const State& x) {
  ContactProbe& probe = parts_.probe;
  PhaseMotion& motion = parts_.motion;
  probe.narrow(nullptr);  // bodies may be elsewhere than a moment ago
  if (!probe.gather(x, motion.keys())) {
    probe.list(x);
    probe.gather(x, {});
  }
  const ContactGaps& gaps = probe.gaps();
  // A body may have been removed and added elsewhere under the same number.
  const double away = parts_.norm.tolerance() * parts_.norm.length();
  const std::size_t gone = std::erase_if(motion.phase.held, [&](const Held& h) {
    const int i = gaps.find(h.key);
    return i < 0 || (gaps.law(i).unilateral() && gaps.gap(i) > away);
  });
  motion.rekey();
  bool comes = false;
  for (int i = 0; i < gaps.size(); ++i)
    comes =
        comes || (!gaps.law(i).unilateral() && findHeld(motion.phase.held, gaps.key(i)) == nullptr);
  return gone > 0 || comes;
}

}  // namespace dynamy
