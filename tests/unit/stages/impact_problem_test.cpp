// The inclusion that was posed: percussions, scales and aims, on masses on vertical lines.
#include <gtest/gtest.h>

#include <dynamy/stages/problem_scales.hpp>
#include <limits>
#include <support/gravity.hpp>

#include "unit/stages/stage_fixture.hpp"

namespace dynamy {
namespace {

using Eigen::VectorXd;
using fixture::Scene;

constexpr double kStep = 1e-3;

/// One mass of 1 kg above the ground, or in it.
Scene mass(double height, double speed) {
  return {
      VectorXd::Ones(1), VectorXd::Constant(1, height), VectorXd::Constant(1, speed), {{0, 0, -1}}};
}

TEST(ImpactProblem, VelocitiesFollowFromThePercussions) {
  Scene s = mass(0.0, -2.0);
  s.system->evaluate(s.x);
  ImpactProblem& problem = s.system->impactProblem(s.x, kStep);
  EXPECT_EQ(problem.gammaA[0], -2.0);
  EXPECT_EQ(problem.gammaFree[0], -2.0 - kG * kStep);
  problem.Lambda()[0] = 3.0;
  problem.velocityFromImpulses(s.x);
  EXPECT_EQ(s.x.u[0], -2.0 - kG * kStep + 3.0);
  EXPECT_EQ(s.x.impulses.Lambda, std::vector<double>{3.0});
  EXPECT_EQ(s.x.impulses.dt, kStep);
}

TEST(ImpactProblem, AnotherFreeVelocityChangesGammaFreeAlone) {
  Scene s = mass(0.0, -2.0);
  s.system->evaluate(s.x);
  ImpactProblem& problem = s.system->impactProblem(s.x, kStep);
  problem.freeVelocity(VectorXd::Constant(1, -5.0));
  EXPECT_EQ(problem.gammaFree[0], -5.0);
  EXPECT_EQ(problem.gammaA[0], -2.0);
  // The largest change of a relative velocity that the contact requires.
  EXPECT_EQ(problem.uRef, 5.0);
}

TEST(ImpactProblem, IsSolvedByNothingWhereNoContactRequiresAVelocity) {
  Scene s = mass(0.0, 2.0);
  s.x.impulses = {{contactKey(0, 0)}, {0, 1}, {7.0}, kStep, false};
  s.system->evaluate(s.x);
  const ImpactProblem& problem = s.system->impactProblem(s.x, kStep);
  EXPECT_EQ(problem.Lambda(0), 0.0);
  EXPECT_TRUE(problem.pressedBefore(0));
}

TEST(ImpulseStart, TakesPercussionsByKeyInProportionToTheStep) {
  Scene s = mass(0.0, -2.0);
  s.system->evaluate(s.x);
  const ContactSet& c = s.system->slot(0).contacts;
  ImpulseStart start;
  std::vector<double> Lambda;
  start.set(c, {{contactKey(0, 0)}, {0, 1}, {7.0}, 2.0 * kStep, false}, kStep, Lambda);
  EXPECT_EQ(Lambda, std::vector<double>{3.5});
  EXPECT_TRUE(start.pressedBefore(0));
  start.set(c, {{contactKey(0, 1)}, {0, 1}, {7.0}, kStep, false}, kStep, Lambda);
  EXPECT_EQ(Lambda, std::vector<double>{0.0});
  EXPECT_FALSE(start.pressedBefore(0));
}

TEST(ImpulseStart, BeginsAgainWithASolutionUntilItForgetsIt) {
  Scene s = mass(0.0, -2.0);
  s.system->evaluate(s.x);
  const ContactSet& c = s.system->slot(0).contacts;
  ImpulseStart start;
  std::vector<double> Lambda;
  start.again(c, {4.0});
  start.set(c, {}, kStep, Lambda);
  EXPECT_EQ(Lambda, std::vector<double>{4.0});
  start.forget();
  start.set(c, {}, kStep, Lambda);
  EXPECT_EQ(Lambda, std::vector<double>{0.0});
}

TEST(PositionAim, AnOpenGapIsClosedByItsTermAndAnImpactWaitsForIt) {
  // At rest 1 mm above the ground: g/Δt is added. At 2 m/s it is an impact, which arrives in this
  // step: its term is larger by 4 (|γ_free| + |γ^A|), and keeps it away.
  for (const double speed : {0.0, -2.0}) {
    Scene s = mass(1e-3, speed);
    s.system->evaluate(s.x, {.ahead = kStep});
    const PositionAim aim;
    const ImpactProblem& problem = s.system->impactProblem(s.x, kStep, 0, &aim);
    if (speed == 0.0) {
      EXPECT_EQ(problem.size(), 0);  // it does not close within the step: nothing to solve
      continue;
    }
    ASSERT_EQ(problem.size(), 1);
    const double free = speed - kG * kStep;
    EXPECT_NEAR(problem.gammaFree[0], free + 1e-3 / kStep + 4.0 * (std::abs(free) - speed), 1e-14);
    EXPECT_EQ(problem.arriving(), std::vector<ContactKey>{contactKey(0, 0)});
  }
}

TEST(EvaluationRequest, HoldsContactsWhateverTheirGap) {
  Scene s = mass(0.5, 0.0);
  EXPECT_EQ(s.system->evaluate(s.x).contacts.size(), 0);
  const std::vector<ContactKey> keys{contactKey(0, 0)};
  EXPECT_EQ(s.system->evaluate(s.x, {.held = HeldContacts{keys}}).contacts.size(), 1);
  EXPECT_EQ(s.system->evaluate(s.x).contacts.size(), 0);  // no mode is left
  EXPECT_EQ(s.system->evaluate(s.x, {.reach = 0.5}).contacts.size(), 1);
  const std::vector<char> none{0};
  EXPECT_EQ(s.system->evaluate(s.x, {.reach = 0.5, .elements = none}).contacts.size(), 0);
}

}  // namespace
}  // namespace dynamy
