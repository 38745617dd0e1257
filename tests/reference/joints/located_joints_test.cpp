// Joints of fast bodies in runs to a tolerance.
#include <gtest/gtest.h>

#include <reference/located/located_run.hpp>

namespace dynamy::reference {
namespace {

TEST(LocatedJoints, OfATumblingPairStayWhereStepsTurnItByARadian) {
  // Two bodies, fixed to each other off their centres, spin at 65 rad/s, in some twenty steps. The
  // velocities that a correction of positions changed were once left, and doubled from step to step:
  // the joint was off by 66 mm, and T rose by 13 %.
  LocatedRun run(R"xml(<dynamy version="1"><systems>
    <RigidBody name="a" mass="1.2" inertia="5e-3 4e-3 6e-3" position="0 0 0" velocity="0 5 0" angularVelocity="-12 48 -44"/>
    <RigidBody name="b" mass="0.4" inertia="1e-3 2e-3 1.5e-3" position="0.8 0 0"/>
    <Ground name="world"/></systems>
    <elements><Fixed name="joint" between="a b" at="0.4 0 0"/></elements>
    <simulation until="0.5" tolerance="1e-3"/></dynamy>)xml",
                 1e-3, 0.5);
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  // Corrections end below 5e-4 of the tolerance of 1e-3 and of the length of 1 m.
  EXPECT_LT(r.gaps.jointError.value, 1e-6);
  // Nothing drives and nothing damps. Each of n steps keeps the energy to 5e-4 of T times its share
  // of ln(1 + t/T), which is below 5 here (50.2a).
  EXPECT_LT(r.trust.energyError, 2.5e-3 * r.trust.energyScale());
}

}  // namespace
}  // namespace dynamy::reference
