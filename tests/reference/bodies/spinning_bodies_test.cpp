/// Tippe-top on a patch (Runge–Kutta with 1e-5 s) and on a point (Jellett's invariant, end of the
/// sliding), sliding and spinning disc (N15).
#include <gtest/gtest.h>

#include <dynamy/core/rotation.hpp>
#include <dynamy/schemes/energy_momentum.hpp>
#include <reference/order.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

constexpr double kR1 = 15e-3, kA1 = 3e-3, kA2 = 16e-3, kR2 = 5e-3;

/// Inclination of the axis to the vertical while the large ball touches.
double theta(Scene& scene) { return std::acos((kR1 - scene.q("top")[2]) / kA1); }

TEST(LongTippeTop, TendsToTheTruthWithOrderOneUnderMoreausRule) {
  const double truth[] = {0.50627368, 1.05807826, 1.57128303};
  const double at[] = {0.5, 0.75, 1.0};
  const std::vector<double> dt = halvings(1e-4, 5);
  std::vector<double> value[3];
  for (const double h : dt) {
    Scene scene("tippe_top", {.scheme = Scheme::moreauMidpoint});
    for (int i = 0; i < 3; ++i) {
      scene.run(at[i], h);
      value[i].push_back(theta(scene));
    }
  }
  for (int i = 0; i < 3; ++i) {
    std::vector<double> error;
    for (const double v : value[i]) error.push_back(std::abs(v - truth[i]));
    EXPECT_NEAR(fitOrder(dt, error).order, 1.0, 0.1) << fitOrder(dt, error);
    // Each elimination leaves an error below the step it made.
    const std::vector<double> coarser(value[i].begin(), value[i].end() - 1);
    const double limit = richardson(value[i], 1, 1), before = richardson(coarser, 1, 1);
    EXPECT_LT(std::abs(limit - before), 1e-5) << at[i] << " s";
    EXPECT_NEAR(limit, truth[i], std::abs(limit - before)) << at[i] << " s";
  }
}

/// When the stem touches, on a patch with R [m]: S passes the height at which both balls touch.
double stemTouches(double R) {
  Scene scene("tippe_top", {.set = {{"patch", std::to_string(1500.0 * R) + "mm"}}});
  const double height = kR1 - kA1 * (kR1 - kR2) / (kA1 - kA2);
  scene.run(1.36, 1e-3);
  while (scene.q("top")[2] < height && scene.state().t < 2.0) scene.step(5e-5);
  return scene.state().t - 2.5e-5;
}

TEST(LongTippeTop, TurnsOverLaterOrSoonerWithItsPatch) {
  // Half a unit of the last digit, half of a step, and rounding of the sum of steps.
  EXPECT_NEAR(stemTouches(0.1e-3), 1.4457, 7.6e-5);
  EXPECT_NEAR(stemTouches(0.2e-3), 1.3649, 7.6e-5);
  EXPECT_NEAR(stemTouches(0.5e-3), 1.4321, 7.6e-5);
}

/// L · (R1 e_z − a1 e_3), which no force at the point of contact changes.
double jellett(Scene& scene) {
  const Eigen::VectorXd q = scene.q("top"), u = scene.u("top");
  const Mat3 A = rotationMatrix(q.data() + 3);
  const Vec3 L = A * Vec3(8e-7 * u[3], 8e-7 * u[4], 7e-7 * u[5]);
  return L.dot(kR1 * Vec3::UnitZ() - kA1 * A.col(2));
}

/// Velocity of the point of contact along the table.
double slip(Scene& scene) {
  const Eigen::VectorXd q = scene.q("top"), u = scene.u("top");
  const Mat3 A = rotationMatrix(q.data() + 3);
  const Vec3 Omega = A * Vec3(u.tail<3>()), rho = kA1 * A.col(2) - kR1 * Vec3::UnitZ();
  return Vec3(Vec3(u.head<3>()) + Omega.cross(rho)).head<2>().norm();
}

SceneSetup onAPoint() {
  SceneSetup setup;
  setup.set = {{"mu", "0.3"}};
  return setup;
}

