// LocatedDormandPrince: steps in time where switches are too dense to be located.
#include <algorithm>
#include <cmath>
#include <dynamy/integrator/located_dormand_prince.hpp>

namespace dynamy {
namespace {

constexpr double kSwitch = 30.0;  ///< evaluations of a located switch
constexpr int kDense = 64;        ///< rows above are solved by sparse methods

/// Floating-point operations of an evaluation of M, h and contacts, per velocity or row.
constexpr double kPerRow = 100.0;
constexpr double kGrown = 0.1;  ///< of an allowed overlap: less is none

/// The largest overlap of unilateral contacts, of those that rebound as well [m].
double deepest(const ContactSet& c) {
  double overlap = 0.0;
  for (int i = 0; i < c.size(); ++i)
    if (const auto at = static_cast<std::size_t>(i); c.law[at]->unilateral())
      overlap = std::max(overlap, -c.position[static_cast<std::size_t>(c.row0[at])]);
  return overlap;
}

}  // namespace

double LocatedDormandPrince::locatedWork(const MechanicalSystem& s, double evaluations) const {
  // Each solves for the forces by an orthogonal decomposition of all rows.
  const double n = static_cast<double>(s.slot(0).h.size()), m = phase_.rows();
  return evaluations * (kPerRow * (n + m) + 10.0 / 3.0 * m * m * m);
}

double LocatedDormandPrince::steppedWork(const MechanicalSystem& s, double evaluations,
                                         double newton) const {
  const double n = static_cast<double>(s.slot(0).h.size()), m = s.slot(0).contacts.rows();
  const double dense = std::min(m, static_cast<double>(kDense));
  return evaluations * kPerRow * (n + m) + newton / 3.0 * m * dense * dense;
}

double LocatedDormandPrince::steppedError(MechanicalSystem& s, const State& a, const State& b,
                                          double h) {
  // Positions by the trapezoidal rule: h/2 |Δu − Δu of the step before|, an impact or h³ü/2; the
  // first step tells the rate. Overlaps at the end count as well, which the step itself does not
  // look at, if they grew: one that stays, shorter steps do not mend.
  double worst = 0.0;
  const bool known = rate_.size() == a.u.size();
  for (Eigen::Index i = 0; known && i < rate_.size(); ++i)
    worst = std::max(worst, norm_.velocity(i, b.u[i] - a.u[i] - h * rate_[i], 0.0));
  worst *= 0.5 * h / norm_.time();
  reached_ = deepest(s.evaluate(b, 1).contacts);
  const double allowed = norm_.tolerance() * norm_.length(), gained = reached_ - overlap_;
  worst = std::max(worst, (gained > kGrown * allowed ? reached_ : gained) / allowed);
  return std::isfinite(worst) && s.indefiniteMass() < 0 ? worst : 1e300;
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
  // Behind the times of the systems: the number of rates, the overlap, the rates, and what the
  // other scheme keeps.
  resumeNorm(s, x);
  const Eigen::Index at = behindTimes();
  const auto n = static_cast<Eigen::Index>(x.scheme[at]);
  head_ = x.scheme.head<kHead>();
  overlap_ = x.scheme[at + 1];
  rate_ = x.scheme.segment(at + 2, n);
  steppedFrom_.scheme = x.scheme.tail(x.scheme.size() - at - 2 - n);
}

void LocatedDormandPrince::beginStepping(const State& x) {
  head_.setZero();
  if (x.scheme.size() > kHead)
    head_ = x.scheme.head<kHead>();
  else
    head_.head<4>() << H_, norm_.time(), lookAhead_, lastEvent_;
  rate_.resize(0), overlap_ = 0.0, untold_.clear();
  steppedFrom_.scheme.resize(0);
}

void LocatedDormandPrince::storeStepping(State& x) const {
  const auto numbers = governor_.numbers();
  const Eigen::Index at = behindTimes(), n = rate_.size();
  const Eigen::VectorXd own = x.scheme;
  x.scheme.resize(at + 2 + n + own.size());
  x.scheme.head<kHead>() = head_;
  x.scheme[kHead - 1] = 0.0;  // nothing is held
  std::copy(numbers.begin(), numbers.end(), x.scheme.data() + kHead);
  x.scheme.segment(kBehind, norm_.times().size()) = norm_.times();
  x.scheme[at] = static_cast<double>(n), x.scheme[at + 1] = overlap_;
  x.scheme.segment(at + 2, n) = rate_;
  x.scheme.tail(own.size()) = own;
}

StepReport LocatedDormandPrince::stepInTime(MechanicalSystem& s, InclusionSolver& solver, State& x,
                                            double dt) {
  system_ = &s, denseReady_ = false, stepped_ = true, stored_.resize(0);
  governor_.scales(norm_.tolerance(), norm_.time());
  s.thaw(), s.bias(false);
  const long before = s.evaluations();
  steppedFrom_.t = x.t, steppedFrom_.q = x.q, steppedFrom_.u = x.u;
  steppedFrom_.memory = x.memory, steppedFrom_.impulses = x.impulses;
  StepReport report;
  double h = 0.0, error = 0.0;
  int rejected = 0, newton = 0;
  for (;; ++rejected) {
    h = std::min(governor_.h(), dt);
    x = steppedFrom_;
    report = timeStepping_.step(s, solver, x, h);
    newton += 1 + report.solved.newton;
    error = steppedError(s, steppedFrom_, x, h);
    if ((error <= 1.0 && report.solved.ok()) || !(h > governor_.least())) break;
    governor_.shorten(h, std::max(error, 1.0));
  }
  x.t = h == dt ? steppedFrom_.t + dt : steppedFrom_.t + h;
  report.dt = x.t - steppedFrom_.t;
  report.counts.rejected = rejected;
  report.counts.stepped = true, report.counts.stepError = error;
  report.counts.turnedBy = governor_.turnedBy(), report.counts.turnedAt = governor_.turnedAt();
  report.counts.effort.stepping = s.evaluations() - before;
  governor_.told();
  const auto evaluations = static_cast<double>(s.evaluations() - before);
  governor_.stepped(x.t, h, error, steppedWork(s, evaluations, newton), rejected > 0,
                    locatedWork(s, kSwitch));
  rate_ = (x.u - steppedFrom_.u) / h, overlap_ = reached_;
  storeStepping(x);
  return report;
}

}  // namespace dynamy
