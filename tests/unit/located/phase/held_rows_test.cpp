// Rows of held contacts at one state: a sledge on a floor.
#include <gtest/gtest.h>

#include <dynamy/located/phase/held_rows.hpp>

#include "unit/located/sledge.hpp"

namespace dynamy {
namespace {

using Eigen::Vector2d;
using fixture::SledgeScene;

/// The rows of contact 0, which slips forward.
struct Rows {
  explicit Rows(SledgeScene& s) : e(s.system->evaluate(s.x)) {
    held.resize(1);
    held[0].key = s.key(), held[0].slips = true, held[0].sign = 1.0;
    known = rows.read(held, e, s.x.u, fault) && rows.readSets(held, e, fault);
  }
  const Evaluation& e;
  std::vector<Held> held;
  HeldRows rows;
  PhaseFault fault;
  bool known = false;
};

TEST(HeldRows, HaveVelocitiesPositionsAndTheSetOfTheirLaw) {
  SledgeScene s({0.3, -1e-3}, {2.0, -0.5}, SledgeScene::pull(0.0), 0.5);
  const Rows r(s);
  ASSERT_TRUE(r.known) << r.fault.why;
  EXPECT_EQ(r.rows.size(), 2);
  EXPECT_EQ(r.rows.gamma(), Vector2d(-0.5, 2.0));
  EXPECT_EQ(r.rows.position(), Vector2d(-1e-3, 0.0));
  EXPECT_EQ(r.rows.W().col(0), Vector2d(0.0, 1.0));
  EXPECT_EQ(r.rows.MInvW(), r.rows.W());  // 1 kg
  EXPECT_EQ(r.rows.set(0).form, ForceSet::Form::cone);
  EXPECT_EQ(r.rows.slip0(0), 1);
  EXPECT_EQ(r.rows.slipRows(0), 1);
  EXPECT_EQ(countRows(r.held, r.e), 2);
}

TEST(HeldRows, NameAContactThatIsNotReported) {
  SledgeScene s({0.0, 0.0}, {0.0, 0.0}, SledgeScene::pull(0.0), 0.5);
  Rows r(s);
  r.held[0].key = s.key(7);
  EXPECT_FALSE(r.rows.read(r.held, r.e, s.x.u, r.fault));
  EXPECT_EQ(r.fault.why, PhaseFault::kLost);
  EXPECT_EQ(r.fault.contact, s.key(7));
}

TEST(HeldRows, KeepTheConstraintOfTheNextPosition) {
  SledgeScene s({0.0, 0.0}, {2.0, -0.5}, SledgeScene::pull(0.0), 0.5);
  Rows r(s);
  AccelerationRows next;
  const double tau = 0.125;
  ASSERT_TRUE(r.rows.readNext(r.held, r.e.contacts, s.x.u, tau, next, r.fault));
  // Rᵀu̇ + r = 0 is Wᵀ(u + τ u̇) = 0.
  EXPECT_EQ(next.R, r.rows.W());
  EXPECT_EQ(next.r, Vector2d(-0.5, 2.0) / tau);
}

}  // namespace
}  // namespace dynamy
