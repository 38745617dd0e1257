// Islands with clocks of their own (theory 50.12): they meet, divide, and go on from checkpoints.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <reference/located/bounce.hpp>
#include <reference/located/located_run.hpp>
#include <string>
#include <support/gravity.hpp>

namespace dynamy::reference {
namespace {

constexpr auto scheme = &LocatedRun::withClocks;

std::string scene(const std::string& bodies, const std::string& forces = "<Gravity/>") {
  return "<dynamy version=\"1\"><systems>" + bodies +
         R"xml(<Ground name="world"><HalfSpace material="floor"/></Ground></systems><forces>)xml" +
         forces + R"xml(</forces><elements>
  <Contact between="ball floor"><UnilateralCoulomb epsilonN="0.8" mu="0.3"/></Contact>
  <Contact between="ball ball"><UnilateralCoulomb epsilonN="1" mu="0"/></Contact></elements>
  <simulation until="1" step="1"/></dynamy>)xml";
}

std::string ball(const std::string& name, const std::string& position,
                 const std::string& velocity = "0 0 0") {
  return "<RigidBody name=\"" + name + "\" position=\"" + position + "\" velocity=\"" + velocity +
         R"xml(" angularVelocity="1 2 0.5"><Sphere radius="0.1" mass="1" material="ball"/></RigidBody>)xml";
}

/// A spring between the centres of the first two systems, neither of which it requests by name.
class Magnet final : public ExternalForce {
 public:
  static void declare(Attributes& a) { a.about("For tests."); }
  explicit Magnet(const Parameters& x) : ExternalForce(x) {}
  void connect(Topology& topology) override { topology_ = &topology; }
  void addTo(const Kinematics& k, ForceSink& sink) const override {
    const SystemHandle &a = topology_->system(0), &b = topology_->system(1);
    for (int i = 0; i < 3; ++i) {
      const double pull = 5.0 * (k.q(b)[i] - k.q(a)[i]);
      sink.generalised(a, i, pull), sink.generalised(b, i, -pull);
    }
  }

 private:
  const Topology* topology_ = nullptr;
};

/// Place of the height of ball i among q.
constexpr int height(int i) { return 7 * i + 2; }

TEST(IslandClocks, BallsApartHaveStepsOfTheirOwnAndTheClosedForm) {
  const std::string text = scene(ball("a", "0 0 1") + ball("b", "2 0 1.7") + ball("c", "4 0 2.3"));
  LocatedRun run(text, 1e-9, 2.0, {}, {}, scheme("islands"));
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  // Parabolas are exact and impacts located to rounding.
  const double start[] = {1.0, 1.7, 2.3};
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(run.state().q[height(i)], 0.1 + bounceHeight(start[i] - 0.1, 0.8, 2.0), 1e-11);
  // T + V is known to 1e-16 of some 50 J in each of some ten steps.
  EXPECT_NEAR(r.energy.discretisation, 0.0, 1e-12);
  LocatedRun one(text, 1e-9, 2.0, {}, {}, scheme("one"));
  EXPECT_EQ(r.contacts.impacts, one.run().contacts.impacts);
  EXPECT_EQ(r.located.islands, 3);
  EXPECT_EQ(one.report().located.islands, 0);
  EXPECT_EQ(r.located.switches, one.report().located.switches);
}

TEST(IslandClocks, BallsThatMeetExchangeTheirVelocities) {
  // Two smooth balls, 1 m/s towards each other, 1.8 m between their surfaces; a third one passes
  // them at 5 cm.
  const std::string text = scene(ball("a", "0 0 1", "1 0 0") + ball("b", "2 0 1", "-1 0 0") +
                                     ball("c", "-0.5 0.25 1", "3 0 0"),
                                 "");
  LocatedRun run(text, 1e-9, 2.0, {}, {}, scheme("islands"));
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_EQ(r.contacts.impacts, 1);
  ASSERT_EQ(run.events.size(), 1u);
  EXPECT_NEAR(run.events[0].t, 0.9, 1e-12);
  // x = 0.9 − 1.1 and 1.1 + 1.1 after 2 s; the root is known to rounding, of numbers of size 1.
  EXPECT_NEAR(run.state().q[0], -0.2, 1e-12);
  EXPECT_NEAR(run.state().q[7], 2.2, 1e-12);
  EXPECT_NEAR(run.state().q[14], 5.5, 1e-12);
}

