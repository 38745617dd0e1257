/// Steps that are too long for the motion are divided into equal parts (theory 37.6).
#include <gtest/gtest.h>

#include <dynamy/core/error.hpp>
#include <dynamy/simulation/run/step_division.hpp>

namespace dynamy {
namespace {

constexpr long kPlenty = 1000;

/// Of an explicit step.
Coarseness coarseness(double turn, double share, double overlap = 0.0) {
  return Coarseness::of(turn, {share, share > ForceResolution::kExplicit}, overlap);
}

TEST(StepDivision, FollowsTheFastestTurn) {
  StepDivision d(true);
  EXPECT_EQ(d.begin(), 1);
  EXPECT_EQ(d.parts(coarseness(0.9, 0.0), 1.0, kPlenty, kPlenty), 1);
  EXPECT_EQ(d.finest(), 1);
  EXPECT_EQ(d.parts(coarseness(2.5, 0.0), 1.0, kPlenty, kPlenty), 4);  // at most 1 rad in each
  EXPECT_EQ(d.finest(), 4);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(d.parts(coarseness(0.625, 0.0), 0.25, kPlenty, kPlenty), 1);
  EXPECT_EQ(d.begin(), 4);  // the next step needs as many
}

TEST(StepDivision, TakesNoPartsForATurnThatNoneWouldResolve) {
  StepDivision d(true);
  d.begin();
  EXPECT_EQ(d.parts(coarseness(4000.0, 0.0), 1.0, 1L << 20, 1L << 20), 4096);
  EXPECT_EQ(StepDivision(d).parts(coarseness(5000.0, 0.0), 1.0, 1L << 20, 1L << 20), 1);
  EXPECT_EQ(StepDivision(d).parts(coarseness(1e20, 0.0), 1.0, 1L << 20, 1L << 20), 1);
}

TEST(StepDivision, ResolvesForcesThatAStepDoesNot) {
  StepDivision d(true);
  d.begin();
  // ωΔt ≤ 2 √(2/32) = 0.5: nothing is divided.
  EXPECT_EQ(d.parts(coarseness(0.0, 1.0 / 32.0), 1.0, kPlenty, kPlenty), 1);
  // A share of 8 is ωΔt ≤ 2 √16 = 8: 22.9 parts of 0.35, so 32.
  EXPECT_EQ(d.parts(coarseness(0.0, 8.0), 1.0, kPlenty, kPlenty), 32);
  const double share = 8.0 / (32.0 * 32.0);
  for (int k = 0; k < 32; ++k)
    EXPECT_EQ(d.parts(coarseness(0.0, share), 1.0 / 32.0, kPlenty, kPlenty), 1);
  EXPECT_EQ(d.begin(), 32);
}

TEST(StepDivision, ChangesTheNumberOfPartsSeldom) {
  StepDivision d(true);
  const auto step = [&d](double share) {  // of a full step
    const int n = d.begin();
    const int again = d.parts(coarseness(0.0, share / (n * n)), 1.0 / n, kPlenty, kPlenty);
    if (again > 1)
      d.parts(coarseness(0.0, share / (n * n * again * again)), 1.0 / (n * again), kPlenty,
              kPlenty);
    return n;
  };
  step(8.0);
  EXPECT_EQ(step(8.0), 32);
  EXPECT_EQ(step(30.0), 32);  // would need 44.3: more parts from now on
  EXPECT_EQ(step(4.5), 64);   // needs 17.1
  EXPECT_EQ(step(0.4), 64);   // needs 5.1: fewer parts from now on
  EXPECT_EQ(step(0.4), 32);
  EXPECT_EQ(step(0.4), 16);
  EXPECT_EQ(step(0.4), 16);  // a quarter of 16 would not do
}

TEST(StepDivision, LeavesForcesDampedThatWouldCostTooMuch) {
  StepDivision d(true);
  d.begin();
  EXPECT_EQ(d.parts(coarseness(0.0, 4e4), 1.0, kPlenty, kPlenty), 1);  // 1616 parts
  EXPECT_EQ(d.parts(coarseness(3.0, 4e4), 1.0, kPlenty, kPlenty), 4);  // bodies turn all the same
}

TEST(StepDivision, OfAMeetingLastsOneStep) {
  StepDivision d(true);
  d.begin();
  EXPECT_EQ(d.parts(coarseness(0.0, 0.0, 0.02), 1.0, kPlenty, kPlenty),
            8);  // 0.4 % of the length each
  EXPECT_EQ(d.finest(), 8);
  EXPECT_EQ(d.begin(), 1);
}

TEST(StepDivision, StopsAtAnEighthOfAStepThatLeadsToAnOverlap) {
  const auto leading = [](double mosts) {
    return Coarseness::of(0.0, {}, 0.0, mosts * Coarseness::kMostForeseen);
  };
  StepDivision d(true);
  d.begin();
  EXPECT_EQ(d.parts(leading(1.0), 1.0, kPlenty, kPlenty), 1);
  EXPECT_EQ(d.parts(leading(3.0), 1.0, kPlenty, kPlenty), 4);
  EXPECT_EQ(d.parts(leading(1.5), 0.25, kPlenty, kPlenty), 2);
  EXPECT_EQ(d.parts(leading(1e6), 1.0, kPlenty, kPlenty), 8);
  EXPECT_EQ(d.parts(leading(1e6), 0.125, kPlenty, kPlenty), 1);
  EXPECT_EQ(d.begin(), 8);  // the overlap would be in the middle of the next step
  EXPECT_EQ(d.parts(leading(0.1), 0.125, kPlenty, kPlenty), 1);
  EXPECT_EQ(d.begin(), 1);  // the step after it need not lead to one
}

TEST(StepDivision, IsOffForANamedScheme) {
  StepDivision d(false);
  EXPECT_FALSE(d.divides());
  EXPECT_EQ(d.begin(), 1);
  EXPECT_EQ(d.parts(coarseness(10.0, 10.0, 1.0), 1.0, kPlenty, kPlenty), 1);
}

TEST(StepDivision, StopsAtItsBound) {
  StepDivision d(true);
  d.begin();
  EXPECT_EQ(d.parts(coarseness(100.0, 0.0), 1.0, 8, 8), 8);
  EXPECT_EQ(d.parts(coarseness(12.5, 0.0), 0.125, 8, 8), 1);
}

TEST(StepDivision, IsKeptAndExamined) {
  StepDivision d(true), same(true);
  d.begin(), d.parts(coarseness(2.5, 0.0), 1.0, kPlenty, kPlenty);
  Archive out;
  d.archive(out);
  Archive in(out.bytes());
  same.archive(in);
  EXPECT_EQ(same.begin(), d.begin());
  Archive wrong;
  bool swings = false;
  double parts = 0.5, need = 1.0;
  wrong(swings), wrong(parts), wrong(need);
  Archive back(wrong.bytes());
  EXPECT_THROW(same.archive(back), ModelError);
}

TEST(StepDivision, LetsForcesThatAreDampedBringInLittle) {
  const auto parts = [](double gain) {
    StepDivision d(true);
    d.begin();
    return d.parts(Coarseness::of(0.0, {}, 0.0, 0.0, gain), 1.0, 64, 64);
  };
  EXPECT_EQ(parts(0.0), 1);
  EXPECT_EQ(parts(Coarseness::kMostGain), 1);
  EXPECT_EQ(parts(2.0 * Coarseness::kMostGain), 2);
  EXPECT_EQ(parts(10.0 * Coarseness::kMostGain), 4);  // errors of order 2
  EXPECT_EQ(parts(1e9), 8);                           // not more at once
}

TEST(StepDivision, FollowsAWayThatBends) {
  const auto of = [](double error) {
    return Coarseness::of(0.0, {}, 0.0, 0.0, 0.0, error * Coarseness::kMostCurve);
  };
  StepDivision d(true);
  d.begin();
  EXPECT_EQ(d.parts(of(0.9), 1.0, kPlenty, kPlenty), 1);
  EXPECT_EQ(d.parts(of(9.0), 1.0, kPlenty, kPlenty),
            4);  // three parts of error 9/27 each would add to 1
  // A quarter may make a quarter of the error: one of 9/64 is fine.
  EXPECT_EQ(d.parts(of(9.0 / 64.0), 0.25, kPlenty, kPlenty), 1);
  EXPECT_EQ(d.begin(), 4);  // the next step bends alike
  // No more than kMostCurveParts in all.
  EXPECT_EQ(d.parts(of(1e9), 1.0 / Coarseness::kMostCurveParts, kPlenty, kPlenty), 1);
}

}  // namespace
}  // namespace dynamy
