#include <algorithm>
#include <cmath>
#include <dynamy/located/step/energy_bound.hpp>

namespace dynamy {
namespace {

constexpr double kShare = 5e-4;         ///< κ
constexpr double kSafety = 0.9;         ///< on the factor of the next step
constexpr double kLeastFactor = 0.2;    ///< least factor from trial to trial,
constexpr double kLargestFactor = 0.8;  ///< and largest
constexpr double kNoBound = 1e3;        ///< a factor that bounds nothing
constexpr double kPositions = 1e-11;    ///< of energies and works, by positions known to g_tol
/// Trials of one step that may exceed the bound. A spring that swings through zero length needs steps
/// of 1e-4 of those before. Then the bound pauses, in first trials: for kPause, and for ten times
/// longer, up to kLongest, each time that it is exceeded right after a pause.
constexpr int kMostTries = 6;
constexpr double kPause = 10.0, kLongest = 1e3;

}  // namespace

EnergyBalance::EnergyBalance(const PhasePoint& a, const PhasePoint& b,
                             const std::array<double, 5>& work)
    : error((b.T - a.T) + (b.V - a.V)), scale(a.T + b.T + std::abs(b.V - a.V)) {
  for (const double W : work) error -= W, works += std::abs(W);
  error = std::abs(error);
}

double EnergyBound::factor(const LocatedStep& step, const PhasePoint& a, const PhasePoint& b,
                           const std::array<double, 5>& works, int order) {
  const double h = b.x.t - a.x.t;
  double& pause = step.parts.pace.energyFrom;
  if (a.x.t < pause) return kNoBound;
  const EnergyBalance balance(a, b, works);
  const double error = balance.error;
  const double turned = a.T + b.T + std::abs(a.V) + std::abs(b.V) + balance.works;
  const double bound =
      kShare * balance.scale * h / (std::abs(a.x.t) + step.parts.norm.time()) + kPositions * turned;
  if (!std::isfinite(error) || !(bound > 0.0)) return kNoBound;
  const double factor = kSafety * std::pow(bound / std::max(error, 1e-10 * bound), 1.0 / order);
  double& longer = step.parts.pace.energyPause;
  if (error <= bound) {
    longer = kPause;
    return std::max(factor, kSafety);
  }
  if (from_ != a.x.t) from_ = a.x.t, first_ = h, tries_ = 0;
  if (++tries_ <= kMostTries) return std::clamp(factor, kLeastFactor, kLargestFactor);
  longer = std::clamp(longer, kPause, kLongest);
  pause = a.x.t + longer * first_;
  longer *= 10.0;
  return kNoBound;
}

}  // namespace dynamy
