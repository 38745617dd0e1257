/// Sliding in space: a puck of any heading (F04), a ball from sliding to rolling (N06), a box. None
/// of them may leave the plane: the convexified cone, the usual short cut, lifts a sliding body by
/// h μ v and throws a slipping ball 67 mm high.
#include <gtest/gtest.h>

#include <dynamy/core/rotation.hpp>
#include <numbers>
#include <reference/order.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

constexpr double kStop = 0.679578661230037;  // v0/(μ g) = v0²/(2 μ g) for v0 = 2, μ = 0.3 [s], [m]

class Sliding : public testing::TestWithParam<Scheme> {};

TEST_P(Sliding, PuckKeepsAnyHeadingAndStopsInTime) {
  constexpr double dt = 1e-3;
  for (const double degrees : {0.0, 17.0, 30.0, 45.0, 60.0, 91.0, 200.0, 333.0}) {
    const double heading = degrees * std::numbers::pi / 180.0;
    Scene scene("sliding_puck",
                {.set = {{"heading", std::to_string(heading)}}, .scheme = GetParam()});
    double stopped = 0.0, highest = 0.0;
    scene.run(1.0, dt, [&] {
      if (scene.u("puck").norm() > 1e-14) stopped = scene.state().t;
      highest = std::max(highest, std::abs(scene.q("puck")[2]));
    });
    const Eigen::VectorXd q = scene.q("puck");
    // Friction opposes the velocity exactly, so the heading keeps its rounding. Moreau: trapezoidal
    // sums are exact for constant friction, the last step misses μ g Δt²/8 at most; half-explicit
    // Euler moves with u^A: v0 Δt/2 too far.
    const double byScheme =
        GetParam() == Scheme::moreauMidpoint ? 0.3 * 9.81 * dt * dt / 8.0 : 2.0 * dt / 2.0;
    EXPECT_NEAR(std::remainder(std::atan2(q[1], q[0]) - heading, 2.0 * std::numbers::pi), 0.0,
                1e-6);
    EXPECT_NEAR(q.norm(), kStop, byScheme * 1.01) << degrees;
    EXPECT_NEAR(stopped, kStop, dt) << degrees;
    EXPECT_LT(highest, 1e-14) << degrees;
    EXPECT_TRUE(scene.solved());
  }
}

TEST_P(Sliding, BallRollsAtFiveSeventhsAndDoesNotHop) {
  constexpr double dt = 1e-3;
  Scene scene("slide_to_roll", {.scheme = GetParam()});
  double highest = 0.0, slipping = 0.0, slowest = 9.0;
  scene.run(0.5, dt, [&] {
    const Eigen::VectorXd q = scene.q("ball"), u = scene.u("ball");
    highest = std::max(highest, std::abs(q[2] - 0.1));
    slowest = std::min(slowest, u[0]);
    const Vec3 Omega_I = rotationMatrix(q.data() + 3) * u.tail<3>();
    if (std::abs(u[0] - 0.1 * Omega_I.y()) > 1e-9) slipping = scene.state().t;
  });
  // The slip falls by 7/2 μ g a second, constant: velocities are exact to rounding, and the step in
  // which sliding ends finds the rolling state at once. 500 steps of rounding of 3 m/s.
  EXPECT_NEAR(scene.u("ball")[0], 15.0 / 7.0, 1e-12);
  EXPECT_NEAR(slowest, 15.0 / 7.0, 1e-12);
  EXPECT_NEAR(slipping, 0.291247997670016, dt);
  EXPECT_LT(highest, 1e-13);
  EXPECT_TRUE(scene.solved());
}

TEST_P(Sliding, BallGoesTheWayOfTheClosedForm) {
  // x(0.5) = x_roll + 15/7 (0.5 − t_roll). Order 1 for half-explicit Euler (moves with u^A), Moreau
  // misses only in the step that ends sliding: envelope of order 2.
  const double truth = 0.748923422580041 + 15.0 / 7.0 * (0.5 - 0.291247997670016);
  const std::vector<double> dt = halvings(8e-3, 5);
  std::vector<double> worst;
  for (const double h : dt)
    worst.push_back(envelope(h, 16, [&](double s) {
      Scene scene("slide_to_roll", {.scheme = GetParam()});
      scene.run(0.5, s);
      return scene.q("ball")[0] - truth;
    }));
  const double order = GetParam() == Scheme::moreauMidpoint ? 2.0 : 1.0;
  EXPECT_NEAR(fitOrder(dt, worst).order, order, 0.15) << fitOrder(dt, worst);
}

const char* const kBox = R"(<dynamy version="1">
  <systems>
    <RigidBody name="box" position="0 0 0.05" velocity="2 1 0" angularVelocity="0 0 3">
      <Box size="0.4 0.2 0.1" mass="1" material="wood"/>
    </RigidBody>
    <Ground name="world"><HalfSpace material="floor"/></Ground>
  </systems>
  <forces><Gravity acceleration="0 0 -9.81"/></forces>
  <elements><Contact between="wood floor"><UnilateralCoulomb mu="0.3"/></Contact></elements>
  <simulation until="1" step="1e-3"><MoreauMidpoint/></simulation>
</dynamy>)";

TEST_P(Sliding, SpinningBoxNeitherFloatsNorTrembles) {
  // The convexified law would lift it by h μ v = 0.7 mm at once.
  Scene scene("box", {.scheme = GetParam(), .text = kBox});
  double worst = 0.0;
  scene.run(2.0, 1e-3, [&] { worst = std::max(worst, std::abs(scene.q("box")[2] - 0.05)); });
  EXPECT_LT(worst, 1e-11);  // g_tol plus rounding of 2000 steps
  EXPECT_LT(scene.u("box").norm(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Schemes, Sliding, testing::ValuesIn(kBothSchemes));

}  // namespace
}  // namespace dynamy::reference
