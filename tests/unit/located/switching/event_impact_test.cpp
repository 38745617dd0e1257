// The impact at an event: a sledge of 1 kg that hits a floor.
#include <gtest/gtest.h>

#include <dynamy/located/switching/event_impact.hpp>

#include "unit/located/switching/sledge_event.hpp"

namespace dynamy {
namespace {

using fixture::kSolved, fixture::SledgeEvent, fixture::SledgeScene;

TEST(EventImpact, ReboundsUnlessAContactIsToBePlastic) {
  for (const bool plastic : {false, true}) {
    SledgeScene s({0.0, 0.0}, {0.0, -3.0}, SledgeScene::pull(0.0), 0.0, 0.5);
    SledgeEvent e(s);
    EventImpact impact;
    impact.take(e.at, plastic ? e.keys : std::vector<ContactKey>{});
    const double after = plastic ? 0.0 : 1.5;
    EXPECT_NEAR(e.p.x.u[1], after, kSolved);
    EXPECT_NEAR(impact.gamma()[0], after, kSolved);
    ASSERT_EQ(impact.percussions().size(), 1u);
    EXPECT_NEAR(impact.percussions()[0].Lambda[0], after + 3.0, kSolved);
    EXPECT_EQ(impact.percussions()[0].gammaMinus[0], -3.0);
    EXPECT_NEAR(impact.works()[2], 0.5 * (after * after - 9.0), 10.0 * kSolved);
  }
}

TEST(EventImpact, StopsAnApproachThatIsNoImpactButNotRounding) {
  for (const double part : {0.5, 1e-4}) {
    SledgeScene s({0.0, 0.0}, {2.0, 0.0}, SledgeScene::pull(0.0), 0.5);
    SledgeEvent e(s);
    const double slow = -part * e.at.restSpeed();
    e.p.x.u[1] = slow;
    EventImpact impact;
    impact.take(e.at, {});
    EXPECT_EQ(e.p.x.u[1], slow);  // no impact
    const bool creeps = part > e.at.stillSpeed() / e.at.restSpeed();
    EXPECT_EQ(impact.stop(e.at), creeps);
    EXPECT_NEAR(e.p.x.u[1], creeps ? 0.0 : slow, 1e-12 * std::abs(slow));
    EXPECT_TRUE(impact.percussions().empty());
  }
}

TEST(EventImpact, NeedsAnApproach) {
  SledgeScene s({0.0, 0.0}, {2.0, 0.0}, SledgeScene::pull(0.0), 0.5);
  SledgeEvent e(s);
  EventImpact impact;
  impact.take(e.at, {});
  EXPECT_TRUE(impact.percussions().empty());
  EXPECT_EQ(e.p.x.u, Eigen::Vector2d(2.0, 0.0));
  EXPECT_EQ(impact.leaves(), e.at.restSpeed());
}

}  // namespace
}  // namespace dynamy
