/// The woodpecker's limit cycle in every scheme that admits it: mean period and fall per cycle tend
/// to those of the event-driven solution (Taylor series of order 40) as Δt → 0.
#include <gtest/gtest.h>

#include <reference/schemes/scheme_table.hpp>
#include <reference/woodpecker_cycle.hpp>

namespace dynamy::reference {
namespace {

constexpr double kMeanFall = 0.019445379285;  // per cycle [m]

/// Means over 100 cycles between turning points of the bird while the sleeve sticks, after 40: the
/// multiplier −0.84 leaves 1e-3 of the start, and its sign alternates in the mean.
Cycle meanCycle(const std::string& scheme, double dt) {
  constexpr int kTransient = 40, kCycles = 100;
  Scene scene("woodpecker_expressions", {.text = modelFile("woodpecker_expressions", scheme)});
  double before = scene.state().u[2], t0 = 0.0, y0 = 0.0;
  int count = 0;
  while (scene.state().t < 0.2 * (kTransient + kCycles)) {
    const double tBefore = scene.state().t;
    if (!scene.step(dt).refused.empty()) return {};
    const State& x = scene.state();
    if (before < 0.0 && x.u[2] >= 0.0 && x.q[2] < -0.4) {
      const double t = tBefore + (x.t - tBefore) * before / (before - x.u[2]);
      if (count == kTransient) t0 = t, y0 = x.q[0];
      if (count == kTransient + kCycles) return {(t - t0) / kCycles, (y0 - x.q[0]) / kCycles};
      ++count;
    }
    before = x.u[2];
  }
  ADD_FAILURE() << "only " << count << " cycles";
  return {};
}

class LongLimitCycle : public testing::TestWithParam<SchemeOrders> {};

TEST_P(LongLimitCycle, OfTheWoodpeckerIsTheEventDrivenOne) {
  const Cycle coarse = meanCycle(GetParam().xml, 4e-5);
  if (coarse.period == 0.0) return;  // refused: SchemeRefusal
  const Cycle fine = meanCycle(GetParam().xml, 1e-5);
  EXPECT_TRUE(fine.period > 0.0);
  std::printf("%s: period %+.1e %+.1e s, fall %+.1e %+.1e m\n", GetParam().xml,
              coarse.period - kPeriod, fine.period - kPeriod, coarse.fall - kMeanFall,
              fine.fall - kMeanFall);
  // Order one: Richardson's value removes most of the error; what is left is the scatter of 1000
  // impacts, each a part of a step late, some dt/√100 of the period and 0.13 m/s of that of the
  // fall, from both runs.
  const auto limit = [](double c, double f) { return (4.0 * f - c) / 3.0; };
  EXPECT_NEAR(limit(coarse.period, fine.period), kPeriod,
              0.35 * std::abs(coarse.period - fine.period) + 4e-6);
  EXPECT_NEAR(limit(coarse.fall, fine.fall), kMeanFall,
              0.35 * std::abs(coarse.fall - fine.fall) + 2e-6);
}

INSTANTIATE_TEST_SUITE_P(LongAllSchemes, LongLimitCycle, testing::ValuesIn(kAllSchemes),
                         [](const auto& p) { return std::string(p.param.name); });

}  // namespace
}  // namespace dynamy::reference
