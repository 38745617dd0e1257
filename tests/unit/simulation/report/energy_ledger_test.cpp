#include <gtest/gtest.h>

#include "unit/simulation/scenes.hpp"

namespace dynamy {
namespace {

using namespace scenes;

EnergyReport energyOf(Model& m) {
  m.build();
  Simulation s(m);
  return s.run().energy;
}

TEST(EnergyLedger, AnImpactTakesWhatNewtonsLawSays) {
  // One impact with speed v: −(1 − ε²) v²/2. The scheme's v is g times a whole number of steps.
  Model m = ballOnFloor(1.0, 0.0, 0.5, 0.0, 0.6, 1e-3);
  const EnergyReport e = energyOf(m);
  const double v2 = 2.0 * kGravity * 1.0;
  // v is off by at most g Δt: relative 1e-2/4.5 in v, twice that in v².
  EXPECT_NEAR(e.normal, -0.75 * 0.5 * v2, 0.75 * 0.5 * v2 * 5e-3);
  EXPECT_EQ(e.start(), 10.0);
  // Sums of 600 steps with terms of order 10 J: far below 1e-12.
  EXPECT_NEAR(e.imbalance, 0.0, 1e-12);
  // The potential is linear and Δq = Δt ū: nothing is left over but rounding.
  EXPECT_NEAR(e.discretisation, 0.0, 1e-12);
}

TEST(EnergyLedger, AnElasticBallLosesNothing) {
  Model m = ballOnFloor(1.0, 0.0, 1.0, 0.0, 5.0, 1e-3);
  const EnergyReport e = energyOf(m);
  // Λ(γ^A + γ^E)/2 is zero up to the tolerance 1e-10 of the solver, 6 impacts of about 10 J.
  EXPECT_NEAR(e.normal, 0.0, 1e-8);
  EXPECT_NEAR(e.end(), 10.0, 1e-8);
}

TEST(EnergyLedger, FrictionTakesTheKineticEnergyOfASlidingBlock) {
  Model m = ballOnFloor(0.0, 2.0, 0.0, 0.5, 1.0, 1e-3);  // stops after v/(μ g) = 0.4 s
  const EnergyReport e = energyOf(m);
  EXPECT_NEAR(e.friction, -2.0, 1e-9);  // ½ m v²; tolerance of the solver over 400 steps
  EXPECT_NEAR(e.kineticEnd, 0.0, 1e-12);
}

TEST(EnergyLedger, DampingIsWorkOfForcesWithoutPotential) {
  Model m;
  m.add<Ball>("ball", {{"vx", 2.0}, {"drag", 1.0}});
  m.simulation.until = 1.0, m.simulation.step = 1e-3;
  const EnergyReport e = energyOf(m);
  // ½ v²(1 − e^{−2t}); the scheme's factor (1 − Δt) per step differs by Δt/2 relative.
  EXPECT_NEAR(e.nonPotential, -2.0 * (1.0 - std::exp(-2.0)), 2e-3);
  // 1000 steps; uE is rounded to 1e-15 and multiplied by a momentum of up to 10.
  EXPECT_NEAR(e.imbalance, 0.0, 1e-11);
}

TEST(EnergyLedger, ABeltBringsInWhatFrictionAndTheBlockTake) {
  Model m;
  addBall(m, "ball", 0.0);
  addFloor(m, "belt", "ball", 0.0, 0.5, 1.0);
  m.simulation.until = 1.0, m.simulation.step = 1e-3;
  const EnergyReport e = energyOf(m);
  // The block is pulled up to 1 m/s with a = μg over 0.2 s: belt work μmg · 0.2 m = 1 J, half of
  // it becomes heat.
  EXPECT_NEAR(e.boundaries, 1.0, 1e-9);
  EXPECT_NEAR(e.friction, -0.5, 1e-9);
  EXPECT_NEAR(e.kineticEnd, 0.5, 1e-9);
}

TEST(EnergyLedger, TheEntriesSumUpToTheChange) {
  Model m = ballOnFloor(1.0, 2.0, 0.5, 0.3, 2.0, 1e-3);
  const EnergyReport e = energyOf(m);
  EXPECT_NEAR(e.end() - e.start(), e.works() + e.discretisation, 1e-14);
  // Terms of 12 J in 2000 steps, each rounded once: below 2000 · 12 · 1e-16.
  EXPECT_NEAR(e.imbalance, 0.0, 3e-12);
}

}  // namespace
}  // namespace dynamy
