#include <algorithm>
#include <cmath>
#include <dynamy/simulation/run/time_loop.hpp>
#include <limits>

namespace dynamy {
namespace {
constexpr int kMostHalvings = 6;
/// Parts of a step that a scheme ends early, down to this part of its length.
constexpr double kMostEarly = 8.0;
/// See Allowance::begin.
constexpr int kFewer = 4, kMore = 2;
/// Full steps after one in parts in which fast bodies are expected.
constexpr int kExpected = 10;
constexpr long kFirstMore = 2;  ///< evaluations of the first attempt beside those of others
constexpr long kMostParts = 2000, kFewestParts = 8;
/// Tries times evaluations times velocities, where the scheme chooses its steps.
constexpr long kFastWork = 144000;
/// Evaluations of an attempt that is to cost little.
constexpr long kFewest = 8;
/// A remaining time up to this share of the instant counts as zero.
constexpr double kTimeNoise = 8.0 * std::numeric_limits<double>::epsilon();

long partsWithin(long work, int nu, long evaluations) {
  return work / (std::max(nu, 1) * std::max(evaluations, 1l));
}
}  // namespace

bool isPassed(double instant, double t) { return !(instant - t > kTimeNoise * std::abs(instant)); }

long partsWithinWork(int nu, long evaluations) {
  return partsWithin(static_cast<long>(StepBudget::kEqual), nu, evaluations);
}

int mostParts(int nu, long evaluations) {
  return static_cast<int>(
      std::clamp(partsWithin(kFastWork, nu, evaluations), kFewestParts, kMostParts));
}

void Allowance::begin() {
  if (!exhausted()) saved_ = std::min(saved_ + 1.0 - static_cast<double>(taken_) / now_, saves_);
  now_ = exhausted() ? std::max(1, now_ / kFewer) : std::min(kMore * now_, most_);
  taken_ = drawn_ = 0;
}

bool Allowance::take() {
  const double one = 1.0 / now_;
  if (taken_ == now_ && saved_ >= one && taken_ + drawn_ < most_) {
    saved_ -= one, ++drawn_;
    return true;
  }
  ++taken_;
  return !exhausted();
}

void Allowance::archive(Archive& a) {
  a(now_), a(taken_), a(saved_);
  if (now_ < 1 || now_ > most_ || taken_ < 0 || !(saved_ >= 0.0 && saved_ <= saves_))
    throw ModelError("the checkpoint leaves no step its tries");
}

Advance FixedStep::next(Stepper& stepper, double until) {
  if (rest_ && isPassed(until, stepper.t())) return Advance::atEnd;
  rest_ = false;
  const double dt = grid_.spacing();
  parts_.begin(), halves_.begin(), budget_.begin();
  if (quiet_ <= kExpected) ++quiet_;
  // Full steps as long as they do not pass the end by more than rounding.
  if (grid_.at(i_ + 1) <= until + 1e-9 * dt) {
    // After an earlier end within this full step, its remainder follows.
    const double done = stepper.t() - grid_.at(i_);
    const double length = done > 1e-9 * dt ? grid_.at(i_ + 1) - stepper.t() : dt;
    if (!sampled(stepper, grid_.at(i_ + 1), length)) return Advance::stopped;
    ++i_;
    return stepper.pause(false) ? Advance::taken : Advance::stopped;
  }
  const double rest = until - stepper.t();
  if (!stepper.pause(true)) return Advance::stopped;  // a longer run takes a full step here
  if (rest <= 1e-9 * dt) return Advance::atEnd;
  rest_ = true;
  return sampled(stepper, until, rest) ? Advance::taken : Advance::stopped;
}

void FixedStep::archive(Archive& a) {
  a(i_), a(quiet_), parts_.archive(a), halves_.archive(a), division_.archive(a), budget_.archive(a);
  if (quiet_ < 0) throw ModelError("the checkpoint counts quiet steps from below zero");
  if (i_ < 0) throw ModelError("the checkpoint counts its steps from below zero");
}

Passing FixedStep::ahead(Stepper& stepper, double dt) {
  if (quiet_ > kExpected || parts_.exhausted() || budget_.exhausted()) return {};
  const double before = stepper.spent().work;
  const Passing p = stepper.passing(dt);
  budget_.spend(stepper.spent().work - before);
  return p;
}

Passing FixedStep::passed(Stepper& stepper) {
  if (parts_.exhausted()) return {};
  const double before = stepper.spent().work;
  const Passing p = stepper.passing();
  budget_.spend(stepper.spent().work - before);
  return p;
}

bool FixedStep::sampled(Stepper& stepper, double tEnd, double dt) {
  double at = samples_.after(stepper.t());
  if (!SampleInstants::isWithin(at, tEnd)) return full(stepper, tEnd, dt);
  for (; SampleInstants::isWithin(at, tEnd); at = samples_.after(stepper.t()))
    if (!full(stepper, at, at - stepper.t())) return false;
  return full(stepper, tEnd, tEnd - stepper.t());
}

bool FixedStep::full(Stepper& stepper, double tEnd, double dt) {
  whole_ = dt;
  const int n = division_.begin();
  const bool taken = n > 1 ? divide(stepper, tEnd, dt, n) : advance(stepper, tEnd, dt, 0);
  if (division_.finest() > 1) stepper.divided(division_.finest());
  return taken;
}

int FixedStep::partsOf(Stepper& stepper, double dt, long evaluations) {
  if (!division_.divides()) return 1;
  const long within = partsWithinWork(nu_, evaluations), most = std::max(within, 1l);
  const long against =
      budget_.exhausted() ? most : std::max(StepDivision::kAgainstGains * within, 1l);
  return division_.parts(stepper.coarseness(), dt / whole_, most, against);
}

bool FixedStep::divide(Stepper& stepper, double tEnd, double dt, int n) {
  const double begin = stepper.t();
  for (int k = 1; k <= n; ++k) {
    const double to = k < n ? begin + k * (dt / n) : tEnd;
    if (!advance(stepper, to, dt / n, 0)) return false;
  }
  return true;
}

bool FixedStep::advance(Stepper& stepper, double tEnd, double dt, int depth, double shortest) {
  if (!(shortest > 0.0)) shortest = dt / kMostEarly;
  // An attempt would end among bodies that it has passed, which takes long to solve.
  if (const Passing p = ahead(stepper, dt)) {
    if (parts_.take()) return inParts(stepper, p, tEnd, dt, depth);
    stepper.leave(p);
  }
  const Spent before = stepper.spent();
  const bool cheap = budget_.exhausted();
  const StepTry how = dt > 1.5 * shortest ? StepTry::whole : StepTry::part;
  const StepReport report = stepper.attempt(tEnd, dt, cheap ? StepTry::cheap : how);
  const Spent after = stepper.spent();
  // The first attempt of a run, also of a resumed one, looks for joints besides.
  const long counted = after.evaluations - before.evaluations;
  const long evaluations = first_ ? std::max(counted - kFirstMore, 1l) : counted;
  first_ = false;
  // A resumed run has the budget of one that goes on.
  budget_.spend(after.work - before.work - static_cast<double>((counted - evaluations) * nu_),
                report.solved.ok() && !report.simpler);
  const bool sound = stepper.sound(), good = sound && report.solved.ok();
  // Parts for which the budget is too small are taken at the least cost, which a cheap try shows.
  const long least = std::min(evaluations, kFewest);
  const long ofPart =
      cheap ? std::max(least, static_cast<long>((after.work - before.work) / nu_))
            : least + static_cast<long>((after.implicit - before.implicit) / std::max(nu_, 1));
  // Too coarse for the motion: all else is looked at in its parts.
  const int taken = report.dt > 0.0 ? static_cast<int>(std::lround(dt / report.dt)) : 1;
  const double length = taken > 1 ? report.dt : dt;
  if (const int n = sound ? partsOf(stepper, length, ofPart) : 1; n > 1) {
    stepper.reject();
    return divide(stepper, tEnd, dt, n * taken);
  }
  if (const Passing p = sound ? passed(stepper) : Passing{}) {
    if (!budget_.exhausted() && parts_.take()) {
      stepper.reject();
      return inParts(stepper, p, tEnd, dt, depth);
    }
    parts_.exhaust();
    stepper.leave(p);
  }
  const bool retry = !good && policy_ == NonConvergence::retry;
  if (retry && (depth == kMostHalvings || budget_.exhausted())) halves_.exhaust();
  // A state that is not sound would end the run, so all halvings are allowed for it.
  if (retry && (sound ? !halves_.exhausted() && halves_.take()
                      : depth < kMostHalvings)) {  // the same step in two halves
    stepper.reject();
    const double tM = stepper.t() + 0.5 * dt;
    return advance(stepper, tM, 0.5 * dt, depth + 1) &&
           advance(stepper, tEnd, tEnd - tM, depth + 1);
  }
  if (!good && sound && policy_ == NonConvergence::stop) {
    stepper.reject();
    return stepper.fail(report);
  }
  // A state that is not sound ends the run there.
  return stepper.accept() &&
         (taken <= 1 || goOn(stepper, tEnd, report.dt, taken - 1, depth, shortest));
}

bool FixedStep::goOn(Stepper& stepper, double tEnd, double dt, int n, int depth, double shortest) {
  const double begin = stepper.t();
  for (int k = 1; k <= n; ++k)
    if (!advance(stepper, k < n ? begin + k * dt : tEnd, dt, depth, shortest)) return false;
  return true;
}

bool FixedStep::inParts(Stepper& stepper, const Passing& p, double tEnd, double dt, int depth) {
  quiet_ = 0;
  // Up to the contact, unless the body is there already.
  const double w = p.width, before = p.t > 2.0 * w ? p.t - w : 0.0;
  if (before > 0.0 && !advance(stepper, stepper.t() + before, before, depth)) return false;
  // Across the contact, with a little more time after it than before, so that every scheme finds it
  // closed.
  const double across = 2.0 * (p.t - before) + w, rest = dt - before - across;
  if (!(rest > 0.0)) return advance(stepper, tEnd, dt - before, depth);
  return advance(stepper, stepper.t() + across, across, depth) &&
         advance(stepper, tEnd, rest, depth);
}

}  // namespace dynamy
