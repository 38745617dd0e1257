// Circles over a half space that come to lie flat are followed by their lowest point and, while they
// lie flat, by four points of the rim (theory 50.11).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <dynamy/simulation/report/run_watch.hpp>
#include <random>
#include <reference/located/located_run.hpp>

namespace dynamy::reference {
namespace {

constexpr double kG = 9.81;

std::string over(const std::string& attributes, const std::string& shape, const std::string& law) {
  return R"(<dynamy version="1"><systems><RigidBody name="b" )" + attributes + "><" + shape +
         R"( mass="1" material="a"/></RigidBody><Ground name="world"><HalfSpace material="c"/>
         </Ground></systems><forces><Gravity/></forces><elements><Contact between="a c">
         <UnilateralCoulomb )" +
         law + R"(/></Contact></elements><simulation until="1" step="1"/></dynamy>)";
}

void expectLocated(const LocatedRun& run) {
  ASSERT_EQ(run.report().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_EQ(run.report().stepping.periods, 0);
  for (const Warning& w : run.report().warnings)
    if (says(w) == Says::warning) ADD_FAILURE() << w.kind << ": " << w.text;
}

TEST(LocatedCircle, ACanThatFallsFlatComesToRest) {
  // Free fall by 0.5 m; instants of impacts are as far off as positions, 1e-8 L with L < 10 m, over
  // the speed there. Without rebound it lies from there on.
  LocatedRun run(over(R"(position="0 0 0.6" velocity="0.4 0 0")",
                      R"(Cylinder radius="0.1" length="0.2")", R"(mu="0.5")"),
                 1e-8, 1.0);
  run.run();
  expectLocated(run);
  const double touch = std::sqrt(2.0 * 0.5 / kG);
  for (int i = 0; i < 4; ++i) {
    const auto at = run.impacts("b-world.rim0.point" + std::to_string(i));
    ASSERT_EQ(at.size(), 1u);
    EXPECT_NEAR(at[0], touch, 1e-7 / (kG * touch));
  }
  EXPECT_NEAR(run.state().q[2], 0.1, 1e-7);
  EXPECT_LT(run.state().u.norm(), 1e-9);
}

TEST(LocatedCircle, ARingThatReboundsFlat) {
  // ε = 1 without friction: at 2 √(2 h/g) it is back at the height h.
  const double h = 0.4, fall = std::sqrt(2.0 * h / kG);
  LocatedRun run(
      over(R"(position="0 0 0.5")", R"(Torus radius="0.3" tube="0.1")", R"(mu="0" epsilonN="1")"),
      1e-8, 4.0 * fall);
  run.run();
  expectLocated(run);
  EXPECT_EQ(run.report().contacts.impacts, 2 * 4);
  EXPECT_NEAR(run.state().q[2], 0.1 + h, 1e-7);  // as above
}

TEST(LocatedCircle, ACanThatTipsOntoItsBase) {
  // It starts on its rim, tilted by θ₀, without friction. Its centre moves along a vertical line at
  // the height h(θ) = R sin θ + ℓ/2 cos θ, so that ½ (I + m h'²) θ̇² = m g (h(θ₀) − h): it lies flat
  // after ∫ dθ/θ̇; with θ = θ₀ − s² the integrand is smooth.
  const double R = 0.3, half = 0.1, start = 0.5, I = (3.0 * R * R + 4.0 * half * half) / 12.0;
  const auto h = [&](double a) { return R * std::sin(a) + half * std::cos(a); };
  const auto slope = [&](double a) { return R * std::cos(a) - half * std::sin(a); };
  const auto slowness = [&](double s) {
    const double a = start - s * s;
    const double fall = s < 1e-6 ? slope(start) * s * s : h(start) - h(a);
    return 2.0 * s * std::sqrt((I + slope(a) * slope(a)) / (2.0 * kG * fall));
  };
  const double flat = boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
      slowness, 0.0, std::sqrt(start), 10, 1e-12);
  for (const double tolerance : {1e-6, 1e-8}) {
    LocatedRun run(over("position=\"0 0 " + std::to_string(h(start)) + R"(" euler="0.5 0 0")",
                        R"(Cylinder radius="0.3" length="0.2")", R"(mu="0")"),
                   tolerance, 0.5);
    run.run();
    expectLocated(run);
    std::vector<double> hits;
    for (const ContactEvent& e : run.events)
      if (e.impact && contactName(run.model(), e.key).find("point") != std::string::npos)
        hits.push_back(e.t);
    ASSERT_FALSE(hits.empty());
    // std::to_string has six digits: it starts up to 5e-7 m above the ground. A circle counts as flat
    // within 0.05 of the tolerance; an error of some tolerances of the time.
    EXPECT_NEAR(hits.front(), flat, 2e-6 + 10.0 * tolerance) << tolerance;
    EXPECT_NEAR(run.state().q[2], half, 10.0 * tolerance);
  }
}

