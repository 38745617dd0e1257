/// Free body near its intermediate axis (S06, extended precision) and Lagrange's heavy top with a
/// cusped start (S07, elliptic integrals).
#include <gtest/gtest.h>

#include <reference/order.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

using Vector7 = Eigen::Matrix<double, 7, 1>;

/// Ω and quaternion at 10 s less the truth.
Vector7 freeTop(Scheme scheme, double dt) {
  Scene scene("free_top", {.scheme = scheme});
  scene.run(10.0, dt);
  Vector7 out, truth;
  out << scene.u("top").tail<3>(), scene.q("top").tail<4>();
  truth << 0.0127148706293, 4.9999938332, 0.010979798649, 0.38107559832, -0.0011060462506,
      -0.92453880296, -0.0028577689043;
  if (out[3] < 0.0) out.tail<4>() *= -1.0;  // p and −p are one attitude
  return out - truth;
}

class Tops : public testing::TestWithParam<Scheme> {};

TEST_P(Tops, FreeBodyIsOfOrderOneAndTendsToTheTruth) {
  const std::vector<double> dt = halvings(5e-4, 6);
  std::vector<double> size, part[7];
  for (const double h : dt) {
    const Vector7 error = freeTop(GetParam(), h);
    size.push_back(error.norm());
    for (int i = 0; i < 7; ++i) part[i].push_back(error[i]);
  }
  EXPECT_NEAR(fitOrder(dt, size).order, 1.0, 0.15) << fitOrder(dt, size);
  for (auto& values : part) EXPECT_NEAR(richardson(values, 1, 1), 0.0, 1e-6);
}

TEST_P(Tops, QuaternionOfAFreeBodyKeepsLengthOne) {
  // 1e5 exponential maps of relative rounding 2e-16 each: a random walk of 1e-13 without
  // normalisation.
  Scene scene("free_top", {.scheme = GetParam()});
  double worst = 0.0;
  scene.run(100.0, 1e-3,
            [&] { worst = std::max(worst, std::abs(scene.q("top").tail<4>().norm() - 1.0)); });
  EXPECT_LT(worst, 1e-12);
}

/// φ advances by the precession of one nutation while θ returns.
Eigen::Vector2d heavyTop(Scheme scheme, double dt) {
  constexpr double kNutation = 0.3282429945789357;
  Scene scene("heavy_top", {.scheme = scheme});
  scene.run(2.0 * kNutation, dt);
  return {scene.q("top")[1] - 0.5235987755982989, scene.q("top")[0] - 2.0 * 0.16451883943857498};
}

TEST_P(Tops, HeavyTopReturnsAfterEachNutationWithOrderOne) {
  const std::vector<double> dt = halvings(1e-3, 6);
  std::vector<double> size, part[2];
  for (const double h : dt) {
    const Eigen::Vector2d error = heavyTop(GetParam(), h);
    size.push_back(error.norm());
    for (int i = 0; i < 2; ++i) part[i].push_back(error[i]);
  }
  EXPECT_NEAR(fitOrder(dt, size).order, 1.0, 0.15) << fitOrder(dt, size);
  for (auto& values : part) EXPECT_NEAR(richardson(values, 1, 1), 0.0, 1e-7);
}

TEST_P(Tops, HeavyTopNutatesBetweenTheRootsOfItsCubic) {
  std::vector<double> highest;
  for (const double h : halvings(1e-3, 5)) {
    Scene scene("heavy_top", {.scheme = GetParam()});
    double theta = 0.0;
    scene.run(0.33, h, [&] { theta = std::max(theta, scene.q("top")[1]); });
    highest.push_back(theta);
  }
  // A step beside the top of θ misses θ̈ Δt²/8 at most: 3e-8 at Δt = 6e-5, amplified to some 1e-6
  // by the elimination of the coarser ones.
  EXPECT_NEAR(richardson(highest, 1, 1), 0.5497905012828481, 2e-6);
}

INSTANTIATE_TEST_SUITE_P(Schemes, Tops, testing::ValuesIn(kBothSchemes));

}  // namespace
}  // namespace dynamy::reference
