// LocatedGragg, Gragg's extrapolation between located switches: closed forms, both ways of holding
// contacts.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/located/located_gragg.hpp>
#include <reference/located/located_run.hpp>
#include <reference/located/located_scenes.hpp>
#include <support/gravity.hpp>

namespace dynamy::reference {
namespace {

struct Method {
  const char *order, *constraint;
};

class LocatedGraggScheme : public testing::TestWithParam<Method> {
 protected:
  LocatedRun run(const std::string& what, double tolerance, double until) const {
    return LocatedRun(what, tolerance, until, {}, {},
                      std::make_unique<LocatedGragg>(Parameters::of<LocatedGragg>(
                          "LocatedGragg", "",
                          {{"order", GetParam().order}, {"constraint", GetParam().constraint}})));
  }
};

TEST_P(LocatedGraggScheme, FollowsABallIntoRest) {
  LocatedRun ball = run(scenes::kBall, 1e-6, 2.0);
  ASSERT_EQ(ball.run().ended, RunReport::Ended::finished) << ball.report().reason;
  // Impacts at t1 + 2 t1 (e + … + eⁿ), t1 = √(2/g): parabolas, which every method has exactly.
  const double t1 = std::sqrt(2.0 / kG);
  const std::vector<double> impacts = ball.impacts("floor");
  ASSERT_GE(impacts.size(), 5u);
  for (int n = 0; n < 5; ++n)
    EXPECT_NEAR(impacts[static_cast<std::size_t>(n)], t1 * (3.0 - 2.0 * std::pow(0.5, n)), 1e-9);
  EXPECT_EQ(ball.report().located.accumulations, 1);
  EXPECT_NEAR(ball.state().q[0], 0.0, 1e-9);
}

TEST_P(LocatedGraggScheme, KeepsTheRhythmOfABeltOscillator) {
  // Stick 1/0.2 s, slip 2π − 2 atan(2.5) s, see EventDriven.
  LocatedRun belt = run(scenes::kBelt, 1e-6, 30.0);
  ASSERT_EQ(belt.run().ended, RunReport::Ended::finished) << belt.report().reason;
  const std::vector<double> release = belt.changes("friction", Status::slip);
  ASSERT_GE(release.size(), 2u);
  const double period = 5.0 + 2.0 * (std::acos(-1.0) - std::atan(2.5));
  EXPECT_NEAR(release[1] - release[0], period, 1e-5);  // 10 tol
}

INSTANTIATE_TEST_SUITE_P(All, LocatedGraggScheme,
                         testing::Values(Method{"4", "acceleration"}, Method{"8", "acceleration"},
                                         Method{"4", "velocity"}, Method{"8", "velocity"}),
                         [](const auto& one) {
                           return std::string(one.param.constraint) + one.param.order;
                         });

}  // namespace
}  // namespace dynamy::reference
