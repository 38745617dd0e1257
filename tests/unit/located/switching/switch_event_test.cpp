// Impacts and decisions at the instant of a switch: a sledge on a floor.
#include <gtest/gtest.h>

#include <dynamy/located/switching/switch_event.hpp>

#include "unit/located/sledge.hpp"

namespace dynamy {
namespace {

using Eigen::Vector2d;
using fixture::kSledgeG, fixture::kSledgeMu, fixture::kSolved, fixture::SledgeScene;

/// The event at the state of the scene, all contacts that touch taking part.
struct Event {
  explicit Event(SledgeScene& scene, std::vector<Held> held = {}) : s(scene) {
    phase.held = std::move(held);
    p.x = s.x;
    probe.prepare(*s.system, s.x);
    probe.look(s.x);
    s.evaluate(s.x);
    norm.start(*s.system, s.x, 0, 1e-8, 1.0, probe.gaps().contacts);
    smooth.prepare(*s.system, dormandPrince8());
    event.prepare(norm);
    accelerate();
    result = event.process(*s.system, s.solver, probe, phase, p, smooth, 1e-4, {});
    EXPECT_TRUE(result.fault.empty()) << result.fault;
    EXPECT_TRUE(result.solved.ok());
  }
  /// The phase that ends has forces at its end.
  void accelerate() {
    heldKeys(phase.held, phase.request.keys);
    EXPECT_TRUE(phase.accelerate(s.system->evaluate(s.x, phase.request.in(1)), s.x.u, p.a))
        << phase.fault();
  }
  SledgeScene& s;
  FrozenPhase phase;
  PhasePoint p;
  ContactProbe probe;
  ErrorNorm norm;
  SmoothStep smooth;
  SwitchEvent event;
  EventResult result;
};

Held sticking(const SledgeScene& s) {
  Held h;
  h.key = s.key();
  return h;
}

TEST(SwitchEvent, ReboundsByTheCoefficientOfRestitution) {
  SledgeScene s({0.0, 0.0}, {0.0, -3.0}, SledgeScene::pull(0.0), 0.0, 0.5);
  const Event e(s);
  EXPECT_TRUE(e.result.impact);
  EXPECT_NEAR(e.p.x.u[1], 1.5, kSolved);
  EXPECT_TRUE(e.phase.held.empty());
  EXPECT_NEAR(e.p.a[1], -kSledgeG, kSolved);
  EXPECT_EQ(e.event.uBefore(), Vector2d(0.0, -3.0));
  ASSERT_EQ(e.event.impact().percussions().size(), 1u);
  EXPECT_NEAR(e.event.impact().percussions()[0].Lambda[0], 4.5, kSolved);
  EXPECT_NEAR(e.event.impact().percussions()[0].gammaMinus[0], -3.0, kSolved);
  EXPECT_NEAR(e.event.impact().works()[2], 0.5 * (1.5 * 1.5 - 3.0 * 3.0), 10.0 * kSolved);
}

TEST(SwitchEvent, StaysOnTheFloorAfterAPlasticImpact) {
  SledgeScene s({0.0, 0.0}, {0.0, -3.0}, SledgeScene::pull(0.0), kSledgeMu);
  const Event e(s);
  EXPECT_TRUE(e.result.impact);
  EXPECT_NEAR(e.p.x.u.norm(), 0.0, kSolved);
  ASSERT_EQ(e.phase.held.size(), 1u);
  EXPECT_FALSE(e.phase.held[0].slips);
  EXPECT_NEAR(e.p.a.norm(), 0.0, kSolved);
  EXPECT_NEAR(e.phase.lambda()[0], kSledgeG, kSolved);
}

TEST(SwitchEvent, HasFrictionInTheImpact) {
  // Λ_N = 3: the slip of 2 m/s loses μΛ_N = 1.5 and goes on; that of 1 m/s ends.
  for (const double v : {2.0, 1.0}) {
    SledgeScene s({0.0, 0.0}, {v, -3.0}, SledgeScene::pull(0.0), kSledgeMu);
    const Event e(s);
    ASSERT_EQ(e.phase.held.size(), 1u);
    EXPECT_EQ(e.phase.held[0].slips, v > 1.5) << v;
    EXPECT_NEAR(e.p.x.u[0], v > 1.5 ? v - 1.5 : 0.0, kSolved);
    EXPECT_NEAR(e.p.a[0], v > 1.5 ? -kSledgeMu * kSledgeG : 0.0, kSolved);
  }
}

TEST(SwitchEvent, DecidesBetweenStickAndSlipWithoutAnImpact) {
  for (const double pull : {4.0, 6.0, -6.0}) {
    SledgeScene s({0.0, 0.0}, {0.0, 0.0}, SledgeScene::pull(pull), kSledgeMu);
    const Event e(s, {sticking(s)});
    EXPECT_FALSE(e.result.impact);
    ASSERT_EQ(e.phase.held.size(), 1u) << pull;
    const bool slips = std::abs(pull) > kSledgeMu * kSledgeG;
    EXPECT_EQ(e.phase.held[0].slips, slips) << pull;
    if (slips) {
      EXPECT_EQ(e.phase.held[0].sign, pull > 0.0 ? 1.0 : -1.0);
    }
    const double sign = pull > 0.0 ? 1.0 : -1.0;
    EXPECT_NEAR(e.p.a[0], slips ? pull - sign * kSledgeMu * kSledgeG : 0.0, kSolved) << pull;
  }
}

TEST(SwitchEvent, LetsGoWhatIsLifted) {
  SledgeScene s(
      {0.0, 0.0}, {0.0, 0.0}, [](double, ConstVec, ConstVec) { return Vector2d(0.0, 1.0); },
      kSledgeMu);
  const Event e(s, {sticking(s)});
  EXPECT_TRUE(e.result.changed);
  EXPECT_TRUE(e.phase.held.empty());
  EXPECT_NEAR(e.p.a[1], 1.0, kSolved);
}

// Which of the three carries is the solver's affair; the motion is not.
TEST(SwitchEvent, MovesWithRedundantContactsAsWithOne) {
  SledgeScene s({0.0, 0.0}, {2.0, -3.0}, SledgeScene::pull(0.0), kSledgeMu, 0.0, 3);
  const Event e(s);
  ASSERT_FALSE(e.phase.held.empty());
  for (const Held& h : e.phase.held) EXPECT_TRUE(h.slips);
  EXPECT_NEAR(e.p.x.u[0], 0.5, kSolved);
  EXPECT_NEAR(e.p.a[0], -kSledgeMu * kSledgeG, kSolved);
}

TEST(SwitchEvent, LeavesAnOpenContactAlone) {
  SledgeScene s({0.0, 1e-3}, {2.0, -3.0}, SledgeScene::pull(0.0), kSledgeMu);
  const Event e(s);
  EXPECT_FALSE(e.result.impact);
  EXPECT_TRUE(e.phase.held.empty());
  EXPECT_EQ(e.p.x.u, Vector2d(2.0, -3.0));
}

}  // namespace
}  // namespace dynamy
