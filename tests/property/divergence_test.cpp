/// A run whose energy grows beyond any meaning.
#include <gtest/gtest.h>

#include <support/bounded_run.hpp>

namespace dynamy {
namespace {

TEST(Divergence, EndsARunWithItsReason) {
  // ωΔt = 100: the explicit rule multiplies the velocity by about (ωΔt)² = 1e4 in each step, the
  // energy by 1e8: two steps pass 1e12, a third one stays in reserve.
  BoundedRun run(R"(<dynamy version="1"><systems>
<RigidBody name="b" position="1.1 0 0"><Sphere radius="0.1" mass="1"/></RigidBody><Ground name="g"/></systems>
<forces><SpringDamper name="s" between="g b" stiffness="1e6" length="1"/></forces>
<simulation until="10" step="0.1"><MoreauMidpoint/></simulation>
<record signals="b.x" frames="0"/></dynamy>)");
  run.run();
  EXPECT_EQ(run.report().ended, RunReport::Ended::failed);
  EXPECT_NE(run.report().reason.find("the run has diverged: T + V rose by"), std::string::npos)
      << run.report().reason;
  EXPECT_NE(run.report().reason.find("the fastest is <RigidBody name=\"b\">"), std::string::npos);
  EXPECT_LE(run.report().steps, 3);
}

TEST(Divergence, IsNotWhatBalances) {
  // A fall for 1e7 s from rest at the height 0: T = −V = 5e15 J balance up to rounding, some J. That
  // is more than 1e12 times the least energy that counts, m (L/until)²/2 = 2e-16 J.
  BoundedRun run(R"(<dynamy version="1"><systems>
<RigidBody name="b"><Sphere radius="0.1" mass="1"/></RigidBody></systems>
<forces><Gravity acceleration="0.3 0.7 -9.81"/></forces><simulation step="7777.7" until="1e7"><MoreauMidpoint/></simulation>
<record signals="b.z" frames="0"/></dynamy>)");
  run.run();
  EXPECT_TRUE(run.finished()) << run.report().reason;
}

}  // namespace
}  // namespace dynamy
