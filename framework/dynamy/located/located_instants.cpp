// LocatedDormandPrince: instants that elements announce, and elements that switch (theory 50.3).
#include <algorithm>
#include <cmath>
#include <dynamy/located/located_dormand_prince.hpp>

namespace dynamy {
namespace {

/// Of the time: distance right before and after an instant, larger than the rounding of formulas.
constexpr double kBeside = 2e-14;
constexpr double kPassed = 4e-13;    ///< of the time: an instant this far back may still be due
constexpr double kNudge = 1e-6;      ///< of the step: greatest delay of a latch after its root
constexpr double kStill = 1e-3;      ///< of the tolerance: speeds of bodies at rest
constexpr double kShortRest = 0.02;  ///< of T: steps at rest are not shortened below this

}  // namespace

double LocatedDormandPrince::untilInstant() {
  const double t = from_.x.t, after = std::max(t - kPassed * std::abs(t), lastEvent_);
  if (after < instantAfter_ || after >= instant_)
    instantAfter_ = after, instant_ = probe_.announcements().nextInstant(after);
  return instant_ - kBeside * std::abs(instant_) - t;
}

bool LocatedDormandPrince::passInstant(MechanicalSystem& s, InclusionSolver& solver, PhasePoint& p,
                                       double end, StepReport& report) {
  const double behind = std::min(instant_ + kBeside * std::abs(instant_), end);
  delta_ = p.x.u;
  if (p.x.t < behind) s.move(p.x, delta_, behind - p.x.t);
  ++report.counts.switches;
  release({});
  relist(p.x);
  return event(s, solver, p, report, {});
}

bool LocatedDormandPrince::throwLatch(MechanicalSystem& s, PhasePoint& p) {
  const auto thrown = [&] {
    const std::vector<double>& x = probe_.switching();
    return std::any_of(x.begin(), x.end(), [](double v) { return v > 0.0; });
  };
  for (double d = kBeside * std::max(std::abs(p.x.t), span()); d < kNudge * span(); d *= 4.0) {
    if (!probe_.look(p.x)) return refuse(ContactProbe::kUnfollowed);
    if (thrown()) break;
    delta_ = p.x.u + 0.5 * d * p.a;
    s.move(p.x, delta_, d);
    p.x.u += d * p.a;
  }
  s.remember(p.x);
  relist(p.x);
  return true;
}

bool LocatedDormandPrince::relist(const State& x) {
  if (!probe_.gather(x, phaseKeys_)) {
    probe_.list(x);
    probe_.gather(x, {});
  }
  // A body may have been removed and added elsewhere under the same number.
  const double away = norm_.tolerance() * norm_.length();
  const std::size_t gone = std::erase_if(phase_.held, [&](const Held& h) {
    const int i = probe_.find(h.key);
    return i < 0 || (probe_.law(i).unilateral() && probe_.gap(i) > away);
  });
  phaseKeys_.clear();
  phase_.keys(phaseKeys_);
  bool comes = false;
  for (int i = 0; i < probe_.size(); ++i)
    comes = comes || (!probe_.law(i).unilateral() && phase_.find(probe_.key(i)) == nullptr);
  return gone > 0 || comes;
}

bool LocatedDormandPrince::tooLongAtRest(MechanicalSystem& s, double h, const Switch& found,
                                         StepReport& report) {
  // Where nothing moves, no error bounds the step, however fast forces change with time.
  const auto moves = [&](const Eigen::VectorXd& u) {
    for (Eigen::Index i = 0; i < u.size(); ++i)
      if (norm_.velocity(i, u[i], 0.0) > kStill) return true;
    return false;
  };
  if (!search_.any() || found.kind == Switch::Kind::atStart || moves(from_.x.u) || moves(to_.x.u) ||
      !search_.rough(s, probe_, phase_, path_))
    return false;
  if (h > kShortRest * norm_.time()) return true;
  if (!found) report.counts.unseen = std::max(report.counts.unseen, h);
  return false;
}

}  // namespace dynamy
