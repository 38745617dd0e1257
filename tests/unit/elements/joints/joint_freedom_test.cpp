// Which coordinate an element means that names none, beside a joint: closed forms of the motion.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <unit/elements/blocks/block_scene.hpp>

namespace dynamy {
namespace {

const std::string kInSpace = R"(<RigidBody name="cart" mass="2" inertia="1 1 1"/>)";
const std::string kInPlane = R"(<PlanarBody name="cart" mass="2" inertia="1"/>)";

std::string scene(const std::string& body, const std::string& joint, const std::string& forces,
                  const std::string& elements, const std::string& coordinates) {
  return R"(<dynamy version="1"><systems><Ground name="world"/>)" + body + "</systems><forces>" +
         forces + "</forces><elements>" + joint + elements +
         R"(</elements><simulation until="1" tolerance="1e-9" coordinates=")" + coordinates +
         R"("/></dynamy>)";
}

const std::string kSlider = R"(<Prismatic name="rail" between="world cart" axis="1 0 0"/>)";

TEST(JointFreedom, ASpringBesideASliderActsAlongIt) {
  // ω = √(c/m) = 5/s, from 0.1 m.
  const std::string spring =
      R"(<JointSpring name="s" between="world cart" axis="1 0 0" stiffness="50N/m" start="0.1"/>)";
  for (const std::string& body : {kInSpace, kInPlane})
    for (const char* coordinates : {"absolute", "minimal", "auto"}) {
      BlockScene s(scene(body, kSlider, spring, "", coordinates));
      const State x = s.run();
      EXPECT_NEAR(s.signal(x, "s.position"), 0.1 * std::cos(5.0), 1e-7) << body << coordinates;
    }
}

TEST(JointFreedom, ASpringBesideAHingeActsAboutIt) {
  // ω = √(c/J) = 5/s, from 0.1 rad.
  const std::string spring =
      R"(<JointSpring name="s" between="world cart" axis="0 1 0" stiffness="25" start="0.1"/>)";
  BlockScene s(
      scene(kInSpace, R"(<Revolute between="world cart" axis="0 1 0"/>)", spring, "", "absolute"));
  const State x = s.run();
  EXPECT_NEAR(s.signal(x, "s.position"), 0.1 * std::cos(5.0), 1e-7);
}

TEST(JointFreedom, AStopBesideASliderHoldsIt) {
  // 3 N for 1 s would move 2 kg by 0.75 m.
  const std::string stop =
      R"(<JointStop name="stop" between="cart world" axis="1 0 0" lower="-0.25m"/>)";
  BlockScene s(
      scene(kInSpace, kSlider, R"(<ForceInput on="cart" force="3; 0; 0"/>)", stop, "absolute"));
  const State x = s.run();
  EXPECT_NEAR(s.signal(x, "cart.x"), 0.25, 1e-7);
}

TEST(JointFreedom, InAPlanarJointTheAxisTellsWhatIsMeant) {
  const std::string joint = R"(<PlanarJoint between="world cart" axis="0 0 1"/>)";
  const std::string spring =
      R"(<JointSpring name="along" between="world cart" axis="0 1 0" stiffness="50" start="0.1"/>
         <JointSpring name="about" between="world cart" axis="0 0 1" stiffness="25" start="0.2"/>)";
  BlockScene s(scene(kInSpace, joint, spring, "", "absolute"));
  const State x = s.run();
  EXPECT_NEAR(s.signal(x, "along.position"), 0.1 * std::cos(5.0), 1e-7);
  EXPECT_NEAR(s.signal(x, "about.position"), 0.2 * std::cos(5.0), 1e-7);
}

TEST(JointFreedom, ATurnThatAUniversalMakesLaterIsAccepted) {
  // About the third axis its rate is zero at the start only.
  const std::string joint = R"(<Universal between="world cart" axis="1 0 0" axisB="0 1 0"/>)";
  const std::string spring =
      R"(<JointSpring name="s" between="world cart" axis="0 0 1" stiffness="1"/>)";
  EXPECT_NO_THROW(BlockScene(scene(kInSpace, joint, spring, "", "absolute")));
}

}  // namespace
}  // namespace dynamy
