#include <dynamy/simulation/time_loop.hpp>

namespace dynamy {
namespace {
constexpr int kMostHalvings = 6;
}

bool FixedStep::run(Stepper& stepper, double until) {
  const double dt = grid_.spacing();
  // Full steps as long as they do not pass the end by more than rounding.
  while (grid_.at(i_ + 1) <= until + 1e-9 * dt) {
    if (!advance(stepper, grid_.at(i_ + 1), dt, 0)) return false;
    ++i_;
    if (!stepper.pause(false)) return false;
  }
  const double rest = until - stepper.t();
  if (!stepper.pause(true)) return false;  // a longer run takes a full step here
  if (rest <= 1e-9 * dt) return true;
  return advance(stepper, until, rest, 0);
}

bool FixedStep::advance(Stepper& stepper, double tEnd, double dt, int depth) {
  const StepReport report = stepper.attempt(tEnd, dt);
  const bool sound = stepper.sound(), good = sound && report.solved.ok();
  const bool halve = policy_ == NonConvergence::retry && depth < kMostHalvings;
  if (!good && halve) {  // the same step in two halves
    stepper.reject();
    const double tM = stepper.t() + 0.5 * dt;
    return advance(stepper, tM, 0.5 * dt, depth + 1) &&
           advance(stepper, tEnd, tEnd - tM, depth + 1);
  }
  if (!good && sound && policy_ == NonConvergence::stop) {
    stepper.reject();
    return stepper.fail(report);
  }
  return stepper.accept();  // a state that is not sound ends the run there
}

}  // namespace dynamy
