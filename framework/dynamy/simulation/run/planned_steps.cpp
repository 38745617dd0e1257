#include <algorithm>
#include <dynamy/simulation/run/planned_steps.hpp>

namespace dynamy {
namespace {

/// An end of the motion may come later than in the planned run by these parts of the planned step and of the
/// step that the scheme would take.
constexpr double kLater = 0.25, kLaterOfNext = 0.1;

}  // namespace

double PlannedSteps::bound(const Stepper& stepper, double rest) const {
  const double next = stepper.nextStep();
  // Two equal steps up to a stop, so that the last one has room for instants that move.
  if (plan_.steps.empty()) return next < rest && rest < 2.0 * next ? 0.5 * rest : rest;
  if (taken_ >= plan_.steps.size()) return rest;
  const PlannedStep& step = plan_.steps[taken_];
  if (step.end == PlannedStep::End::atStop) return rest;
  if (step.end == PlannedStep::End::bounded) return std::min(rest, step.dt);
  return std::min(rest, step.dt + std::max(kLater * step.dt, kLaterOfNext * next));
}

Advance PlannedSteps::next(Stepper& stepper, double until) {
  while (stop_ < plan_.stops.size() && isPassed(plan_.stops[stop_], stepper.t())) ++stop_;
  const double stop = stop_ < plan_.stops.size() ? std::min(plan_.stops[stop_], until) : until;
  const double rest = stop - stepper.t();
  if (isPassed(stop, stepper.t())) return Advance::atEnd;
  const double most = bound(stepper, rest);
  stepper.attempt(most == rest ? stop : stepper.t() + most, most, StepTry::whole);
  ++taken_;
  return stepper.accept() && stepper.pause(false) ? Advance::taken : Advance::stopped;
}

}  // namespace dynamy
