#include <algorithm>
#include <cmath>
#include <dynamy/located/governed/step_patience.hpp>

namespace dynamy {
namespace {

constexpr double kLeast = 1e-5;         ///< of T: shortest step in time
constexpr double kStepPatience = 1500;  ///< evaluations of steps in time between two checks
constexpr double kLeastCovered = 0.1;   ///< of T: the time that these steps have to cover
constexpr double kLonger = 4.0;         ///< factor on the least step where they do not,
constexpr double kLongestLeast = 1e-2;  ///< up to this part of T
/// Evaluations of steps in time after which the least step is this part of the run, or of the sum of
/// steps in time where its end is not known; it grows with the square of all, up to the last, and on
/// where kFar times as many have been spent.
constexpr double kAllPatience = 3e4, kOfAll = 5e-4, kMostOfAll = 2e-3, kFar = 5.0;

/// Times kAllPatience: work after which solvers hardly search.
constexpr double kHurried = 2.0;

}  // namespace

double StepPatience::least(double tolerance, double T) const {
  const double least = std::max(tolerance, kLeast);
  return std::max(std::max(least, std::min(longer_ * least, kLongestLeast)) * T, bounded_);
}

Effort StepPatience::effort(Effort usual) const {
  if (all_ > kHurried * kAllPatience) return Effort::little;
  return all_ > kAllPatience && usual == Effort::full ? Effort::retried : usual;
}

void StepPatience::spend(double h, double evaluations, double T, double end) {
  all_ += evaluations, time_ += h;
  if (const double over = all_ / kAllPatience; over > 1.0)
    bounded_ =
        std::min(kOfAll * over * over, kMostOfAll * std::max(1.0, over * over / (kFar * kFar))) *
        (std::isfinite(end) ? end : time_);
  spent_ += evaluations, covered_ += h;
  if (spent_ < kStepPatience) return;
  if (covered_ < kLeastCovered * T)
    longer_ = std::min(kLonger * longer_, kLongestLeast / kLeast);
  else if (covered_ > T)
    longer_ = std::max(longer_ / kLonger, 1.0);
  spent_ = covered_ = 0.0;
}

}  // namespace dynamy
