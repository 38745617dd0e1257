#include <algorithm>
#include <cmath>
#include <dynamy/schemes/augmented/block_lengths.hpp>
#include <limits>

namespace dynamy {
namespace {

/// More switches than this within Δt_max are not located: plain steps of Δt_max/kPlain follow.
constexpr int kMostSwitches = 32;
constexpr double kPlain = 32.0;
/// Shortest Δt_min, as a multiple of the time.
constexpr double kPostImpactNoise = 64.0 * std::numeric_limits<double>::epsilon();

}  // namespace

bool BlockLengths::restore(const Eigen::VectorXd& data) {
  if (data.size() <= kSize || !data.head(kSize).allFinite() || !(std::abs(data[5]) < kMostSwitches))
    return false;
  plan_ = {data[0], data[1], data[2], data[3] > 0.0, data[4], static_cast<int>(data[5]), data[6]};
  return true;
}

void BlockLengths::store(Eigen::VectorXd& data) const {
  data.head(kSize) << plan_.dtMax, plan_.next, plan_.failedEnd, plan_.bisecting, plan_.windowStart,
      plan_.switches, plan_.plainUntil;
}

void BlockLengths::begin(double t, double dt) {
  t_ = t;
  plan_.dtMax = std::max(plan_.dtMax, dt);
  if (!(plan_.next > 0.0)) plan_.next = plan_.dtMax;
}

std::optional<double> BlockLengths::plain() const {
  if (t_ < plan_.plainUntil) return plan_.dtMax / kPlain;
  return std::nullopt;
}

double BlockLengths::shortest() const {
  const double given = dtMin_ > 0.0 ? dtMin_ : std::pow(plan_.dtMax, order_) / 4;
  return std::clamp(given, kPostImpactNoise * std::max(plan_.dtMax, std::abs(t_)), plan_.dtMax);
}

void BlockLengths::accepted(double t, double H) {
  // After the end of the block that failed no switch is left to be found: there was none.
  if (plan_.bisecting && t > plan_.failedEnd - 0.5 * shortest()) plan_.bisecting = false;
  if (plan_.bisecting)
    plan_.next = std::max(H / 2, shortest());
  else if (H >= plan_.next)
    plan_.next = std::min(2 * H, plan_.dtMax);
}

void BlockLengths::failed(double H) {
  const double end = t_ + H;
  plan_.failedEnd = plan_.bisecting ? std::min(plan_.failedEnd, end) : end;
  plan_.bisecting = true;
  if (H > shortest()) plan_.next = std::max(H / 2, shortest());
}

std::optional<double> BlockLengths::countSwitch() {
  if (t_ - plan_.windowStart > plan_.dtMax) plan_.windowStart = t_, plan_.switches = 0;
  if (++plan_.switches <= kMostSwitches) return std::nullopt;
  plan_.plainUntil = t_ + plan_.dtMax, plan_.switches = 0;
  return plan_.plainUntil;
}

}  // namespace dynamy
