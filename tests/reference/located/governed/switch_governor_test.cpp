// Where switches are too dense to be located, runs to a tolerance step in time, and back.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/located/governed/switch_governor.hpp>
#include <limits>
#include <reference/located/bounce.hpp>
#include <reference/located/located_run.hpp>
#include <string>
#include <support/gravity.hpp>

namespace dynamy::reference {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// Height at which ball i is let go [m].
double start(int i) { return 0.5 + 0.01 * i; }

/// Balls that do not see each other over a floor, with restitution e.
std::string balls(int n, double e) {
  std::string text = "<dynamy version=\"1\"><systems>";
  for (int i = 0; i < n; ++i)
    text += "<PointMass name=\"p" + std::to_string(i) + "\" mass=\"1\" position=\"0 0 " +
            std::to_string(start(i)) + "\"><Point material=\"ball\"/></PointMass>";
  return text +
         "<Ground name=\"world\"><HalfSpace material=\"floor\"/></Ground></systems>"
         "<forces><Gravity/></forces><elements><Contact between=\"ball floor\"><Unilateral "
         "epsilonN=\"" +
         std::to_string(e) +
         "\"/></Contact></elements><simulation until=\"1\" step=\"1\"/></dynamy>";
}

/// Six balls in a funnel of four walls, which lie against each other in the end. While one slides to
/// a stop, others that have just parted graze.
const std::string kFunnel = R"xml(<dynamy version="1"><systems>
  <RigidBody name="b0" position="0.061 0.121 0.150"><Sphere radius="0.1" mass="1" material="stone"/></RigidBody>
  <RigidBody name="b1" position="0.148 0.221 0.376"><Sphere radius="0.1" mass="1" material="stone"/></RigidBody>
  <RigidBody name="b2" position="0.120 0.211 0.602"><Sphere radius="0.1" mass="1" material="stone"/></RigidBody>
  <RigidBody name="b3" position="-0.235 -0.017 0.828"><Sphere radius="0.1" mass="1" material="stone"/></RigidBody>
  <RigidBody name="b4" position="0.222 0.074 1.054"><Sphere radius="0.1" mass="1" material="stone"/></RigidBody>
  <RigidBody name="b5" position="0.200 -0.193 1.280"><Sphere radius="0.1" mass="1" material="stone"/></RigidBody>
  <Ground name="world"><HalfSpace material="floor"/>
    <HalfSpace normal="1 0 0.5" position="-0.25 0 0" material="floor"/>
    <HalfSpace normal="-1 0 0.5" position="0.25 0 0" material="floor"/>
    <HalfSpace normal="0 1 0.5" position="0 -0.25 0" material="floor"/>
    <HalfSpace normal="0 -1 0.5" position="0 0.25 0" material="floor"/>
  </Ground></systems><forces><Gravity/></forces><elements>
  <Contact between="stone stone"><UnilateralCoulomb mu="0.3" epsilonN="0.3"/></Contact>
  <Contact between="stone floor"><UnilateralCoulomb mu="0.3" epsilonN="0.3"/></Contact></elements>
  <simulation until="1" step="1"/></dynamy>)xml";

TEST(SwitchGovernor, StepsManyBouncingBallsInTimeWithinTheTolerance) {
  constexpr int kBalls = 80;
  constexpr double kTolerance = 5e-3, kUntil = 2.5;
  LocatedRun run(balls(kBalls, 0.9), kTolerance, kUntil);
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_GE(r.stepping.periods, 1);
  EXPECT_EQ(r.stepping.stalls, 0);
  // Each of four or five impacts may be off by the tolerance, and its time by that over the
  // speed, which the next flight passes on: ten tolerances, as for located switches.
  for (int i = 0; i < kBalls; ++i)
    EXPECT_NEAR(run.state().q[3 * i + 2], bounceHeight(start(i), 0.9, kUntil),
                10.0 * kTolerance * run.model().length())
        << i;
  // Parabolas are exact for the trapezoidal rule: nothing but rounding of 260 J is left over.
  EXPECT_NEAR(r.energy.discretisation, 0.0, 1e-9);
  EXPECT_NEAR(r.energy.imbalance, 0.0, 1e-9);
}

