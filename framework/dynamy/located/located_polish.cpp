// LocatedDormandPrince: the step to a switch, and the distance left to its root     (theory 50.3).
//
//   d        from the end of that step to the root, by Newton's method on the true monitor
//   |d/h|³ ≤ 0.01 tol   u + d u̇ + ½ d² ü, with ü of the cubic through u and u̇ of both ends
//   |d/h|  ≤ 0.1        dense output of the step: its value and slope at the end are those of the
//                       motion, so that its error there is 16 (d/h)² of the largest
//   else                a step of its own, with all of its stages
#include <algorithm>
#include <cmath>
#include <dynamy/located/located_dormand_prince.hpp>

namespace dynamy {
namespace {

constexpr int kMostFirst = 8;        ///< contacts that close before the one that was found
constexpr int kMostMoves = 8;        ///< iterations of Newton's method
constexpr double kTaylor = 0.01;     ///< (d/h)³ over the tolerance
constexpr double kDenseShare = 0.1;  ///< largest d/h for the dense output
constexpr double kFarthest = 0.5;    ///< d/h above which the root is not of this step

/// True: Taylor's polynomial is accurate enough over this part of the step.
bool isSmall(double part, double tolerance) {
  return std::abs(part) * part * part <= kTaylor * tolerance;
}

}  // namespace

bool LocatedDormandPrince::repeat(MechanicalSystem& s, double h, const Switch& w) {
  s.hold(phaseKeys_);
  const double length = w.theta * h;
  smoothOwn_.light(smooth_.light()), denseReady_ = false;
  if (!smooth_.take(s, phase_, from_, length, to_.x)) return refuse(phase_);
  if (!evaluateEnd(s, to_)) return false;
  impulse_ = smooth_.impulse(), stepTo_ = to_;
  Switch first = w;
  for (int i = 0; i < kMostFirst; ++i) {
    if (!polish(s, length, first)) return false;
    if (!search_.closedBefore(probe_, to_.x, first)) return true;
  }
  return true;
}

bool LocatedDormandPrince::polish(MechanicalSystem& s, double h, const Switch& w) {
  double slope = w.slope, last = 0.0, moved = 0.0;
  // Another value of a gap costs next to nothing, one of a force costs an evaluation.
  const double near = w.force ? std::min(1e-8, 0.01 * norm_.tolerance()) : 1e-15;
  bool known = true;
  known_ = to_;
  for (int i = 0; i < kMostMoves; ++i) {
    double value = 0.0;
    if (!search_.value(probe_, phase_, to_.x, w, value)) return refuse(ContactProbe::kUnfollowed);
    if (i > 0 && moved != 0.0 && value != last) {
      const double secant = (value - last) / moved;
      if (secant * slope > 0.0) slope = secant;
    }
    if (!(slope < 0.0)) break;  // grazing: the switch is where the search found it
    const double d = -value / slope;
    if (std::abs(d) <= near * h || std::abs(d) > kFarthest * h) break;
    last = value, moved = d;
    if (!moveOn(s, h, d, known)) return false;
    if (w.force && !known && !settle(s)) return false;
    known = known || w.force;
    if (known) known_ = to_;
  }
  const double on = to_.x.t - known_.x.t;
  if (known || !isSmall(on / h, norm_.tolerance())) return known || settle(s);
  // At the root of a gap the event evaluates the forces anew: here the last known ones will do.
  impulse_ += on * known_.lambda;
  for (std::size_t k = 0; k < works_.size(); ++k) works_[k] += on * known_.power[k];
  return true;
}

bool LocatedDormandPrince::moveOn(MechanicalSystem& s, double h, double d, bool& known) {
  const double behind = to_.x.t + d - stepTo_.x.t;
  known = false;
  if (!denseReady_ && isSmall(d / h, norm_.tolerance())) {
    moveByTaylor(s, d);
    return true;
  }
  const bool dense = !smooth_.implicit() && !smooth_.halfExplicit();
  if (dense && std::abs(behind) <= kDenseShare * h) return moveByDense(s, to_.x.t + d);
  known = true;
  return moveByStep(s, d);
}

void LocatedDormandPrince::moveByTaylor(MechanicalSystem& s, double d) {
  // In a stiff motion ü would be that of the fast part, which has died away: it is left out.
  const double h = smooth_.length();
  rates_.setZero(to_.x.u.size());
  if (!smooth_.implicit())
    rates_ = (6.0 / h * (from_.x.u - stepTo_.x.u) + 2.0 * from_.a + 4.0 * stepTo_.a) / h;
  delta_ = to_.x.u + 0.5 * d * to_.a + d * d / 6.0 * rates_;
  s.move(to_.x, delta_, d);
  to_.x.u += d * to_.a + 0.5 * d * d * rates_;
}

bool LocatedDormandPrince::moveByDense(MechanicalSystem& s, double t) {
  if (!denseReady_ && !smooth_.prepareDense(s, phase_, from_, stepTo_)) return refuse(phase_);
  denseReady_ = true;
  smooth_.dense((t - from_.x.t) / smooth_.length(), to_.x);
  to_.x.t = t;
  const Topology& topology = *s.parts().topology;
  for (std::size_t i = 0; i < topology.systems().size(); ++i)
    if (const SystemHandle& handle = topology.system(static_cast<int>(i)); handle.nq > 0)
      topology.systems()[i]->normalise(slice(to_.x.q, handle.q0, handle.nq));
  return true;
}

bool LocatedDormandPrince::moveByStep(MechanicalSystem& s, double d) {
  trial_ = to_;
  if (!smoothOwn_.take(s, phase_, trial_, d, to_.x)) return refuse(phase_);
  if (!evaluateEnd(s, to_)) return false;
  impulse_ += smoothOwn_.impulse();
  for (std::size_t k = 0; k < works_.size(); ++k) works_[k] += smoothOwn_.works()[k];
  return true;
}

bool LocatedDormandPrince::settle(MechanicalSystem& s) {
  if (!evaluateEnd(s, to_)) return false;
  const double half = 0.5 * (to_.x.t - known_.x.t);
  impulse_ += half * (known_.lambda + to_.lambda);
  for (std::size_t k = 0; k < works_.size(); ++k)
    works_[k] += half * (known_.power[k] + to_.power[k]);
  return true;
}

}  // namespace dynamy