TEST(LocatedCircle, AWheelThatSwingsPastLyingFlatKeepsItsEnergy) {
  // A wheel falls over and all but lies flat: the lowest point runs half around its rim in about a
  // thousandth of a second, and lifts it again. Friction holds it, and no force does work.
  const double R = 0.3, half = 0.02, tilt = 0.4;
  for (const double spin : {0.3, 0.03, 0.003}) {
    const std::string turn = std::to_string(spin);
    LocatedRun run(
        over("position=\"0 0 " + std::to_string(R * std::sin(tilt) + half * std::cos(tilt) + 1e-3) +
                 R"(" euler="0.4 0 0" angularVelocity="0 )" + turn + R"( 0")",
             R"(Cylinder radius="0.3" length="0.04")", R"(mu="50")"),
        1e-8, 1.5);
    const double J = (3.0 * R * R + 4.0 * half * half) / 12.0, J3 = 0.5 * R * R;
    const auto energy = [&](const State& x) {
      return 0.5 * x.u.head<3>().squaredNorm() +
             0.5 * (J * (x.u[3] * x.u[3] + x.u[4] * x.u[4]) + J3 * x.u[5] * x.u[5]) + kG * x.q[2];
    };
    // Sine of the tilt, from the quaternion w x y z.
    const auto sine = [](const State& x) {
      const double c = 1.0 - 2.0 * (x.q[4] * x.q[4] + x.q[5] * x.q[5]);
      return std::sqrt(1.0 - c * c);
    };
    double lowest = 1.0, raised = 0.0;
    double after = 0.0;  // the plastic impact at the start
    while (run.simulation().step()) {
      if (run.events.empty()) continue;
      if (after == 0.0) after = energy(run.state());
      if (std::any_of(run.events.begin() + 1, run.events.end(),
                      [](const ContactEvent& e) { return e.impact; }))
        break;  // it came down with the other rim, or flat
      EXPECT_NEAR(energy(run.state()), after, 1e-5 * kG * R) << spin << " at " << run.state().t;
      lowest = std::min(lowest, sine(run.state()));
      if (lowest < 0.1) raised = std::max(raised, sine(run.state()));
    }
    EXPECT_LT(lowest, 0.3 * spin);
    EXPECT_GT(raised, 0.2);
    EXPECT_EQ(run.report().stepping.periods, 0) << spin;
  }
}

TEST(LocatedCircle, RoundBodiesThatFallAtAnyTiltAreLocated) {
  // Nothing drives them: energy does not rise by more than the tolerance allows, 1e-6 of L U² with
  // L, U below 10, in some tens of events.
  std::mt19937 random(5);
  const auto one = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  const std::array<double, 6> tilts{0.0, 1e-9, 1e-6, 1e-3, 0.05, 1.0};
  const std::array<std::string, 3> shapes{R"(Cylinder radius="0.7" length="0.6")",
                                          R"(Cone radius="0.6" length="1.1")",
                                          R"(Torus radius="0.7" tube="0.2")"};
  for (int i = 0; i < 36; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double v = i % 4 == 0 ? 0.0 : 1.0, w = i % 5 == 0 ? 0.0 : 3.0;
    const std::string law = "mu=\"" + std::to_string(0.5 * (i % 4)) + "\" epsilonN=\"" +
                            std::to_string(i % 3 == 0 ? 0.0 : one(0.0, 1.0)) + "\"";
    std::string at = R"(position="0 0 1.8" euler=")" + std::to_string(one(-3.0, 3.0)) + " " +
                     std::to_string(tilts[k % 6]) + R"( 0" velocity=")";
    for (int j = 0; j < 3; ++j) at += std::to_string(v * one(-1.0, 1.0)) + " ";
    at += R"(" angularVelocity=")";
    for (int j = 0; j < 3; ++j) at += std::to_string(w * one(-1.0, 1.0)) + " ";
    LocatedRun run(over(at + "\"", shapes[k / 2 % 3], law), 1e-6, 2.0);
    run.run();
    SCOPED_TRACE(at + " " + shapes[k / 2 % 3] + " " + law);
    expectLocated(run);
    EXPECT_LT(run.report().energy.discretisation, 1e-3);
  }
}

}  // namespace
}  // namespace dynamy::reference