TEST(TippeTopOnAPoint, SlidesUntilItRolls) {
  // μ = 0.3: 0.269550 m/s at the start; sliding ends at 0.03614 s, θ = 0.03638 rad, half a unit of
  // the last digit. It rolls from then on: slip is what the scheme leaves of it, of first order.
  Scene scene("tippe_top_point", onAPoint());
  scene.model().scheme(std::make_unique<EnergyMomentum>());
  EXPECT_NEAR(slip(scene), 0.269550, 5e-7);
  const double dt = 1e-6;
  scene.run(0.0361, dt);
  EXPECT_GT(slip(scene), 1e-5);
  while (slip(scene) > 1e-5 && scene.state().t < 0.04) scene.step(dt);
  EXPECT_NEAR(scene.state().t, 0.03614, 6e-6);
  EXPECT_NEAR(theta(scene), 0.03638, 6e-6);
  scene.run(0.04, dt);
  EXPECT_LT(slip(scene), 1e-5);
}

TEST(TippeTopOnAPoint, KeepsJellettsQuantityWhileItSlidesAndRolls) {
  // Order 1: 1e-4 of it at 1e-5 s, and half of that at half the step.
  std::vector<double> drift;
  for (const double dt : {2e-5, 1e-5}) {
    Scene scene("tippe_top_point", onAPoint());
    scene.model().scheme(std::make_unique<EnergyMomentum>());
    EXPECT_NEAR(jellett(scene), 1.502557872e-6, 5e-16);
    scene.run(0.1, dt);
    drift.push_back(std::abs(jellett(scene) / 1.5025578723755e-6 - 1.0));
  }
  EXPECT_LT(drift[1], 1e-4);
  EXPECT_NEAR(drift[0] / drift[1], 2.0, 0.2);
}

TEST(SpinningDisc, StopsSlidingAndSpinningAtOnceWithTheFinalRatio) {
  // N15: stop, way, and v/(a Ω) = 0.653001789206 at the end. The ratio tends to it like
  // (aΩ)^0.615, by linearisation of the motion about it.
  struct {
    const char *v, *spin;
    double stop, way;
  } const kCases[] = {{"1", "20", 0.970040839352, 0.5012731400},
                      {"2", "5", 1.060681857284, 1.0354866478}};
  for (const auto& c : kCases) {
    SceneSetup setup;
    setup.set = {{"v", c.v}, {"spin", c.spin}};
    Scene scene("spinning_disc", std::move(setup));
    std::vector<double> ratio;
    for (const double left : {1e-4, 1e-6, 1e-8}) {
      // Steps of a tenth of the time that is left: the motion is a power of it.
      for (double rest; (rest = c.stop - scene.state().t) > left + 1e-14;)
        scene.step(std::min({1e-3, 0.1 * rest, rest - left}));
      const Eigen::VectorXd u = scene.u("disc");
      ratio.push_back(u[0] / (0.1 * u[5]) - 0.653001789206);
    }
    // Two orders of magnitude nearer to the stop 10^(2 · 0.615) = 17 times nearer to the ratio;
    // at 1e-8 s the stop is known to 1e-9 s only, a tenth of the speed but none of the ratio.
    EXPECT_NEAR(ratio[0] / ratio[1], std::pow(100.0, 0.6151), 0.5) << c.v;
    EXPECT_NEAR(ratio[1] / ratio[2], std::pow(100.0, 0.6151), 2.0) << c.v;
    // The limit along that power; 1e-10 s of the stop's time are 1 % of the last ratio, 1e-7.
    const double factor = std::pow(100.0, 0.6151);
    EXPECT_NEAR((factor * ratio[2] - ratio[1]) / (factor - 1.0), 0.0, 1e-6) << c.v;
    scene.step(1e-6);
    EXPECT_NEAR(scene.q("disc")[0], c.way, 1e-9) << c.v;
    EXPECT_LT(scene.u("disc").norm(), 1e-12) << c.v;
  }
}

}  // namespace
}  // namespace dynamy::reference
