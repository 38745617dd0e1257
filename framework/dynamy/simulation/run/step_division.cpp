#include <algorithm>
#include <cmath>
#include <dynamy/core/error.hpp>
#include <dynamy/simulation/run/step_division.hpp>

namespace dynamy {
namespace {

constexpr double kMostEqual = 4096.0;  ///< parts of a full step
/// Parts are divided again if they are kTolerated times too long, and doubled in length if kSlack times fewer
/// were enough.
constexpr double kTolerated = 1.5, kSlack = 4.0;

/// Least power of two that is at least x.
double powerOfTwo(double x) { return std::exp2(std::ceil(std::log2(std::max(x, 1.0)))); }

}  // namespace

Coarseness Coarseness::of(double turn, const ForceResolution& forces, double overlap,
                          double foreseen, double gain, double curve) {
  // share ≥ (ωΔt)²/8 for two equal bodies, (ωΔt)²/4 for one to the ground: ωΔt ≤ 2 √(2 share).
  return {turn / kMostTurn,
          2.0 * std::sqrt(2.0 * forces.share) / kMostSwing,
          forces.coarse,
          overlap / kMostOverlap,
          foreseen / kMostForeseen,
          gain > kMostGain ? std::clamp(std::sqrt(gain / kMostGain), 2.0, kMostAtOnce) : 1.0,
          std::sqrt(curve / kMostCurve)};
}

int StepDivision::begin() {
  if (!divides_) return 1;
  if (need_ > parts_) parts_ = powerOfTwo(need_);
  if (kSlack * need_ <= parts_) parts_ = std::max(1.0, 0.5 * parts_);
  swings_ = swings_ && parts_ > 1.0;
  finest_ = std::max(parts_, ahead_);
  need_ = 1.0, ahead_ = 1.0;
  return static_cast<int>(finest_);
}

int StepDivision::parts(const Coarseness& c, double share, long most, long against) {
  if (!divides_ || !(share > 0.0)) return 1;
  const auto boundOf = [](long n) {
    return std::min(std::exp2(std::floor(std::log2(static_cast<double>(n)))), kMostEqual);
  };
  const double bound = boundOf(most);
  // What cannot be resolved is damped instead, and costs no parts.
  const bool resolvable = c.swing <= share * bound;
  if (!resolvable) swings_ = false;
  if (c.coarse && resolvable) swings_ = true;
  // Parts that were equal so far stay so until they are kTolerated times too long.
  const bool rough = swings_ && (c.coarse || c.swing > kTolerated);
  // So many parts would not resolve a turn of millions of radians: its unit is wrong, and the run
  // warns of it at once instead of computing parts that are no better.
  const double turn = c.turn <= kMostEqual * share ? c.turn : 0.0;
  const double motion = std::max(turn, rough ? c.swing : 0.0);
  const double ahead = std::min(c.ahead, Coarseness::kMostAhead * share);
  // Errors of n equal parts, e/n³ each, may add to kMostCurve in a full step.
  const double bend = std::min(c.curve / std::sqrt(share), Coarseness::kMostCurveParts * share);
  const double curve = bend > 1.0 ? std::clamp(bend, 2.0, Coarseness::kMostAtOnce) : 0.0;
  const double wanted =
      std::max(std::min(std::max({motion, c.overlap, ahead, curve}), bound * share),
               std::min(c.gain, boundOf(against) * share));
  const double needed = std::max({turn, swings_ ? c.swing : 0.0, std::min(bend, curve)});
  // What is ahead is in the next step, too: the last part looks no further than the next part.
  ahead_ = std::max(ahead_, powerOfTwo(std::min(ahead / share, bound)));
  // The next step moves alike; its bodies need not meet.
  need_ = std::max(need_, std::min(needed / share, bound));
  const double n = powerOfTwo(wanted);
  if (n > 1.0) finest_ = std::max(finest_, std::ceil(n / share));
  return static_cast<int>(n);
}

void StepDivision::archive(Archive& a) {
  a(swings_), a(parts_), a(need_), a(ahead_);
  if (!(need_ >= 1.0) || !(ahead_ >= 1.0) || !(ahead_ <= 2.0 * kMostEqual) || !(parts_ >= 1.0) ||
      !(parts_ <= 2.0 * kMostEqual))
    throw ModelError("the checkpoint divides steps into parts that no run has");
}

}  // namespace dynamy
