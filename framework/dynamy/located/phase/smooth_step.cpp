#include <algorithm>
#include <cmath>
#include <dynamy/located/phase/smooth_step.hpp>

namespace dynamy {
namespace {

// A motion is stiff if h |λ| is above the bound of stability for kManySteps steps, without kOthers
// steps below it in a row [hairer_wanner1996, IV.2].
constexpr int kManySteps = 15, kOthers = 6;
/// A step with a damped fast part counts as a part of a step at the bound, so that a trial in vain
/// costs no more than a tenth.
constexpr double kStiffPart = 0.1;
/// An implicit step with h |λ| below this could be taken explicitly, too.
constexpr double kSmallStep = 2.0;
constexpr int kSomeSteps = 10;  ///< such implicit steps before explicit ones take over
/// Implicit steps after which their work is compared with that of explicit steps: they may have
/// grown 1296 times by then. The explicit steps before must have cost at least as much as such a
/// trial, and four times as much after each trial that failed.
constexpr int kTrial = 4;
constexpr double kCostlierThanExplicit = 4.0;

}  // namespace

void SmoothStep::prepare(const MechanicalSystem& s, const ButcherTableau& table,
                         const ButcherTableau* light) {
  const Topology& topology = *s.parts().topology;
  plain_ = ratesArePlain(topology);
  explicit_.prepare(topology, table, light, plain_);
  half_.prepare(plain_);
}

void SmoothStep::implicit(bool wanted, const MechanicalSystem& s, const ErrorNorm& norm) {
  implicit_ = wanted, stiff_.steps = stiff_.others = stiff_.tried = 0.0;
  implicitStep_.forget();
  if (wanted) implicitStep_.prepare(*s.parts().topology, norm);
}

const SmoothMethod& SmoothStep::last() const {
  if (took_ == Took::implicitly) return implicitStep_;
  if (took_ == Took::halfExplicitly) return half_;
  return explicit_;
}

bool SmoothStep::take(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from, double h,
                      State& to) {
  denseReady_ = false;
  took_ = implicit_ ? Took::implicitly : halfExplicit() ? Took::halfExplicitly : Took::explicitly;
  if (!last().take(s, phase, from, h, to)) return false;
  const Topology& topology = *s.parts().topology;
  if (!plain_)
    for (std::size_t i = 0; i < topology.systems().size(); ++i)
      if (const SystemHandle& handle = topology.system(static_cast<int>(i)); handle.nq > 0)
        topology.systems()[i]->normalise(slice(to.q, handle.q0, handle.nq));
  return to.q.allFinite() && to.u.allFinite();
}

void SmoothStep::rates(const MechanicalSystem& s, PhasePoint& p) const {
  if (plain_) {
    p.qdot = p.x.u, p.qddot = p.a;
    return;
  }
  const Topology& topology = *s.parts().topology;
  configurationRate(topology, p.x, p.qdot);
  // q̈ by the central difference of q̇ along the motion; only the search of switches uses it.
  constexpr double kDifference = 1e-5;
  const double speed = p.x.u.lpNorm<Eigen::Infinity>(), a = p.a.lpNorm<Eigen::Infinity>();
  const double d = kDifference / (1.0 + speed + std::sqrt(a));
  State y;
  Eigen::VectorXd forward;
  y.t = p.x.t + d, y.q = p.x.q + d * p.qdot, y.u = p.x.u + d * p.a;
  configurationRate(topology, y, forward);
  y.t = p.x.t - d, y.q = p.x.q - d * p.qdot, y.u = p.x.u - d * p.a;
  configurationRate(topology, y, p.qddot);
  p.qddot = (forward - p.qddot) / (2.0 * d);
}

void SmoothStep::lighten() {
  if (!implicit_ && took_ != Took::halfExplicitly) explicit_.lighten();
}

SmoothStep::Counted SmoothStep::counted() const {
  return {stiff_.steps,      stiff_.others,   stiff_.tried,
          stiff_.rate,       stiff_.patience, explicit_.light() ? 1.0 : 0.0,
          explicit_.enough()};
}

void SmoothStep::counted(const Counted& n) {
  stiff_ = {n[0], n[1], n[2], n[3], std::max(1.0, n[4])};
  explicit_.light(n[5] != 0.0), explicit_.enough(n[6]);
}

bool SmoothStep::outgrown(const ErrorNorm& norm, const PhasePoint& to) {
  if (took_ == Took::halfExplicitly) return false;
  const bool tookImplicit = took_ == Took::implicitly;
  ExplicitStep::Stiffness now;
  double steps = kSomeSteps;
  if (tookImplicit) {
    if (++stiff_.tried >= kTrial && implicitStep_.work() > stiff_.rate * last().length()) {
      stiff_.patience *= kCostlierThanExplicit;
      return true;
    }
    now.product = implicitStep_.product(), now.bound = kSmallStep;
  } else {
    if (!explicit_.stiffness(norm, to, now)) return false;
    stiff_.rate = explicit_.evaluations() / explicit_.length();
    const double trial = kTrial * ImplicitStep::usualWork(to.x.q.size() + to.x.u.size());
    steps = stiff_.patience * std::max<double>(kManySteps, trial / explicit_.evaluations());
  }
  if (tookImplicit != (now.product > now.bound)) {
    stiff_.others = 0.0;
    return ++stiff_.steps >= steps;
  }
  if (now.damped) {
    stiff_.others = 0.0;
    return (stiff_.steps += kStiffPart) >= steps;
  }
  if (++stiff_.others >= kOthers || tookImplicit) stiff_.steps = 0.0;
  return false;
}

}  // namespace dynamy
