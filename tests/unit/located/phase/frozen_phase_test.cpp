// Accelerations and forces with the status of every contact held: a sledge on a floor.
#include <gtest/gtest.h>

#include <dynamy/located/phase/frozen_phase.hpp>

#include "unit/located/sledge.hpp"

namespace dynamy {
namespace {

using Eigen::Vector2d;
using fixture::kSledgeG, fixture::kSledgeRounding, fixture::SledgeScene;

/// Contact `i` with its status; sign 0: it sticks.
Held held(const SledgeScene& s, double sign = 0.0, int i = 0) {
  Held h;
  h.key = s.key(i);
  h.slips = sign != 0.0, h.sign = sign;
  return h;
}

/// Evaluates with exactly the held contacts and accelerates.
bool accelerate(SledgeScene& s, FrozenPhase& phase, Eigen::VectorXd& a) {
  std::vector<ContactKey> keys;
  heldKeys(phase.held, keys);
  return phase.accelerate(s.evaluate(s.x, keys), s.x.u, a);
}

TEST(FrozenPhase, WithoutContactsIsFreeMotion) {
  SledgeScene s({0.0, 1.0}, {0.0, 0.0}, SledgeScene::pull(3.0), 0.5);
  FrozenPhase phase;
  Eigen::VectorXd a;
  ASSERT_TRUE(accelerate(s, phase, a)) << phase.fault();
  EXPECT_EQ(a, Vector2d(3.0, -kSledgeG));
  EXPECT_EQ(phase.rows().size(), 0);
}

TEST(FrozenPhase, SticksWithTheForceThatHoldsIt) {
  SledgeScene s({0.0, 0.0}, {0.0, 0.0}, SledgeScene::pull(3.0), 0.5);
  FrozenPhase phase;
  phase.held = {held(s)};
  Eigen::VectorXd a;
  ASSERT_TRUE(accelerate(s, phase, a)) << phase.fault();
  EXPECT_NEAR(a.norm(), 0.0, kSledgeRounding);
  EXPECT_NEAR(phase.lambda()[0], kSledgeG, kSledgeRounding);
  EXPECT_NEAR(phase.lambda()[1], -3.0, kSledgeRounding);
  // Distance from the bound: μ λ_N − |λ_T| = 5 − 3.
  double margin = 0.0;
  ASSERT_TRUE(phase.margin(0, margin));
  EXPECT_NEAR(margin, 2.0, kSledgeRounding);
}

TEST(FrozenPhase, SlipsAgainstItsDirection) {
  for (const double sign : {1.0, -1.0}) {
    SledgeScene s({0.0, 0.0}, {2.0 * sign, 0.0}, SledgeScene::pull(3.0), 0.5);
    FrozenPhase phase;
    phase.held = {held(s, sign)};
    Eigen::VectorXd a;
    ASSERT_TRUE(accelerate(s, phase, a)) << phase.fault();
    EXPECT_NEAR(a[0], 3.0 - sign * 0.5 * kSledgeG, kSledgeRounding);
    EXPECT_NEAR(a[1], 0.0, kSledgeRounding);
    EXPECT_EQ(phase.rows().set(0).form, ForceSet::Form::cone);
    EXPECT_NEAR(phase.gammaDot(1), a[0], kSledgeRounding);
    double margin = 0.0;
    ASSERT_TRUE(phase.margin(0, margin));
    EXPECT_NEAR(margin, kSledgeG, kSledgeRounding);  // λ_N alone ends a slip's normal force
  }
}

TEST(FrozenPhase, KeepsTheDirectionOfASlipPastItsEnd) {
  // The velocity is already against the sign: the force does not flip, so that the end is a root.
  SledgeScene s({0.0, 0.0}, {-1e-3, 0.0}, SledgeScene::pull(3.0), 0.5);
  FrozenPhase phase;
  phase.held = {held(s, 1.0)};
  Eigen::VectorXd a;
  ASSERT_TRUE(accelerate(s, phase, a)) << phase.fault();
  EXPECT_NEAR(a[0], 3.0 - 0.5 * kSledgeG, kSledgeRounding);
}

TEST(FrozenPhase, PullsWhereTheFloorWouldHaveToHoldItDown) {
  // Lifted by 2 g: λ_N = −g, which the margin reports as a status that cannot last.
  SledgeScene s(
      {0.0, 0.0}, {0.0, 0.0}, [](double, ConstVec, ConstVec) { return Vector2d(0.0, kSledgeG); },
      0.5);
  FrozenPhase phase;
  phase.held = {held(s)};
  Eigen::VectorXd a;
  ASSERT_TRUE(accelerate(s, phase, a)) << phase.fault();
  double margin = 0.0;
  ASSERT_TRUE(phase.margin(0, margin));
  EXPECT_LT(margin, 0.0);
}

TEST(FrozenPhase, SharesForcesOfRedundantContacts) {
  SledgeScene s({0.0, 0.0}, {0.0, 0.0}, SledgeScene::pull(3.0), 0.5, 0.0, 2);
  FrozenPhase phase;
  phase.held = {held(s, 0.0, 0), held(s, 0.0, 1)};
  Eigen::VectorXd a;
  ASSERT_TRUE(accelerate(s, phase, a)) << phase.fault();
  EXPECT_NEAR(a.norm(), 0.0, kSledgeRounding);
  EXPECT_NEAR(phase.lambda()[0] + phase.lambda()[2], kSledgeG, kSledgeRounding);
  EXPECT_NEAR(phase.lambda()[1] + phase.lambda()[3], -3.0, kSledgeRounding);
}

TEST(FrozenPhase, NamesAContactThatIsHeldAndGone) {
  SledgeScene s({0.0, 0.0}, {0.0, 0.0}, SledgeScene::pull(3.0), 0.5);
  FrozenPhase phase;
  phase.held = {held(s, 0.0, 7)};
  Eigen::VectorXd a;
  EXPECT_FALSE(accelerate(s, phase, a));
  EXPECT_EQ(phase.fault(), PhaseFault::kLost);
  EXPECT_EQ(phase.lost(), s.key(7));
}

TEST(FrozenPhase, ReportsThePowerOfFriction) {
  SledgeScene s({0.0, 0.0}, {2.0, 0.0}, SledgeScene::pull(3.0), 0.5);
  FrozenPhase phase;
  phase.held = {held(s, 1.0)};
  Eigen::VectorXd a;
  ASSERT_TRUE(accelerate(s, phase, a)) << phase.fault();
  EXPECT_NEAR(phase.power()[1], -0.5 * kSledgeG * 2.0, kSledgeRounding);
}

}  // namespace
}  // namespace dynamy