TEST(SwitchGovernor, AFunnelNeedsNoStepsInTime) {
  LocatedRun run(kFunnel, 1e-4, 2.0), again(kFunnel, 1e-4, 2.0);
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_EQ(r.stepping.periods, 0);
  // With steps towards impacts of grazing contacts, which do not come, 165 000 were not enough for
  // the first 1.0085 s. Twice what it takes now.
  EXPECT_LT(r.cost.evaluations, 20000);
  EXPECT_LE(r.gaps.penetration.value, 1e-4 * run.model().length());
  EXPECT_NEAR(r.energy.imbalance, 0.0, 1e-9 * r.energy.start());
  again.run();
  EXPECT_EQ(run.state().q, again.state().q);
  EXPECT_EQ(run.state().u, again.state().u);
  EXPECT_EQ(r.cost.evaluations, again.report().cost.evaluations);
}

TEST(SwitchGovernor, FindsBackWhenAllIsAtRest) {
  constexpr double kUntil = 4.0;
  // With clocks of their own no ball has dense impacts.
  LocatedRun run(balls(40, 0.5), 5e-3, kUntil, {}, {}, LocatedRun::withClocks("one"));
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_GE(r.stepping.periods, 1);
  // The highest ball rests at (1 + e)/(1 − e) √(2 z/g) = 1.28 s; periods double, so that no more
  // than as much again goes by until switches are located for good. Steps are 1e-3 T and longer.
  EXPECT_LT(r.stepping.time, 2.0 * 3.0 * std::sqrt(2.0 * start(39) / kG));
  EXPECT_LT(r.stepping.steps, 1000);
  EXPECT_EQ(run.state().u.lpNorm<Eigen::Infinity>(), 0.0);
}

TEST(SwitchGovernor, GoesOnFromACheckpointBitForBit) {
  expectToGoOnBitForBit(balls(80, 0.9), 5e-3);
}

TEST(SwitchGovernor, AFunnelStaysInTheToleranceOfAFinerRun) {
  LocatedRun run(kFunnel, 1e-5, 1.1);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  // x of the first ball: -0.074579, -0.074577 at 1e-8 and 1e-9. Some hundred impacts by then
  // amplify errors (36 tol): three times that.
  EXPECT_NEAR(run.state().q[0], -0.074577, 100.0 * 1e-5);
}

TEST(SwitchGovernor, ScenesWithRareSwitchesNeverStepInTime) {
  for (const char* model : {"woodpecker", "belt_oscillator", "falling_box", "impact_oscillator"})
    for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
      LocatedRun run(model, tolerance, 1.0);
      EXPECT_EQ(run.run().ended, RunReport::Ended::finished) << model << run.report().reason;
      EXPECT_EQ(run.report().stepping.periods, 0) << model << ", tolerance " << tolerance;
    }
}

TEST(SwitchGovernor, StepsInTimeEndHoweverFastAPartOfTheMotionIs) {
  // A run of 1 s whose T is 1e-7 s, and whose steps miss the tolerance by far at any length. After
  // 3e4 evaluations, here k₀ = 10 000 steps of 1e-10 s or so (500 of them cover T), step k is
  // 5e-4 (k/k₀)² of the time covered, up to 2e-3, whose logarithm grows by 5e-4 k₀ 7/3 = 11.7 until
  // that, and by 14 from 1 µs to 1 s: k = 21 200. At 1e-9 s they would be 10⁹.
  constexpr double kT = 1e-7, kMissed = 1e6;
  SwitchGovernor governor;
  governor.scales(1e-6, kT);
  governor.turn(0.0, TurnedBy::stall, SwitchGovernor::kNowhere);
  double t = 0.0;
  int steps = 0;
  for (; t < 1.0 && steps < 100000; ++steps) {
    const double h = governor.h();
    t += h;
    governor.stepped(t, h, kMissed, 1.0, false, 3, kEndless);
    EXPECT_LE(h, t < 100.0 * kT ? 0.1 * kT : 2e-3 * t);
  }
  EXPECT_GE(t, 1.0);
  EXPECT_LT(steps, 21500);
}

