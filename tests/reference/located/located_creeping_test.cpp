// Motions that used to creep on in steps of 1e-11 of the scene's time: each ends after few evaluations.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <reference/located/located_run.hpp>

namespace dynamy::reference {
namespace {

std::string textOf(const std::string& file) {
  std::ifstream in(DYNAMY_SOURCE_DIR "/tests/data/" + file);
  return {std::istreambuf_iterator<char>(in), {}};
}

long evaluations(const RunReport& r) {
  const StepEffort& e = r.cost.effort;
  return e.smooth + e.rejected + e.switches + e.events + e.stepping;
}

TEST(LocatedCreeping, AFaceThatNothingPressesAgainstAWallStaysThere) {
  // A plate hits a wall flat, without rebound, and weighs nothing: what is left of its speed, 1e-10
  // of the scene's, is no impact, and used to close its corners again every 0.5 µs.
  const std::string scene = R"(<dynamy version="1"><systems>
    <RigidBody name="plate" position="-1.37 0.3 0.1" velocity="46.0853 3 -2">
      <Box size="0.31 0.83 0.57" mass="1.7" material="a"/></RigidBody>
    <Ground name="wall"><HalfSpace normal="-1 0 0" material="a"/></Ground></systems>
    <elements><Contact between="a a"><UnilateralCoulomb mu="0.01"/></Contact></elements>
    <simulation until="1" step="1"/></dynamy>)";
  LocatedRun run(scene, 1e-8, 1.0);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_EQ(run.report().stepping.periods, 0);
  // Free flight, an impact and a smooth slide are some tens of evaluations each.
  EXPECT_LT(evaluations(run.report()), 300);
  EXPECT_NEAR(run.state().q[0], -0.155, 1e-8);
}

TEST(LocatedCreeping, ABodyThatSpinsFarFromAllOthersBindsNone) {
  // A box turns by 10 000 rad in a second, about the axis of its symmetry, 100 m above the floor, and
  // pulls another one, which slides, by a weak spring. Steps of 0.5 rad would be 20 000 with more than ten
  // evaluations each; no error asks for that.
  const std::string scene = R"(<dynamy version="1"><systems>
    <RigidBody name="top" position="0 0 100" angularVelocity="0 0 1e4">
      <Box size="0.1 0.1 0.05" mass="0.1" material="a"/></RigidBody>
    <RigidBody name="block" position="50 0 0.1" velocity="1 0 0">
      <Box size="1 1 0.2" mass="1" material="a"/></RigidBody>
    <Ground name="floor"><HalfSpace material="a"/></Ground></systems>
    <forces><Gravity/><SpringDamper between="top block" stiffness="1e-3" length="110"/></forces>
    <elements><Contact between="a a"><Unilateral/></Contact></elements>
    <simulation until="1" step="1"/></dynamy>)";
  LocatedRun run(scene, 1e-3, 1.0);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_LT(evaluations(run.report()), 100000);
  EXPECT_NEAR(run.state().q[2], 100.0 - 0.5 * 9.81, 1e-2);
}

TEST(LocatedCreeping, BodiesThatSinkIntoEachOtherFromAnOverlapAreStepped) {
  // A random scene: bodies that overlap at the start, heavy ones on light ones. No gap of two bodies
  // inside each other falls through zero, however short the step.
  LocatedRun run(textOf("defects/sinking_inside.xml"), 1e-3, 0.494509);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_GT(run.report().stepping.steps, 0);
  // 31 811 when it was written; 100 979 evaluations had come to 0.0128 s before.
  EXPECT_LT(evaluations(run.report()), 60000);
}

}  // namespace
}  // namespace dynamy::reference
