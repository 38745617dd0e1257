// Contacts that would leave and return within the tolerance: a sledge on a floor.
#include <gtest/gtest.h>

#include <dynamy/located/switching/resting_contacts.hpp>

#include "unit/located/switching/sledge_event.hpp"

namespace dynamy {
namespace {

using fixture::kSledgeG, fixture::SledgeEvent, fixture::SledgeScene;

/// A contact that leaves with v. It rises by v²/(2 g); heights below 0.1 tol L = 1e-7 m count as
/// zero.
struct Leaving {
  explicit Leaving(double v, double epsilonN = 0.0)
      : s({0.0, 0.0}, {0.0, v}, SledgeScene::pull(0.0), 0.5, epsilonN), e(s) {
    impact.take(e.at, {});
  }
  bool find() { return resting.findClosed(e.at, impact, {}); }
  SledgeScene s;
  SledgeEvent e;
  EventImpact impact;
  RestingContacts resting;
};

TEST(RestingContacts, StayClosedIfTheyRiseWithinTheTolerance) {
  const double most = std::sqrt(2.0 * kSledgeG * 1e-7);
  Leaving low(0.99 * most), high(1.01 * most);
  EXPECT_TRUE(low.find());
  EXPECT_FALSE(high.find());
  EXPECT_TRUE(low.resting.shuts());
  EXPECT_EQ(low.e.result.accumulations, 1);
  // The flight takes 2 v/g; a product of rounded numbers.
  EXPECT_NEAR(low.e.result.accumulationEnd, 2.0 * 0.99 * most / kSledgeG, 1e-17);
}

TEST(RestingContacts, AreFoundOnce) {
  Leaving low(1e-6);
  EXPECT_TRUE(low.find());
  EXPECT_FALSE(low.find());
}

TEST(RestingContacts, AreShutByAProjectionOfVelocities) {
  Leaving low(1e-6);
  ASSERT_TRUE(low.find());
  EventProjection projection;
  low.resting.shut(low.e.at, low.impact, projection);
  EXPECT_NEAR(low.e.p.x.u.norm(), 0.0, 1e-20);  // rounding of 1e-6
}

TEST(RestingContacts, RepeatAnImpactWithoutRebound) {
  Leaving hit(-1e-5, 0.5);  // rebounds with 5e-6 m/s
  hit.e.evaluate();
  EXPECT_TRUE(hit.find());
  EXPECT_EQ(hit.resting.plastic(), hit.e.keys);
  EXPECT_FALSE(hit.resting.shuts());
  // The rest of the sequence takes 2 v/(g (1 − ε)); v is that of the solver.
  EXPECT_NEAR(hit.e.result.accumulationEnd, 2.0 * 5e-6 / (kSledgeG * 0.5), 1e-8 * 5e-6);
}

}  // namespace
}  // namespace dynamy