TEST(SwitchGovernor, StepsInTimeAreFewWhereTheEndIsKnown) {
  // The same motion in a run of 1 s: beyond 3e4 evaluations a step is 5e-4 (k/k₀)² s or more, up to
  // 2e-3 s: Σ = 1 s needs fewer than 2000 of them.
  SwitchGovernor governor;
  governor.scales(1e-6, 1e-7);
  governor.turn(0.0, TurnedBy::stall, SwitchGovernor::kNowhere);
  double t = 0.0;
  int steps = 0;
  for (; t < 1.0 && steps < 100000; ++steps) {
    const double h = governor.h();
    t += h;
    governor.stepped(t, h, 1e6, 1.0, false, 3, 1.0);
  }
  EXPECT_LT(steps, 12000);
}

TEST(RunPatience, GrantsWorkAlongTheTimeOfARun) {
  // Of 2.6e7 half at any time, the rest in proportion to time; 1e5 of each velocity in large models.
  RunPatience patience;
  patience.spend(2e7);
  EXPECT_TRUE(patience.allowance(1.0, 10.0, 0.4, 1.0).over);
  EXPECT_FALSE(patience.allowance(1.0, 10.0, 0.6, 1.0).over);
  EXPECT_FALSE(patience.allowance(2.0, 10.0, 0.0, 1.0).over);
  EXPECT_FALSE(patience.allowance(1.0, 600.0, 0.0, 1.0).over);
  // A run whose end nobody knows has no bound, and patience may be endless.
  EXPECT_FALSE(patience.allowance(1.0, 10.0, 0.4, kEndless).over);
  EXPECT_FALSE(patience.allowance(kEndless, 10.0, 0.4, 1.0).over);
}

TEST(RunPatience, TurnsIslandsThatSpendMoreThanTheirShare) {
  // Over an allowance of 2e7 in 1 s, an island that would spend 4e6 in 1 s goes on, one of 6e6 turns:
  // a quarter is its share.
  for (const double rate : {4e6, 6e6}) {
    WorkPace pace;
    bool dear = false;
    for (int i = 0; i < 100; ++i)
      dear = dear || pace.tooDear(1e-3, 1e-3 * rate, {.over = true, .rate = 2e7, .end = 1.0});
    EXPECT_EQ(dear, rate > 5e6) << rate;
  }
  SwitchGovernor governor;
  governor.scales(1e-6, 0.1);
  governor.giveUp(0.5, 1.0, SwitchGovernor::kNowhere);
  EXPECT_EQ(governor.mode(), SwitchGovernor::Mode::step);
  EXPECT_EQ(governor.turnedBy(), TurnedBy::patience);
}

/// Six pendulums whose bobs springs of 1e9 N/m pull to and fro.
std::string stiffPendulums() {
  return R"(<dynamy version="1"><systems><Ground name="world"/><replicate count="6">
    <PointMass name="bob" plane="xz" position="{i} 0 -1.01" velocity="1 0 0" mass="0.1"/></replicate></systems>
    <forces><Gravity/><replicate count="6"><SpringDamper between="world bob" pointA="{i} 0 0"
      stiffness="1e9" length="1"/></replicate></forces>
    <simulation until="20" tolerance="1e-6"/></dynamy>)";
}

TEST(RunPatience, EndsARunThatWouldGoOnForLong) {
  // ω = 1e5 1/s for 20 s: two million radians of six springs at some 1000 evaluations each. The work
  // granted is 1.3e7 evaluations of a velocity, of which an evaluation of a bob costs seven, and what
  // steps in time need.
  LocatedRun run(stiffPendulums(), 1e-6, 20.0);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_GT(run.report().stepping.impatient, 0);
  EXPECT_LT(7.0 * static_cast<double>(run.report().cost.evaluations), 4e7);
  ASSERT_FALSE(run.report().warnings.empty());
  EXPECT_NE(run.report().warnings.back().text.find("patience"), std::string::npos)
      << run.report().warnings.back().text;
}

