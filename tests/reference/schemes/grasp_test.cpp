// Loads that forces could carry in several ways: what can rest does rest.
#include <gtest/gtest.h>
#include <cmath>
#include <support/bounded_run.hpp>

namespace dynamy {
namespace {

std::string grasp(const std::string& simulation) {
  // Two pads press a box of 0.5 kg with twice the force that friction needs. On one pair of corners
  // alone it would turn about them: that is a solution of the inclusion, too.
  return R"(<dynamy version="1"><systems><Ground name="world"/>
    <RigidBody name="left" position="-0.06 0 0.2"><Box size="0.02 0.04 0.04" mass="0.1" material="pad"/></RigidBody>
    <RigidBody name="right" position="0.06 0 0.2"><Box size="0.02 0.04 0.04" mass="0.1" material="pad"/></RigidBody>
    <RigidBody name="box" position="0 0 0.2"><Box size="0.1 0.06 0.1" mass="0.5" material="box"/></RigidBody>
    </systems><forces><Gravity/>
    <JointForce between="world left" coordinate="displacement" axis="1 0 0" force="9.81"/>
    <JointForce between="world right" coordinate="displacement" axis="1 0 0" force="-9.81"/></forces>
    <elements><Prismatic between="world left" axis="1 0 0"/><Prismatic between="world right" axis="1 0 0"/>
    <Contact between="box pad"><UnilateralCoulomb mu="0.5"/></Contact><NoContact between="pad pad"/></elements>
    <simulation until="1" )" +
         simulation + R"(/><record signals="box.z box.x" every="0.1"/></dynamy>)";
}

TEST(Grasp, HoldsABoxWhateverTheCoordinatesAndTheMethod) {
  for (const char* coordinates : {"minimal", "absolute"})
    for (const char* method : {"step=\"1e-3\"", "tolerance=\"1e-6\""}) {
      BoundedRun run(grasp(std::string(method) + " coordinates=\"" + coordinates + '"'));
      run.run();
      ASSERT_TRUE(run.finished()) << run.report().reason;
      // Rest: rounding of 1000 steps of at most 1e-15 m each. Along x pads and box are free as a whole:
      // 1e-10 of the velocity that a step without contacts would give them, 0.1 m/s, adds up.
      EXPECT_NEAR(run.last(0), 0.2, 1e-11) << coordinates << ' ' << method;
      EXPECT_NEAR(run.last(1), 0.0, 1e-8) << coordinates << ' ' << method;
    }
}

/// A plate of 10 kg on 25 balls of 1 kg, drawn by 150 N at its lower face.
std::string plate(const std::string& force, const std::string& simulation) {
  return R"(<dynamy version="1"><systems><Ground name="w"><HalfSpace material="m"/></Ground>
    <replicate count="25"><RigidBody name="ball" position="{2*mod(i, 5) - 4} {2*floor(i/5) - 4} 0.5" mass="1"
      inertia="0.1 0.1 0.1"><Sphere radius="0.5" material="m"/></RigidBody></replicate>
    <RigidBody name="plate" position="0 0 1.5" mass="10" inertia="1e5 1e5 1e5">
    <Box size="300 300 1" material="m"/></RigidBody></systems>
    <forces><Gravity/><ForceInput on="plate" point="0 0 -0.5" force=")" +
         force + R"("/></forces>
    <elements><Contact between="m m"><UnilateralCoulomb mu="2"/></Contact></elements>
    <simulation until="0.7" )" +
         simulation + R"(/><record signals="plate.vx plate.vy" every="0.1"/></dynamy>)";
}

TEST(Rolling, OfAPlateOnBallsThatShareItsWeightInManyWays) {
  // A ball has half of the plate's acceleration a, and from its momentum and its angular momentum the
  // plate drives it with 0.35 m a: a = F/(M + 0.35 n m). Where a ball carried little, it would slip:
  // that is a solution of the inclusion, too, from 0.24 s or 0.35 s on.
  const double v = 150.0 / (10.0 + 0.35 * 25.0) * 0.7;
  for (const char* simulation : {"step=\"1e-3\"", "step=\"1e-2\"", "tolerance=\"1e-8\""})
    for (const double turn : {0.0, 1.0}) {
      const std::string force = turn == 0.0 ? "150; 0; 0" : "150*cos(1); 150*sin(1); 0";
      BoundedRun run(plate(force, simulation));
      run.run();
      ASSERT_TRUE(run.finished()) << run.report().reason;
      // Rounding of 700 steps, and what a residual of 2e-6 of g Δt may leave in the step that begins
      // with another solution.
      EXPECT_NEAR(run.last(0), v * std::cos(turn), 1e-8) << simulation << ' ' << turn;
      EXPECT_NEAR(run.last(1), v * std::sin(turn), 1e-8) << simulation << ' ' << turn;
    }
}

TEST(OverdampedForces, NeedNoShorterSteps) {
  // A flap of J = 1e-3 kg m² at its hinge under a stiff controller with much damping, ωΔt = 0.4 and
  // Δt d/J = 4: taken at the end of a step, it comes to rest in steps of the given length.
  BoundedRun run(R"(<dynamy version="1"><systems><Ground name="world"/>
    <RigidBody name="flap" mass="0.1" inertia="1e-3 1e-3 1e-3"/></systems><forces>
    <PdController between="world flap" axis="0 1 0" stiffness="160" damping="4" target="0.5"/></forces>
    <elements><Revolute name="h" between="world flap" axis="0 1 0"/></elements>
    <simulation until="1" step="1e-3" coordinates="absolute"/>
    <record signals="h.angle" every="0.1"/></dynamy>)");
  run.run();
  ASSERT_TRUE(run.finished()) << run.report().reason;
  EXPECT_EQ(run.report().steps, 1000);
  // exp(−k/d t) = 4e-18 of 0.5 rad is left.
  EXPECT_NEAR(run.last(), 0.5, 1e-9);
}

TEST(Bore, HoldsABallWithRestitutionThatSlidesRoundIt) {
  // Each step of 2 ms at up to 1.5 m/s leads it (v Δt)²/2R = 0.04 mm outwards, which the next one takes
  // back; where it comes down at first, half of a step's way.
  BoundedRun run(R"(<dynamy version="1"><systems>
    <Ground name="g"><Bore radius="0.12" length="1" euler="90deg 0 0" material="m"/></Ground>
    <RigidBody name="p" position="0.09 0 0"><Sphere radius="0.01" mass="0.1" material="m"/></RigidBody></systems>
    <forces><Gravity/></forces>
    <elements><Contact between="m m"><Unilateral epsilonN="0.3"/></Contact></elements>
    <simulation until="4" step="2ms"/><record signals="p.x p.z" every="10ms"/></dynamy>)");
  run.run();
  ASSERT_TRUE(run.finished()) << run.report().reason;
  EXPECT_LT(run.report().gaps.penetration.value, 1.5e-3);
  // Overlaps up to 0.1 % of the scene's length, 1 m, are left as they are.
  EXPECT_LT(std::hypot(run.last(0), run.last(1)), 0.11 + 1.05e-3);
}

}  // namespace
}  // namespace dynamy
