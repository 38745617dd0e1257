/// The wall of a hundred bricks at rest: its forces are not unique, what statics says of them is.
/// And hit by a ball.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/simulation/run/simulation.hpp>
#include <reference/scene.hpp>
#include <support/load_model.hpp>

namespace dynamy::reference {
namespace {

constexpr double kWallStep = 5e-3;
/// The solver finds rest to 1e-10 of g Δt for each brick; the forces of what lies above add up, of
/// 1528 kg: 1e-10 · 15 kN, and a factor of ten for sums of rows.
constexpr double kForce = 1.5e-5;

/// The wall after some steps, with the forces of the last one.
class Wall {
 public:
  explicit Wall(const std::string& push)
      : loaded_("models/brick_wall_standing.xml", {{"push", push}}), stepper_(loaded_.model()) {
    for (int i = 0; i < 10; ++i) solved_ = stepper_.step(kWallStep).solved.ok() && solved_;
  }
  bool solved() const { return solved_; }
  const ContactSet& contacts() const { return stepper_.system().slot(0).contacts; }
  double lambda(int row) { return stepper_.Lambda()[row] / kWallStep; }
  const Topology& topology() { return loaded_.model().topology(); }
  /// m g of block b [N].
  double weight(int b) { return 9.81 / stepper_.system().slot(0).mass.inverseDiagonal(b)[0]; }

