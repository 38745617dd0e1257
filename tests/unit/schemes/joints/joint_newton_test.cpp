// Newton's iteration on joints, against closed forms of two masses on a line.
#include <gtest/gtest.h>

#include <dynamy/schemes/joints/joint_newton.hpp>

#include "unit/stages/linked_masses.hpp"

namespace dynamy {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;
using fixture::LinkedMasses;

constexpr double kM1 = 1.0, kM2 = 3.0, kForce = 8.0, kJointDt = 1e-2;
/// K is taken by differences of 1e-7 of a linear residual: rounding over the difference.
constexpr double kDifferences = 1e-7;

/// A rod of 1 m, and a force on mass 0.
LinkedMasses pulled() {
  return {Vector2d(kM1, kM2),
          Vector2d(1.0, 0.0),
          Vector2d::Zero(),
          {{0, 1, 1.0}},
          {},
          0.0,
          [](double, ConstVec, ConstVec, Vec h) { h = Vector2d(kForce, 0.0); }};
}

/// Contact i: one row, 1 on velocity i.
ContactSet unitDirections(int n) {
  ContactSet c;
  c.row0 = {0}, c.segment0 = {0};
  for (int i = 0; i < n; ++i) {
    c.segment.push_back({.block = i, .u0 = i, .nu = 1, .w = i});
    c.W.push_back(1.0), c.row0.push_back(i + 1), c.segment0.push_back(i + 1);
  }
  return c;
}

TEST(JointNewton, SolvesALinearProblemInTwoSteps) {
  LinkedMasses s = pulled();
  JointNewton newton;
  ASSERT_TRUE(newton.equations.begin(*s.system, s.x, kJointDt));
  EXPECT_EQ(newton.equations.rows(), 1);
  EXPECT_EQ(newton.unknowns(), 3);
  const VectorXd none = VectorXd::Zero(2);
  using Tangent = JointNewton::Tangent;
  // Masses and W are all that a linear problem has. Differences are asked for in the second turn.
  for (const auto& [wanted, found] : {std::pair(Tangent::closedForm, Tangent::masses),
                                      std::pair(Tangent::differences, Tangent::differences)}) {
    newton.equations.evaluate(*s.system, none);
    ASSERT_TRUE(newton.linearise(*s.system, none, wanted));
    EXPECT_EQ(newton.tangent(), found);
    newton.newtonStep(), newton.take();
  }
  // Both masses get a = F/(m₁ + m₂); the rod gives mass 1 what it needs: Λ = −m₂ a Δt.
  const double a = kForce / (kM1 + kM2);
  EXPECT_NEAR(newton.equations.v[0], 0.5 * a * kJointDt, kDifferences * kJointDt);
  EXPECT_NEAR(newton.equations.v[1], 0.5 * a * kJointDt, kDifferences * kJointDt);
  EXPECT_NEAR(newton.equations.Lambda[0], -kM2 * a * kJointDt, kDifferences);
  newton.equations.evaluate(*s.system, none);
  EXPECT_NEAR(newton.equations.end.q[0] - newton.equations.end.q[1], 1.0, 1e-14);
  EXPECT_NEAR(newton.equations.end.u[0], a * kJointDt, kDifferences * kJointDt);
  EXPECT_NEAR(newton.equations.midpoint.t, 0.5 * kJointDt, 1e-17);
}

TEST(JointNewton, StartsFromThePercussionsOfTheLastStep) {
  LinkedMasses s = pulled();
  s.x.impulses.key = {contactKey(1, 0)};
  s.x.impulses.first = {0, 1};
  s.x.impulses.Lambda = {-0.5};
  s.x.impulses.dt = 2.0 * kJointDt;
  JointNewton newton;
  ASSERT_TRUE(newton.equations.begin(*s.system, s.x, kJointDt));
  EXPECT_EQ(newton.equations.Lambda[0], -0.25);  // in proportion to the step
}

TEST(JointNewton, BringsBackARodThatIsOff) {
  LinkedMasses s(Vector2d(kM1, kM2), Vector2d(1.001, 0.0), Vector2d::Zero(), {{0, 1, 1.0}}, {}, 0.0,
                 [](double, ConstVec, ConstVec, Vec h) { h.setZero(); });
  JointNewton newton;
  ASSERT_TRUE(newton.equations.begin(*s.system, s.x, kJointDt));
  const VectorXd none = VectorXd::Zero(2);
  for (int turn = 0; turn < 2; ++turn) {
    newton.equations.evaluate(*s.system, none);
    ASSERT_TRUE(newton.linearise(*s.system, none));
    newton.newtonStep(), newton.take();
  }
  newton.equations.evaluate(*s.system, none);
  EXPECT_NEAR(newton.equations.end.q[0] - newton.equations.end.q[1], 1.0, 1e-13);
  // No force from outside: the centre of mass stays.
  EXPECT_NEAR(kM1 * newton.equations.v[0] + kM2 * newton.equations.v[1], 0.0, 1e-12);
}

TEST(JointNewton, AnswersWithTheMassesThatARodCouples) {
  LinkedMasses s = pulled();
  JointNewton newton;
  ASSERT_TRUE(newton.equations.begin(*s.system, s.x, kJointDt));
  const VectorXd none = VectorXd::Zero(2);
  newton.equations.evaluate(*s.system, none);
  ASSERT_TRUE(newton.linearise(*s.system, none));
  // An impulse on mass 0 moves both: 2 (m₁ + m₂) δv = 1.
  const ContactSet ends = unitDirections(2);
  ContactResponse response;
  newton.respond(ends, 0, response);
  for (const int mass : {0, 1})
    EXPECT_NEAR(newton.along(ends, mass, 0, response, 0), 0.5 / (kM1 + kM2), kDifferences);
}

TEST(JointNewton, HasNothingToDoWithoutJointsAndWithConstantMasses) {
  LinkedMasses s(Vector2d(kM1, kM2), Vector2d(1.0, 0.0), Vector2d::Zero(), {}, {{0, 1, -1}});
  JointNewton newton;
  EXPECT_FALSE(newton.equations.begin(*s.system, s.x, kJointDt));
}

}  // namespace
}  // namespace dynamy
