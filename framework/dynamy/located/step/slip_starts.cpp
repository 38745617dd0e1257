#include <algorithm>
#include <cmath>
#include <dynamy/located/step/located_constants.hpp>
#include <dynamy/located/step/slip_starts.hpp>

namespace dynamy {
namespace {

double mostTurned(const ErrorNorm& norm) {
  return SlipConstants::mostTurned * norm.tolerance() * norm.speed();
}

/// True: the slip of held[i] has a clear direction of its own, for steps of length h.
bool slipIsClear(const LocatedParts& parts, std::size_t i, double h) {
  // γ_T has a clear direction if it points along the slip's direction and forces change it by less
  // than itself within h. The direction of γ̇_T, which has none where it vanishes, is then not
  // needed.
  const FrozenPhase& phase = parts.motion.phase;
  const HeldRows& rows = phase.rows();
  const Held& held = phase.held[i];
  double speed = 0.0, rate = 0.0, along = 0.0;
  for (int r = 0; r < rows.slipRows(i); ++r) {
    const double w = rows.set(i).weight[static_cast<std::size_t>(r)];
    const int row = rows.slip0(i) + r;
    const double g = w * rows.gamma()[row], d = w * phase.gammaDot(row);
    speed += g * g, rate += d * d;
    along += g * w * held.direction[static_cast<std::size_t>(r)];
  }
  const double across = std::sqrt(std::max(0.0, speed - along * along));
  return speed > rate * h * h && along > 0.0 && across <= mostTurned(parts.norm);
}

/// ∫ |γ_T| dθ of held[i] over the turn from the direction `before` to the present one [m/s].
double turnOf(const FrozenPhase& phase, std::size_t i, const Held& before) {
  const Held& h = phase.held[i];
  const HeldRows& rows = phase.rows();
  double speed = 0.0, along = 0.0, across = 0.0;
  for (int turn = 0; turn < 2; ++turn)  // unit vectors: first the cosine, then the part across
    for (int r = 0; r < rows.slipRows(i); ++r) {
      const double w = rows.set(i).weight[static_cast<std::size_t>(r)],
                   g = w * rows.gamma()[rows.slip0(i) + r];
      const double a = w * before.direction[static_cast<std::size_t>(r)],
                   b = w * h.direction[static_cast<std::size_t>(r)];
      if (turn == 0)
        along += a * b, speed += g * g;
      else
        across += (b - along * a) * (b - along * a);
    }
  return std::sqrt(speed * across);
}

/// γ_T·t of a slip that starts [m/s].
double speedAlong(const FrozenPhase& phase, std::size_t i) {
  const HeldRows& rows = phase.rows();
  double out = 0.0;
  for (int r = 0; r < rows.slipRows(i); ++r) {
    const double w = rows.set(i).weight[static_cast<std::size_t>(r)];
    out += w * w * rows.gamma()[rows.slip0(i) + r] *
           phase.held[i].direction[static_cast<std::size_t>(r)];
  }
  return out;
}

}  // namespace

bool startsPassTheirEnd(const LocatedParts& parts) {
  const FrozenPhase& phase = parts.motion.phase;
  for (std::size_t i = 0; i < phase.held.size(); ++i)
    if (phase.held[i].starts && speedAlong(phase, i) < 0.0) return true;
  return false;
}

double turnOfStarts(LocatedParts& parts, const std::vector<Held>& before) {
  double past = 0.0;
  FrozenPhase& phase = parts.motion.phase;
  for (std::size_t i = 0; i < phase.held.size(); ++i) {
    Held& h = phase.held[i];
    if (!h.starts) continue;
    h.turned = before[i].turned + turnOf(phase, i, before[i]);
    past = std::max(past, h.turned / mostTurned(parts.norm));
  }
  return past;
}

Refusal endClearStarts(LocatedStep& step, double h) {
  if (Refusal r = step.evaluate(step.from)) return r;
  bool any = false;
  std::vector<Held>& held = step.parts.motion.phase.held;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i].starts && slipIsClear(step.parts, i, h)) held[i].starts = false, any = true;
  if (!any) return {};
  step.startHeld = held;
  return step.evaluate(step.from);
}

bool endStarts(LocatedParts& parts) {
  bool any = false;
  FrozenPhase& phase = parts.motion.phase;
  const HeldRows& rows = phase.rows();
  for (std::size_t i = 0; i < phase.held.size(); ++i) {
    Held& h = phase.held[i];
    if (!h.starts) continue;
    double along = 0.0;
    for (int r = 0; r < rows.slipRows(i); ++r) {
      const double w = rows.set(i).weight[static_cast<std::size_t>(r)];
      const int row = rows.slip0(i) + r;
      along += w * w * rows.gamma()[row] * phase.gammaDot(row);
    }
    if (h.turned > mostTurned(parts.norm) || !(along > 0.0) || !(speedAlong(phase, i) > 0.0) ||
        slipIsClear(parts, i, parts.pace.next))
      h.starts = false, any = true;
  }
  return any;
}

}  // namespace dynamy
