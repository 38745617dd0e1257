// Periodic orbits of the impact oscillator x'' + d x' + x = cos(Ω t) before a wall, x ≤ a: one
// impact in n periods of the drive, speeds and phases to 14 digits; without damping in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <reference/located/located_run.hpp>

namespace dynamy::reference {
namespace {

/// Started right behind an impact at t = 0.
const std::string kOscillator = R"xml(<dynamy version="1">
  <parameter name="d" value="0"/><parameter name="omega" value="1"/><parameter name="phase" value="0"/>
  <parameter name="a" value="0"/><parameter name="e" value="1"/><parameter name="v" value="1"/>
  <systems><Coordinates name="mass" q="x" units="m" q0="{a}" u0="{-e*v}" M="1"
    h="-x - d*x_dot + cos(omega*t + phase)"/></systems>
  <elements><CoordinateContact name="wall" on="mass" gap="a - x">
    <Unilateral epsilonN="{e}"/></CoordinateContact></elements>
  <simulation until="1" step="1"/></dynamy>)xml";

struct Orbit {
  double d, omega;
  int n;  ///< periods of the drive between impacts
  double a, e;
  double speed, instant;  ///< before an impact [m/s]; within a period [s]
  /// Impacts to follow. Modulus of the multipliers: √(e² exp(−2 π n d/Ω)) where they are a pair,
  /// 2.9581 on the unstable orbit, which is followed for one period.
  int impacts;
};

const Orbit kOrbits[] = {
    {0.0, 2.2, 1, 0.0, 0.8, 1.8987487383113, 1.2744484431692, 10},
    {0.0, 2.6, 1, 0.0, 0.8, 0.50543997089396, 1.1651472829823, 10},
    {0.0, 4.2, 2, 0.0, 0.8, 0.8402129343498, 0.66719807368774, 10},
    {0.0, 2.8, 1, 0.0, 0.8, 0.33617726997566, 1.0926345564091, 1},
    {0.1, 2.5, 1, 0.0, 0.6, 0.68442079380126, 1.0950252426633, 10},
    {0.2, 2.4, 1, 0.1, 0.7, 0.45035138358123, 1.174423096611, 10},
};

TEST(LocatedOrbits, OfTheImpactOscillatorAreKeptTo1e10) {
  for (const Orbit& o : kOrbits) {
    const double period = 2.0 * std::numbers::pi * o.n / o.omega;
    LocatedRun run(kOscillator, 1e-12, (o.impacts + 0.5) * period,
                   {{"d", numberText(o.d)},
                    {"omega", numberText(o.omega)},
                    {"phase", numberText(o.omega * o.instant)},
                    {"a", numberText(o.a)},
                    {"e", numberText(o.e)},
                    {"v", numberText(o.speed)}});
    ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    int k = 0;
    for (const ContactEvent& e : run.events) {
      if (!e.impact) continue;
      ++k;
      EXPECT_NEAR(e.t, k * period, 1e-10) << "omega " << o.omega << ", impact " << k;
      EXPECT_NEAR(e.speed, o.speed, 1e-10) << "omega " << o.omega << ", impact " << k;
    }
    EXPECT_EQ(k, o.impacts) << "omega " << o.omega;
  }
}

TEST(LocatedOrbits, AnUnstableOrbitIsLeftAtItsMultiplier) {
  // What is added to the phase of the start grows by −2.9581 a period once the direction of the
  // other multiplier, −0.21636, has died out.
  const Orbit& o = kOrbits[3];
  constexpr double kBy = 1e-5;
  const double period = 2.0 * std::numbers::pi / o.omega;
  const auto instants = [&](double by) {
    LocatedRun run(kOscillator, 1e-12, 5.5 * period,
                   {{"omega", numberText(o.omega)},
                    {"phase", numberText(o.omega * (o.instant + by))},
                    {"e", numberText(o.e)},
                    {"v", numberText(o.speed)}});
    EXPECT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    return run.impacts("wall");
  };
  const std::vector<double> there = instants(kBy), back = instants(-kBy);
  ASSERT_GE(there.size(), 5u);
  ASSERT_GE(back.size(), 5u);
  const auto phase = [&](std::size_t k) { return 0.5 * (there[k] - back[k]) + kBy; };
  // Five periods leave (0.21636/2.9581)^4 = 3e-5 of the other direction; the difference of both
  // sides has errors of third order, (1e-5 · 2.9581^5)² = 5e-6; five digits of the multiplier.
  EXPECT_NEAR(phase(4) / phase(3), -2.9581, 1e-3);
}

}  // namespace
}  // namespace dynamy::reference
