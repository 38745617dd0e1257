// LocatedDormandPrince: steps in time where switches are too dense to be located.
#include <algorithm>
#include <cmath>
#include <dynamy/located/located_dormand_prince.hpp>

namespace dynamy {
namespace {

constexpr double kSwitch = 30.0;  ///< evaluations of a located switch
constexpr int kDense = 64;        ///< problems with more rows are solved by sparse methods

/// Floating-point operations of an evaluation of M, h and contacts, per velocity or row.
constexpr double kPerRow = 100.0;
constexpr double kSliver = 1e-3;  ///< of a step: a rest this short is joined to the step
constexpr int kStepped = 4;       ///< numbers in front of the rates

}  // namespace

void LocatedDormandPrince::govern(const MechanicalSystem& s, long evaluations,
                                  const StepReport& report) {
  const double work = locatedWork(s, static_cast<double>(evaluations));
  const bool switched = report.counts.switches > 0;
  owe(s, work, switched);
  const bool over = governor_.located(to_.x.t, report.dt, evaluations, work,
                                      steppedWork(s, 1.0, 4.0), switched, lastSwitched_);
  if (over && governor_.mode() == SwitchGovernor::Mode::locate) owed_.setZero();
}

double LocatedDormandPrince::locatedWork(const MechanicalSystem& s, double evaluations) const {
  // Each evaluation solves for the forces by an orthogonal decomposition of all rows.
  const double n = static_cast<double>(s.slot(0).h.size()), m = phase_.rows();
  return evaluations * (kPerRow * (n + m) + 10.0 / 3.0 * m * m * m);
}

double LocatedDormandPrince::steppedWork(const MechanicalSystem& s, double evaluations,
                                         double newton) const {
  const double n = static_cast<double>(s.slot(0).h.size()), m = s.slot(0).contacts.rows();
  const double dense = std::min(m, static_cast<double>(kDense));
  return evaluations * kPerRow * (n + m) + newton / 3.0 * m * dense * dense;
}

bool LocatedDormandPrince::stepsInTime(const State& x) {
  if (x.scheme.size() <= kHead) {
    governor_.reset();
    return false;
  }
  governor_.numbers(x.scheme.data() + kHead);
  return governor_.mode() == SwitchGovernor::Mode::step;
}

void LocatedDormandPrince::resumeStepping(const MechanicalSystem& s, const State& x) {
  // After the numbers of each system follow: the number of rates, the overlap, the number of data
  // of located islands, whether joints are projected. Then the rates, the data of located islands,
  // and the data of the time-stepping scheme.
  resumeNorm(s, x);
  const Eigen::Index at = behindTimes(), systems = norm_.times().size();
  const auto n = static_cast<Eigen::Index>(x.scheme[at]),
             quiet = static_cast<Eigen::Index>(x.scheme[at + 2]);
  head_ = x.scheme.head<kHead>();
  timed_.resize(static_cast<std::size_t>(systems));
  for (Eigen::Index i = 0; i < systems; ++i)
    timed_[static_cast<std::size_t>(i)] = x.scheme[kBehind + systems + i] != 0.0 ? 1 : 0;
  steps_.resume(slice(x.scheme, at + kStepped, n), x.scheme[at + 1], x.scheme[at + 3] != 0.0);
  quietKept_ = x.scheme.segment(at + kStepped + n, quiet);
  steppedFrom_.scheme = x.scheme.tail(x.scheme.size() - at - kStepped - n - quiet);
}

void LocatedDormandPrince::beginStepping(const State& x) {
  head_.setZero();
  if (x.scheme.size() > kHead)
    head_ = x.scheme.head<kHead>();
  else
    head_.head<4>() << H_, norm_.time(), lookAhead_, lastEvent_;
  chooseStepped(x);
  steps_.begin(), untold_.clear();
  steppedFrom_.scheme.resize(0);
}

void LocatedDormandPrince::storeStepping(State& x) const {
  const auto numbers = governor_.numbers();
  const Eigen::Index at = behindTimes(), n = steps_.rate().size(), quiet = quietKept_.size();
  const Eigen::VectorXd own = x.scheme;
  x.scheme.resize(at + kStepped + n + quiet + own.size());
  x.scheme.head<kHead>() = head_;
  x.scheme[kHead - 1] = 0.0;  // nothing is held
  std::copy(numbers.begin(), numbers.end(), x.scheme.data() + kHead);
  x.scheme.segment(kBehind, norm_.times().size()) = norm_.times();
  x.scheme.segment(kBehind, at - kBehind).tail(2 * norm_.times().size()).setZero();
  for (std::size_t i = 0; i < timed_.size(); ++i)
    x.scheme[kBehind + norm_.times().size() + static_cast<Eigen::Index>(i)] = timed_[i];
  x.scheme.segment<kStepped>(at) << static_cast<double>(n), steps_.overlap(),
      static_cast<double>(quiet), steps_.projected() ? 1.0 : 0.0;
  x.scheme.segment(at + kStepped, n) = steps_.rate();
  x.scheme.segment(at + kStepped + n, quiet) = quietKept_;
  x.scheme.tail(own.size()) = own;
}

StepReport LocatedDormandPrince::stepInTime(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                            double dt) {
  system_ = &s, denseReady_ = false, stepped_ = true, stored_.resize(0);
  governor_.scales(norm_.tolerance(), norm_.time());
  islands_.start(s.parts());
  const long before = s.evaluations();
  steppedFrom_.t = x.t, steppedFrom_.q = x.q, steppedFrom_.u = x.u;
  steppedFrom_.memory = x.memory, steppedFrom_.impulses = x.impulses;
  StepReport report;
  StepCounts quiet;
  double h = 0.0, tE = 0.0, error = 0.0;
  int rejected = 0, newton = 0;
  for (;; ++rejected) {
    const double known = followQuiet(s, solver, steppedFrom_.t + dt, quiet);
    h = std::min(governor_.h(), dt);
    tE = h == dt ? steppedFrom_.t + dt : steppedFrom_.t + h;
    if (known <= tE + kSliver * h) tE = known, h = tE - steppedFrom_.t;
    placeQuiet(s, tE);
    const SteppedIslands::Trial trial =
        steps_.attempt(s, solver, norm_, islands_, timed_, steppedFrom_, x, h);
    report = trial.report, error = trial.error, newton += trial.newton;
    if (trial.good() || !(h > governor_.least())) break;
    governor_.shorten(h, std::max(error, 1.0));
  }
  x.t = tE;
  report.dt = x.t - steppedFrom_.t;
  steps_.take(steppedFrom_, x.u, h);
  joinQuiet(s, x, report);
  report.counts = quiet;
  report.counts.rejected += rejected;
  report.counts.stepped = true, report.counts.stepError = error;
  report.counts.turnedBy = governor_.turnedBy(), report.counts.turnedAt = governor_.turnedAt();
  report.counts.steppedSystems = steppedSystems();
  const StepEffort& e = quiet.effort;
  const long evaluations = s.evaluations() - before - e.smooth - e.rejected - e.switches - e.events;
  report.counts.effort.stepping = evaluations;
  governor_.told();
  governor_.stepped(x.t, h, error, steppedWork(s, static_cast<double>(evaluations), newton),
                    rejected > 0, locatedWork(s, kSwitch), evaluations);
  head_[0] = nextStepped(x.t);
  storeStepping(x);
  return report;
}

}  // namespace dynamy
