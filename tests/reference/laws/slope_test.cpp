/// Block on a slope: rest at 0.99 of the friction limit, and the shot up the slope (N04).
#include <gtest/gtest.h>

#include <reference/order.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

class Slope : public testing::TestWithParam<Scheme> {};

TEST_P(Slope, HoldsABlockAtNinetyNinePercentOfItsFriction) {
  // 1e4 steps of rest: at g_tol = 1e-12 of the scene's length the contacts stay closed, and each
  // step adds rounding of u (1e-17 m/s) times Δt only.
  Scene scene("block_on_slope", {.scheme = GetParam()});
  const Eigen::VectorXd start = scene.q("block");
  double worst = 0.0;
  scene.run(100.0, 0.01,
            [&] { worst = std::max(worst, (scene.q("block") - start).lpNorm<Eigen::Infinity>()); });
  EXPECT_LT(worst, 1e-12);
  EXPECT_TRUE(scene.solved());
}

TEST_P(Slope, LetsABlockGoBeyondItsFriction) {
  // tan α = 1.01 μ: acceleration g (sin α − μ cos α), constant, so velocities are exact but for the
  // tolerance of the solver, 1e-10 of g Δt in each of 100 steps.
  Scene scene("block_on_slope", {.set = {{"share", "1.01"}}, .scheme = GetParam()});
  const double alpha = std::atan(1.01 * 0.3);
  scene.run(1.0, 0.01);
  EXPECT_NEAR(scene.u("block").head<2>().norm(), 9.81 * (std::sin(alpha) - 0.3 * std::cos(alpha)),
              1e-9);
}

/// Way and velocity along the slope of 20° at 2 s, less the truth.
Eigen::Vector2d shot(Scheme scheme, double dt) {
  Scene scene("block_on_slope_slide", {.scheme = scheme});
  const double alpha = 20.0 * std::acos(-1.0) / 180.0;
  const Eigen::Vector2d along(std::cos(alpha), std::sin(alpha));
  const Eigen::Vector2d start = scene.q("block").head<2>();
  scene.run(2.0, dt);
  EXPECT_TRUE(scene.solved());
  return {along.dot(scene.q("block").head<2>() - start) - -0.498747597767098,
          along.dot(scene.u("block").head<2>()) - -0.986714379697699};
}

TEST_P(Slope, ReturnsABlockShotUpWithOrderOne) {
  // The step in which the block turns takes friction of one sign only: an error of the velocity of
  // at most 2 μ g cos α Δt, depending on where in the step it turns. Envelope of 16 samples.
  const std::vector<double> dt = halvings(8e-3, 5);
  std::vector<double> way, velocity;
  for (const double h : dt) {
    way.push_back(envelope(h, 16, [&](double s) { return shot(GetParam(), s)[0]; }));
    velocity.push_back(envelope(h, 16, [&](double s) { return shot(GetParam(), s)[1]; }));
  }
  EXPECT_NEAR(fitOrder(dt, velocity).order, 1.0, 0.15) << fitOrder(dt, velocity);
  EXPECT_NEAR(fitOrder(dt, way).order, 1.0, 0.15) << fitOrder(dt, way);
  EXPECT_LT(velocity.back(), 2.0 * 0.3 * 9.81 * 1.3 * dt.back());
  EXPECT_LT(way.back(), 2.0 * 2.0 * 0.3 * 9.81 * 1.3 * dt.back());
}

INSTANTIATE_TEST_SUITE_P(Schemes, Slope, testing::ValuesIn(kBothSchemes));

}  // namespace
}  // namespace dynamy::reference
