#include <algorithm>
#include <dynamy/located/step/located_constants.hpp>
#include <dynamy/located/step/phase_projection.hpp>
#include <dynamy/stages/projection.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Turns of one projection. Positions that were corrected change W, and with it the velocities that
/// contacts have: with one turn errors of steps in which bodies turn by a radian doubled from step to
/// step (theory 50.1).
constexpr int kMost = 6;

}  // namespace

Refusal PhaseProjection::take(LocatedStep& step, PhasePoint& p, bool& missing) {
  missing = false;
  if (parts_.motion.phase.held.empty()) return {};
  double before = std::numeric_limits<double>::infinity();
  for (int turn = 0; turn < kMost; ++turn) {
    const double off = measure(step, p);
    if (off <= TrialConstants::project || !(moved_ < before)) return {};
    if (turn == 0 && off > TrialConstants::suspicious)
      if (Refusal r = checkBias(step, p, missing); r || missing) return r;
    before = moved_ > 0.0 ? moved_ : before;
    correct(step, p);
    if (Refusal r = step.evaluate(p)) return r;
  }
  return {};
}

/// Finds the corrections of positions and velocities, and their size in units of the tolerance.
double PhaseProjection::measure(LocatedStep& step, const PhasePoint& p) {
  const ErrorNorm& norm = parts_.norm;
  FrozenPhase& phase = parts_.motion.phase;
  const Evaluation& e = step.s.slot(0);
  double off = 0.0;
  const auto add = [&](const Eigen::VectorXd& velocity) {
    for (Eigen::Index i = 0; i < velocity.size(); ++i)
      off = std::max(off, norm.velocity(i, velocity[i], 0.0));
  };
  moved_ = 0.0, turns_ = false;
  if (!phase.read(e, p.x.u)) return off;
  if (projection_.positions(phase.held, phase.rows(), e, position_))
    add(velocity_ = position_ / norm.time());
  moved_ = off;
  turns_ = projection_.velocities(phase.held, phase.rows(), e, velocity_);
  if (turns_) add(velocity_);
  return off;
}

Refusal PhaseProjection::checkBias(LocatedStep& step, const PhasePoint& p, bool& missing) {
  const MissingBias::Verdict verdict =
      parts_.bias.check(step.s, p, parts_.norm, parts_.motion.phase.request);
  missing = verdict == MissingBias::Verdict::missing;
  if (verdict == MissingBias::Verdict::wrong) return {Refusal::Kind::fault, parts_.bias.why()};
  if (verdict == MissingBias::Verdict::kinked) {
    step.lastSwitched = parts_.bias.lost();
    return {Refusal::Kind::stalled, parts_.bias.why(), true};
  }
  return {};
}

void PhaseProjection::correct(LocatedStep& step, PhasePoint& p) {
  if (turns_) p.x.u += velocity_;
  if (!(moved_ > 0.0)) return;
  const double t = p.x.t;
  position_ /= kDisplacementTime;
  step.s.move(p.x, position_, kDisplacementTime);
  p.x.t = t;
}

}  // namespace dynamy
