// Projections in the metric of the mass, against closed forms of two masses on a line.
#include <gtest/gtest.h>

#include <dynamy/stages/projection.hpp>

#include "unit/stages/linked_masses.hpp"

namespace dynamy {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;
using fixture::LinkedMasses;

constexpr double kM1 = 1.0, kM2 = 3.0;
const Vector2d kMasses{kM1, kM2};
/// The solver's default tolerance of 1e-10, relative to numbers of size 1e-1 here; the regularised
/// solution of touch() has 1e-10, too.
constexpr double kSolved = 1e-9;

/// Masses 0 and 1 with a rod of 1 m that is too long by `error`.
LinkedMasses rodOffBy(double error, const Vector2d& u = Vector2d::Zero()) {
  return {kMasses, Vector2d(1.0 + error, 0.0), u, {{0, 1, 1.0}}};
}

/// The state remembers that each contact of element 0 carried.
void carried(LinkedMasses& s) {
  s.x.impulses.dt = 1e-2;
  s.x.impulses.first = {0};
  for (const fixture::Pair& p : s.stack.pairs) {
    s.x.impulses.key.push_back(contactKey(0, p.id));
    s.x.impulses.first.push_back(static_cast<int>(s.x.impulses.key.size()));
    s.x.impulses.Lambda.push_back(1.0);
  }
}

TEST(Projection, MovesLightBodiesFartherThanHeavyOnes) {
  // min ½ δᵀMδ with δ₁ − δ₂ = −e: δ₁ = −e m₂/(m₁ + m₂), δ₂ = e m₁/(m₁ + m₂).
  LinkedMasses s = rodOffBy(0.1);
  ASSERT_TRUE(Projection().positions(*s.system, s.solver, s.x, 1e-12));
  EXPECT_NEAR(s.x.q[0], 1.1 - 0.1 * kM2 / (kM1 + kM2), kSolved);
  EXPECT_NEAR(s.x.q[1], 0.1 * kM1 / (kM1 + kM2), kSolved);
  EXPECT_EQ(s.x.t, 0.0);
}

TEST(Projection, LeavesWhatIsNotOffToTheLastBit) {
  LinkedMasses s = rodOffBy(1e-6);
  const VectorXd q = s.x.q;
  ASSERT_TRUE(Projection().positions(*s.system, s.solver, s.x, 1e-5));
  EXPECT_EQ(s.x.q, q);
}

TEST(Projection, OpensOverlapsAndClosesNoGap) {
  // Contact of mass 0 on mass 1, and of mass 1 on the ground: the first overlaps, the second is
  // open by more than the way that the first needs.
  LinkedMasses s(kMasses, Vector2d(0.4, 0.5), Vector2d::Zero(), {}, {{0, 0, 1}, {1, 1, -1}});
  ASSERT_TRUE(Projection().positions(*s.system, s.solver, s.x, 1e-12));
  EXPECT_NEAR(s.x.q[0], 0.4 + 0.1 * kM2 / (kM1 + kM2), kSolved);
  EXPECT_NEAR(s.x.q[1], 0.5 - 0.1 * kM1 / (kM1 + kM2), kSolved);
}

TEST(Projection, LooksNoFurtherThanATenthOfTheScene) {
  // The rod is too long by 0.1 m. Of a scene without a known length the ground 0.5 m below takes part
  // in the projection, of one of 1 m it does not: less work for the same place.
  long visits[2] = {0, 0};
  for (const bool known : {false, true}) {
    LinkedMasses s(kMasses, Vector2d(1.6, 0.5), Vector2d::Zero(), {{0, 1, 1.0}}, {{0, 1, -1}});
    SolverWork work;
    s.system->limits.work = &work;
    if (known) s.system->limits.length = 1.0;
    ASSERT_TRUE(Projection().positions(*s.system, s.solver, s.x, 1e-12));
    EXPECT_NEAR(s.x.q[1], 0.5 + 0.1 * kM1 / (kM1 + kM2), kSolved);
    visits[known ? 1 : 0] = work.visits;
  }
  EXPECT_LT(visits[1], visits[0]);
}

TEST(Projection, DoesNotMendAJointAtTheCostOfAContact) {
  // Mass 1 lies on the ground and may not go below: the rod moves mass 0 alone.
  LinkedMasses s(kMasses, Vector2d(0.9, 0.0), Vector2d::Zero(), {{0, 1, 1.0}}, {{0, 1, -1}});
  ASSERT_TRUE(Projection().positions(*s.system, s.solver, s.x, 1e-12));
  EXPECT_NEAR(s.x.q[0], 1.0, kSolved);
  EXPECT_NEAR(s.x.q[1], 0.0, kSolved);
}

TEST(Projection, LeavesPositionsThatContradictEachOtherNoWorse) {
  // Two rods of 1 m and 2 m between the same masses, which are 1.5 m apart, and a contact that closes
  // on the way: no position fulfils them.
  LinkedMasses s(kMasses, Vector2d(1.5, 0.0), Vector2d::Zero(), {{0, 1, 1.0}, {0, 1, 2.0}},
                 {{0, 1, -1}});
  EXPECT_FALSE(Projection().positions(*s.system, s.solver, s.x, 1e-12));
  const double apart = s.x.q[0] - s.x.q[1];
  EXPECT_LE(std::max(std::abs(apart - 1.0), std::abs(apart - 2.0)), 0.5 + kSolved);
}

TEST(Projection, OfOverlapsHoldsJointsAndLeavesThoseThatRebound) {
  // The rod is off and keeps its length; mass 1 comes out of the ground with mass 0.
  LinkedMasses s(kMasses, Vector2d(1.05, -0.01), Vector2d::Zero(), {{0, 1, 1.0}}, {{0, 1, -1}});
  ASSERT_TRUE(Projection().overlaps(*s.system, s.solver, s.x, 1e-12));
  EXPECT_NEAR(s.x.q[1], 0.0, kSolved);
  EXPECT_NEAR(s.x.q[0] - s.x.q[1], 1.06, kSolved);
  LinkedMasses elastic(kMasses, Vector2d(1.0, -0.01), Vector2d::Zero(), {}, {{0, 1, -1}}, 0.5);
  ASSERT_TRUE(Projection().overlaps(*elastic.system, elastic.solver, elastic.x, 1e-12));
  EXPECT_EQ(elastic.x.q[1], -0.01);
}

TEST(Projection, TouchesWhatIsAboutToCloseAndOpensNothingThatCarries) {
  // Mass 1 carries on the ground; mass 0 is to be closed on it and comes down alone.
  LinkedMasses s(kMasses, Vector2d(1e-3, 0.0), Vector2d::Zero(), {}, {{0, 0, 1}, {1, 1, -1}});
  carried(s);
  s.x.impulses.Lambda[0] = 0.0;
  s.system->evaluate(s.x, {.reach = 1e-2});
  ASSERT_TRUE(Projection().touch(*s.system, s.x, {contactKey(0, 0)}, 1e-12));
  EXPECT_NEAR(s.x.q[0], 0.0, 1e-3 * kSolved);
  EXPECT_NEAR(s.x.q[1], 0.0, 1e-3 * kSolved);
}

TEST(Projection, EndsWithWhatCameNearest) {
  // Nothing meets a tolerance below zero: turns that do not halve the violation end it.
  LinkedMasses rod = rodOffBy(0.25);
  EXPECT_FALSE(Projection().positions(*rod.system, rod.solver, rod.x, -1.0));
  EXPECT_LT(largestViolation(rod.system->evaluate(rod.x).contacts, rod.x), 0.25 * kSolved);
  // Rods of 1 and of 1.5 m: whatever corrections lead to, the result is no worse than the start.
  LinkedMasses both(kMasses, Vector2d(1.2, 0.0), Vector2d::Zero(), {{0, 1, 1.0}, {0, 1, 1.5}});
  EXPECT_FALSE(Projection().positions(*both.system, both.solver, both.x, 1e-12));
  EXPECT_LE(largestViolation(both.system->evaluate(both.x).contacts, both.x), 0.3 + 1e-12);
}

TEST(Projection, OfVelocitiesKeepsTheMomentum) {
  LinkedMasses s = rodOffBy(0.0, {2.0, -2.0});
  ASSERT_TRUE(Projection().velocities(*s.system, s.solver, s.x));
  const double common = (2.0 * kM1 - 2.0 * kM2) / (kM1 + kM2);
  EXPECT_NEAR(s.x.u[0], common, kSolved);
  EXPECT_NEAR(s.x.u[1], common, kSolved);
}

TEST(Projection, OfVelocitiesTakesContactsThatCarriedAlone) {
  for (const bool carries : {true, false}) {
    LinkedMasses s(kMasses, Vector2d(0.0, 0.0), Vector2d(-2.0, 0.0), {}, {{0, 0, 1}});
    if (carries) carried(s);
    ASSERT_TRUE(Projection().velocities(*s.system, s.solver, s.x));
    EXPECT_NEAR(s.x.u[0], carries ? -2.0 * kM1 / (kM1 + kM2) : -2.0, kSolved) << carries;
  }
}

TEST(Projection, HasAnImpactOnlyWhereForcesDoNotExplainTheApproach) {
  // Δt = 1e-2 s: four steps of weight change a velocity by 0.39 m/s.
  for (const double speed : {0.3, 2.0}) {
    LinkedMasses s(kMasses, Vector2d(1.0, 0.0), Vector2d(0.0, -speed), {}, {{0, 1, -1}}, 0.5);
    s.system->evaluate(s.x);
    Projection projection;
    Jump jump;
    const auto solved = projection.impact(*s.system, s.solver, s.x, 1e-2, jump);
    EXPECT_EQ(solved.has_value(), speed > 1.0) << speed;
    if (!solved) continue;
    EXPECT_NEAR(s.x.u[1], 0.5 * speed, kSolved);
    ASSERT_NE(projection.percussions(contactKey(0, 0)), nullptr);
    EXPECT_NEAR(projection.percussions(contactKey(0, 0))[0], 1.5 * kM2 * speed, kSolved);
    // ½ m (u⁺² − u⁻²)
    EXPECT_NEAR(jump.works.normal, -0.5 * kM2 * 0.75 * speed * speed, 10.0 * kSolved);
  }
}

}  // namespace
}  // namespace dynamy
