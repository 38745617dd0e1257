// Dice on a table: what they lose, from their motion and from their contacts.
#include <gtest/gtest.h>

#include <support/gravity.hpp>
#include <support/load_model.hpp>

namespace dynamy::reference {
namespace {

constexpr double kEdge = 0.016, kMass = 1200.0 * kEdge * kEdge * kEdge;

/// Of three cubes, whose inertia is m a²/6 about any axis.
double energy(const State& x) {
  double out = 0.0;
  for (int i = 0; i < 3; ++i)
    out += kMass * (0.5 * x.u.segment<3>(6 * i).squaredNorm() + kG * x.q[7 * i + 2]) +
           kMass * kEdge * kEdge / 12.0 * x.u.segment<3>(6 * i + 3).squaredNorm();
  return out;
}

/// Energy by the motion, and the works Λ·(γ⁻ + γ⁺)/2 of the contacts by each step.
class Losses final : public Observer {
 public:
  Losses() : Observer(Parameters()) {}
  void step(const StepView& v) override {
    const double lost = energy(v.before) - energy(v.after);
    least_ = std::min(least_, lost);
    lost_ += lost;
  }
  double least() const { return least_; }
  double lost() const { return lost_; }

 private:
  double least_ = 0.0, lost_ = 0.0;
};

TEST(Dice, LoseWhatImpactsAndFrictionTake) {
  LoadedModel loaded("models/dice.xml");
  const State first = loaded.model().initialState();
  Simulation simulation(loaded.model());
  Losses losses;
  simulation.observe(losses);
  const RunReport& r = simulation.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished);
  // At the start by hand: speeds, turns and heights of the model.
  const double v2 = 0.26 + 0.41 + 0.68,
               turn2 = (400 + 100 + 1225) + (225 + 625 + 100) + (25 + 900 + 400);
  const double E0 =
      kMass * (0.5 * v2 + kG * (0.15 + 0.18 + 0.2)) + kMass * kEdge * kEdge / 12.0 * turn2;
  // Rounding of sums of 20000 steps of 0.03 J.
  constexpr double kRounding = 1e-14;
  EXPECT_NEAR(energy(first), E0, kRounding);
  EXPECT_NEAR(r.energy.start(), E0, kRounding);
  // At rest on the table, up to overlaps of 4e-8 m: as the model's tolerance of heights, 1e-7 m.
  EXPECT_NEAR(energy(simulation.state()), 3.0 * kMass * kG * 0.5 * kEdge, 3.0 * kMass * kG * 1e-7);
  // No step brings more energy than its solver leaves, 1e-8 of it, and the ledger of impacts and
  // friction has what the motion lost.
  EXPECT_GT(losses.least(), -1e-8 * E0);
  EXPECT_LT(r.energy.normal, 0.0);
  EXPECT_LT(r.energy.friction, 0.0);
  EXPECT_NEAR(losses.lost(), -(r.energy.normal + r.energy.friction), kRounding);
}

}  // namespace
}  // namespace dynamy::reference
