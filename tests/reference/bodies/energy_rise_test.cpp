/// What an impact has lost does not hide what a scheme brings in afterwards.
#include <gtest/gtest.h>

#include <dynamy/simulation/run/simulation.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

TEST(EnergyRise, IsMeasuredFromTheLowestLevelSoFar) {
  // A ball falls by h = 0.9 m and stops: −m g h = −8.8 J. Another one swings on a spring, ω = 10 /s,
  // by Heun's explicit rule, which multiplies its energy by 1 + (ω Δt)⁴/4 = 1.0156 in each step
  // (y' = i ω y: |1 + z + z²/2|² with z = i ω Δt): from ½ 100 N/m (0.4 m)² = 8 J about the place of
  // balance at 0.1 m, in the ten whole steps from the impact at 0.43 s on, 1.2 J at least.
  Scene scene(
      "gain",
      {.text = "<dynamy version=\"1\"><systems><RigidBody name=\"falls\" position=\"0 0 1\">"
               "<Sphere radius=\"0.1\" mass=\"1\" material=\"m\"/></RigidBody>"
               "<RigidBody name=\"swings\" position=\"5 0 5.3\"><Sphere radius=\"0.1\" "
               "mass=\"1\"/></RigidBody><Ground name=\"floor\"><HalfSpace "
               "material=\"m\"/></Ground></systems><forces><Gravity/><SpringDamper "
               "between=\"floor swings\" pointA=\"5 0 4\" stiffness=\"100\" "
               "length=\"1\"/></forces><elements><Contact between=\"m m\"><Unilateral "
               "epsilonN=\"0\"/></Contact></elements><simulation until=\"1\" step=\"0.05\">"
               "<HalfExplicitHeun/></simulation></dynamy>"});
  Simulation simulation(scene.model());
  const RunReport& r = simulation.run();
  EXPECT_LT(r.energy.end(), r.energy.start() - 5.0);
  EXPECT_GT(r.trust.energyGain, 1.2);
  EXPECT_LT(r.trust.energyGain, 2.9);  // in all steps from the start, (1.0156²⁰ − 1) 8 J
  ASSERT_FALSE(r.warnings.empty());
  EXPECT_EQ(r.warnings.front().kind, "energy gain");
}

TEST(EnergyRise, IsNotMeasuredByForcesThatAStepDoesNotResolve) {
  // ½ k s² = 5e6 J in a spring with ω = 3e4 /s; h Δt alone would be 1e6 m/s in a step of 10 ms. What
  // moves is measured by T, which the implicit rule holds below k s²/2 in any case.
  Scene scene("stretched",
              {.text = "<dynamy version=\"1\"><systems><RigidBody name=\"b\" position=\"1.1 0 0\">"
                       "<Sphere radius=\"0.1\" mass=\"1\"/></RigidBody><Ground name=\"g\"/>"
                       "</systems><forces><SpringDamper between=\"g b\" stiffness=\"1e9\" "
                       "length=\"1\"/></forces><simulation until=\"0.1\" step=\"0.01\">"
                       "<StaggeredMoreau/></simulation></dynamy>"});
  Simulation simulation(scene.model());
  const RunReport& r = simulation.run();
  EXPECT_EQ(r.trust.damped, 1);
  EXPECT_LE(r.trust.energyScale(), 5e6);  // 5e11 J by h Δt
  // The end of a step with ω Δt = 300 leaves 1/300 of the stretch, 1e-5 of V. Nearly all that goes is
  // damped, and no error of the scheme.
  EXPECT_NEAR(r.trust.dampedLoss, 5e6, 1e-4 * 5e6);
  EXPECT_LT(r.trust.energyError, 1e-3 * 5e6);
  // Of that, T of what the spring moved is no fall of its potential: it is warned of as before.
  ASSERT_GE(r.warnings.size(), 2U);
  EXPECT_EQ(r.warnings[0].kind, "energy");
  EXPECT_EQ(r.warnings[1].kind, "damped");
  EXPECT_FALSE(r.qualified());
}

}  // namespace
}  // namespace dynamy::reference
