/// Friction along a grain that is fixed in one of the bodies: runners, skates, sawn wood.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <dynamy/core/rotation.hpp>
#include <numbers>
#include <reference/located/located_run.hpp>
#include <reference/scene.hpp>
#include <support/gravity.hpp>

namespace dynamy::reference {
namespace {

std::string vector(const Vec3& v) { return fmt::format("{} {} {}", v.x(), v.y(), v.z()); }

/// A body on a plane with the normal n; `body` and `plane`: attributes of the shapes.
struct OnAPlane {
  std::string body, plane, law;
  Vec3 n = Vec3::UnitZ(), gravity = -kG * Vec3::UnitZ();
  std::string scene(const std::string& start) const {
    return fmt::format(
        "<dynamy version=\"1\"><systems>{}<Point material=\"runner\" {}/></RigidBody>"
        "<Ground><HalfSpace name=\"ice\" material=\"ice\" normal=\"{}\" {}/></Ground></systems>"
        "<forces><Gravity acceleration=\"{}\"/></forces><elements><Contact between=\"runner ice\">"
        "<UnilateralOrthotropic {}/></Contact></elements><simulation until=\"1\" step=\"1e-3\">"
        "<MoreauMidpoint/></simulation></dynamy>",
        start, body, vector(n), plane, vector(gravity), law);
  }
};
std::string rigid(const Vec3& velocity, double spin, const std::string& more = "") {
  return fmt::format(
      "<RigidBody name=\"skate\" mass=\"2\" inertia=\"0.3 0.4 0.5\" velocity=\"{}\" "
      "angularVelocity=\"0 0 {}\" {}>",
      vector(velocity), spin, more);
}

TEST(Grain, OfEitherBodyStopsAPuckWhereTheExactMotionStops) {
  // Along the grain 0.1, across 0.3, thrown at 45° to it with √2 m/s: the stop of orthotropic_puck,
  // turned by any angle. All three ways to say the direction.
  for (const double angle : {0.0, 0.7, 2.5}) {
    const Vec3 e(std::cos(angle), std::sin(angle), 0.0), across(-e.y(), e.x(), 0.0);
    const std::string grain = "grain=\"" + vector(2.0 * e) + '"', mu = "mu1=\"0.1\" mu2=\"0.3\" ";
    const OnAPlane ways[] = {
        {.body = grain, .plane = "", .law = mu},
        {.body = "", .plane = grain, .law = mu},
        {.body = "", .plane = "", .law = fmt::format("{} angle=\"{}\"", mu, angle)}};
    for (const OnAPlane& way : ways) {
      SCOPED_TRACE(way.scene(""));
      LocatedRun run(way.scene(rigid(e + across, 0.0)), 1e-10, 1.3);
      ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
      // The digits of the quadrature, and 100 times the tolerance of the run.
      const Vec3 r = 0.6679106377 * e + 0.2045723940 * across;
      EXPECT_LT((run.state().q.head<3>() - r).norm(), 1e-8);
      const std::vector<double> stops = run.changes("skate-ice", Status::stick);
      ASSERT_EQ(stops.size(), 1U);
      // It stops with μ1 g: what is left of the way, 1e-8 m, takes √(2e-8 m/μ1 g).
      EXPECT_NEAR(stops[0], 1.1887585369, std::sqrt(2e-8 / (0.1 * kG)));
    }
  }
}

TEST(Grain, OfASkateThatTurnsMakesACircle) {
  // No friction along the runner, enough across: the skate goes where it points, with constant
  // speed on a circle of radius v/ω, while v ω < μ2 g.
  constexpr double v = 3.0, omega = 1.5, t = 3.0;
  const OnAPlane skate{.body = "grain=\"1 0 0\"", .plane = "", .law = "mu1=\"0\" mu2=\"0.5\""};
  const Vec3 exact(v / omega * std::sin(omega * t), v / omega * (1.0 - std::cos(omega * t)), 0.0);
  const auto error = [&](double dt) {
    Scene s("skate", {.text = skate.scene(rigid(v * Vec3::UnitX(), omega))});
    s.run(t, dt);
    EXPECT_TRUE(s.solved());
    return (s.q("skate").head<3>() - exact).norm();
  };
  const double coarse = error(4e-3), fine = error(2e-3);
  // A step ends along the runner in its middle: the mean velocity lags by ω Δt/2, and each step
  // takes 1 − cos ω Δt of the speed, ω² Δt t/2 after all, half of it in the way.
  EXPECT_LT(coarse, v * t * (0.5 * omega + 0.25 * omega * omega * t) * 4e-3);
  EXPECT_GT(coarse / fine, 1.8);
}

/// ẍ = −g D² v/√(v·D² v), D² turned with the body: Runge and Kutta's formula of fourth order.
std::array<double, 4> spinningPuck(double mu1, double mu2, double omega, double t, int steps) {
  using Point = std::array<double, 4>;
  const auto rate = [&](double time, const Point& x) {
    const double c = std::cos(omega * time), s = std::sin(omega * time);
    const double along = c * x[2] + s * x[3], across = -s * x[2] + c * x[3];
    const double f1 = mu1 * mu1 * along, f2 = mu2 * mu2 * across,
                 size = kG / std::sqrt(f1 * along + f2 * across);
    return Point{x[2], x[3], -size * (c * f1 - s * f2), -size * (s * f1 + c * f2)};
  };
  const auto after = [](Point x, const Point& k, double h) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * k[i];
    return x;
  };
  Point x{0.0, 0.0, 2.0, 0.5};
  const double h = t / steps;
  for (int n = 0; n < steps; ++n) {
    const double time = n * h;
    const Point k1 = rate(time, x), k2 = rate(time + 0.5 * h, after(x, k1, 0.5 * h)),
                k3 = rate(time + 0.5 * h, after(x, k2, 0.5 * h)),
                k4 = rate(time + h, after(x, k3, h));
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
  }
  return x;
}

TEST(Grain, OfASpinningPuckTurnsWithIt) {
  constexpr double mu1 = 0.05, mu2 = 0.4, omega = 4.0, t = 0.6;
  const OnAPlane puck{.body = "grain=\"1 0 0\"", .plane = "", .law = "mu1=\"0.05\" mu2=\"0.4\""};
  LocatedRun run(puck.scene(rigid(Vec3(2.0, 0.5, 0.0), omega)), 1e-10, t);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  const auto fine = spinningPuck(mu1, mu2, omega, t, 20000),
             coarse = spinningPuck(mu1, mu2, omega, t, 10000);
  for (std::size_t i = 0; i < fine.size(); ++i) ASSERT_NEAR(fine[i], coarse[i], 1e-11);
  const auto& [q, u] = std::pair(run.state().q, run.state().u);
  EXPECT_NEAR(q[0], fine[0], 1e-8);
  EXPECT_NEAR(q[1], fine[1], 1e-8);
  EXPECT_NEAR(u[0], fine[2], 1e-8);
  EXPECT_NEAR(u[1], fine[3], 1e-8);
  EXPECT_NEAR(u[5], omega, 1e-12);  // a point has no drilling friction
}

TEST(Grain, TurnsWithTheWholeScene) {
  // A spinning runner on a slope, and the same turned in space: the same motion but for rounding
  // and the solver's 1e-10 a step in the velocities, 300 steps.
  const Vec3 axis(0.3, -0.5, 0.8);
  double p[4];
  axisQuaternion(axis, 1.1, p);
  const Mat3 R = rotationMatrix(p);
  OnAPlane slope{.body = "grain=\"1 0.2 0\"", .plane = "", .law = "mu1=\"0.05\" mu2=\"0.4\""};
  slope.gravity = kG * Vec3(std::sin(0.3), 0.0, -std::cos(0.3));
  const Vec3 v(1.0, 0.3, 0.0);
  Scene here("here", {.text = slope.scene(rigid(v, 3.0))});
  here.run(0.3, 1e-3);
  OnAPlane turned = slope;
  turned.n = R * slope.n, turned.gravity = R * slope.gravity;
  Scene there(
      "there",
      {.text = turned.scene(
           rigid(R * v, 3.0, fmt::format("orientation=\"{} {} {} {}\"", p[0], p[1], p[2], p[3])))});
  there.run(0.3, 1e-3);
  EXPECT_LT((R * here.q("skate").head<3>() - there.q("skate").head<3>()).norm(), 1e-7);
  EXPECT_LT((R * here.u("skate").head<3>() - there.u("skate").head<3>()).norm(), 1e-7);
}

}  // namespace
}  // namespace dynamy::reference
