/// One mass with dry friction: it comes to rest off-centre (N05c), and it sticks and slips on a
/// belt (N05), both in closed form.
#include <gtest/gtest.h>

#include <reference/order.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

class DryFriction : public testing::TestWithParam<Scheme> {};

TEST_P(DryFriction, StopsAnOscillatorAfterThirteenHalfCyclesForGood) {
  constexpr double dt = 1e-3;
  Scene scene("coulomb_oscillator", {.scheme = GetParam()});
  int turns = 0;
  double last = -1.0;
  scene.run(4.08407044966673 + 2.0 * dt, dt, [&] {
    const double v = scene.u("block")[0];
    if (v * last < 0.0) ++turns;
    if (v != 0.0) last = v;
  });
  EXPECT_EQ(turns, 12);  // twelve turns between thirteen half cycles
  // Really at rest: friction carries the spring from now on, and no number moves.
  const double x = scene.q("block")[0];
  double fastest = 0.0;
  scene.run(20.0, dt, [&] { fastest = std::max(fastest, std::abs(scene.u("block")[0])); });
  EXPECT_LT(fastest, 1e-14);
  EXPECT_NEAR(scene.q("block")[0], x, 1e-13);
  EXPECT_LT(std::abs(x), 0.01962);
  EXPECT_NEAR(scene.q("block")[1], 0.0, 1e-14);  // and the block does not float
}

TEST_P(DryFriction, RestsAtThePlaceOfTheClosedForm) {
  const std::vector<double> dt = halvings(2e-3, 5);
  std::vector<double> worst;
  for (const double h : dt)
    worst.push_back(envelope(h, 12, [&](double s) {
      Scene scene("coulomb_oscillator", {.scheme = GetParam()});
      scene.run(5.0, s);
      return scene.q("block")[0] - 0.01012;
    }));
  const Fit fit = fitOrder(dt, worst);
  // Started and ended at rest both schemes are the same leapfrog, and a turn costs Δt² of the
  // place. Measured 9 to 15 m/s² Δt²; 12 samples scatter by some 10 %.
  EXPECT_NEAR(fit.order, 2.0, 0.25) << fit;
  EXPECT_LT(worst.back(), 3.0 * 15.0 * dt.back() * dt.back());
}

struct Cycle {
  double period, highest, lowest;
};
/// Limit cycle on the belt: start of sticking to start of sticking, by interpolation.
Cycle cycle(Scheme scheme, double dt) {
  Scene scene("belt_oscillator", {.scheme = scheme});
  scene.run(15.0, dt);
  Cycle out{0.0, -1e9, 1e9};
  double before = scene.q("block")[0], first = 0.0, last = 0.0;
  int crossings = 0;
  scene.run(34.0, dt, [&] {
    const double x = scene.q("block")[0], t = scene.state().t;
    out.highest = std::max(out.highest, x), out.lowest = std::min(out.lowest, x);
    if (before < 0.5 && x >= 0.5) {
      last = t - dt * (x - 0.5) / (x - before);
      if (crossings++ == 0) first = last;
    }
    before = x;
  });
  out.period = (last - first) / (crossings - 1);
  return out;
}

TEST_P(DryFriction, SticksAndSlipsOnABeltWithOrderOne) {
  const std::vector<double> dt = halvings(1.6e-2, 5);
  std::vector<double> period, highest, lowest;
  for (const double h : dt) {
    period.push_back(
        envelope(h, 8, [&](double s) { return cycle(GetParam(), s).period - 8.90260540781452; }));
    highest.push_back(envelope(
        h, 8, [&](double s) { return cycle(GetParam(), s).highest - 1.0385164807134504; }));
    lowest.push_back(envelope(
        h, 8, [&](double s) { return cycle(GetParam(), s).lowest - -0.0385164807134504; }));
  }
  EXPECT_NEAR(fitOrder(dt, period).order, 1.0, 0.2) << fitOrder(dt, period);
  EXPECT_GT(fitOrder(dt, highest).order, 0.8) << fitOrder(dt, highest);
  EXPECT_GT(fitOrder(dt, lowest).order, 0.8) << fitOrder(dt, lowest);
  EXPECT_LT(period.back(), 1e-2);
  EXPECT_LT(highest.back(), 2e-3);
  EXPECT_LT(lowest.back(), 2e-3);
}

TEST_P(DryFriction, WithOneCoefficientTheBeltLeavesTheAmplitudeAtBeltSpeedOverOmega) {
  // Pure Coulomb: after the first stick x = F/k + (v/ω) sin, neither growing nor decaying.
  Scene scene("belt_oscillator", {.set = {{"Fk", "1"}}, .scheme = GetParam()});
  scene.run(15.0, 1e-3);
  double highest = -1e9, lowest = 1e9;
  scene.run(60.0, 1e-3, [&] {
    highest = std::max(highest, scene.q("block")[0]);
    lowest = std::min(lowest, scene.q("block")[0]);
  });
  // Order one at the grazing return, once a cycle: a few v Δt.
  EXPECT_NEAR(0.5 * (highest - lowest), 0.2, 5.0 * 0.2 * 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Schemes, DryFriction, testing::ValuesIn(kBothSchemes));

}  // namespace
}  // namespace dynamy::reference
