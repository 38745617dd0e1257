#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/located/located_dormand_prince.hpp>
#include <dynamy/located/step/located_constants.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Of the run: T of steps in time where it has no patience left.
constexpr double kOfRun = 0.1;
/// A step that diverges is taken a quarter as long, down to a part of the least step, a larger one
/// and where solvers are to make little effort; after it the next one is tried so much longer.
constexpr double kQuarter = 0.25, kLeastSense = 1e-3, kLittleSense = 0.05, kLongerAgain = 2.0;
/// Velocities and rows of a usual evaluation, and its work; one of a larger model is worth more.
constexpr double kUsualRows = 80, kUsualEvaluation = 100 * kUsualRows;
constexpr double kSliver = 1e-3;  ///< of a step: a rest this short is joined to the step
/// Of the length that a step in time might have: one that an island makes shorter is held up.
constexpr double kHeldUp = 0.5;

/// The time in which velocities u pass through their scales, between the times T_i of the fastest and
/// of the slowest island: accelerations at the start of the run, of springs that it finds stretched,
/// may have made T very short.
double presentTime(const ErrorNorm& norm, const Eigen::VectorXd& u) {
  const double rate = (u.array().abs() / norm.velocityScales().array()).maxCoeff();
  return std::max(norm.time(), std::min(1.0 / rate, norm.times().maxCoeff()));
}

/// Number of systems with velocities that are stepped in time.
int steppedSystems(const Topology& topology, const SteppedState& stepped) {
  int n = 0;
  for (std::size_t i = 0; i < stepped.systems.size(); ++i)
    n += stepped.systems[i] != 0 && topology.system(static_cast<int>(i)).nu > 0 ? 1 : 0;
  return n;
}

/// Time up to which all islands are known [s]; ∞ without any.
double knownUpTo(const IslandClocks& clocks) {
  double out = std::numeric_limits<double>::infinity();
  for (const auto& c : clocks) out = std::min(out, c->now().to.t);
  return out;
}

/// Longest time from t after which the next step of an island would end [s].
double nextApart(const IslandClocks& clocks, double t) {
  double out = 0.0;
  for (const auto& c : clocks) out = std::max(out, c->now().to.t + c->now().next() - t);
  return out;
}

/// Length of the next step in time from t, h without islands, which ends with the first of theirs.
double nextInTime(const IslandClocks& clocks, double t, double h) {
  for (const auto& c : clocks)
    h = c->now().to.t > t ? std::min(h, c->now().to.t - t) : c->now().next();
  return h;
}

}  // namespace

LocatedDormandPrince::LocatedDormandPrince(const Parameters& x)
    : LocatedDormandPrince(
          x,
          {.stiff = stiffOf(x), .patience = x["patience"], .oneClock = x["clocks"].text == "one"}) {
}

LocatedDormandPrince::LocatedDormandPrince(const Parameters& x, const LocatedSettings& settings)
    : OneStep(x), governed_(settings) {}

StiffSteps LocatedDormandPrince::stiffOf(const Parameters& x) {
  const std::string& stiff = x["stiff"].text;
  return stiff == "never"    ? StiffSteps::never
         : stiff == "always" ? StiffSteps::always
                             : StiffSteps::automatic;
}

void LocatedDormandPrince::declareStiff(Attributes& a) {
  a.choice("stiff", {"automatic", "never", "always"}, "automatic",
           "steps by the implicit Radau IIA method of order 5, for fast forces that are damped: "
           "automatic turns to it where the bound of stability limits explicit steps, and back");
}

void LocatedDormandPrince::declare(Attributes& a) {
  a.about(
      "Steps by tolerance: Dormand and Prince's explicit method of order 8 (5 at loose tolerances, "
      "and where the motion is simple) between switches, which are located; impacts and new "
      "contact "
      "states by inclusions. The scheme of every run with a tolerance.");
  declareStiff(a);
  a.choice("clocks", {"islands", "one"}, "islands",
           "islands: bodies that do not touch have steps of their own, which end at their own "
           "switches; one: all bodies end their steps together");
  a.optional(
       "patience", Unit::none, 1.0,
       "factor on the work after which what is most expensive is stepped in time, with a "
       "warning: by default some seconds of small models, 1e5 evaluations of large ones; inf: "
       "never")
      .positive()
      .mayBeInfinite();
  a.example("<simulation until=\"1\" tolerance=\"1e-6\"><LocatedDormandPrince/></simulation>");
}

