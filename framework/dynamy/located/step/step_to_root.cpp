#include <algorithm>
#include <cmath>
#include <dynamy/located/step/located_constants.hpp>
#include <dynamy/located/step/step_to_root.hpp>

namespace dynamy {
namespace {

/// True: Taylor's polynomial is accurate enough over this part of the step.
bool isSmall(double part, double tolerance) {
  return std::abs(part) * part * part <= RootConstants::taylor * tolerance;
}

}  // namespace

Refusal StepToRoot::take(LocatedStep& step, double h, const Switch& w, PhasePoint& end) {
  PhaseMotion& motion = parts_.motion;
  const double length = w.theta * h;
  motion.shortStep.explicitStep().light(motion.step.explicitStep().light());
  if (!motion.step.take(step.s, motion.phase, step.from, length, step.to.x)) return step.fault();
  if (Refusal r = step.evaluate(step.to, true)) return r;
  SmoothMethod& method = motion.step.last();
  if (method.errorNeedsEnd()) method.end(step.to);
  const double error = method.error(parts_.norm, step.from.x, step.to.x);
  strays_ = !parts_.settings.givenSteps && !(error <= RootConstants::mostError);
  if (strays_) return {};
  step.record.impulse = method.impulse(), end = step.to;
  end_ = &end;
  Switch first = w;
  for (int i = 0; i < RootConstants::mostFirst; ++i) {
    if (Refusal r = polish(step, length, first)) return r;
    if (!parts_.search.closedBefore(parts_.probe, step.to.x, first)) break;
  }
  return {};
}

Refusal StepToRoot::polish(LocatedStep& step, double h, const Switch& w) {
  PhasePoint& to = step.to;
  double slope = w.slope, last = 0.0, moved = 0.0;
  // Another value of a gap costs next to nothing, one of a force costs an evaluation.
  const double tolerance = parts_.norm.tolerance();
  const double near = w.force ? std::min(1e-8, 0.01 * tolerance) : 1e-15;
  const double farthest =
      parts_.search.isOfFeatures(w) ? RootConstants::jump : RootConstants::farthest;
  bool known = true;
  known_ = to;
  for (int i = 0; i < RootConstants::mostMoves; ++i) {
    double value = 0.0;
    if (!parts_.search.value(parts_.probe, parts_.motion.phase, to.x, w, value))
      return step.unfollowed();
    if (i > 0 && moved != 0.0 && value != last) {
      const double secant = (value - last) / moved;
      if (secant * slope > 0.0) slope = secant;
    }
    if (!(slope < 0.0)) break;  // grazing: the switch is where the search found it
    const double d = -value / slope;
    if (std::abs(d) <= near * h || std::abs(d) > farthest * h) break;
    last = value, moved = d;
    if (Refusal r = move(step, h, d, known)) return r;
    if (w.force && !known)
      if (Refusal r = settle(step)) return r;
    known = known || w.force;
    if (known) known_ = to;
  }
  const double on = to.x.t - known_.x.t;
  if (known) return {};
  if (!isSmall(on / h, tolerance)) return settle(step);
  // At the root of a gap the event evaluates the forces anew: here the last known ones will do.
  step.record.impulse += on * known_.lambda;
  step.record.addWorks(known_.power, on);
  return {};
}

Refusal StepToRoot::move(LocatedStep& step, double h, double d, bool& known) {
  const SmoothStep& smooth = parts_.motion.step;
  const double behind = step.to.x.t + d - end_->x.t;
  known = false;
  if (!smooth.denseReady() && isSmall(d / h, parts_.norm.tolerance())) {
    moveByTaylor(step, d);
    return {};
  }
  const bool dense = !smooth.implicit() && !smooth.halfExplicit();
  if (dense && std::abs(behind) <= RootConstants::denseShare * h)
    return moveByDense(step, step.to.x.t + d);
  known = true;
  return moveByStep(step, d);
}

void StepToRoot::moveByTaylor(LocatedStep& step, double d) {
  // In a stiff motion ü would be that of the fast part, which has died away: it is left out.
  const SmoothStep& smooth = parts_.motion.step;
  const PhasePoint& from = step.from;
  PhasePoint& to = step.to;
  const double h = smooth.last().length();
  second_.setZero(to.x.u.size());
  if (!smooth.implicit())
    second_ = (6.0 / h * (from.x.u - end_->x.u) + 2.0 * from.a + 4.0 * end_->a) / h;
  velocity_ = to.x.u + 0.5 * d * to.a + d * d / 6.0 * second_;
  step.s.move(to.x, velocity_, d);
  to.x.u += d * to.a + 0.5 * d * d * second_;
}

Refusal StepToRoot::moveByDense(LocatedStep& step, double t) {
  PhaseMotion& motion = parts_.motion;
  State& x = step.to.x;
  if (!motion.step.denseReady() &&
      !motion.step.prepareDense(step.s, motion.phase, step.from, *end_))
    return step.fault();
  const SmoothMethod& method = motion.step.last();
  method.dense((t - step.from.x.t) / method.length(), x);
  x.t = t;
  const Topology& topology = *step.s.parts().topology;
  for (std::size_t i = 0; i < topology.systems().size(); ++i)
    if (const SystemHandle& handle = topology.system(static_cast<int>(i)); handle.nq > 0)
      topology.systems()[i]->normalise(slice(x.q, handle.q0, handle.nq));
  return {};
}

Refusal StepToRoot::moveByStep(LocatedStep& step, double d) {
  PhaseMotion& motion = parts_.motion;
  start_ = step.to;
  if (!motion.shortStep.take(step.s, motion.phase, start_, d, step.to.x)) return step.fault();
  if (Refusal r = step.evaluate(step.to, true)) return r;
  step.record.impulse += motion.shortStep.last().impulse();
  step.record.addWorks(motion.shortStep.last().works());
  return {};
}

Refusal StepToRoot::settle(LocatedStep& step) {
  if (Refusal r = step.evaluate(step.to, true)) return r;
  const double half = 0.5 * (step.to.x.t - known_.x.t);
  step.record.impulse += half * (known_.lambda + step.to.lambda);
  for (std::size_t k = 0; k < step.record.works.size(); ++k)
    step.record.works[k] += half * (known_.power[k] + step.to.power[k]);
  return {};
}

}  // namespace dynamy
