/// A run whose energy grows beyond any meaning.
#include <gtest/gtest.h>

#include <support/bounded_run.hpp>

namespace dynamy {
namespace {

TEST(Divergence, EndsARunWithItsReason) {
  // ωΔt = 100: the explicit rule multiplies the velocity by about (ωΔt)² in each step.
  BoundedRun run(R"(<dynamy version="1"><systems>
<RigidBody name="b" position="1.1 0 0"><Sphere radius="0.1" mass="1"/></RigidBody><Ground name="g"/></systems>
<forces><SpringDamper name="s" between="g b" stiffness="1e6" length="1"/></forces>
<simulation until="10" step="0.1"><MoreauMidpoint/></simulation>
<record signals="b.x" frames="0"/></dynamy>)");
  run.run();
  EXPECT_EQ(run.report().ended, RunReport::Ended::failed);
  EXPECT_NE(run.report().reason.find("the run has diverged: T + V rose by"), std::string::npos)
      << run.report().reason;
  // 1e12 is passed after (1e4)² in each of the first two steps, or in the third.
  EXPECT_LE(run.report().steps, 3);
}

}  // namespace
}  // namespace dynamy
