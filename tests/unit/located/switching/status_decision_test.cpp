// Decisions of new statuses: a sledge on a floor with μ = 0.5, λ_N = 10 N.
#include <gtest/gtest.h>

#include <dynamy/located/switching/status_decision.hpp>

#include "unit/located/switching/sledge_event.hpp"

namespace dynamy {
namespace {

using fixture::kSledgeMu, fixture::SledgeEvent, fixture::SledgeScene;

struct Decision {
  Decision(double v, double pull, bool plain = false, double released = 0.0)
      : s({0.0, 0.0}, {v, 0.0}, SledgeScene::pull(pull), kSledgeMu), e(s) {
    const Eigen::VectorXd a = Eigen::VectorXd::Zero(2);
    StatusDecision decision;
    decision.decide(e.at,
                    {.lookAhead = plain ? 1.0 : 1e-4,
                     .held = {},
                     .a = a,
                     .stopped = {},
                     .leaves = e.at.restSpeed(),
                     .impact = false,
                     .jumped = false,
                     .plain = plain,
                     .released = {s.key(), released}},
                    held);
    EXPECT_TRUE(e.result.fault.empty()) << e.result.fault;
    EXPECT_FALSE(e.result.undecided);
    EXPECT_EQ(held.size(), 1u);
    held.resize(1);
  }
  SledgeScene s;
  SledgeEvent e;
  std::vector<Held> held;
};

TEST(StatusDecision, SticksBelowTheBoundAndSlipsAboveIt) {
  for (const double pull : {4.0, -4.0, 6.0, -6.0}) {
    const Held h = Decision(0.0, pull).held[0];
    EXPECT_EQ(h.slips, std::abs(pull) > 5.0) << pull;
    if (h.slips) {
      EXPECT_EQ(h.sign, pull > 0.0 ? 1.0 : -1.0);
    }
    EXPECT_NEAR(h.lambda[0], SledgeScene::kG, 1e-7);  // the solver's 1e-10 over h_s and 1 m/s
  }
}

TEST(StatusDecision, KeepsTheDirectionOfASlip) {
  const Held h = Decision(-1e-3, 4.0).held[0];
  EXPECT_TRUE(h.slips);
  EXPECT_EQ(h.sign, -1.0);
}

TEST(StatusDecision, ReleasesAContactAtItsBoundIfItIsPlain) {
  EXPECT_FALSE(Decision(0.0, 5.0, true).held[0].slips);
  const Held h = Decision(0.0, 5.0, true, 1.0).held[0];
  EXPECT_TRUE(h.slips);
  EXPECT_EQ(h.sign, 1.0);
}

}  // namespace
}  // namespace dynamy