TEST(IslandClocks, AgreesWithOneClockWhereManyMeet) {
  std::string bodies;
  for (int i = 0; i < 9; ++i)
    bodies += ball(
        "b" + std::to_string(i),
        std::to_string(0.4 * (i % 3)) + ' ' + std::to_string(0.4 * (i / 3)) + ' ' +
            std::to_string(0.5 + 0.07 * i),
        std::to_string(0.8 - 0.4 * (i % 3)) + ' ' + std::to_string(0.7 - 0.6 * (i / 3)) + " 0");
  constexpr double kTolerance = 1e-10;
  LocatedRun islands(scene(bodies), kTolerance, 0.6, {}, {}, scheme("islands"));
  LocatedRun one(scene(bodies), kTolerance, 0.6, {}, {}, scheme("one"));
  ASSERT_EQ(islands.run().ended, RunReport::Ended::finished);
  ASSERT_EQ(one.run().ended, RunReport::Ended::finished);
  ASSERT_GT(one.report().contacts.impacts, 9);
  EXPECT_EQ(islands.report().contacts.impacts, one.report().contacts.impacts);
  // Impacts between balls of radius R after flights of l amplify errors by up to 2 l/R = 8 each;
  // each ball has at most three of them here: 500 tolerances.
  for (Eigen::Index i = 0; i < one.state().q.size(); ++i)
    EXPECT_NEAR(islands.state().q[i], one.state().q[i], 500.0 * kTolerance);
}

TEST(IslandClocks, AreOneWhereAForceMayCoupleSystemsThatItDoesNotName) {
  const std::string text = scene(ball("a", "0 0 1") + ball("b", "2 0 1.7"), "<Gravity/><Magnet/>");
  const auto magnet = [](Registry& r) { r.add<Magnet>("Magnet"); };
  LocatedRun islands(text, 1e-8, 1.0, {}, magnet, scheme("islands"));
  LocatedRun one(text, 1e-8, 1.0, {}, magnet, scheme("one"));
  ASSERT_EQ(islands.run().ended, RunReport::Ended::finished) << islands.report().reason;
  one.run();
  expectSameBits(islands, one);
}

TEST(IslandClocks, GoOnFromACheckpointBitForBit) {
  const std::string text =
      scene(ball("a", "0 0 1", "1 0 0") + ball("b", "2 0 1.1", "-1 0 0") + ball("c", "4 0 2.3"));
  LocatedRun whole(text, 1e-8, 1.5, {}, {}, scheme("islands"));
  LocatedRun part(text, 1e-8, 0.7, {}, {}, scheme("islands"));
  LocatedRun resumed(text, 1e-8, 1.5, {}, {}, scheme("islands"));
  whole.run(), part.run();
  resumed.simulation().resume(part.simulation().checkpoint());
  resumed.run();
  expectSameBits(resumed, whole);
}

TEST(IslandClocks, DoNotDependOnWhatIsRecorded) {
  const std::string text =
      scene(ball("a", "0 0 1", "1 0 0") + ball("b", "2 0 1.1", "-1 0 0") + ball("c", "4 0 2.3"));
  LocatedRun once(text, 1e-8, 1.5, {}, {}, scheme("islands"));
  LocatedRun often(text, 1e-8, 1.5, {}, {}, scheme("islands"));
  often.record(0.013, 30.0);
  once.run(), often.run();
  expectSameBits(often, once);
}

/// A ball that bounces, beside two bodies, fixed to each other off their centres, that spin at 65 rad/s.
std::string pairBesideABall() {
  std::string text = scene(ball("drop", "9 0 0.4") + R"xml(
    <RigidBody name="a" mass="1.2" inertia="5e-3 4e-3 6e-3" position="0 0 50" velocity="0 5 0" angularVelocity="-12 48 -44"/>
    <RigidBody name="b" mass="0.4" inertia="1e-3 2e-3 1.5e-3" position="0.8 0 50"/>)xml");
  text.insert(text.find("</elements>"), R"xml(<Fixed between="a b" at="0.4 0 50"/>)xml");
  return text;
}

TEST(IslandClocks, ShowJointsClosedWithinTheirSteps) {
  // Where the steps of the ball end, the dense output of 1e-3 leaves the joint open by e of some
  // millimetres; one turn of Newton's iteration leaves e²/l of arms of l = 0.4 m.
  LocatedRun run(pairBesideABall(), 1e-3, 1.0, {}, {}, scheme("islands"));
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  ASSERT_GE(r.contacts.impacts, 3);
  EXPECT_LT(r.gaps.jointError.value, 1e-4);
}

/// Expects the same bits at 1 s of a run that stops after this number of steps, and goes on.
void expectToGoOnAfter(int steps, const std::string& text, double tolerance,
                       const std::string& stiff = "automatic") {
  SCOPED_TRACE(std::to_string(steps) + " steps");
  const auto run = [&] {
    return std::make_unique<LocatedRun>(
        text, tolerance, 1.0, Overrides{}, std::function<void(Registry&)>{},
        std::make_unique<LocatedDormandPrince>(
            Parameters::of<LocatedDormandPrince>("LocatedDormandPrince", "", {{"stiff", stiff}})));
  };
  const auto whole = run(), part = run(), resumed = run();
  whole->run();
  part->simulation().start();
  for (int i = 0; i < steps; ++i) ASSERT_TRUE(part->simulation().step());
  const std::atomic<bool> stop{true};
  part->simulation().stopWhen(stop);
  part->run();
  ASSERT_LT(part->state().t, 1.0);
  resumed->simulation().resume(part->simulation().checkpoint());
  resumed->run();
  expectSameBits(*resumed, *whole);
}

