#include <algorithm>
#include <dynamy/simulation/run/own_steps.hpp>

namespace dynamy {
namespace {

/// What fast bodies may cost beside the steps, in evaluations of one velocity: in small models, and for
/// each velocity of large ones; the part of it that may be spent at any time.
constexpr double kPartsWork = 4e6, kPartsOfEach = 2e4, kAtOnce = 0.5;
/// Where it is used up, one of so many steps looks what it passes.
constexpr long kSeldom = 16;

}  // namespace

Advance OwnSteps::next(Stepper& stepper, double until) {
  const double rest = until - stepper.t(), next = stepper.nextStep();
  const bool over = isPassed(until, stepper.t());
  // A longer run continues from the state stored here, before the end time shortens a step.
  if (!kept_ &&
      (over || !(next > 0.0 && std::min(next, largest_ > 0.0 ? largest_ : next) < rest))) {
    if (!stepper.pause(true)) return Advance::stopped;
    kept_ = true;
  }
  if (over) return Advance::atEnd;
  return advance(stepper, until) && stepper.pause(false) ? Advance::taken : Advance::stopped;
}

bool OwnSteps::mayEndAtContact(double t, double until) const {
  const double share = until > 0.0 ? std::clamp(t / until, 0.0, 1.0) : 1.0;
  return parted_ < (kAtOnce + share) * std::max(kPartsWork, kPartsOfEach * nu_);
}

Passing OwnSteps::passed(Stepper& stepper, double until, double tried) {
  if (!mayEndAtContact(stepper.t(), until) && ++unseen_ % kSeldom != 0) {
    stepper.leave({});
    return {};
  }
  const double before = stepper.spent().work;
  const Passing p = stepper.passing();
  parted_ += std::max(0.0, stepper.spent().work - before - tried);
  return p;
}

bool OwnSteps::advance(Stepper& stepper, double until) {
  double end = until;
  if (const double at = samples_.after(stepper.t()); SampleInstants::isWithin(at, until)) end = at;
  double most = end - stepper.t();
  if (largest_ > 0.0) most = std::min(most, largest_);
  for (int i = 0;; ++i) {
    const Spent before = stepper.spent();
    const StepReport report = stepper.attempt(stepper.t() + most, most, StepTry::whole);
    const int tries = mostParts(nu_, stepper.spent().evaluations - before.evaluations);
    const double tried = stepper.spent().work - before.work;
    const bool sound = stepper.sound();
    if (const Passing p = sound ? passed(stepper, until, tried) : Passing{}) {
      if (i < tries && mayEndAtContact(stepper.t(), until)) {
        parted_ += tried;
        stepper.reject();
        // Next try: up to the contact or, if the body is there already, across it in a very short
        // step.
        most = p.t > 2.0 * p.width ? p.t - p.width : 2.0 * p.t + p.width;
        continue;
      }
      stepper.leave(p);
    }
    if (sound && !report.solved.ok() && policy_ == NonConvergence::stop) {
      stepper.reject();
      return stepper.fail(report);
    }
    return stepper.accept();
  }
}

}  // namespace dynamy
