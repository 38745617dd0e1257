#include <algorithm>
#include <dynamy/located/governed/governed_motion.hpp>

namespace dynamy {
namespace {

constexpr int kDense = 64;  ///< problems with more rows are solved by sparse methods
/// Floating-point operations of an evaluation of M, h and contacts, per velocity or row.
constexpr double kPerRow = 100.0;
constexpr double kSwitch = 30.0;  ///< evaluations of a located switch
/// Of what a run may spend: a step that is not done by then stalls.
constexpr double kOneStep = 0.125;

}  // namespace

bool GovernedMotion::load(const MechanicalSystem& s, const State& x) {
  fresh_ = x.scheme.size() == 0;
  if (fresh_) {
    state_.governor = {}, state_.patience = {}, state_.pace = {};
    return true;
  }
  // What this object has just stored is known. A state from elsewhere is checked.
  if (x.scheme.size() == stored_.size() && x.scheme == stored_ &&
      (turned() || motion_.endsAt(s, x)))
    return true;
  stored_.resize(0);
  if (!state_.read(x.scheme, s.parts())) return false;
  motion_.scales(s, state_.time, state_.times);
  if (state_.governor.mode() == SwitchGovernor::Mode::locate)
    work_.resume(s.parts(), state_.charged);
  return true;
}

Refusal GovernedMotion::locate(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt,
                               StepReport& report) {
  const long before = s.evaluations();
  const double visited = s.limits.visits();
  SwitchGovernor& governor = state_.governor;
  const bool anew = fresh_ || governor.mode() == SwitchGovernor::Mode::decideAnew;
  const LocatedMotion::Start start{.held = anew ? nullptr : &state_.held,
                                   .scaled = !fresh_,
                                   .goesOn = !anew && stored_.size() > 0,
                                   .lastSwitched = governor.turnedAt(),
                                   .most = kOneStep * allowed_.rate * allowed_.end};
  governor.mode(SwitchGovernor::Mode::locate);
  Refusal refusal = motion_.advance(s, solver, x, start, dt, report);
  const ErrorNorm& norm = motion_.parts().norm;
  governor.scales(norm.tolerance(), norm.time());
  if (anew) work_.begin(s.parts(), norm.times().size());
  stored_.resize(0);
  spent_ = motion_.parts().work(s, s.evaluations() - before - motion_.parts().repeated) +
           RunPatience::ofVisits(s.limits.visits() - visited, s.slot(0).contacts.rows());
  state_.patience.spend(spent_);
  if (refusal) {
    if (refusal.passable) governor.turn(x.t, TurnedBy::stall, motion_.lastSwitched());
  } else {
    const State& end = motion_.end();
    const double t = x.t;
    x.t = end.t == t + dt ? t + dt : end.t;
    x.q = end.q, x.u = end.u, x.memory = end.memory;
    report.dt = x.t - t;
    // A resumed run decides as one that goes on does.
    govern(s, s.evaluations() - before - motion_.parts().repeated, report);
  }
  if (turned()) {
    governor.switchCosts(locatedWork(s, kSwitch));
    state_.stepped = {};
    work_.choose(s, x, motion_, governor, refusal.lost, state_.stepped.systems);
  } else if (!refusal) {
    store(x);
  }
  if (!refusal) motion_.report(s, x, report);
  return refusal;
}

void GovernedMotion::store(State& x) {
  const ErrorNorm& norm = motion_.parts().norm;
  state_.time = norm.time(), state_.times = norm.times();
  if (state_.governor.mode() == SwitchGovernor::Mode::locate) {
    motion_.keep(state_.held);
    state_.next = state_.held.pace.next, state_.charged = work_.numbers();
  }
  numbers_.clear();
  numbers_(state_);
  numbers_.copyTo(x.scheme);
  stored_ = x.scheme;
}

void GovernedMotion::leave(const MechanicalSystem& s) {
  state_.governor.mode(SwitchGovernor::Mode::step);
  state_.stepped = {};
  state_.stepped.systems.assign(s.parts().topology->systems().size(), 0);
}

void GovernedMotion::govern(const MechanicalSystem& s, long evaluations, const StepReport& report) {
  const double work = locatedWork(s, static_cast<double>(evaluations));
  const bool switched = report.counts.switches > 0;
  work_.charge(s, motion_, work, switched);
  const bool over =
      state_.governor.located(motion_.end().t, report.dt, evaluations, work,
                              steppedWork(s, 1.0, 4.0), switched, motion_.lastSwitched());
  if (state_.pace.tooDear(report.dt, spent_, allowed_) && !turned())
    state_.governor.giveUp(motion_.end().t, allowed_.end, motion_.lastSwitched());
  if (over && !turned()) work_.forget();
}

Eigen::VectorXd GovernedMotion::decidedAnew() const {
  const ErrorNorm& norm = motion_.parts().norm;
  GovernedState state;
  state.governor.mode(SwitchGovernor::Mode::decideAnew);
  state.time = norm.time(), state.times = norm.times();
  NumberArchive numbers;
  numbers(state);
  Eigen::VectorXd out;
  numbers.copyTo(out);
  return out;
}

double GovernedMotion::locatedWork(const MechanicalSystem& s, double evaluations) const {
  // Each evaluation solves for the forces by an orthogonal decomposition of all rows.
  const FrozenPhase& phase = motion_.parts().motion.phase;
  const double n = static_cast<double>(s.slot(0).h.size()),
               m = phase.held.empty() ? 0.0 : phase.rows().size();
  return evaluations * (kPerRow * (n + m) + 10.0 / 3.0 * m * m * m);
}

double GovernedMotion::steppedWork(const MechanicalSystem& s, double evaluations,
                                   double newton) const {
  const double n = static_cast<double>(s.slot(0).h.size()), m = s.slot(0).contacts.rows();
  const double dense = std::min(m, static_cast<double>(kDense));
  return evaluations * kPerRow * (n + m) + newton / 3.0 * m * dense * dense;
}

}  // namespace dynamy
