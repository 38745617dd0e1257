// EventDriven, the plain scheme of the textbooks: closed forms where it gets through, and its
// stalls.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/located/event_driven.hpp>
#include <reference/located/located_run.hpp>
#include <reference/located/located_scenes.hpp>
#include <support/gravity.hpp>

namespace dynamy::reference {
namespace {

/// Block on a rough floor, 1 m/s at the start, μ = 0.5.
const std::string kSlidingBlock = R"xml(<dynamy version="1">
  <systems><Coordinates name="block" q="x y" units="m m" q0="0 0" u0="1 0" M="1 ; 0 ; 1"
    potential="9.81*y"/></systems>
  <elements><CoordinateContact name="floor" on="block" gap="y" slip="1 ; 0">
    <UnilateralCoulomb mu="0.5"/></CoordinateContact></elements>
  <simulation until="1" step="1"/></dynamy>)xml";

LocatedRun plain(const std::string& what, double tolerance, double until) {
  return LocatedRun(what, tolerance, until, {}, {}, std::make_unique<EventDriven>());
}

TEST(EventDriven, FollowsTheBallUpToItsAccumulationPoint) {
  const double t1 = std::sqrt(2.0 / kG);
  // Ten impacts, at t1 + 2 t1 (e + … + eⁿ); the next would come at 1.3537 s.
  LocatedRun ball = plain(scenes::kBall, 1e-9, 1.353);
  ASSERT_EQ(ball.run().ended, RunReport::Ended::finished) << ball.report().reason;
  const std::vector<double> impacts = ball.impacts("floor");
  ASSERT_EQ(impacts.size(), 10u);
  for (int n = 0; n < 10; ++n)  // each passes an error of the tolerance on
    EXPECT_NEAR(impacts[static_cast<std::size_t>(n)], t1 * (3.0 - 2.0 * std::pow(0.5, n)), 1e-8);
}

TEST(EventDriven, StallsAtTheAccumulationPointAndSaysSo) {
  LocatedRun ball = plain(scenes::kBall, 1e-9, 2.0);
  const RunReport& r = ball.run();
  EXPECT_EQ(r.ended, RunReport::Ended::failed);
  EXPECT_NE(r.reason.find("events follow each other without end"), std::string::npos) << r.reason;
  EXPECT_NEAR(r.t, 3.0 * std::sqrt(2.0 / kG), 1e-8);  // nine tolerances, as above
  EXPECT_EQ(r.located.accumulations, 0);
}

TEST(EventDriven, StopsASlidingBlockWhereTheClosedFormDoes) {
  LocatedRun block = plain(kSlidingBlock, 1e-9, 1.0);
  ASSERT_EQ(block.run().ended, RunReport::Ended::finished) << block.report().reason;
  const double a = kG * 0.5;  // μ g; stop at u²/(2a) = 1/(2a)
  ASSERT_EQ(block.changes("floor", Status::stick).size(), 1u);
  EXPECT_NEAR(block.changes("floor", Status::stick).front(), 1.0 / a, 1e-9);
  EXPECT_NEAR(block.state().q[0], 0.5 / a, 1e-9);
  EXPECT_EQ(block.state().u[0], 0.0);
}

TEST(EventDriven, FindsThePeriodOfTheWoodpecker) {
  // Event-driven, Taylor series of order 40 (models/woodpecker.xml): 0.145976065144 s. Mean of 40
  // periods behind 120, see LocatedWoodpecker.
  LocatedRun toy = plain("woodpecker", 1e-7, 23.45);
  ASSERT_EQ(toy.run().ended, RunReport::Ended::finished) << toy.report().reason;
  const std::vector<double> beak = toy.impacts("beak");
  ASSERT_GE(beak.size(), 160u);
  EXPECT_NEAR((beak[159] - beak[119]) / 40.0 / 0.145976065144, 1.0, 1e-6);  // 10 tol
}

TEST(EventDriven, ReleasesAStickingBeltOscillatorAtItsBound) {
  // Static friction 1 N lets go at x = 1; kinetic 0.5 N: x − 1/2 turns on a circle until the belt
  // is as fast again, at x = 0: stick 1/0.2 s, slip 2π − 2 atan(0.5/0.2) s.
  LocatedRun belt = plain(scenes::kBelt, 1e-9, 30.0);
  ASSERT_EQ(belt.run().ended, RunReport::Ended::finished) << belt.report().reason;
  const std::vector<double> release = belt.changes("friction", Status::slip);
  ASSERT_GE(release.size(), 2u);
  const double period = 5.0 + 2.0 * (std::acos(-1.0) - std::atan(2.5));
  EXPECT_NEAR(release[1] - release[0], period, 1e-8);  // 10 tol
}

}  // namespace
}  // namespace dynamy::reference
