#include <algorithm>
#include <cmath>
#include <dynamy/located/step/located_constants.hpp>
#include <dynamy/located/step/located_motion.hpp>
#include <dynamy/located/step/slip_starts.hpp>

namespace dynamy {

void LocatedMotion::scales(const MechanicalSystem& s, double time, const Eigen::VectorXd& times) {
  ErrorNorm& norm = parts_.norm;
  const Accuracy& accuracy = parts_.settings.accuracy;
  if (norm.time() != time || norm.times().size() != times.size() || norm.times() != times)
    norm.resume(s, accuracy.tolerance, accuracy.length, time, view(times));
}

bool LocatedMotion::endsAt(const MechanicalSystem& s, const State& x) const {
  return system_ == &s && x.t == to_.x.t && x.q == to_.x.q && x.u == to_.x.u &&
         x.memory == to_.x.memory;
}

void LocatedMotion::keep(HeldState& out) const {
  const PhaseMotion& motion = parts_.motion;
  out.pace = parts_.pace, out.held = motion.phase.held, out.missing = parts_.bias.elements();
  out.implicit = motion.step.implicit(), out.counted = motion.step.counted();
  out.jacobian = out.implicit ? motion.step.implicitStep().kept() : Eigen::VectorXd();
}

Refusal LocatedMotion::advance(MechanicalSystem& s, InclusionSolver& solver, const State& x,
                               const Start& start, double dt, StepReport& report) {
  LocatedStep step{s, solver, report, parts_, from_, to_, record_, startHeld_, start.lastSwitched};
  bool done = false;
  parts_.forgetWork();
  Refusal refusal = enter(step, x, start);
  if (parts_.settings.givenSteps) parts_.pace.next = dt;
  const long impacts = report.counts.impacts, before = s.evaluations();
  for (long tries = 0; !refusal && !done; ++tries) {
    if (s.limits.stop != nullptr && s.limits.stop->load(std::memory_order_relaxed))
      return {Refusal::Kind::fault, "the run is stopped within this step"};
    // Bodies between others that touch on both sides hit them in turn, and lose speed.
    const long hits = std::min<long>(report.counts.impacts - impacts, EventConstants::mostImpacts);
    const bool dear = parts_.work(s, s.evaluations() - before) > start.most &&
                      (parts_.search.any() || parts_.probe.any());
    const bool more = tries < TrialConstants::most + hits && !dear;
    refusal = more ? proceed(step, x.t + dt - from_.x.t, done) : step.stall();
  }
  lastSwitched_ = step.lastSwitched;
  report.counts.effort.looks += parts_.probe.looks.whole;
  report.counts.effort.gaps += parts_.probe.looks.gaps;
  refusal.passable = refusal.kind == Refusal::Kind::stalled &&
                     (parts_.search.any() || parts_.probe.any() || step.otherSet || refusal.lost);
  return refusal;
}

Refusal LocatedMotion::enter(LocatedStep& step, const State& x, const Start& start) {
  const bool same = system_ == &step.s;
  MechanicalSystem& s = step.s;
  record_.begin(), last_.begin(x.q);
  parts_.motion.phase.request.differences = &parts_.bias.differences();
  if (!same) {
    const ButcherTableau& table = parts_.settings.table();
    const bool light = &table == &dormandPrince8() && !parts_.settings.givenSteps;
    parts_.motion.prepare(s, table, light ? &dormandPrince5() : nullptr);
    parts_.probe.prepare(s, x);
    parts_.forgetWork();  // a resumed run prepares once more
    coming_.prepare(s.parts());
    parts_.event.prepare(parts_.norm);
    parts_.event.plain(!parts_.settings.events.looksAhead);
    system_ = &s;
  }
  Refusal refusal;
  parts_.repeated = 0;
  parts_.probe.flat(parts_.flatHeight());
  if (start.held == nullptr && !start.goesOn)
    refusal = begin(step, x, start.scaled);
  else if (start.goesOn)
    std::swap(from_, to_), parts_.bias.use(parts_.norm);
  else
    refusal = restore(step, x, *start.held);
  const ErrorNorm& norm = parts_.norm;
  parts_.search.prepare({.gapNoise = TrialConstants::gapNoise * norm.length(),
                         .speedNoise = TrialConstants::speedNoise * norm.speed(),
                         .touch = parts_.leftOverlap(),
                         .flat = parts_.flatHeight(),
                         .same = EventContacts::kSame * norm.length(),
                         .gone = EventContacts::kGone * norm.length()});
  return refusal;
}

Refusal LocatedMotion::begin(LocatedStep& step, const State& x, bool scaled) {
  MechanicalSystem& s = step.s;
  PhaseMotion& motion = parts_.motion;
  const LocatedSettings& settings = parts_.settings;
  parts_.probe.list(x);
  from_.x.t = x.t, from_.x.q = x.q, from_.x.u = x.u, from_.x.memory = x.memory;
  motion.clear();
  s.evaluate(from_.x, motion.phase.request.in(0));
  if (!scaled) {
    parts_.probe.look(from_.x);
    parts_.norm.start(s, from_.x, 0, settings.accuracy.tolerance, settings.accuracy.length,
                      parts_.probe.gaps().contacts);
    parts_.probe.flat(parts_.flatHeight());
  }
  parts_.bias.elements(parts_.norm, {});
  motion.step.counted(SmoothStep::kNothing);
  motion.implicit(settings.stiff == StiffSteps::always, s, parts_.norm);
  from_.a.setZero(from_.x.u.size());
  parts_.pace = {TrialConstants::firstStep * parts_.norm.time(), EventConstants::lookAhead};
  Refusal refusal = scaled ? events_.decideAnew(step, from_) : events_.start(step, from_);
  step.book(&StepEffort::events);
  return refusal;
}

Refusal LocatedMotion::restore(LocatedStep& step, const State& x, const HeldState& held) {
  MechanicalSystem& s = step.s;
  PhaseMotion& motion = parts_.motion;
  parts_.pace = held.pace;
  parts_.probe.narrow(nullptr);  // what was near belongs to another motion
  motion.implicit(held.implicit, s, parts_.norm);
  motion.step.counted(held.counted);
  motion.phase.held = held.held;
  parts_.bias.elements(parts_.norm, held.missing);
  motion.rekey();
  from_.x.t = x.t, from_.x.q = x.q, from_.x.u = x.u, from_.x.memory = x.memory;
  // Between two steps populations may remove bodies and add others.
  const bool renewed = x.q.size() != to_.x.q.size() || x.q != to_.x.q;
  if (renewed && events_.relist(x)) {
    from_.a.setZero(x.u.size());
    return events_.event(step, from_);
  }
  const long before = s.evaluations();
  motion.step.implicitStep().keep(s, motion.phase, x, held.jacobian);
  Refusal refusal = step.evaluate(from_);
  parts_.repeated = s.evaluations() - before;
  parts_.forgetWork();
  return refusal;
}

Refusal LocatedMotion::proceed(LocatedStep& step, double most, bool& done) {
  PhaseMotion& motion = parts_.motion;
  const double least = std::max(std::abs(from_.x.t), parts_.norm.time());
  if (parts_.pace.next < TrialConstants::leastStep * least) return step.stall();
  if (!coming_.begin(step, std::min(parts_.pace.next, most))) return step.unfollowed();
  const double until = events_.untilInstant(step), end = from_.x.t + most;
  const bool announced = until < most && events_.instant() <= end;
  if (until <= 0.0 && announced) {
    to_ = from_, done = parts_.endedByMotion = true;
    return events_.passInstant(step, to_, end);
  }
  if (until > 0.0) most = std::min(most, until);
  SlipEnds::Result slips = slipEnds_.take(step, most);
  if (slips.refusal) return slips.refusal;
  step.book(&StepEffort::events);
  if (slips.stopped) {
    ++step.report.counts.switches;
    to_ = from_, done = parts_.endedByMotion = true;
    return {};
  }
  startHeld_ = motion.phase.held;
  const int columns = parts_.settings.columns;
  motion.halfExplicit(columns > 0 ? columns
                                  : parts_.bias.columns(motion.phase, parts_.norm.tolerance()));
  const double longest = trials_.shortened(from_, slips.most);
  Trial trial = trials_.take(step, std::min(parts_.pace.next, longest));
  if (trial.refusal || !trial.accepted) return trial.refusal;
  if (trial.found) step.lastSwitched = parts_.search.contact(motion.phase, trial.found);
  if (trial.found.kind == Switch::Kind::atStart) {
    ++step.report.counts.switches;
    Refusal refusal = events_.decide(step, from_, trial.found);
    step.book(&StepEffort::events);
    return refusal;
  }
  const std::array<double, 5> before = record_.works;
  if (trial.found)
    if (Refusal r = toRoot_.take(step, trial.h, trial.found, last_.end())) return r;
  const bool strays = trial.found && toRoot_.strays();
  if (strays || coming_.sinks(to_.x)) {
    record_.works = before;
    trials_.drop(step, trial.h);
    const ContactKey sunk = strays ? kNoContact : coming_.sunk(parts_.pace.next);
    return sunk == kNoContact ? Refusal{} : step.lose(sunk);
  }
  return finish(step, trial, {most, announced, end, longest < most && trial.h == longest}, done);
}

Refusal LocatedMotion::finish(LocatedStep& step, const Trial& trial, const Bound& bound,
                              bool& done) {
  PhaseMotion& motion = parts_.motion;
  const bool full = !trial.found && trial.h == bound.most;
  if (trial.found) {
    ++step.report.counts.switches;
    step.book(&StepEffort::switches);
  } else {
    record_.impulse = motion.step.last().impulse();
    if (full) to_.x.t = from_.x.t + bound.most;
    last_.end() = to_;
  }
  done = true, parts_.endedByMotion = trial.found || bound.own || (full && bound.announced);
  const std::array<double, 5> before = record_.works;
  record_.impulsesOf(motion.phase);
  record_.addWorks(motion.step.last().works());
  last_.keep(from_, motion);
  const bool ended = endStarts(parts_);
  bool missing = false;
  Refusal refusal;
  if (trial.found)
    refusal = events_.decide(step, to_, trial.found);
  else if (full && bound.announced)
    refusal = events_.passInstant(step, to_, bound.end);
  else if (refusal = projection_.take(step, to_, missing); !refusal && !missing && ended)
    refusal = step.evaluate(to_);
  else if (!refusal && !missing && parts_.search.looksAtForces() &&
           !motion.phase.accelerate(step.s.slot(0), to_.x.u, to_.a))
    refusal = step.fault();
  step.book(trial.found ? &StepEffort::events : &StepEffort::smooth);
  if (!missing) return refusal;
  // The decision at the start is repeated with the bias that an element lacks.
  record_.works = before, done = false;
  motion.phase.held = startHeld_;
  record_.noImpulses();
  refusal = events_.decideAnew(step, from_);
  step.book(&StepEffort::events);
  return refusal;
}

void LocatedMotion::report(MechanicalSystem& s, State& x, StepReport& report) {
  if (report.dt > 0.0) report.uBeforeImpact = record_.uBeforeImpact(to_.x.t);
  record_.report(s, parts_.motion.phase, x, report);
}

bool LocatedMotion::interpolate(const MechanicalSystem& s, const State& a, const State& b,
                                double theta, State& out, bool closed) {
  if (system_ != &s) return false;
  if (!last_.interpolate(*system_, parts_.motion, a, b, theta, out)) {
    const Eigen::VectorXd* before = record_.uBeforeImpact(b.t);
    if (before == nullptr) return false;
    LastStep::towards(s, a, *before, b.t - a.t, theta, out);
  }
  if (closed) last_.close(*system_, out);
  return true;
}

bool LocatedMotion::contactsAt(const MechanicalSystem& s, const State& at, bool after,
                               ContactInstant& out) {
  return system_ == &s && last_.contactsAt(*system_, parts_.motion, at, after, out);
}

}  // namespace dynamy
