// State machines: located guards, actions, times, and what they refuse.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <unit/elements/blocks/block_scene.hpp>

namespace dynamy {
namespace {

/// Two states: pushed until x passes 0.5 m, then braked until it stands.
const char* const kPushed = R"(<StateMachine name="m" states="push brake rest" out="4; -6; 0">
  <Transition from="push" to="brake" when="cart.x - 0.5" set="cart.vx"/>
  <Transition from="brake" to="rest" when="-cart.vx" set="value + t"/></StateMachine>)";

TEST(StateMachine, SwitchesWhereItsGuardsPassZero) {
  // v² = 1 + 2·2·0.2; then −3 m/s² until v = 0, t = (v − 1)/2 + v/3.
  const double v = std::sqrt(1.8), until = (v - 1.0) / 2.0 + v / 3.0;
  for (const auto& [simulation, tolerance] : {std::pair{R"(tolerance="1e-9">)", 1e-8},
                                              // Late by up to a step each time.
                                              std::pair{R"(step="0.1ms">)", 1e-3}}) {
    BlockScene scene(cart(R"(<ForceInput on="cart" force="m.out; 0; 0"/>)", simulation, kPushed));
    const State x = scene.run();
    EXPECT_NEAR(x.q[0], 0.5 + v * v / 6.0, tolerance) << simulation;
    EXPECT_EQ(scene.signal(x, "m.state"), 2.0) << simulation;
    EXPECT_NEAR(scene.signal(x, "m.value"), v + until, 3.0 * tolerance) << simulation;
    EXPECT_NEAR(scene.signal(x, "m.time"), 1.0 - until, 3.0 * tolerance) << simulation;
  }
}

TEST(StateMachine, LeavesAStateAfterATimeAndCounts) {
  // On for 0.2 s, off for 0.1 s: 4 changes to on by t = 1, and an impulse of (0.2·3 + 0.1)·2 N s.
  BlockScene scene(cart(R"(<ForceInput on="cart" force="m.out; 0; 0"/>)", R"(tolerance="1e-9">)",
                        R"(<StateMachine name="m" states="on off" out="2; 0">
      <Transition from="on" to="off" after="0.2s"/>
      <Transition from="off" to="on" after="100ms" set="value + 1"/></StateMachine>)"));
  const State x = scene.run();
  EXPECT_EQ(scene.signal(x, "m.value"), 3.0);
  EXPECT_NEAR(x.u[0], 1.0 + 0.7, 1e-9);
}

TEST(StateMachine, ChecksTheStateOfACheckpoint) {
  BlockScene scene(cart("", R"(step="1e-2">)",
                        R"(<StateMachine name="m" states="on off" out="2; 0">
      <Transition from="on" to="off" after="0.2s"/></StateMachine>)"));
  const NonSmoothElement& machine = *scene.model().contacts().front();
  for (const double number : {2.0, -1.0, 0.5, std::nan("")})
    EXPECT_FALSE(machine.memoryFault(ConstVec(&number, 1)).empty()) << number;
  const double good = 1.0;
  EXPECT_TRUE(machine.memoryFault(ConstVec(&good, 1)).empty());
}

TEST(StateMachine, RefusesStatesThatItHasNotAndComparisons) {
  const auto refused = [](const std::string& transition) {
    try {
      BlockScene scene(
          cart("", R"(step="1ms">)",
               "<StateMachine name=\"m\" states=\"on off\">" + transition + "</StateMachine>"));
    } catch (const ModelError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(refused(R"(<Transition from="on" to="of" after="1"/>)").find("did you mean \"off\""),
            std::string::npos);
  EXPECT_NE(refused(R"(<Transition from="on" to="off" when="cart.x &gt; 1"/>)")
                .find("cart.x - 1 in place of cart.x > 1"),
            std::string::npos);
  EXPECT_NE(refused(R"(<Transition from="on" to="off"/>)").find("neither when nor after"),
            std::string::npos);
}

}  // namespace
}  // namespace dynamy
