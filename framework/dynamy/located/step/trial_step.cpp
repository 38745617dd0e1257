#include <algorithm>
#include <cmath>
#include <dynamy/located/step/located_constants.hpp>
#include <dynamy/located/step/slip_starts.hpp>
#include <dynamy/located/step/trial_step.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Steps may be longer by this factor than turns permit, so that rounding rejects none.
constexpr double kRoomy = 1.01;

}  // namespace

/// Longest step from u in which turning bodies do not turn past a contact between two samples of the
/// search [s]. Bodies none of whose contacts can close turn freely.
double TrialStep::longestOfTurns(const Eigen::VectorXd& u) const {
  const ContactGaps& gaps = parts_.probe.gaps();
  const bool features = gaps.comeAndGo();
  if (!parts_.search.gaps() && !features) return std::numeric_limits<double>::infinity();
  const ContactSet& c = gaps.contacts;
  double turn = 0.0;
  for (int i = 0; i < c.size(); ++i) {
    if (!gaps.law(i).unilateral()) continue;
    for (int s = c.segment0[static_cast<std::size_t>(i)];
         s < c.segment0[static_cast<std::size_t>(i) + 1]; ++s) {
      const Segment& of = c.segment[static_cast<std::size_t>(s)];
      turn = std::max(turn, parts_.norm.fastestTurn(u, of.u0, of.nu));
    }
  }
  return (features ? TrialConstants::mostFeatures : TrialConstants::mostTurn) / turn;
}

double TrialStep::shortened(const PhasePoint& from, double h) const {
  h = std::min(h, longestOfTurns(from.x.u));
  // A force that is ignored may pass its bound, but no longer than it is to be ignored.
  for (const Held& held : parts_.motion.phase.held)
    if (!held.slips && held.mutedUntil > from.x.t) h = std::min(h, held.mutedUntil - from.x.t);
  return h;
}

Trial TrialStep::take(LocatedStep& step, double h) {
  Trial trial;
  trial.h = h;
  Tried tried = attempt(step, false, trial);
  if (tried == Tried::again) {
    step.book(&StepEffort::switches);
    trial.h *= trial.found.theta, tried = attempt(step, true, trial);
  }
  const bool dropped = tried == Tried::rejected || tried == Tried::turned;
  if (dropped) parts_.motion.phase.held = step.startHeld;  // directions as they were
  if (tried == Tried::turned)
    trial.refusal = endClearStarts(step, trial.h);
  else if (dropped && slipsInSpace())
    // The end of slip in space is predicted from speeds at the start, not from those of the trial.
    trial.refusal = step.evaluate(step.from);
  trial.accepted = tried == Tried::accepted;
  step.book(dropped && !trial.refusal ? &StepEffort::rejected
            : trial.found             ? &StepEffort::switches
                                      : &StepEffort::smooth);
  return trial;
}

TrialStep::Tried TrialStep::reject(LocatedStep& step, double next) {
  ++step.report.counts.rejected;
  parts_.pace.next = next;
  return Tried::rejected;
}

TrialStep::Tried TrialStep::fail(Refusal why, Trial& trial) {
  trial.refusal = std::move(why);
  return Tried::failed;
}

/// Where a law's set becomes another one, steps are halved: they end as near to it as possible.
TrialStep::Tried TrialStep::faultOfPhase(LocatedStep& step, Trial& trial) {
  const FrozenPhase& phase = parts_.motion.phase;
  if (phase.fault() != PhaseFault::kOtherSet) return fail(step.fault(), trial);
  step.lastSwitched = phase.lost(), step.otherSet = true;
  return reject(step, trial.h * TrialConstants::half);
}

TrialStep::Tried TrialStep::takeSmooth(LocatedStep& step, Trial& trial, double& factor) {
  PhaseMotion& motion = parts_.motion;
  SmoothStep& smooth = motion.step;
  const double h = trial.h;
  if (!smooth.take(step.s, motion.phase, step.from, h, step.to.x)) {
    if (!motion.phase.fault().empty()) return faultOfPhase(step, trial);
    return reject(step, h * TrialConstants::shrink);
  }
  const auto evaluated = [&] {
    parts_.search.forget(step.to.x.t);
    return motion.evaluate(step.s, step.to);
  };
  SmoothMethod& method = smooth.last();
  if (method.errorNeedsEnd()) {
    if (!evaluated()) return faultOfPhase(step, trial);
    method.end(step.to);
  }
  const double error = method.error(parts_.norm, step.from.x, step.to.x);
  if (!std::isfinite(error)) return reject(step, h * TrialConstants::shrink);
  const bool given = parts_.settings.givenSteps;
  if (!given && smooth.tooLight(error)) return reject(step, h);
  factor =
      given ? method.mostGrowth()
            : TrialConstants::safety * std::pow(std::max(error, 1e-10), -1.0 / method.errorOrder());
  if (!given && error > 1.0)
    return reject(step, h * std::clamp(factor, TrialConstants::shrink, 1.0));
  if (!method.errorNeedsEnd() && !evaluated()) return faultOfPhase(step, trial);
  if (!step.to.a.allFinite()) return reject(step, h * TrialConstants::shrink);
  return given ? Tried::accepted : boundEnergy(step, h, factor);
}

TrialStep::Tried TrialStep::boundEnergy(LocatedStep& step, double h, double& factor) {
  SmoothStep& smooth = parts_.motion.step;
  const SmoothMethod& method = smooth.last();
  const double keeps =
      energy_.factor(step, step.from, step.to, method.works(), method.errorOrder());
  factor = std::min(factor, keeps);
  if (keeps >= EnergyBound::kKept) return Tried::accepted;
  if (smooth.tooLight(std::numeric_limits<double>::infinity())) return reject(step, h);
  return reject(step, h * keeps);
}

