/// Planar pendulum released from the horizontal, l = 1 m, g = 9.81 m/s²: Jacobi's elliptic
/// functions.
///
///   period 4 K(1/2)/√(g/l), places from sn(·, 1/2)                      (S01, 30-digit arithmetic)
#include <gtest/gtest.h>

#include <numbers>
#include <reference/order.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

struct Instant {
  double t, x, z;
};
constexpr Instant kTruth[] = {{1.0, 0.986291751131875, -0.165010853125541},
                              {2.0, -0.793566195343322, -0.608483930443792},
                              {5.0, -0.942305435043757, -0.334754338414001},
                              {10.0, -0.275087462576117, -0.961419205099125}};

double angle(const Instant& at) { return std::atan2(at.x, -at.z); }
/// Difference of angles, in [−π, π].
double turn(double a, double b) { return std::remainder(a - b, 2.0 * std::numbers::pi); }

double minimalError(Scheme scheme, double dt, const Instant& at) {
  Scene scene("pendulum", {.scheme = scheme});
  scene.run(at.t, dt);
  return turn(scene.q("minimal")[0], angle(at));
}
/// Error of the direction of the bob on its rod.
double jointError(Scheme scheme, double dt, const Instant& at) {
  Scene scene("pendulum", {.scheme = scheme});
  scene.run(at.t, dt);
  const Eigen::VectorXd q = scene.q("bob");
  EXPECT_TRUE(scene.solved());
  return turn(std::atan2(q[0], -q[1]), angle(at));
}

/// Angle after the quarter of a period from rest at `start`: 0 in truth, T/4 = K(sin(start/2))/√g.
double quarterError(Scheme scheme, double dt, double start) {
  Scene scene("pendulum", {.scheme = scheme});
  scene.state().q[0] = start;
  scene.run(std::comp_ellint_1(std::sin(0.5 * std::abs(start))) / std::sqrt(9.81), dt);
  return scene.q("minimal")[0];
}
Fit minimalFit(Scheme scheme, double start) {
  const std::vector<double> dt = halvings(8e-3, 5);
  std::vector<double> error;
  for (const double h : dt) error.push_back(std::abs(quarterError(scheme, h, start)));
  return fitOrder(dt, error);
}

TEST(Pendulum, InMinimalCoordinatesMoreauIsTheLeapfrogOfOrderTwo) {
  // h = h(q), M constant: even powers of Δt only. The step is rounded to a whole number of steps:
  // slopes within 2 %.
  for (const double start : {0.5, 1.0, 2.0, 2.8}) {
    const Fit fit = minimalFit(Scheme::moreauMidpoint, start);
    EXPECT_NEAR(fit.order, 2.0, 0.04) << "from " << start << ": " << fit;
  }
  // From the horizontal the term of Δt² vanishes: T + V = 0 there, and the leapfrog's neighbouring
  // energy turns at the same angle in the same time. So S01 alone would not tell an order.
  const Fit fit = minimalFit(Scheme::moreauMidpoint, -0.5 * std::numbers::pi);
  EXPECT_NEAR(fit.order, 4.0, 0.2) << fit;
}

TEST(Pendulum, InMinimalCoordinatesHalfExplicitEulerIsOfOrderOne) {
  for (const double start : {0.5, 1.0, 2.0, -0.5 * std::numbers::pi}) {
    const Fit fit = minimalFit(Scheme::halfExplicitEuler, start);
    EXPECT_NEAR(fit.order, 1.0, 0.04) << "from " << start << ": " << fit;
  }
}

TEST(Pendulum, LimitOfMoreauIsTheEllipticFunction) {
  for (const Instant& at : kTruth) {
    std::vector<double> value;
    for (const double h : halvings(4e-3, 5))
      value.push_back(minimalError(Scheme::moreauMidpoint, h, at));
    // Five levels of Richardson leave Δt¹⁰ terms; what stays is rounding of 1e4 steps, amplified
    // by the elimination: some 1e4 · 2e-16 · 10.
    EXPECT_NEAR(richardson(value, 2, 2), 0.0, 1e-10) << "t = " << at.t;
  }
}

TEST(Pendulum, EnergyOfTheLeapfrogDoesNotDrift) {
  // The leapfrog keeps a neighbouring energy: T + V oscillates with O(Δt²) and returns.
  // Amplitude: (Δt²/24)(…)~ 40 J/s² Δt² for l = 1, m = 1 at Δt = 2e-3.
  Scene scene("pendulum", {.scheme = Scheme::moreauMidpoint});
  double worst = 0.0;
  const auto energy = [&] {
    const double phi = scene.q("minimal")[0], rate = scene.u("minimal")[0];
    return 0.5 * rate * rate - 9.81 * std::cos(phi);
  };
  double early = 0.0;
  scene.run(5.0, 2e-3, [&] { early = std::max(early, std::abs(energy())); });
  scene.run(50.0, 2e-3, [&] { worst = std::max(worst, std::abs(energy())); });
  EXPECT_LT(worst, 1.2 * early);
  EXPECT_LT(worst, 40.0 * 2e-3 * 2e-3);
}

class PendulumOnARod : public testing::TestWithParam<Scheme> {};

TEST_P(PendulumOnARod, IsOfOrderOne) {
  std::vector<double> dt = halvings(1e-3, 5), error;
  for (const double h : dt) error.push_back(std::abs(jointError(GetParam(), h, kTruth[0])));
  const Fit fit = fitOrder(dt, error);
  EXPECT_NEAR(fit.order, 1.0, 0.1) << fit;
}

TEST_P(PendulumOnARod, TendsToTheEllipticFunction) {
  std::vector<double> value;
  for (const double h : halvings(1e-3, 6)) value.push_back(jointError(GetParam(), h, kTruth[1]));
  EXPECT_NEAR(richardson(value, 1, 1), 0.0, 1e-7);
}

TEST_P(PendulumOnARod, LeavesItsCircleWithOrderOne) {
  // The constraint holds for velocities: |r| − l grows along the curved guide, linear in Δt.
  std::vector<double> dt = halvings(1e-3, 5), error;
  for (const double h : dt) {
    Scene scene("pendulum", {.scheme = GetParam()});
    scene.run(2.0, h);
    error.push_back(std::abs(scene.q("bob").norm() - 1.0));
  }
  const Fit fit = fitOrder(dt, error);
  EXPECT_NEAR(fit.order, 1.0, 0.1) << fit;
}

INSTANTIATE_TEST_SUITE_P(Schemes, PendulumOnARod, testing::ValuesIn(kBothSchemes));

}  // namespace
}  // namespace dynamy::reference
