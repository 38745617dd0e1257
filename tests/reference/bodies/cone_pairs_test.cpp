/// Cones on cylinders, tori and each other: stacks that stand, a cone that rolls on a cap and on
/// the base of another cone as it does on a table.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <reference/located/located_run.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

TEST(Cones, StandOnCylindersAndCarryPlatesAndRings) {
  // A cone on a can; three cones, a plate on their tips, a ring on it and a cone on the ring.
  SceneSetup setup;
  setup.text = R"(<dynamy version="1"><systems>
    <RigidBody name="can" position="0 0 0.1"><Cylinder radius="0.1" length="0.2" mass="2" material="s"/></RigidBody>
    <RigidBody name="cone" position="0.05 0.02 0.2"><Cone radius="0.12" length="0.3" mass="1" material="s"/></RigidBody>
    <RigidBody name="a" position="0.4 0 0"><Cone radius="0.05" length="0.1" mass="1" material="s"/></RigidBody>
    <RigidBody name="b" position="0.6 0 0"><Cone radius="0.05" length="0.1" mass="1" material="s"/></RigidBody>
    <RigidBody name="c" position="0.5 0.2 0"><Cone radius="0.05" length="0.1" mass="1" material="s"/></RigidBody>
    <RigidBody name="plate" position="0.5 0.08 0.11"><Cylinder radius="0.2" length="0.02" mass="2" material="s"/></RigidBody>
    <RigidBody name="ring" position="0.5 0.05 0.13"><Torus radius="0.1" tube="0.01" mass="2" material="s"/></RigidBody>
    <RigidBody name="hat" position="0.5 0.06 0.14"><Cone radius="0.12" length="0.1" mass="1" material="s"/></RigidBody>
    <Ground name="floor"><HalfSpace normal="0 0 1" material="s"/></Ground>
    </systems><forces><Gravity/></forces><elements>
    <Contact between="s s"><UnilateralCoulomb mu="0.4"/></Contact></elements>
    <simulation until="1" step="1ms"/></dynamy>)";
  Scene stack("cones", std::move(setup));
  const Eigen::VectorXd start = stack.state().q;
  stack.run(1.0, 1e-3);
  EXPECT_TRUE(stack.solved());
  // A thousand steps of the solver's residual, 1e-10 of g Δt each, and first gaps of up to g_tol.
  EXPECT_LT((stack.state().q - start).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Cones, RollOnCapsAndBasesAsOnATable) {
  // Period and amplitude as in models/rolling_cone.xml, where the closed form stands: 60° to one
  // side, back after T = 4 K(1/2)/w.
  const double h = 0.3, alpha = std::atan(1.0 / 3.0), c = std::cos(alpha), psi = 0.2;
  const double w = std::sqrt(5.0 * 9.81 * c * std::sin(psi) / (h * (1.0 + 5.0 * c * c)));
  const double period = 4.0 * 1.685750354812596 / w;
  for (
      const char* const table :
      {R"(<Cylinder radius="0.5" length="0.05" position="-0.2 0 -0.025" material="felt"/>)",
       R"(<Cone radius="0.5" length="0.2" position="-0.2 0 0" euler="{pi} 0 0" material="felt"/>)"}) {
    LocatedRun run(R"(<dynamy version="1"><systems>
      <RigidBody name="cone" position="{-0.3*cos(alpha)*cos(pi/3)} {-0.3*cos(alpha)*sin(pi/3)} {0.3*sin(alpha)}"
                 euler="0 {pi/2 + alpha} {pi/3}"><Cone radius="0.1" length="0.3" mass="1" material="wood"/></RigidBody>
      <Ground name="table">)" +
                       std::string(table) + R"(</Ground></systems>
      <parameter name="alpha" value="{atan(1/3)}"/>
      <forces><Gravity acceleration="{-9.81*sin(0.2)} 0 {-9.81*cos(0.2)}"/></forces>
      <elements><Contact between="wood felt"><UnilateralCoulomb mu="0.6"/></Contact></elements>
      <simulation until="1" step="1ms"/></dynamy>)",
                   1e-6, period);
    ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    // Ten tolerances, of the scene's size.
    EXPECT_NEAR(run.state().q[1], -0.75 * h * c * std::sin(std::numbers::pi / 3.0), 1e-5) << table;
    EXPECT_LT(run.state().u.cwiseAbs().maxCoeff(), 1e-4) << table;
  }
}

}  // namespace
}  // namespace dynamy::reference
