#include <algorithm>
#include <cmath>
#include <dynamy/located/step/energy_bound.hpp>
#include <dynamy/located/step/located_constants.hpp>
#include <dynamy/located/step/slip_ends.hpp>

namespace dynamy {

SlipEnds::Slip SlipEnds::slipOf(std::size_t i) const {
  const FrozenPhase& phase = parts_.motion.phase;
  const HeldRows& rows = phase.rows();
  Slip out;
  double v = 0.0;
  for (int r = 0; r < rows.slipRows(i); ++r) {
    const double w = rows.set(i).weight[static_cast<std::size_t>(r)];
    const int row = rows.slip0(i) + r;
    const double g = w * rows.gamma()[row], d = w * phase.gammaDot(row);
    v += g * g, out.along += g * d, out.rate += d * d;
  }
  out.v = std::sqrt(v);
  return out;
}

Refusal SlipEnds::find(LocatedStep& step, double most, double& bound) {
  const FrozenPhase& phase = parts_.motion.phase;
  const ErrorNorm& norm = parts_.norm;
  stopping_.clear();
  last_ = 0.0, bound = most;
  for (std::size_t i = 0; i < phase.held.size(); ++i) {
    const Held& h = phase.held[i];
    if (!h.slips || phase.rows().slipRows(i) < 2 || h.starts || h.mutedUntil > step.from.x.t)
      continue;
    const Slip slip = slipOf(i);
    const double v = slip.v, along = slip.along;
    if (!(along < 0.0)) continue;
    const double T = -v * v / along, path = 0.5 * v * T;
    const double tol = SlipConstants::stop * norm.tolerance();
    const double sine = std::max(0.0, 1.0 - along * along / (v * v * slip.rate));
    // The moment of a disc may turn bodies: the way of its slip may be an angle.
    const bool disc = phase.rows().set(i).form == ForceSet::Form::disc;
    const double most1 = disc ? std::min(1.0, norm.length()) : norm.length();
    if (path > tol * most1 || T * sine > 10.0 * tol * norm.time() || T > most) {
      bound = std::min(bound, SlipConstants::shareOfStop * T);
      continue;
    }
    if (!parts_.settings.events.endsSlipInSpace)
      return {Refusal::Kind::fault,
              "slip in space ends, and its speed has no sign whose change could be found"};
    stopping_.push_back({h.key, h.first});
    step.lastSwitched = h.key;
    last_ = std::max(last_, T);
  }
  return {};
}

SlipEnds::Result SlipEnds::take(LocatedStep& step, double most) {
  Result out;
  out.refusal = find(step, most, out.most);
  if (out.refusal || stopping_.empty()) return out;
  // The slip may last longer than the trial whose contacts are followed.
  if (last_ > parts_.pace.next && !coming_.begin(step, last_)) {
    out.refusal = step.unfollowed();
    return out;
  }
  FrozenPhase& phase = parts_.motion.phase;
  PhasePoint& p = step.from;
  start_ = p, slipping_ = phase;
  const Eigen::VectorXd mean = p.x.u + 0.5 * last_ * p.a;
  step.s.move(p.x, mean, last_);
  p.x.u += last_ * p.a;
  // Where an impact comes first shorter steps locate it; they follow fast forces, too.
  if (coming_.closesOpen(p.x) || !keepsEnergy(step)) {
    p = start_;
    out.most = std::min(out.most, SlipConstants::shareOfStop * last_);
    return out;
  }
  const StepRecord::Mark before = step.record.mark();
  out.refusal = events_.event(step, p, stopping_);
  if (out.refusal) return out;
  out.stopped = std::all_of(stopping_.begin(), stopping_.end(), [&](HeldKey part) {
    const Held* after = findHeld(phase.held, part);
    return after == nullptr || !after->slips;
  });
  if (out.stopped) {
    keepImpulses(step);
    return out;
  }
  p = start_, phase = slipping_;  // contacts continue to slip: this is no stop
  step.record.back(before);
  for (Held& h : phase.held)
    if (std::find(stopping_.begin(), stopping_.end(), HeldKey{h.key, h.first}) != stopping_.end())
      h.mutedUntil = p.x.t + 2.0 * last_;
  parts_.motion.rekey();
  out.most = most, out.refusal = step.evaluate(p);
  return out;
}

/// False: forces change so much until the slip ends that the energy does not remain. Friction that
/// turns until then makes an error of less than its work.
bool SlipEnds::keepsEnergy(LocatedStep& step) {
  FrozenPhase& phase = parts_.motion.phase;
  const PhasePoint& a = start_;
  PhasePoint& b = step.from;
  step.s.evaluate(b.x, phase.request.ofStage());
  PhaseMotion::energies(step.s, 1, b);
  const bool known = phase.accelerate(step.s.slot(1), b.x.u, b.a);
  std::array<double, 5> work{};
  for (std::size_t k = 0; k < work.size(); ++k)
    work[k] = 0.5 * last_ * (a.power[k] + (known ? phase.power()[k] : 0.0));
  phase = slipping_, b.a = a.a;
  const EnergyBalance balance(a, b, work);
  return !(balance.error > SlipConstants::energy * balance.scale + balance.works);
}

/// Forces are constant until the slip ends, and powers of slips fall linearly to zero.
void SlipEnds::keepImpulses(LocatedStep& step) {
  step.record.impulse = last_ * start_.lambda;
  step.record.impulsesOf(slipping_);
  for (std::size_t k = 0; k < step.record.works.size(); ++k)
    step.record.works[k] += 0.5 * last_ * (start_.power[k] + step.from.power[k]);
}

}  // namespace dynamy
