#include <algorithm>
#include <cmath>
#include <dynamy/located/governed/run_patience.hpp>

namespace dynamy {
namespace {

constexpr double kLeastBudget = 2.6e7;  ///< B₀, some seconds
constexpr double kOfEach = 1e5;         ///< b: evaluations of the whole model
constexpr double kAtOnce = 0.5;         ///< part of B that may be spent at any time
constexpr double kWhile = 6e4;          ///< work between two looks at the pace of an island
constexpr double kShare = 0.25;         ///< of the run's rate: what one island may spend

}  // namespace

WorkAllowance RunPatience::allowance(double patience, double velocities, double t,
                                     double end) const {
  if (!std::isfinite(patience) || !std::isfinite(end) || !(end > 0.0)) return {};
  const double all = patience * std::max(kLeastBudget, kOfEach * velocities);
  return {.over = spent_ > all * (kAtOnce + (1.0 - kAtOnce) * std::clamp(t / end, 0.0, 1.0)),
          .rate = all / end,
          .end = end};
}

bool WorkPace::tooDear(double h, double work, const WorkAllowance& allowed) {
  time_ += h, work_ += work;
  if (work_ < kWhile) return false;
  const bool dear = allowed.over && work_ > kShare * allowed.rate * time_;
  time_ = work_ = 0.0;
  return dear;
}

}  // namespace dynamy
