/// Slender block rocking on its corners without slip (N08): Housner's impact, flights by
/// quadrature.
#include <gtest/gtest.h>

#include <reference/order.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

constexpr double kAlpha = 0.19739555984988075, kEta = 0.9423076923076923;
constexpr double kImpact[] = {0.4128261160473157, 1.10230523122, 1.702799677331815};
constexpr double kRate[] = {0.6463580940920205, 0.6090682040482501, 0.5739296538146972};
constexpr double kPeak[] = {0.49611579332844813, 0.4192034424847593, 0.3585644249893716};

struct Rocking {
  std::vector<double> time, rate, ratio, peak;
};

/// Times of impacts, rates behind them, their ratio, peaks [of alpha] up to 2.2 s.
Rocking rock(Scheme scheme, double dt) {
  Scene scene("rocking_block", {.scheme = scheme});
  Rocking out;
  double before = scene.q("block")[2], rateBefore = 0.0, peak = 0.0;
  scene.run(2.2, dt, [&] {
    const double phi = scene.q("block")[2], rate = scene.u("block")[2];
    if (phi * before < 0.0) {
      if (!out.time.empty()) out.peak.push_back(peak / kAlpha);
      peak = 0.0;
      out.time.push_back(scene.state().t);
    }
    peak = std::max(peak, std::abs(phi));
    // The largest fall of the rate in one step near the passage is the impact.
    if (std::abs(rate) < 0.97 * std::abs(rateBefore) && std::abs(phi) < 0.02 &&
        std::abs(rate) > 0.3 && out.ratio.size() < 3) {
      out.ratio.push_back(rate / rateBefore);
      out.rate.push_back(std::abs(rate));
    }
    before = phi, rateBefore = rate;
  });
  out.peak.push_back(peak / kAlpha);
  EXPECT_TRUE(scene.solved());
  return out;
}

class RockingBlock : public testing::TestWithParam<Scheme> {};

TEST_P(RockingBlock, KeepsHousnersShareOfItsRateAtEachImpact) {
  // One step of smooth motion, g Δt/h, lies beside the impact's in the step: 2e-3 at 1e-4 s; the
  // rate itself also has the error of the impact's time, of order 1.
  const Rocking r = rock(GetParam(), 1e-4);
  ASSERT_EQ(r.ratio.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(r.ratio[static_cast<std::size_t>(i)], kEta, 5e-3) << i;
    EXPECT_NEAR(r.rate[static_cast<std::size_t>(i)], kRate[i], 5e-3) << i;
  }
}

TEST_P(RockingBlock, TendsToHousnersMotionWithOrderOne) {
  const std::vector<double> dt = halvings(1e-3, 5);
  std::vector<double> time, peak;
  for (const double h : dt) {
    time.push_back(
        envelope(h, 8, [&](double s) { return rock(GetParam(), s).time.at(2) - kImpact[2]; }));
    peak.push_back(
        envelope(h, 8, [&](double s) { return rock(GetParam(), s).peak.at(1) - kPeak[1]; }));
  }
  EXPECT_NEAR(fitOrder(dt, time).order, 1.0, 0.2) << fitOrder(dt, time);
  EXPECT_NEAR(fitOrder(dt, peak).order, 1.0, 0.2) << fitOrder(dt, peak);
}

INSTANTIATE_TEST_SUITE_P(Schemes, RockingBlock, testing::ValuesIn(kBothSchemes));

}  // namespace
}  // namespace dynamy::reference