StepReport LocatedDormandPrince::step(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                      double dt) {
  StepReport report;
  system_ = &s, stepped_ = apart_ = false;
  if (!governed_.load(s, x)) {
    report.refused = "the checkpoint holds what this scheme does not leave in a state";
    return report;
  }
  if (governed_.turned()) {
    const SteppedState& kept = governed_.state().stepped;
    steps_.resume(view(kept.rate), kept.overlap, kept.projected);
    steppedFrom_.scheme = kept.scheme;
    return kept.any() ? stepInTime(s, solver, x, dt, s.evaluations()) : stepApart(s, solver, x, dt);
  }
  governed_.allow(allowance(s, x.t));
  const Refusal refusal = governed_.locate(s, solver, x, dt, report);
  if (governed_.turned()) steps_.begin(), steppedFrom_.scheme.resize(0);
  if (refusal.passable) {
    const StepEffort spent = report.counts.effort;
    report = stepInTime(s, solver, x, dt, s.evaluations());
    report.counts.effort.rejected += spent.smooth + spent.rejected + spent.switches + spent.events;
  } else if (refusal) {
    refusal_ = refusal.why;
    report.refused = refusal_;
  } else if (governed_.turned()) {
    governed_.state().next = governed_.motion().parts().pace.next;
    governed_.store(x);
  } else if (!governed_.motion().settings().oneClock && clocks_.divide(s, governed_, x, report)) {
    governed_.leave(s);
    clocks_.keep(governed_.state().stepped);
    governed_.store(x);
  }
  return report;
}

/// What the run may spend up to t.
WorkAllowance LocatedDormandPrince::allowance(const MechanicalSystem& s, double t) {
  return governed_.state().patience.allowance(governed_.motion().settings().patience,
                                              static_cast<double>(s.parts().topology->nu()), t,
                                              s.limits.end);
}

/// A step of islands with clocks of their own, none of which is stepped in time: up to the end of the
/// first of their steps.
StepReport LocatedDormandPrince::stepApart(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                           double dt) {
  SteppedState& stepped = governed_.state().stepped;
  StepReport report;
  clocks_.stand(s, solver, governed_, x, stepped);
  const long before = s.evaluations();
  if (const Refusal refusal =
          clocks_.follow(s, solver, x, x.t + dt, stepped, governed_.state().patience)) {
    refusal_ = refusal.why, report.refused = refusal_;
    return report;
  }
  if (stepped.any()) {
    governed_.governor() = clocks_.turnedBy();
    clocks_.keep(stepped);
    steps_.begin(), steppedFrom_.scheme.resize(0);
    return stepInTime(s, solver, x, dt, before);
  }
  apart_ = true;
  const double from = x.t;
  x.t = std::min(from + dt, knownUpTo(clocks_.clocks()));
  clocks_.place(s, x.t);
  clocks_.join(s, x);
  x.impulses = {};
  report.dt = x.t - from;
  clocks_.report(s, x, stepped, report);
  governed_.state().next = nextApart(clocks_.clocks(), x.t);
  governed_.store(x);
  return report;
}

/// Takes a step in time from steppedFrom_ into x, at most dt long, shorter ones until one is good.
LocatedDormandPrince::InTime LocatedDormandPrince::tryInTime(MechanicalSystem& s,
                                                             InclusionSolver& solver, State& x,
                                                             double dt) {
  SteppedState& stepped = governed_.state().stepped;
  SwitchGovernor& governor = governed_.governor();
  const ErrorNorm& norm = governed_.motion().parts().norm;
  InTime out;
  const long before = s.evaluations();
  clocks_.stand(s, solver, governed_, steppedFrom_, stepped);
  steps_.prepare(s, steppedFrom_, std::min(governor.h(), dt));
  out.again = s.evaluations() - before;
  double most = stepped.burst > 0.0 ? std::min(dt, kLongerAgain * stepped.burst) : dt;
  const bool little = governor.effort(Effort::full) == Effort::little;
  const double sense = (little ? kLittleSense : kLeastSense) * governor.least();
  stepped.burst = 0.0;
  for (;; ++out.rejected) {
    if (const Refusal r = clocks_.follow(s, solver, steppedFrom_, steppedFrom_.t + dt, stepped,
                                         governed_.state().patience)) {
      out.refused = r.why;
      return out;
    }
    const double known = std::min(knownUpTo(clocks_.clocks()), steppedFrom_.t + dt);
    double& h = out.h;
    h = std::min(governor.h(), most);
    out.tE = h == dt ? steppedFrom_.t + dt : steppedFrom_.t + h;
    if (known <= out.tE + kSliver * h) out.tE = known, h = out.tE - steppedFrom_.t;
    clocks_.place(s, out.tE);
    const SteppedIslands::Trial trial =
        steps_.attempt(s, solver, norm, islands_, stepped.systems,
                       governor.effort(stepped.searches.next()), steppedFrom_, x, h);
    stepped.searches.done(trial.report.solved.ok() && !trial.report.solved.inVain);
    out.report = trial.report, out.error = trial.error, out.newton += trial.newton;
    // A step to the end of a located one may be longer than the shortest by a sliver, in each try.
    if (trial.good()) break;
    if (h > (1.0 + 2.0 * kSliver) * governor.least()) {
      governor.shorten(h, std::max(trial.error, 1.0));
      continue;
    }
    if (!trial.bursts || h < sense) break;
    most = kQuarter * h;
  }
  if (most < std::min(governor.h(), dt)) stepped.burst = out.h;
  return out;
}