TrialStep::Tried TrialStep::attempt(LocatedStep& step, bool looked, Trial& trial) {
  PhaseMotion& motion = parts_.motion;
  motion.phase.held = step.startHeld;
  step.to.x.memory = step.from.x.memory;
  double factor = 1.0;
  const double h = trial.h;
  if (const Tried tried = takeSmooth(step, trial, factor); tried != Tried::accepted) return tried;
  if (parts_.settings.stiff == StiffSteps::automatic && motion.step.outgrown(parts_.norm, step.to))
    motion.implicit(!motion.step.implicit(), step.s, parts_.norm);
  if (const double past = turnOfStarts(parts_, step.startHeld); past > 2.0)
    return reject(step, h * std::clamp(1.0 / std::cbrt(past), TrialConstants::shrink, 0.7)),
           Tried::turned;
  // A slip that starts at a speed of rounding may have any direction: it is left to the next step.
  if (h > SlipConstants::leastStart * parts_.norm.time() && startsPassTheirEnd(parts_))
    return reject(step, h * TrialConstants::half);
  trial.found = {};
  coming_.newTrial();
  if (const Tried tried = findSwitch(step, looked, trial); tried != Tried::accepted) return tried;
  if (trial.found.kind == Switch::Kind::look) return Tried::again;
  const double until = trial.found ? trial.found.theta : 1.0;
  if (coming_.passing() < until || parts_.search.passesFlat(until) || tooLongAtRest(step, trial))
    return reject(step, h * TrialConstants::half);
  if (trial.found) motion.step.lighten();
  // The next step does not become shorter because an outer bound shortened this one.
  const double next = h * std::min(factor, motion.step.last().mostGrowth());
  double& planned = parts_.pace.next;
  planned = h < planned ? std::max(planned, next) : next;
  return Tried::accepted;
}

TrialStep::Tried TrialStep::findSwitch(LocatedStep& step, bool looked, Trial& trial) {
  SwitchSearch& search = parts_.search;
  FrozenPhase& phase = parts_.motion.phase;
  if (!search.any() && !parts_.probe.gathers() && !coming_.narrowed()) return Tried::accepted;
  path_.through(step.s, step.from, step.to);
  search.atEnd(phase, step.to.x.t);
  if (!coming_.widen(step.from.x, path_)) return shortOfMeeting(step, trial, coming_.clear());
  // The path may reach contacts of bodies that turn fast.
  if (const double longest = longestOfTurns(step.from.x.u); trial.h > kRoomy * longest)
    return reject(step, longest);
  const double width = 0.1 * std::cbrt(0.01 * parts_.norm.tolerance());
  if (search.find(step.s, parts_.probe, phase, path_, looked, width, trial.found))
    return Tried::accepted;
  if (phase.fault().empty()) return shortOfMeeting(step, trial, TrialConstants::half);
  return fail(step.fault(), trial);
}

/// A trial has reached two bodies whose contact cannot be followed: requires a shorter trial that
/// ends right before they meet, or gives up the step.
TrialStep::Tried TrialStep::shortOfMeeting(LocatedStep& step, Trial& trial, double clear) {
  parts_.pace.next = trial.h * clear;
  if (parts_.pace.next > MeetingConstants::atMeeting * parts_.norm.time()) {
    ++step.report.counts.rejected;
    return Tried::rejected;
  }
  const ContactProbe& probe = parts_.probe;
  const ContactKey met = probe.noted().unreported();
  return fail(step.lose(met != kNoContact ? met : probe.unfollowed()), trial);
}

/// True: bodies move at p, or would within the least length of a step at rest.
bool TrialStep::moves(const PhasePoint& p) const {
  const double least = InstantConstants::shortRest * parts_.norm.time();
  for (Eigen::Index i = 0; i < p.x.u.size(); ++i)
    if (parts_.norm.velocity(i, std::max(std::abs(p.x.u[i]), least * std::abs(p.a[i])), 0.0) >
        InstantConstants::still)
      return true;
  return false;
}

/// True: a step at rest is too long to see forces change within it. A step of the least length for
/// rest is accepted all the same, and the report says so.
bool TrialStep::tooLongAtRest(LocatedStep& step, const Trial& trial) {
  // Where nothing moves, no error bounds the step, however fast forces change with time.
  SwitchSearch& search = parts_.search;
  if (!search.any() || trial.found.kind == Switch::Kind::atStart || moves(step.from) ||
      moves(step.to) || !search.rough(step.s, parts_.probe, parts_.motion.phase, path_))
    return false;
  if (trial.h > InstantConstants::shortRest * parts_.norm.time()) return true;
  double& unseen = step.report.counts.unseen;
  if (!trial.found) unseen = std::max(unseen, trial.h);
  return false;
}

bool TrialStep::slipsInSpace() const {
  const FrozenPhase& phase = parts_.motion.phase;
  for (std::size_t i = 0; i < phase.held.size(); ++i)
    if (phase.held[i].slips && phase.rows().slipRows(i) > 1) return true;
  return false;
}

void TrialStep::drop(LocatedStep& step, double h) {
  parts_.motion.phase.held = step.startHeld;
  reject(step, MeetingConstants::shorter * h);
  step.book(&StepEffort::rejected);
}

}  // namespace dynamy
