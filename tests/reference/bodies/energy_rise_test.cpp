/// What an impact has lost does not hide what a scheme brings in afterwards.
#include <gtest/gtest.h>

#include <algorithm>
#include <dynamy/simulation/run/simulation.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

bool warns(const RunReport& r, const std::string& kind) {
  return std::any_of(r.warnings.begin(), r.warnings.end(),
                     [&](const Warning& w) { return w.kind == kind; });
}

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
  // The end of a step with ω Δt = 300 leaves 1/300 of the stretch, 1e-5 of V. All that goes is damped,
  // to the rounding of sums of 5e6 J, and no error of the scheme.
  EXPECT_NEAR(r.trust.dampedLoss, 5e6, 1e-4 * 5e6);
  EXPECT_LT(r.trust.energyError, 1e-15 * 1e2 * 5e6);
  EXPECT_FALSE(warns(r, "energy"));
  EXPECT_TRUE(warns(r, "damped"));
  EXPECT_FALSE(r.qualified());
}

TEST(EnergyRise, TellsMotionThatDampedForcesStopFromOtherLosses) {
  // Two bodies run along springs without stretch, which stop them within a few parts of the first
  // step. With the pendulum beside them the steps are those with joints on position level.
  Scene scene(
      "stopped",
      {.text =
           "<dynamy version=\"1\"><systems><RigidBody name=\"b\" position=\"1 0 0\" "
           "velocity=\"100 0 0\"><Sphere radius=\"0.1\" mass=\"1\"/></RigidBody><RigidBody "
           "name=\"c\" position=\"0 2 0\"><Sphere radius=\"0.1\" mass=\"1\"/></RigidBody>"
           "<RigidBody name=\"d\" position=\"1 3 0\" velocity=\"3 0 0\" angularVelocity=\"1 2 3\">"
           "<Sphere radius=\"0.1\" mass=\"1\"/></RigidBody><Ground name=\"g\"/></systems><forces>"
           "<SpringDamper between=\"g b\" stiffness=\"1e9\" length=\"1\"/><SpringDamper "
           "between=\"g "
           "d\" pointA=\"0 3 0\" stiffness=\"1e8\" damping=\"1e3\" length=\"1\"/><Gravity/>"
           "</forces><elements><Revolute between=\"g c\" at=\"0 1.5 0\" axis=\"0 0 1\"/></elements>"
           "<simulation until=\"0.1\" step=\"0.01\"/></dynamy>"});
  Simulation simulation(scene.model());
  const RunReport& r = simulation.run();
  EXPECT_EQ(r.trust.damped, 2);
  // ½ m v² of the first, of the second less what its damper takes, gravity's work within 0.1 s.
  EXPECT_NEAR(r.trust.dampedLoss, 5000.0, 4.5 + 10.0);
  // Forces, works and V are those of the steps: what is left is the rounding of sums of at most
  // ½ k (Δt v)² = 5e8 J, in some ten parts.
  EXPECT_LT(r.trust.energyError, 1e-16 * 10.0 * 5e8);
  EXPECT_FALSE(warns(r, "energy"));
  EXPECT_TRUE(warns(r, "damped"));
}

TEST(EnergyRise, IsSeenThoughAnImpactTakesItAtOnce) {
  // Ball a starts 0.1 m inside of a wall. Brought out of it, it compresses the spring: ½ k s² = 50 J,
  // with which b, after a quarter of a period, 16 ms, comes to rest at a wall. Energies are sampled
  // every 39 ms, and c moves meanwhile.
  for (const std::string how : {"tolerance=\"1e-6\"", "step=\"1e-3\""}) {
    Scene scene(
        "burst",
        {.text = "<dynamy version=\"1\"><systems><Ground name=\"walls\"><HalfSpace euler=\"0 90deg "
                 "0\" material=\"m\"/><HalfSpace position=\"1.2 0 0\" euler=\"0 -90deg 0\" "
                 "material=\"m\"/></Ground><RigidBody name=\"a\"><Sphere radius=\"0.1\" mass=\"1\" "
                 "material=\"m\"/></RigidBody><RigidBody name=\"b\" position=\"1 0 0\"><Sphere "
                 "radius=\"0.1\" mass=\"1\" material=\"m\"/></RigidBody><RigidBody name=\"c\" "
                 "position=\"0.5 5 0\" velocity=\"0 0 3\"><Sphere radius=\"0.1\" mass=\"1\"/>"
                 "</RigidBody></systems><forces><SpringDamper between=\"a b\" stiffness=\"1e4\" "
                 "length=\"1\"/></forces><elements><Contact between=\"m m\"><Unilateral "
                 "epsilonN=\"0\"/></Contact></elements><simulation until=\"10\" " +
                 how + "/></dynamy>"});
    Simulation simulation(scene.model());
    const RunReport& r = simulation.run();
    EXPECT_NEAR(r.energy.end(), r.energy.start(), 1e-3 * 50.0) << how << ": nothing is left of it";
    EXPECT_NEAR(r.trust.energyRise, 50.0, 0.01 * 50.0)
        << how << ": T + V of a step of 1 ms, ωΔt = 0.1";
    EXPECT_TRUE(warns(r, "energy gain")) << how;
  }
}

}  // namespace
}  // namespace dynamy::reference
