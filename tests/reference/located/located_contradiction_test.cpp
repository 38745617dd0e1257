// Rows that stick and begin to contradict others (theory 50.1b): one of them has to yield, although
// no force is near its bound.
#include <gtest/gtest.h>

#include <reference/located/located_run.hpp>
#include <support/bounded_run.hpp>
#include <support/gravity.hpp>

namespace dynamy::reference {
namespace {

/// A block of 2 kg on a floor, whose speed a drive prescribes from the start on.
std::string drawn(const std::string& speed, double most) {
  return R"xml(<dynamy version="1"><systems>
  <PointMass name="block" mass="2" position="0 0 0"><Point material="block"/></PointMass>
  <Ground name="world"><HalfSpace material="floor"/></Ground></systems>
  <forces><Gravity/></forces><elements>
  <Contact between="block floor"><UnilateralCoulomb mu="0.3"/></Contact>
  <CoordinateContact name="drive" on="block" slipVelocity="vx - )xml" +
         speed + R"xml("><ForceLimit lower="-)xml" + std::to_string(most) + "\" upper=\"" +
         std::to_string(most) +
         "\"/></CoordinateContact></elements><simulation until=\"2\" step=\"1\"/></dynamy>";
}

TEST(LocatedContradiction, ABlockSlipsWhenItsDriveBegins) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    LocatedRun run(drawn("0.5*t^2", 100.0), tolerance, 2.0);
    const RunReport& r = run.run();
    ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
    // x = t³/6. What is missing passes 1e-3 of the weight at a = 0.02 m/s², after 20 ms at most, in
    // which the block would be moved by half of its way: 0.02³/12 = 7e-7 m, and v by 1e-4 m/s.
    EXPECT_NEAR(run.state().q[0], 8.0 / 6.0, 1e-6) << tolerance;
    EXPECT_NEAR(run.state().u[0], 2.0, 1e-10);
    // The weight's friction takes 0.3 m g over this way.
    EXPECT_NEAR(r.energy.friction, -0.3 * 2.0 * kG * 8.0 / 6.0, 1e-5);
  }
}

TEST(LocatedContradiction, ADriveThatIsTooWeakYieldsInstead) {
  // 5 N do not move it: friction holds up to 5.886 N.
  LocatedRun run(drawn("0.5*t^2", 5.0), 1e-6, 2.0);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_NEAR(run.state().q[0], 0.0, 1e-6);
  EXPECT_NEAR(run.state().u[0], 0.0, 1e-10);
}

TEST(LocatedContradiction, ALiftInMinimalCoordinatesTravelsAsGiven) {
  BoundedRun lift(
      "models/elevator_travel.xml",
      {.signals = "lift/cabin.z", .every = 0.5, .coordinates = JointCoordinates::minimal});
  lift.run();
  ASSERT_TRUE(lift.finished()) << lift.report().reason;
  // The drive travels from 3 m to 9 m; ten tolerances of 1e-6, as the model's own check.
  EXPECT_NEAR(lift.last(), 9.0, 1e-5);
}

}  // namespace
}  // namespace dynamy::reference
