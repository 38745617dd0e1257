// Runs with pairs of boxes to a tolerance that go on from a checkpoint, and a ball that rolls over
// an edge of a polyhedron.
#include <gtest/gtest.h>

#include <reference/located/located_run.hpp>
#include <tuple>

namespace dynamy::reference {
namespace {

std::string plainPairScene(const std::string& systems, const std::string& law) {
  return R"xml(<dynamy version="1"><systems>)xml" + systems +
         R"xml(</systems><forces><Gravity/></forces><elements><Contact between="stone stone">)xml" +
         law + R"xml(</Contact></elements><simulation until="1" step="1"/></dynamy>)xml";
}

/// A block slides over a table, with its corners on the face and its edges over the border, tips
/// over the rim and falls.
const std::string kTips = plainPairScene(R"xml(
    <RigidBody name="block" position="0.1 0 0.1" velocity="1.5 0.2 0" angularVelocity="0 0 0.5">
      <Box size="0.4 0.2 0.2" mass="2" material="stone"/></RigidBody>
    <Ground name="world"><Box size="1 1 0.1" position="0 0 -0.05" material="stone"/></Ground>)xml",
                                         R"xml(<UnilateralCoulomb mu="0.1" epsilonN="0.3"/>)xml");
/// A crooked tower: one block slides on another, which slides on the floor.
const std::string kCrooked = plainPairScene(R"xml(
    <RigidBody name="low" position="0 0 0.1" velocity="0.4 0 0">
      <Box size="0.6 0.4 0.2" mass="2" material="stone"/></RigidBody>
    <RigidBody name="high" position="0.1 0.05 0.3" velocity="-0.7 0.3 0" angularVelocity="0 0 2">
      <Box size="0.3 0.3 0.2" mass="1" material="stone"/></RigidBody>
    <Ground name="world"><Box size="4 4 0.2" position="0 0 -0.1" material="stone"/></Ground>)xml",
                                            R"xml(<UnilateralCoulomb mu="0.3"/>)xml");
/// A cube falls on its corner and tumbles, until it rests on a face.
const std::string kTumbles =
    plainPairScene(R"xml(
    <RigidBody name="die" position="0 0 0.4" euler="0.3 0.7 0.2" angularVelocity="2 3 1">
      <Box size="0.2 0.2 0.2" mass="1" material="stone"/></RigidBody>
    <Ground name="world"><Box size="4 4 0.2" position="0 0 -0.1" material="stone"/></Ground>)xml",
                   R"xml(<UnilateralCoulomb mu="0.5" epsilonN="0.3"/>)xml");

TEST(LocatedPairs, ARunResumedAtAnyTimeGoesOnBitForBit) {
  int located = 0;
  for (const auto& [name, model, until] :
       {std::tuple{"tips", kTips, 0.9}, std::tuple{"crooked", kCrooked, 0.6},
        std::tuple{"tumbles", kTumbles, 1.5}, std::tuple{"tower", std::string("tower"), 2.0}}) {
    constexpr double kTolerance = 1e-6;
    LocatedRun whole(model, kTolerance, until);
    ASSERT_EQ(whole.run().ended, RunReport::Ended::finished) << whole.report().reason;
    for (int k = 1; k < 10; k += 2) {
      SCOPED_TRACE(std::string(name) + ", " + std::to_string(k) + " tenths");
      LocatedRun first(model, kTolerance, 0.1 * k * until), second(model, kTolerance, until);
      ASSERT_EQ(first.run().ended, RunReport::Ended::finished) << first.report().reason;
      located += first.report().located.switches > 0;
      second.simulation().resume(first.simulation().checkpoint());
      second.run();
      EXPECT_EQ(second.state().q, whole.state().q);
      EXPECT_EQ(second.state().u, whole.state().u);
      EXPECT_EQ(second.report().located.switches, whole.report().located.switches);
      EXPECT_EQ(second.report().steps, whole.report().steps);
    }
  }
  EXPECT_GT(located, 10);
}

/// A ball near the edge of a block's upper face, and another far away that rolls round on a hill.
std::string rolls(const std::string& x) {
  return R"xml(<dynamy version="1"><systems>
    <RigidBody name="A" position=")xml" +
         x +
         R"xml( 0 0.55" velocity="0.3 0 0"><Sphere radius="0.1" mass="1" material="s"/></RigidBody>
    <RigidBody name="B" position="5.0 0 0.1" velocity="0.2 0.1 0"><Sphere radius="0.1" mass="1" material="s"/></RigidBody>
    <Ground name="g"><Polyhedron points="-1 -1 0 1 -1 0 1 1 0 -1 1 0 -0.5 -0.5 0.4 0.5 -0.5 0.4 0.5 0.5 0.4 -0.5 0.5 0.4" material="c"/>
      <Sphere radius="5" position="5 0 -5" material="c"/></Ground></systems>
    <forces><Gravity/></forces>
    <elements><Contact between="s c"><UnilateralCoulomb mu="0.3"/></Contact><NoContact between="s s"/></elements>
    <simulation until="3" tolerance="1e-8"/></dynamy>)xml";
}

TEST(LocatedPairs, ABallOverAnEdgeOfAPolyhedronLeavesTheStepsAsTheyAre) {
  LocatedRun beside(rolls("0.4480"), 1e-8, 3.0);
  ASSERT_EQ(beside.run().ended, RunReport::Ended::finished) << beside.report().reason;
  for (const char* x : {"0.4484", "0.4486", "0.4488", "0.4490", "0.4494"}) {
    LocatedRun over(rolls(x), 1e-8, 3.0);
    ASSERT_EQ(over.run().ended, RunReport::Ended::finished) << over.report().reason;
    // Another way of the first ball, a tenth more or less; half-explicit steps for both balls, as
    // for elements that tell no bias, take 1.7 times as many evaluations.
    EXPECT_LT(static_cast<double>(over.report().cost.effort.smooth),
              1.2 * static_cast<double>(beside.report().cost.effort.smooth))
        << x;
  }
}

}  // namespace
}  // namespace dynamy::reference