/// `before`: evaluations when the step of the run began.
StepReport LocatedDormandPrince::stepInTime(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                            double dt, long before) {
  SteppedState& stepped = governed_.state().stepped;
  SwitchGovernor& governor = governed_.governor();
  const ErrorNorm& norm = governed_.motion().parts().norm;
  stepped_ = true;
  if (stepped.time <= 0.0) {
    stepped.time = presentTime(norm, x.u);
    if (governor.turnedBy() == TurnedBy::patience)
      stepped.time = std::max(stepped.time, kOfRun * s.limits.end);
  }
  governor.scales(norm.tolerance(), stepped.time);
  islands_.start(s.parts());
  const double visited = s.limits.visits();
  steppedFrom_.t = x.t, steppedFrom_.q = x.q, steppedFrom_.u = x.u;
  steppedFrom_.memory = x.memory, steppedFrom_.impulses = x.impulses;
  const InTime taken = tryInTime(s, solver, x, dt);
  StepReport report = taken.report;
  if (!taken.refused.empty()) {
    refusal_ = taken.refused, report.refused = refusal_;
    return report;
  }
  x.t = taken.tE;
  report.dt = x.t - steppedFrom_.t;
  steps_.take(s, steppedFrom_, x, taken.h);
  clocks_.touch(s, x.t, stepped);
  clocks_.join(s, x);
  report.counts = {};
  report.counts.rejected = taken.rejected;
  report.counts.stepped = true, report.counts.stepError = taken.error;
  report.counts.turnedBy = governor.turnedBy(), report.counts.turnedAt = governor.turnedAt();
  report.counts.steppedSystems = steppedSystems(*s.parts().topology, stepped);
  clocks_.report(s, x, stepped, report);
  const StepEffort& e = report.counts.effort;
  const long evaluations =
      s.evaluations() - before - taken.again - e.smooth - e.rejected - e.switches - e.events;
  report.counts.effort.stepping = evaluations;
  governor.told();
  const auto evaluated = static_cast<double>(evaluations);
  const double work = governed_.steppedWork(s, evaluated, taken.newton);
  const ContactSet& contacts = s.slot(0).contacts;
  const double larger = std::max(1.0, governed_.steppedWork(s, 1.0, 0.0) / kUsualEvaluation) +
                        contacts.features.searched / kUsualRows;
  const double solving = RunPatience::ofVisits(s.limits.visits() - visited, contacts.rows());
  const double worth = evaluated * larger + solving / kUsualRows;
  RunPatience& patience = governed_.state().patience;
  const double part = taken.h / std::min(governor.h(), dt),
               lost =
                   part < kHeldUp && stepped.burst == 0.0 ? kUsualRows * worth * (1.0 - part) : 0.0;
  stepped.heldUp = stepped.held.tooDear(taken.h, lost, allowance(s, x.t));
  governor.stepped(x.t, taken.h, taken.error, work, taken.rejected > 0, worth, s.limits.end);
  patience.spend(kUsualRows * worth);
  governed_.state().next = nextInTime(clocks_.clocks(), x.t, governor.h());
  stepped.rate = steps_.rate(), stepped.overlap = steps_.overlap();
  stepped.projected = steps_.projected(), stepped.scheme = x.scheme;
  governed_.store(x);
  return report;
}

void LocatedDormandPrince::interpolate(const MechanicalSystem& s, const State& a, const State& b,
                                       double theta, State& out) const {
  if ((stepped_ || apart_) && system_ == &s) {
    const double t = a.t + theta * (b.t - a.t);
    if (stepped_)
      steps_.between(s, a, b, theta, out);
    else
      out.t = t, out.q = b.q, out.u = b.u, out.memory = b.memory;
    clocks_.show(*system_, t, out);
    return;
  }
  if (!governed_.motion().interpolate(s, a, b, theta, out))
    OneStep::interpolate(s, a, b, theta, out);
}

bool LocatedDormandPrince::contactsAt(const MechanicalSystem& s, const State& at, bool after,
                                      ContactInstant& out) const {
  if (apart_) return clocks_.contactsAt(*system_, at, after, out);
  return !stepped_ && governed_.motion().contactsAt(s, at, after, out);
}

}  // namespace dynamy
