// Corrections of positions and velocities of held contacts: a sledge on a floor.
#include <gtest/gtest.h>

#include <dynamy/located/phase/held_projection.hpp>

#include "unit/located/sledge.hpp"

namespace dynamy {
namespace {

using Eigen::Vector2d;
using fixture::SledgeScene;

/// Rounding of numbers below 1e-2 through a solve of one or two unknowns.
constexpr double kProjectionRounding = 1e-16;

/// Corrections δ with `contacts` contacts held that slip or stick.
struct Corrections {
  Corrections(SledgeScene& s, int contacts, bool slips) {
    const Evaluation& e = s.system->evaluate(s.x);
    std::vector<Held> held(static_cast<std::size_t>(contacts));
    for (int i = 0; i < contacts; ++i) {
      Held& h = held[static_cast<std::size_t>(i)];
      h.key = s.key(i), h.slips = slips, h.sign = 1.0;
    }
    HeldRows rows;
    PhaseFault fault;
    EXPECT_TRUE(rows.read(held, e, s.x.u, fault)) << fault.why;
    HeldProjection projection;
    moves = projection.positions(held, rows, e, position);
    turns = projection.velocities(held, rows, e, velocity);
  }
  bool moves, turns;
  Eigen::VectorXd position, velocity;
};

TEST(HeldProjection, CorrectsHeldRowsAlone) {
  SledgeScene s({0.3, -1e-4}, {2.0, 1e-3}, SledgeScene::pull(3.0), 0.5);
  const Corrections c(s, 1, true);
  ASSERT_TRUE(c.moves && c.turns);
  EXPECT_NEAR((c.position - Vector2d(0.0, 1e-4)).norm(), 0.0, kProjectionRounding);
  // The slip is no held row: the normal velocity goes, the tangential one stays.
  EXPECT_NEAR((c.velocity - Vector2d(0.0, -1e-3)).norm(), 0.0, 10.0 * kProjectionRounding);
}

TEST(HeldProjection, StopsWhatSticks) {
  SledgeScene s({0.3, 0.0}, {2e-3, 1e-3}, SledgeScene::pull(3.0), 0.5);
  const Corrections c(s, 1, false);
  ASSERT_TRUE(c.turns);
  EXPECT_NEAR((c.velocity - Vector2d(-2e-3, -1e-3)).norm(), 0.0, 10.0 * kProjectionRounding);
}

TEST(HeldProjection, SharesTheCorrectionOfRedundantRows) {
  SledgeScene s({0.3, -1e-4}, {0.0, 1e-3}, SledgeScene::pull(3.0), 0.5, 0.0, 3);
  const Corrections c(s, 3, true);
  ASSERT_TRUE(c.moves && c.turns);
  EXPECT_NEAR((c.position - Vector2d(0.0, 1e-4)).norm(), 0.0, 10.0 * kProjectionRounding);
  EXPECT_NEAR((c.velocity - Vector2d(0.0, -1e-3)).norm(), 0.0, 100.0 * kProjectionRounding);
}

TEST(HeldProjection, ReportsThatNothingIsOff) {
  SledgeScene s({0.3, 0.0}, {2.0, 0.0}, SledgeScene::pull(3.0), 0.5);
  const Corrections c(s, 1, true);
  EXPECT_FALSE(c.moves || c.turns);
}

}  // namespace
}  // namespace dynamy
