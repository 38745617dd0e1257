// Projections at the instant of a switch: a sledge on a floor.
#include <gtest/gtest.h>

#include <dynamy/located/switching/event_projection.hpp>

#include "unit/located/switching/sledge_event.hpp"

namespace dynamy {
namespace {

using Eigen::Vector2d;
using fixture::SledgeEvent, fixture::SledgeScene;

TEST(EventProjection, BringsTheGapsOfAllContactsToZero) {
  SledgeScene s({0.3, -1e-6}, {2.0, 1e-3}, SledgeScene::pull(0.0), 0.5);
  SledgeEvent e(s);
  EventProjection projection;
  projection.positions(e.at, e.keys, {});
  EXPECT_NEAR(e.p.x.q[1], 0.0, 1e-20);  // rounding of 1e-6
  EXPECT_EQ(e.p.x.q[0], 0.3);
  EXPECT_EQ(e.p.x.u, Vector2d(2.0, 1e-3));
}

TEST(EventProjection, StopsTheRowsThatStatusesHold) {
  SledgeScene s({0.3, 0.0}, {2.0, 1e-3}, SledgeScene::pull(0.0), 0.5);
  SledgeEvent e(s);
  std::vector<Held> held(1);
  held[0].key = s.key(), held[0].slips = true, held[0].sign = 1.0;
  EventProjection projection;
  projection.velocities(*s.system, held, e.p.x);
  EXPECT_NEAR((e.p.x.u - Vector2d(2.0, 0.0)).norm(), 0.0, 1e-17);  // rounding of 1e-3
}

}  // namespace
}  // namespace dynamy