TEST(IslandClocks, GoOnFromACheckpointWithinAStepOfAJoint) {
  // Most steps of the run end with those of the ball.
  for (const int steps : {3, 5, 7}) expectToGoOnAfter(steps, pairBesideABall(), 1e-3);
}

/// Balls that slide until they roll, beside one that bounces.
const std::string kSliding = scene(ball("a", "0 0 0.1", "3 1 0") + ball("b", "9 0 0.1", "2 -1 0") +
                                   ball("c", "20 0 0.1", "1 4 0") + ball("d", "40 0 1.3"));

TEST(IslandClocks, GoOnFromACheckpointWhileBodiesSlide) {
  for (int steps = 1; steps <= 25; steps += 2) expectToGoOnAfter(steps, kSliding, 1e-6);
}

TEST(IslandClocks, GoOnFromACheckpointWithinImplicitSteps) {
  // The Jacobian that a resumed run evaluates again does not count where work decides.
  for (int steps = 1; steps <= 25; steps += 2) expectToGoOnAfter(steps, kSliding, 1e-6, "always");
}

TEST(IslandClocks, EvaluationsASwitchDoNotGrowWithTheNumberOfBalls) {
  const auto cost = [](int n) {
    std::string bodies;
    for (int i = 0; i < n; ++i)
      bodies += ball("b" + std::to_string(i),
                     std::to_string(i) + " 0 " + std::to_string(0.5 + 0.37 * (i % 5)));
    LocatedRun run(scene(bodies), 1e-8, 1.0, {}, {}, scheme("islands"));
    EXPECT_EQ(run.run().ended, RunReport::Ended::finished);
    return static_cast<double>(run.report().cost.evaluations) /
           static_cast<double>(run.report().located.switches);
  };
  // With one clock four times as many balls cost four times as many evaluations, each of all.
  EXPECT_NEAR(cost(24) / cost(6), 1.0, 0.25);
}

TEST(IslandClocks, KeepTheirDigitsAndImpactsBesideTimeSteppedIslands) {
  // A column of sixteen balls that bounce on each other until it is stepped in time, and one that
  // drops beside it: from 2.28 − 0.1 m, after t₁ = √(2·2.18/g) and t₁ (1 + 2·0.8).
  std::string bodies = ball("drop", "9 0 2.28");
  for (int i = 0; i < 16; ++i)
    bodies += ball("b" + std::to_string(i), "0 0 " + std::to_string(0.2 + 0.21 * i));
  for (const char* clocks : {"one", "islands"}) {
    constexpr double kUntil = 2.2;
    LocatedRun run(scene(bodies), 5e-3, kUntil, {}, {}, scheme(clocks));
    const RunReport& r = run.run();
    ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
    ASSERT_GE(r.stepping.steps, 3) << clocks;
    EXPECT_NEAR(run.state().q[height(0)], 0.1 + bounceHeight(2.18, 0.8, kUntil), 1e-11);
    // Nothing of it is lost among the events, though others are stepped in time then.
    const double first = std::sqrt(2.0 * 2.18 / kG);
    const std::vector<double> impacts = run.impacts("drop-world");
    ASSERT_EQ(impacts.size(), 2u) << clocks;
    EXPECT_NEAR(impacts[0], first, 1e-12);
    EXPECT_NEAR(impacts[1], 2.6 * first, 1e-12);
  }
}

/// A tower of eight boxes that is laid in a slant, so that its switches are dense, if there is one; and
/// a box far above that spins by 3000 rad/s.
std::string spinningBoxBeside(bool tower) {
  return std::string(R"xml(<dynamy version="1"><systems>
    <Ground name="world"><HalfSpace normal="0 0 1" material="a"/></Ground>)xml") +
         (tower ? R"xml(<replicate count="8"><RigidBody name="b" velocity="0 0 -1"
      position="{0.05*i} {0.02*i*i} {0.11+0.201*i}"><Box size="0.4 0.3 0.2" mass="1" material="a"/>
    </RigidBody></replicate>)xml"
                : "") +
         R"xml(<RigidBody name="fast" position="5 0 50" angularVelocity="3000 150 400">
      <Box size="0.1 0.2 0.3" mass="1"/></RigidBody></systems>
    <forces><Gravity/></forces>
    <elements><Contact between="a a"><UnilateralCoulomb mu="0.5" epsilonN="0.2"/></Contact></elements>
    <simulation until="1" tolerance="1e-3"/></dynamy>)xml";
}

TEST(IslandClocks, OfFastIslandsDoNotHoldUpDearOnesForLong) {
  // Steps in time of the tower end with steps of the box that spins, each of which costs much less.
  // Without patience for that, the box is stepped in time, too: it takes less than half of the located
  // steps that it takes alone.
  const auto smooth = [](bool tower) {
    LocatedRun run(spinningBoxBeside(tower), 1e-3, 1.0, {}, {}, LocatedRun::withPatience("0.1"));
    EXPECT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    return run.report().cost.effort.smooth;
  };
  EXPECT_LT(smooth(true), smooth(false) / 2);
}

}  // namespace
}  // namespace dynamy::reference
