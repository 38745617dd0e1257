/// Bouncing ball with infinitely many impacts in finite time (N01, closed form), and invariants of
/// Moreau's rule with impacts that hold to rounding.
#include <gtest/gtest.h>

#include <limits>
#include <reference/order.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

/// Height over the floor less the truth, after `t`.
double error(Scheme scheme, double t, double truth, double dt) {
  Scene scene("bouncing_ball", {.scheme = scheme});
  scene.run(t, dt);
  return scene.q("ball")[1] - 0.1 - truth;
}

class BouncingBall : public testing::TestWithParam<Scheme> {};

TEST_P(BouncingBall, IsOfOrderOneAcrossImpacts) {
  // Where in its step an impact falls decides the error: the envelope has an order, with the
  // scatter of 24 samples, some 10 % each.
  const std::vector<double> dt = halvings(4e-3, 6);
  std::vector<double> worst;
  for (const double h : dt)
    worst.push_back(envelope(
        h, 24, [&](double step) { return error(GetParam(), 1.0, 0.0612555656575454, step); }));
  const Fit fit = fitOrder(dt, worst);
  EXPECT_NEAR(fit.order, 1.0, 0.15) << fit;
}

TEST_P(BouncingBall, TendsToTheClosedForm) {
  // First order with a constant below 4 m/s (checked by the fit above): 4e-5 m at 1e-5 s.
  constexpr double dt = 1e-5;
  EXPECT_NEAR(error(GetParam(), 0.6, 0.220702226263018, dt), 0.0, 4.0 * dt);
  EXPECT_NEAR(error(GetParam(), 1.0, 0.0612555656575454, dt), 0.0, 4.0 * dt);
  EXPECT_NEAR(error(GetParam(), 1.3, 0.000241637333294965, dt), 0.0, 4.0 * dt);
}

TEST_P(BouncingBall, PassesTheAccumulationPointAndRests) {
  // t_rest = 1.35457 s; what is left of the velocity when a flight gets shorter than a step is
  // below 2 g Δt, and dies out within as many steps as rounding takes: log2(1/ε) < 60 steps.
  constexpr double dt = 1e-3;
  Scene scene("bouncing_ball", {.scheme = GetParam()});
  scene.run(1.35457092295719 + 200.0 * dt, dt);
  const double rest = scene.q("ball")[1];
  EXPECT_NEAR(rest, 0.1, 2.0 * 9.81 * dt * dt);
  double fastest = 0.0;
  scene.run(3.0, dt, [&] { fastest = std::max(fastest, std::abs(scene.u("ball")[1])); });
  EXPECT_LT(fastest, 1e-14);
  EXPECT_NEAR(scene.q("ball")[1], rest, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Schemes, BouncingBall, testing::ValuesIn(kBothSchemes));

/// A ball that keeps its energy (e = 1), dropped from 1 m.
const char* const kElastic = R"(<dynamy version="1">
  <systems>
    <PointMass name="ball" plane="xz" position="0 0 1" mass="1"><Point material="ball"/></PointMass>
    <Ground name="world"><HalfSpace material="floor"/></Ground>
  </systems>
  <forces><Gravity acceleration="0 0 -9.81"/></forces>
  <elements><Contact between="ball floor"><Unilateral epsilonN="1"/></Contact></elements>
  <simulation until="1" step="0.1"><MoreauMidpoint/></simulation>
</dynamy>)";

TEST(ElasticBall, KeepsItsEnergyToRoundingEvenAtTenStepsAFlight) {
  // Free steps: ½(u^E² − u^A²) = −g Δt ū = −g (q^E − q^A) exactly. Impact step: u^E = −u^A and
  // q^E = q^A, whatever Δt. So only rounding is left: 4 ε of the energy at each impact.
  Scene scene("elastic", {.text = kElastic});
  const double flight = 2.0 * std::sqrt(2.0 / 9.81), E0 = 9.81;
  constexpr int kImpacts = 100;
  double worst = 0.0, before = 0.0;
  int impacts = 0;
  while (impacts < kImpacts) {
    before = scene.u("ball")[1];
    scene.step(flight / 10.0);
    if (before < 0.0 && scene.u("ball")[1] > 0.0) ++impacts;
    const double u = scene.u("ball")[1], z = scene.q("ball")[1];
    worst = std::max(worst, std::abs(0.5 * u * u + 9.81 * z - E0));
  }
  EXPECT_LE(worst, 4.0 * kEps * E0 * kImpacts);
}

/// A point thrown over a rough table: it bounces and rubs.
const char* const kThrown = R"(<dynamy version="1">
  <parameter name="e" value="0.5"/><parameter name="mu" value="0.3"/>
  <systems>
    <PointMass name="point" plane="xz" position="0 0 1" velocity="20 0 0" mass="0.7">
      <Point material="rubber"/>
    </PointMass>
    <Ground name="world"><HalfSpace material="table"/></Ground>
  </systems>
  <forces><Gravity acceleration="0 0 -9.81"/></forces>
  <elements>
    <Contact between="rubber table"><UnilateralCoulomb epsilonN="{e}" mu="{mu}"/></Contact>
  </elements>
  <simulation until="1" step="0.01"><MoreauMidpoint/></simulation>
</dynamy>)";

class ThrownPoint : public testing::TestWithParam<std::pair<double, double>> {};

TEST_P(ThrownPoint, KeepsBothDiscreteInvariantsToRounding) {
  // As long as it slides, Λ_T = −μ Λ_N in every step, and positions are trapezoidal sums:
  //   u_x + μ u_z + μ g t,   x + μ z + ½ μ g t² − u_x(0) t     are constant for any e and Δt.
  const auto [e, dt] = GetParam();
  constexpr double mu = 0.3, g = 9.81;
  Scene scene("thrown", {.set = {{"e", std::to_string(e)}}, .text = kThrown});
  double velocity = 0.0, place = 0.0;
  long steps = 0;
  while (scene.state().t < 4.0) {  // stops later: 20/(μ g) − … = 6.5 s
    scene.step(dt);
    ++steps;
    const double t = static_cast<double>(steps) * dt;
    const Eigen::VectorXd q = scene.q("point"), u = scene.u("point");
    velocity = std::max(velocity, std::abs(u[0] + mu * u[1] + mu * g * t - 20.0));
    place =
        std::max(place, std::abs(q[0] + mu * q[1] + 0.5 * mu * g * t * t - 20.0 * t - mu * 1.0));
    ASSERT_GT(u[0], 0.0);
  }
  // Each step rounds numbers of size 20 (velocity) and 60 (place): ε/2 of them at most; the place
  // sums the errors of the velocity over time.
  const auto n = static_cast<double>(steps);
  EXPECT_LT(velocity, n * kEps * 20.0);
  EXPECT_LT(place, n * kEps * (60.0 + 20.0 * 4.0));
}

INSTANTIATE_TEST_SUITE_P(RestitutionAndStep, ThrownPoint,
                         testing::Values(std::pair{0.0, 0.01}, std::pair{0.5, 0.01},
                                         std::pair{0.5, 0.037}, std::pair{0.9, 0.001}));

}  // namespace
}  // namespace dynamy::reference
