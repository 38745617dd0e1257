// Signals of named frames: attitude and course of a vehicle.
#include <gtest/gtest.h>

#include <cmath>
#include <unit/elements/blocks/block_scene.hpp>

namespace dynamy {
namespace {

TEST(FrameSignals, TellLeanPitchHeadingAndSideslip) {
  // R = R_z(heading) R_y(pitch) R_x(lean) as written in euler; a frame turned by 0.4 about z in the
  // body; the body moves level with a course of 0.55, of 2 m/s.
  BlockScene scene(R"(<dynamy version="1"><systems>
    <RigidBody name="bike" mass="1" inertia="1 1 1" euler="0.1 0.2 0.3" velocity="1.7050490441190114 1.0453744578613184 -0.3">
      <Frame name="base"/><Frame name="turned" euler="0 0 0.4"/></RigidBody>
    <PlanarBody name="flat" mass="1" inertia="1"><Frame name="base"/></PlanarBody></systems>
    <simulation until="1" step="0.1"/></dynamy>)");
  const State x = scene.model().initialState();
  const auto angle = [&](const char* name) { return scene.signal(x, name); };
  EXPECT_NEAR(angle("bike.base.lean"), 0.1, 1e-15);
  EXPECT_NEAR(angle("bike.base.pitch"), 0.2, 1e-15);
  EXPECT_NEAR(angle("bike.base.heading"), 0.3, 1e-15);
  EXPECT_NEAR(angle("bike.base.sideslip"), 0.25, 1e-15);
  // R_y(0.2) R_x(0.1) R_z(0.4), seen from above.
  const double forward =
                   std::cos(0.2) * std::cos(0.4) + std::sin(0.2) * std::sin(0.1) * std::sin(0.4),
               left = std::cos(0.1) * std::sin(0.4);
  EXPECT_NEAR(angle("bike.turned.heading"), 0.3 + std::atan2(left, forward), 1e-15);
  EXPECT_EQ(scene.model().signal("flat.base.lean"), nullptr);
}

}  // namespace
}  // namespace dynamy
