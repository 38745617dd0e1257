#include <algorithm>
#include <cmath>
#include <dynamy/located/located_dormand_prince.hpp>
#include <dynamy/stages/projection.hpp>

namespace dynamy {
namespace {

constexpr double kLookAhead = 1e-5, kMostLookAhead = 1e-2;  ///< of the step
constexpr double kAtOnce = 1e-6;  ///< events within this part of the step are at one instant
constexpr int kMostNulls = 5;
constexpr double kRapid = 1e-7;       ///< of T: plain events this close together have no end
constexpr double kMuted = 1e-3;       ///< of the step: monitors are ignored for this time
constexpr double kProject = 5e-4;     ///< corrections below this part of the tolerance wait
constexpr double kSuspicious = 0.1;   ///< above this part the bias of elements is checked
constexpr int kMostTries = 60;        ///< tries of one step
constexpr double kLeastStep = 1e-14;  ///< of the time and of T
constexpr double kGapNoise = 2e-14, kSpeedNoise = 1e-12;  ///< of L and U
constexpr double kSafety = 0.9, kShrink = 0.2, kHalf = 0.5;

}  // namespace

double LocatedDormandPrince::nextStep(const State& x) const {
  return x.scheme.size() > 0 ? x.scheme[0] : 0.0;
}

bool LocatedDormandPrince::evaluateEnd(MechanicalSystem& s, PhasePoint& p) {
  search_.forget(p.x.t);
  s.hold(phaseKeys_);
  s.evaluate(p.x, 0);
  if (!phase_.accelerate(s.slot(0), p.x.u, p.a)) return refuse(phase_);
  p.lambda = phase_.lambda(), p.power = phase_.power();
  smooth_.rates(s, p);
  return true;
}

void LocatedDormandPrince::book(const MechanicalSystem& s, long StepEffort::*what,
                                StepReport& report) {
  report.counts.effort.*what += s.evaluations() - booked_;
  booked_ = s.evaluations();
}

void LocatedDormandPrince::begin(MechanicalSystem& s, InclusionSolver& solver, const State& x,
                                 StepReport& report) {
  from_.x.t = x.t, from_.x.q = x.q, from_.x.u = x.u, from_.x.memory = x.memory;
  phaseKeys_.clear(), phase_.held.clear();
  s.hold(phaseKeys_);
  s.evaluate(from_.x, 0);
  if (x.scheme.size() == 0) {
    probe_.look(from_.x);
    norm_.start(s, from_.x, 0, accuracy_.tolerance, accuracy_.length, probe_.contacts());
    governor_.scales(norm_.tolerance(), norm_.time());
    governor_.reset();
  } else {
    resumeNorm(s, x);
  }
  untold_.clear(), useDifferences(s);
  islands_.start(s.parts());
  owed_.setZero(norm_.times().size(), 2);
  const bool implicit = stiff_ == Stiff::always;
  smooth_.forget();
  smooth_.implicit(implicit, s, norm_), smoothOwn_.implicit(implicit, s, norm_);
  from_.a.setZero(from_.x.u.size());
  H_ = kFirstStep * norm_.time(), lookAhead_ = kLookAhead, lastEvent_ = -1e300, nulls_ = 0;
  release({});
  event(s, solver, from_, report, {});
  book(s, &StepEffort::events, report);
}

// ---- events ------------------------------------------------------------------------------------

bool LocatedDormandPrince::event(MechanicalSystem& s, InclusionSolver& solver, PhasePoint& p,
                                 StepReport& report, const std::vector<HeldKey>& stopped) {
  const double unit = plain_ ? norm_.time() : lookAhead_ * span();
  const SwitchEvent::Result r =
      event_.process(s, solver, probe_, phase_, p, smooth_, unit, stopped);
  if (r.fault == FrozenPhase::kLost) return lose(r.lost);
  if (r.fault == FrozenPhase::kOtherSet) return stall(r.lost);
  if (!r.fault.empty()) return refuse(r.fault);
  if (!r.solved.ok()) report.solved = r.solved;
  report.solved.repaired += r.solved.repaired;
  report.solved.energyGain = std::max(report.solved.energyGain, r.solved.energyGain);
  report.counts.impacts += r.impact ? 1 : 0;
  if (r.impact) uBeforeImpact_ = event_.uBefore(), tImpact_ = p.x.t;
  report.counts.accumulations += r.accumulations;
  if (r.accumulations > 0) report.counts.accumulationEnd = r.accumulationEnd;
  report.counts.undecided += r.undecided ? 1 : 0;
  keepPercussions(p.x.t);
  for (std::size_t k = 0; k < works_.size(); ++k) works_[k] += event_.works()[k];
  noteNull(r, p);
  // A slip that did not end was ignored because of the old statuses: it is watched again.
  for (Held& h : phase_.held)
    if (r.changed && h.slips) h.mutedUntil = std::min(h.mutedUntil, p.x.t);
  if (plain_ && nulls_ == kMostNulls) return stall();
  smooth_.forgetJacobian(), smoothOwn_.forgetJacobian(), search_.forget();
  const bool anew = findUntold(s, p.x, false);
  phaseKeys_.clear();
  phase_.keys(phaseKeys_);
  return !anew || event(s, solver, p, report, {});
}

void LocatedDormandPrince::release(const Switch& w) {
  // A contact whose sticking friction has reached its bound slips against this friction. Without a
  // look ahead no decision would find that.
  event_.release({}, 0.0);
  if (!plain_ || !w || !w.force) return;
  const ContactKey key = search_.contact(phase_, w);
  for (std::size_t i = 0; i < phase_.held.size(); ++i)
    if (const Held& h = phase_.held[i];
        h.key == key && h.first == 0 && !h.slips && phase_.slipRows(i) == 1)
      event_.release(key, phase_.lambda()[phase_.slip0(i)] > 0.0 ? -1.0 : 1.0);
}

void LocatedDormandPrince::noteNull(const SwitchEvent::Result& r, const PhasePoint& p) {
  if (plain_) {  // only a count of events that follow each other at once
    nulls_ = p.x.t - lastEvent_ <= kRapid * norm_.time() ? nulls_ + 1 : 0;
    lastEvent_ = p.x.t;
    return;
  }
  const bool atOnce = p.x.t - lastEvent_ <= kAtOnce * span();
  lastEvent_ = p.x.t;
  if (r.changed || r.impact || !atOnce) {
    if (!atOnce) lookAhead_ = kLookAhead, nulls_ = 0;
    return;
  }
  lookAhead_ = std::min(10.0 * lookAhead_, kMostLookAhead);
  if (++nulls_ < kMostNulls) return;
  for (Held& h : phase_.held) h.mutedUntil = p.x.t + kMuted * span();
  nulls_ = 0;
}

// ---- steps -------------------------------------------------------------------------------------

LocatedDormandPrince::Tried LocatedDormandPrince::attempt(MechanicalSystem& s, double h,
                                                          bool looked, StepReport& report,
                                                          Switch& found) {
  s.hold(phaseKeys_);
  phase_.held = startHeld_, denseReady_ = false;
  const auto reject = [&](double factor) {
    ++report.counts.rejected;
    H_ = h * factor;
    return Tried::rejected;
  };
  // Where a law's set becomes another one, steps are halved: they end as near to it as possible.
  const auto otherSet = [&] {
    if (phase_.fault() != FrozenPhase::kOtherSet) return Tried::failed;
    lastSwitched_ = phase_.lost(), otherSet_ = true;
    stalled_ = false, why_ = {};
    return reject(kHalf);
  };
  to_.x.memory = from_.x.memory;
  if (!smooth_.take(s, phase_, from_, h, to_.x)) {
    if (!phase_.fault().empty()) return refuse(phase_), otherSet();
    return reject(kShrink);
  }
  if (smooth_.errorNeedsEnd()) {
    if (!evaluateEnd(s, to_)) return otherSet();
    smooth_.end(to_);
  }
  const double error = smooth_.error(norm_, from_.x, to_.x);
  if (!std::isfinite(error)) return reject(kShrink);
  if (smooth_.tooLight(error)) return reject(1.0);
  const double factor = kSafety * std::pow(std::max(error, 1e-10), -1.0 / smooth_.errorOrder());
  if (error > 1.0) return reject(std::clamp(factor, kShrink, 1.0));
  if (!smooth_.errorNeedsEnd() && !evaluateEnd(s, to_)) return otherSet();
  if (!to_.a.allFinite()) return reject(kShrink);
  if (stiff_ == Stiff::automatic && smooth_.outgrown(norm_, to_)) {
    const bool implicit = !smooth_.implicit();
    smooth_.implicit(implicit, s, norm_), smoothOwn_.implicit(implicit, s, norm_);
  }
  if (const double past = turn(); past > 2.0)
    return reject(std::clamp(1.0 / std::cbrt(past), kShrink, 0.7)), Tried::turned;
  found = {}, passing_ = 1.0;
  if (search_.any() || probe_.gathers()) {
    path_.through(s, from_, to_);
    search_.atEnd(phase_, to_.x.t);
    if (!widen()) return shortOfMeeting(h, report);
    const double width = 0.1 * std::cbrt(0.01 * norm_.tolerance());
    if (!search_.find(s, probe_, phase_, path_, looked, width, found)) {
      if (phase_.fault().empty()) return clear_ = kHalf, shortOfMeeting(h, report);
      return refuse(phase_), Tried::failed;
    }
  }
  if (found.kind == Switch::Kind::look) return Tried::again;
  if (passing_ < (found ? found.theta : 1.0) || tooLongAtRest(s, h, found, report))
    return reject(kHalf);
  if (found) smooth_.lighten();
  // The next step does not become shorter because an outer bound shortened this one.
  const double next = h * std::min(factor, smooth_.mostGrowth());
  H_ = h < H_ ? std::max(H_, next) : next;
  return found ? Tried::located : Tried::accepted;
}

bool LocatedDormandPrince::project(MechanicalSystem& s, PhasePoint& p) {
  if (phase_.held.empty()) return true;
  double off = 0.0;
  const auto measure = [&] {
    for (Eigen::Index i = 0; i < delta_.size(); ++i)
      off = std::max(off, norm_.velocity(i, delta_[i], 0.0));
  };
  Eigen::VectorXd& position = trial_.qdot;
  if (phase_.positionCorrection(s.slot(0), position)) delta_ = position / norm_.time(), measure();
  const bool moves = off > 0.0;
  const bool turns = phase_.velocityCorrection(s.slot(0), p.x.u, delta_);
  if (turns) measure();
  if (off <= kProject) return true;
  if (off > kSuspicious && !checkBias(s, p)) return false;
  if (turns) p.x.u += delta_;
  if (moves) {
    const double t = p.x.t;
    position /= kDisplacementTime;
    s.move(p.x, position, kDisplacementTime);
    p.x.t = t;
  }
  return evaluateEnd(s, p);
}

bool LocatedDormandPrince::enter(MechanicalSystem& s, InclusionSolver& solver, const State& x,
                                 StepReport& report) {
  const bool same = system_ == &s;
  why_ = {}, system_ = &s, denseReady_ = false;
  stalled_ = stepped_ = otherSet_ = lost_ = false, lastSwitched_ = governor_.turnedAt();
  told_.clear(), impacts_.clear(), works_ = {};
  booked_ = s.evaluations(), tImpact_ = -1e300;
  stepKeys_.clear(), impulse_.resize(0), enteredAt_ = x.q;
  s.bias(true);
  if (!ready_) {
    const ButcherTableau* light = table_ == &dormandPrince8() ? &dormandPrince5() : nullptr;
    smooth_.prepare(s, *table_, light), smoothOwn_.prepare(s, *table_, light);
    probe_.prepare(s, x);
    event_.prepare(s, norm_);
    event_.plain(plain_);
    ready_ = true;
  }
  const bool anew = x.scheme.size() > 0 && governor_.mode() == SwitchGovernor::Mode::decideAnew;
  if (x.scheme.size() == 0 || anew)
    probe_.list(x), governor_.locate(), begin(s, solver, x, report);
  else if (same && goesOn(x))
    std::swap(from_, to_);
  else
    restore(s, solver, x, report);
  search_.prepare(kGapNoise * norm_.length(), kSpeedNoise * norm_.speed(), leftOverlap(),
                  SwitchEvent::kSame * norm_.length());
  return why_.empty();
}

bool LocatedDormandPrince::goOn(MechanicalSystem& s, InclusionSolver& solver, double most,
                                StepReport& report, bool& done) {
  if (H_ < kLeastStep * std::max(std::abs(from_.x.t), norm_.time())) return stall();
  if (probe_.gathers() && !probe_.gather(from_.x, phaseKeys_))
    return refuse(ContactProbe::kUnfollowed);
  startOverlap_ = std::max(0.0, probe_.overlap());
  if (!search_.begin(probe_, phase_, from_.x) || !leaveToJoints(s))
    return refuse(ContactProbe::kUnfollowed);
  const double until = untilInstant();
  const double end = from_.x.t + most;
  const bool told = until < most && instant_ <= end;
  if (until <= 0.0 && told) {
    to_ = from_, done = true;
    return passInstant(s, solver, to_, end, report);
  }
  if (until > 0.0) most = std::min(most, until);
  bool stopped = false;
  double bound = most;
  if (!stop(s, solver, bound, report, stopped)) return false;
  book(s, &StepEffort::events, report);
  if (stopped) {
    ++report.counts.switches;
    to_ = from_, done = true;
    return true;
  }
  double h = shortened(std::min(H_, bound));
  startHeld_ = phase_.held;
  chooseMethod();
  Switch found;
  const Tried tried = tryStep(s, h, report, found);
  if (tried == Tried::failed || tried == Tried::rejected) return tried == Tried::rejected;
  if (found) ++report.counts.switches, lastSwitched_ = search_.contact(phase_, found);
  if (found.kind == Switch::Kind::atStart) {
    const bool good = decide(s, solver, from_, found, report);
    book(s, &StepEffort::events, report);
    return good;
  }
  const std::array<double, 5> before = works_;
  if (found && !repeat(s, h, found)) return false;
  if (sinks(to_.x)) return takeShorter(s, h, before, report);
  if (found) book(s, &StepEffort::switches, report);
  if (!found) impulse_ = smooth_.impulse();
  if (!found && h == most) to_.x.t = from_.x.t + most;
  done = true;
  const std::array<double, 5> works = works_;
  keepImpulses();
  if (!found) stepTo_ = to_;
  stepFrom_ = from_, stepPhase_ = phase_, stepPhaseKeys_ = phaseKeys_;
  const bool ended = endStarts();
  bool good = true;
  if (found)
    good = decide(s, solver, to_, found, report);
  else if (told && h == most)
    good = passInstant(s, solver, to_, end, report);
  else
    good = project(s, to_) && (!ended || evaluateEnd(s, to_));
  book(s, found ? &StepEffort::events : &StepEffort::smooth, report);
  if (good || !foundUntold_) return good;
  works_ = works, done = false;  // the decision is repeated with the bias that an element lacks
  return decideUntold(s, solver, report);
}

bool LocatedDormandPrince::decide(MechanicalSystem& s, InclusionSolver& solver, PhasePoint& p,
                                  const Switch& w, StepReport& report) {
  release(w);
  if (search_.leaves(w)) event_.leave(search_.contact(phase_, w));
  return (!search_.latches(w) || throwLatch(s, p)) && event(s, solver, p, report, {});
}

bool LocatedDormandPrince::proceed(MechanicalSystem& s, InclusionSolver& solver, const State& x,
                                   double dt, StepReport& report) {
  bool done = false, good = enter(s, solver, x, report);
  for (int tries = 0; good && !done; ++tries)
    good = tries < kMostTries ? goOn(s, solver, x.t + dt - from_.x.t, report, done) : stall();
  return good;
}

StepReport LocatedDormandPrince::step(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                      double dt) {
  if (!knows(s, x)) {
    StepReport report;
    report.refused = "the checkpoint holds what this scheme does not leave in a state";
    return report;
  }
  if (stepsInTime(x)) {
    resumeStepping(s, x);
    return stepInTime(s, solver, x, dt);
  }
  StepReport report;
  const long before = s.evaluations();
  const bool good = proceed(s, solver, x, dt, report);
  if (!good && stalled_ && !plain_ &&
      (search_.any() || probe_.gathers() || otherSet_ || lost_)) {  // otherwise a force is singular
    governor_.turn(x.t, TurnedBy::stall, lastSwitched_);
    beginStepping(x);
    if (quietOnly_) return report;
    const StepEffort spent = report.counts.effort;
    report = stepInTime(s, solver, x, dt);
    report.counts.effort.rejected += spent.smooth + spent.rejected + spent.switches + spent.events;
    return report;
  }
  if (good) {
    const double t = x.t;
    x.t = to_.x.t == t + dt ? t + dt : to_.x.t;
    x.q = to_.x.q, x.u = to_.x.u, x.memory = to_.x.memory;
    report.dt = x.t - t;
    const long n = s.evaluations() - before;
    if (!plain_) govern(s, n, report);
    store(x);
    if (tImpact_ == to_.x.t && report.dt > 0.0) report.uBeforeImpact = &uBeforeImpact_;
    tell(s, x, report);
  } else {
    report.refused = why_;
  }
  s.thaw();
  return report;
}

}  // namespace dynamy
