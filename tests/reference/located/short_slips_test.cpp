// Slip in space that begins and ends within what would be one step.
#include <gtest/gtest.h>
#include <cmath>
#include <numbers>
#include <support/bounded_run.hpp>

namespace dynamy {
namespace {

/// A block on a table that moves with A (1 − cos ωt), where A ω² is `share` times μ g: it slips a
/// little twice a period. Its slip in closed form, phase by phase.
class ShakenBlock {
 public:
  explicit ShakenBlock(double share) : limit_(kA * kOmega * kOmega / share) {}
  double slipAt(double end) const {
    double slip = 0.0, t = 0.0;
    while (t < end) {
      // At rest until the table is too fast: |A ω² cos ωt| = μ g, in search of which 1e-6 s are enough
      // to find the interval.
      double begin = t;
      while (begin < end && std::abs(acceleration(begin)) <= limit_) begin += 1e-6;
      if (begin >= end) break;
      if (begin > t)
        begin =
            root(begin - 1e-6, begin, [&](double s) { return std::abs(acceleration(s)) - limit_; });
      const double sign = acceleration(begin) > 0.0 ? -1.0 : 1.0;  // of the slip
      double stop = begin + 1e-5;
      while (stop < end && sign * rate(begin, stop, sign) > 0.0) stop += 1e-6;
      if (stop < end)
        stop = root(stop - 1e-6, stop, [&](double s) { return -sign * rate(begin, s, sign); });
      stop = std::min(stop, end);
      slip += way(begin, stop, sign);
      t = stop;
    }
    return slip;
  }
  static constexpr double kA = 0.01, kOmega = 6.0 * std::numbers::pi;

 private:
  static double acceleration(double t) { return kA * kOmega * kOmega * std::cos(kOmega * t); }
  /// Slip velocity t after it began, against the table.
  double rate(double begin, double t, double sign) const {
    return -kA * kOmega * (std::sin(kOmega * t) - std::sin(kOmega * begin)) -
           sign * limit_ * (t - begin);
  }
  double way(double begin, double t, double sign) const {
    return kA * (std::cos(kOmega * t) - std::cos(kOmega * begin)) +
           kA * kOmega * std::sin(kOmega * begin) * (t - begin) -
           0.5 * sign * limit_ * (t - begin) * (t - begin);
  }
  template <class F>
  static double root(double l, double r, const F& f) {
    for (int k = 0; k < 60; ++k) (f(0.5 * (l + r)) < 0.0 ? l : r) = 0.5 * (l + r);
    return 0.5 * (l + r);
  }
  double limit_;  // μ g
};

TEST(ShortSlips, EndWhereTheClosedFormDoes) {
  for (const double share : {1.01, 1.1, 1.5}) {
    BoundedRun run(
        R"x(<dynamy version="1"><parameter name="mu" value="1"/><systems>
           <Ground name="table" motion="0.01*(1-cos(6*pi*t)); 0; 0"><HalfSpace material="table"/></Ground>
           <PointMass name="puck" mass="1"><Point material="puck"/></PointMass></systems>
           <forces><Gravity/><Formula name="slip" of="puck.x - 0.01*(1-cos(6*pi*t))"/></forces>
           <elements><Contact between="puck table"><UnilateralCoulomb mu="{mu}"/></Contact></elements>
           <simulation until="1" tolerance="1e-8"/><record signals="slip.out" every="0.1"/></dynamy>)x",
        {.set = {{"mu", std::to_string(ShakenBlock::kA * std::pow(ShakenBlock::kOmega, 2) / 9.81 /
                                       share)}}});
    // The coefficient has six decimals: the share is that of the run.
    const double mu = std::stod(
        std::to_string(ShakenBlock::kA * std::pow(ShakenBlock::kOmega, 2) / 9.81 / share));
    const ShakenBlock exact(ShakenBlock::kA * std::pow(ShakenBlock::kOmega, 2) / 9.81 / mu);
    run.run();
    ASSERT_TRUE(run.finished()) << run.report().reason;
    EXPECT_FALSE(run.report().qualified());
    // Six starts and ends, each within the tolerance of 1 m.
    EXPECT_NEAR(run.last(), exact.slipAt(1.0), 6e-8) << share;
  }
}

}  // namespace
}  // namespace dynamy