TEST(RunPatience, OfStepsInTimeDoesNotFeedGainsOfEnergy) {
  // Two masses on a spring of 1e10 N/m whose line turns, stepped in time: V = ½ k 0.01² = 5e5 J at the
  // start, T = 412.5 J. Steps in which the damped spring brings in energy give it back.
  const std::string text = R"(<dynamy version="1"><systems>
    <PointMass name="a" mass="1" position="0 0 0" velocity="0 20 0"/>
    <PointMass name="b" mass="1" position="1.01 0 0" velocity="0 -20 5"/></systems>
    <forces><SpringDamper between="a b" stiffness="1e10" length="1"/></forces>
    <simulation until="1" tolerance="1e-4"/></dynamy>)";
  const auto again = [&] {
    return std::make_unique<LocatedRun>(text, 1e-4, 1.0, Overrides{}, nullptr,
                                        LocatedRun::withPatience("1e-6"));
  };
  const auto whole = again();
  LocatedRun& run = *whole;
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_GT(run.report().trust.slowed.steps, 0);
  EXPECT_LT(run.report().energy.discretisation, 0.0);
  // A run that goes on from a checkpoint behind such a step ends with the same bits.
  const auto part = again(), resumed = again();
  while (part->report().trust.slowed.steps == 0) ASSERT_TRUE(part->simulation().step());
  resumed->simulation().resume(part->simulation().archived());
  resumed->run();
  expectSameBits(*resumed, run);
}

TEST(RunPatience, IsNotSpentOnOneStep) {
  // Of a work of 1.3e7 · 1e-6 one step may spend an eighth, 1.6: none that does not end with its first
  // trial ends at all, and stalls. Steps in time take the run to its end.
  LocatedRun dice("dice", 1e-5, 0.5, {}, {}, LocatedRun::withPatience("1e-6"));
  ASSERT_EQ(dice.run().ended, RunReport::Ended::finished) << dice.report().reason;
  EXPECT_GT(dice.report().stepping.stalls, 0);
  // Without contacts nothing else would follow the motion of a step that stalls: none does.
  LocatedRun smooth(stiffPendulums(), 1e-6, 0.01, {}, {}, LocatedRun::withPatience("1e-6"));
  ASSERT_EQ(smooth.run().ended, RunReport::Ended::finished) << smooth.report().reason;
  EXPECT_EQ(smooth.report().stepping.stalls, 0);
}

TEST(SwitchGovernor, TurnsWhereWindowsCoverHardlyAnyTime) {
  // Windows of 3000 evaluations that cost less than steps in time would: only their length counts,
  // 1e-4 of T, and eight of them in turn.
  const auto windows = [](SwitchGovernor& g, int n, double length) {
    for (int i = 0; i < n; ++i)
      g.located(0.0, length, 3000, 1.0, 1e9, false, SwitchGovernor::kNowhere);
  };
  SwitchGovernor governor;
  governor.scales(1e-8, 1.0);
  windows(governor, 7, 0.9e-4), windows(governor, 1, 1.1e-4), windows(governor, 7, 0.9e-4);
  EXPECT_EQ(governor.mode(), SwitchGovernor::Mode::locate);
  windows(governor, 1, 0.9e-4);
  EXPECT_EQ(governor.mode(), SwitchGovernor::Mode::step);
  EXPECT_EQ(governor.turnedBy(), TurnedBy::density);
}

TEST(SwitchGovernor, KeepsWhatASwitchCostsWithItsState) {
  // Each step is missed. Switches that cost more than a step are not rare, others are.
  for (const double cost : {0.5, 2.0}) {
    SwitchGovernor before, after;
    before.turn(0.0, TurnedBy::density, SwitchGovernor::kNowhere);
    before.switchCosts(cost);
    NumberArchive kept;
    kept(before);
    Eigen::VectorXd numbers;
    kept.copyTo(numbers);
    NumberArchive read(numbers);
    read(after);
    after.scales(1e-3, 1.0);
    for (double t = 0.0; t < 0.5;) {
      t += after.h();
      after.stepped(t, after.h(), 4.0, 1.0, false, 3, kEndless);
    }
    EXPECT_EQ(after.mode() == SwitchGovernor::Mode::step, cost > 1.0) << cost;
  }
}

}  // namespace
}  // namespace dynamy::reference
