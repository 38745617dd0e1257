// Forces of held contacts: a sledge of 1 kg on a floor.
#include <gtest/gtest.h>

#include <bit>
#include <dynamy/located/phase/held_forces.hpp>

#include "unit/located/sledge.hpp"

namespace dynamy {
namespace {

using Eigen::Vector2d;
using fixture::kSledgeG, fixture::kSledgeRounding, fixture::SledgeScene;

struct Forces {
  Forces(SledgeScene& s, const std::vector<Held>& given) : e(s.evaluate(s.x)), held(given) {
    EXPECT_TRUE(rows.read(held, e, s.x.u, fault) && rows.readSets(held, e, fault)) << fault.why;
    forces.solve(held, rows, e, rows.present());
  }
  const Evaluation& e;
  std::vector<Held> held;
  HeldRows rows;
  PhaseFault fault;
  HeldForces forces;
};

Held contact(const SledgeScene& s, int i, double sign = 0.0) {
  Held h;
  h.key = s.key(i), h.slips = sign != 0.0, h.sign = sign;
  return h;
}

TEST(HeldForces, HaveTheDirectionsOfTheirStatuses) {
  SledgeScene s({0.0, 0.0}, {2.0, 0.0}, SledgeScene::pull(3.0), 0.5);
  const Forces slip(s, {contact(s, 0, 1.0)}), stick(s, {contact(s, 0)});
  ForceDirections directions;
  directions.find(slip.held, slip.rows);
  EXPECT_EQ(directions.kept, std::vector<int>{0});
  EXPECT_EQ(directions.P().col(0), Vector2d(1.0, -0.5));  // e_N − μ t
  directions.find(stick.held, stick.rows);
  EXPECT_EQ(directions.kept, (std::vector<int>{0, 1}));
  EXPECT_EQ(directions.P(), Eigen::MatrixXd::Identity(2, 2));
}

TEST(HeldForces, KeepTheRowsThatStatusesHold) {
  SledgeScene s({0.0, 0.0}, {2.0, 0.0}, SledgeScene::pull(3.0), 0.5);
  const Forces slip(s, {contact(s, 0, 1.0)});
  EXPECT_NEAR((slip.forces.a() - Vector2d(3.0 - 0.5 * kSledgeG, 0.0)).norm(), 0.0, kSledgeRounding);
  EXPECT_NEAR((slip.forces.lambda() - Vector2d(kSledgeG, -0.5 * kSledgeG)).norm(), 0.0,
              kSledgeRounding);
  EXPECT_FALSE(slip.forces.redundant());
}

TEST(HeldForces, OfRedundantRowsAreNearestToThoseOfTheDecision) {
  SledgeScene s({0.0, 0.0}, {0.0, 0.0}, SledgeScene::pull(0.0), 0.5, 0.0, 2);
  std::vector<Held> held = {contact(s, 0), contact(s, 1)};
  held[0].lambda[0] = 6.0, held[1].lambda[0] = 2.0;
  const Forces f(s, held);
  EXPECT_TRUE(f.forces.redundant());
  // 10 N: the missing 2 N in equal parts.
  EXPECT_NEAR(f.forces.lambda()[0], 7.0, kSledgeRounding);
  EXPECT_NEAR(f.forces.lambda()[2], 3.0, kSledgeRounding);
  EXPECT_NEAR(f.forces.a().norm(), 0.0, kSledgeRounding);
}

TEST(HeldForces, OfRedundantRowsAreSharedByWeight) {
  SledgeScene s({0.0, 0.0}, {0.0, 0.0}, SledgeScene::pull(0.0), 0.0, 0.0, 2);
  std::vector<Held> held = {contact(s, 0), contact(s, 1)};
  held[0].weight = 2.0;
  const Forces f(s, held);
  // The smallest (λ₁/2)² + λ₂² with λ₁ + λ₂ = 10.
  EXPECT_NEAR(f.forces.lambda()[f.rows.row0(0)], 8.0, kSledgeRounding);
  EXPECT_NEAR(f.forces.lambda()[f.rows.row0(1)], 2.0, kSledgeRounding);
}

TEST(HeldForces, KnowWhichRowsOthersImply) {
  SledgeScene s({0.0, 0.0}, {0.0, 0.0}, SledgeScene::pull(3.0), 0.5, 0.0, 2);
  Forces first(s, {contact(s, 0), contact(s, 1)});
  first.forces.findImplied(first.held, first.rows);
  // Two rows of four: each contact holds both directions of the sledge.
  EXPECT_EQ(std::popcount(static_cast<unsigned>(first.held[0].implied)) +
                std::popcount(static_cast<unsigned>(first.held[1].implied)),
            2);
  const Forces later(s, first.held);
  EXPECT_TRUE(later.forces.redundant());
  EXPECT_NEAR((later.forces.a() - first.forces.a()).norm(), 0.0, kSledgeRounding);
  EXPECT_NEAR((later.forces.lambda() - first.forces.lambda()).norm(), 0.0, kSledgeRounding);
}

}  // namespace
}  // namespace dynamy
