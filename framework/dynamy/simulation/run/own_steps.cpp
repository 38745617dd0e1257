#include <algorithm>
#include <dynamy/simulation/run/own_steps.hpp>

namespace dynamy {
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

bool OwnSteps::advance(Stepper& stepper, double until) {
  double end = until;
  if (const double at = samples_.after(stepper.t()); SampleInstants::isWithin(at, until)) end = at;
  double most = end - stepper.t();
  if (largest_ > 0.0) most = std::min(most, largest_);
  for (int i = 0;; ++i) {
    const long before = stepper.spent().evaluations;
    const StepReport report = stepper.attempt(stepper.t() + most, most, false);
    const int tries = mostParts(nu_, stepper.spent().evaluations - before);
    const bool sound = stepper.sound();
    if (const Passing p = sound ? stepper.passing() : Passing{}) {
      if (i < tries) {
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