 private:
  LoadedModel loaded_;
  HandStepper stepper_;
  bool solved_ = true;
};

TEST(BrickWall, EveryBedJointCarriesWhatIsAboveIt) {
  Wall wall("0");
  ASSERT_TRUE(wall.solved());
  const ContactSet& c = wall.contacts();
  // Rows of bricks, from below: 12 bricks; 11 bricks and two halves.
  constexpr double kOfRow[] = {40.0 * 12 * 0.398, 40.0 * (11 * 0.398 + 2 * 0.198)};
  for (int joint = 0; joint < 8; ++joint) {
    double above = 0.0, carried = 0.0, moment = 0.0;
    for (int row = joint; row < 8; ++row) above += 9.81 * kOfRow[row % 2];
    for (int i = 0; i < c.size(); ++i) {
      const Vec3& P = c.places.point[static_cast<std::size_t>(i)];
      if (std::abs(P.z() - 0.2 * joint) > 1e-6) continue;
      const double N = wall.lambda(c.row0[static_cast<std::size_t>(i)]);
      EXPECT_GE(N, 0.0);
      carried += N, moment += N * P.x();
    }
    EXPECT_NEAR(carried, above, kForce) << "joint " << joint;
    // What is above lies about the middle of the wall, which is 2.4 m from its ends.
    EXPECT_NEAR(moment, 0.0, 2.4 * kForce) << "joint " << joint;
  }
}

TEST(BrickWall, EveryBrickIsInBalanceAlsoWhileItIsPushed) {
  Wall wall("0.9");
  ASSERT_TRUE(wall.solved());
  const ContactSet& c = wall.contacts();
  Eigen::VectorXd balance = Eigen::VectorXd::Zero(600);
  for (int i = 0; i < c.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    for (int s = c.segment0[at]; s < c.segment0[at + 1]; ++s) {
      const Segment& of = c.segment[static_cast<std::size_t>(s)];
      for (int row = 0; row < c.dim(i); ++row)
        for (int k = 0; k < of.nu; ++k)
          balance[of.u0 + k] +=
              c.W[static_cast<std::size_t>(of.w + row * of.nu + k)] * wall.lambda(c.row0[at] + row);
    }
  }
  double pushed = 0.0;
  for (int b = 0; b < 100; ++b) {
    const Eigen::VectorXd f = balance.segment(6 * b, 6);
    EXPECT_NEAR(f[2], wall.weight(b), kForce) << "brick " << b;
    EXPECT_NEAR(f[0], 0.0, kForce) << "brick " << b;
    EXPECT_LT(f.tail(3).norm(), kForce) << "moments of brick " << b;
    pushed += std::abs(f[1]);
  }
  // Friction holds against the push on one brick, and nothing else goes that way; one sum of all.
  EXPECT_NEAR(pushed, 0.9 * 0.5 * 9.81 * 40.0 * 0.398, 100 * kForce);
}

TEST(BrickWall, ABrickPushedBeyondItsFrictionSlidesAlone) {
  // ½ (1.01 − 1) μ g t²: exact for constant forces, but for the residual in each of 50 steps.
  LoadedModel wall("models/brick_wall_standing.xml", {{"push", "1.01"}});
  HandStepper stepper(wall.model());
  for (int i = 0; i < 50; ++i) ASSERT_TRUE(stepper.step(kWallStep).solved.ok());
  const NamedSignal* y = wall.model().signal("over[3][5].y");
  ASSERT_NE(y, nullptr);
  const SystemHandle& s = wall.model().topology().system(y->system);
  EXPECT_NEAR(stepper.x.q[s.q0 + 1], 0.5 * 0.01 * 0.5 * 9.81 * 0.0625, 1e-10);
}

TEST(BrickWall, BricksThatTurnAsideMeetWithTheirEdges) {
  // Hit in the middle, both turn about the edges in front, which are parallel. A contact that is there only
  // while they overlap left 1.75 mm.
  Scene bricks("bricks", {.text = R"(<dynamy version="1">
    <systems>
      <RigidBody name="a" position="-0.2 0 0"><Box size="0.4 0.2 0.2" mass="16" material="brick"/></RigidBody>
      <RigidBody name="b" position="0.2 0 0"><Box size="0.4 0.2 0.2" mass="16" material="brick"/></RigidBody>
      <RigidBody name="ball" position="0 -0.401 0" velocity="0 10 0">
        <Sphere radius="0.3" mass="200" material="brick"/>
      </RigidBody>
    </systems>
    <elements><Contact between="brick brick"><UnilateralCoulomb mu="0.5"/></Contact></elements>
    <simulation until="0.01" step="2ms"/>
  </dynamy>)"});
  Simulation simulation(bricks.model());
  const RunReport& report = simulation.run();
  ASSERT_EQ(report.ended, RunReport::Ended::finished) << report.reason;
  EXPECT_EQ(report.solver.unconverged, 0);
  // 31 rad/s: half a step turns them by 0.03, (0.03)²/2 of 0.22 m.
  EXPECT_LT(report.gaps.penetration.value, 1e-4);
}

TEST(LongBrickWall, OfAHundredBricksIsHit) {
  // 50 kg with 10 m/s: 2500 J. It arrives after 60 ms; a fifth of a second later bricks fly.
  LoadedModel wall("models/brick_wall.xml", {{"n", "10"}});
  Model& model = wall.model();
  model.simulation.until = 0.25;
  Simulation simulation(model);
  const RunReport& report = simulation.run();
  ASSERT_EQ(report.ended, RunReport::Ended::finished) << report.reason;
  EXPECT_EQ(report.solver.unconverged, 0);
  EXPECT_GT(report.contacts.impacts, 100);
  // The pass marks of the model: programs that correct overlaps afterwards show millimetres where
  // this one solves for its forces. At the end of a step a ball that has come into the wall in its
  // second half is half a step deep: 10 m/s in 1 ms.
  EXPECT_LT(report.gaps.solvedOverlap.value, 1e-9);
  EXPECT_LT(report.gaps.penetration.value, 10.0 * 1e-3);
  EXPECT_LT(report.trust.energyRise, 1e-6 * report.trust.kineticMax);
  // Nothing but impacts and friction takes energy; the step equations hold to rounding.
  const EnergyReport& e = report.energy;
  EXPECT_LT(e.normal, 0.0);
  EXPECT_LT(e.friction, 0.0);
  EXPECT_NEAR(e.imbalance, 0.0, 1e-9 * report.trust.kineticMax);
  // What is left of the ledger is gyroscopic terms of bricks that turn by ω Δt = 0.02 in a step, to
  // its square.
  EXPECT_NEAR(e.end() - e.start(), e.works(), 1e-3 * report.trust.kineticMax);
  const NamedSignal* v = model.signal("ball.vy");
  ASSERT_NE(v, nullptr);
  const double speed = simulation.state().u[model.topology().system(v->system).u0 + 1];
  EXPECT_GT(speed, 0.0);
  EXPECT_LT(speed, 10.0);
}

}  // namespace
}  // namespace dynamy::reference
