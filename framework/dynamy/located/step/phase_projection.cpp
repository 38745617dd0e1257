#include <algorithm>
#include <dynamy/located/step/located_constants.hpp>
#include <dynamy/located/step/phase_projection.hpp>
#include <dynamy/stages/projection.hpp>

namespace dynamy {

Refusal PhaseProjection::take(LocatedStep& step, PhasePoint& p, bool& missing) {
  PhaseMotion& motion = parts_.motion;
  const ErrorNorm& norm = parts_.norm;
  missing = false;
  if (motion.phase.held.empty()) return {};
  double off = 0.0;
  const auto measure = [&](const Eigen::VectorXd& velocity) {
    for (Eigen::Index i = 0; i < velocity.size(); ++i)
      off = std::max(off, norm.velocity(i, velocity[i], 0.0));
  };
  const Evaluation& e = step.s.slot(0);
  FrozenPhase& phase = motion.phase;
  if (!phase.read(e, p.x.u)) return {};
  if (projection_.positions(phase.held, phase.rows(), e, position_))
    measure(velocity_ = position_ / norm.time());
  const bool moves = off > 0.0;
  const bool turns = projection_.velocities(phase.held, phase.rows(), e, velocity_);
  if (turns) measure(velocity_);
  if (off <= TrialConstants::project) return {};
  if (off > TrialConstants::suspicious) {
    const MissingBias::Verdict verdict = parts_.bias.check(step.s, p, norm, phase.request);
    missing = verdict == MissingBias::Verdict::missing;
    if (missing) return {};
    if (verdict == MissingBias::Verdict::wrong) return {Refusal::Kind::fault, parts_.bias.why()};
    if (verdict == MissingBias::Verdict::kinked) {
      step.lastSwitched = parts_.bias.lost();
      return {Refusal::Kind::stalled, parts_.bias.why(), true};
    }
  }
  if (turns) p.x.u += velocity_;
  if (moves) {
    const double t = p.x.t;
    position_ /= kDisplacementTime;
    step.s.move(p.x, position_, kDisplacementTime);
    p.x.t = t;
  }
  return step.evaluate(p);
}

}  // namespace dynamy
