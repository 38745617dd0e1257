// Where a status ends on a path that is known exactly: polynomials of time.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/located/switching/switch_search.hpp>
#include <functional>

#include "unit/located/sledge.hpp"

namespace dynamy {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;
using fixture::kSledgeG, fixture::kSledgeMu, fixture::SledgeScene;

/// Roots of gaps and slips are found to 1e-14 of the step, those of forces to `kWidth`.
constexpr double kRoot = 1e-13, kWidth = 1e-9;

/// Position, velocity and acceleration at time t.
struct Motion {
  std::function<Vector2d(double)> q, u, a;
};

PhasePoint pointAt(const Motion& m, double t) {
  PhasePoint p;
  p.x.t = t, p.x.q = m.q(t), p.x.u = m.u(t);
  p.qdot = p.x.u, p.a = m.a(t), p.qddot = p.a;
  return p;
}

/// One search on the path of `motion` from 0 to h.
struct Search {
  Search(SledgeScene& scene, std::vector<Held> held, const Motion& motion, double h) : s(scene) {
    phase.held = std::move(held);
    from = pointAt(motion, 0.0), to = pointAt(motion, h);
    probe.prepare(*s.system, from.x);
    search.prepare({1e-13, 1e-13, 1e-10, 1e-6});
    heldKeys(phase.held, phase.request.keys);
    VectorXd a;
    EXPECT_TRUE(forcesAt(from.x, a)) << phase.fault();
    EXPECT_TRUE(search.begin(probe, phase, from.x));
    EXPECT_TRUE(forcesAt(to.x, a)) << phase.fault();
    search.atEnd(phase, to.x.t);
    path.through(*s.system, from, to);
    EXPECT_TRUE(search.find(*s.system, probe, phase, path, false, kWidth, found));
  }
  bool forcesAt(const State& x, VectorXd& a) {
    return phase.accelerate(s.system->evaluate(x, phase.request.in(1)), x.u, a);
  }
  SledgeScene& s;
  FrozenPhase phase;
  ContactProbe probe;
  SwitchSearch search;
  PhasePoint from, to;
  QuinticPath path;
  Switch found;
};

Held heldSledge(const SledgeScene& s, double sign = 0.0) {
  Held h;
  h.key = s.key();
  h.slips = sign != 0.0, h.sign = sign;
  return h;
}

Motion fall(double height) {
  return {[=](double t) { return Vector2d(0.0, height - 0.5 * kSledgeG * t * t); },
          [](double t) { return Vector2d(0.0, -kSledgeG * t); },
          [](double) { return Vector2d(0.0, -kSledgeG); }};
}

/// Slip with the velocity v and the deceleration μ (g − c t), for a lift that grows as c t.
Motion slide(double v, double c) {
  return {[=](double t) {
            return Vector2d(v * t - kSledgeMu * (0.5 * kSledgeG * t * t - c * t * t * t / 6.0),
                            0.0);
          },
          [=](double t) { return Vector2d(v - kSledgeMu * (kSledgeG * t - 0.5 * c * t * t), 0.0); },
          [=](double t) { return Vector2d(-kSledgeMu * (kSledgeG - c * t), 0.0); }};
}

const Motion kRest{[](double) { return Vector2d(0.0, 0.0); },
                   [](double) { return Vector2d(0.0, 0.0); },
                   [](double) { return Vector2d(0.0, 0.0); }};

fixture::Sledge::Force lifted(double c, double pull = 0.0) {
  return [=](double t, ConstVec, ConstVec) { return Vector2d(pull * t, -kSledgeG + c * t); };
}

TEST(SwitchSearch, FindsWhereAGapCloses) {
  constexpr double h = 0.6;
  SledgeScene s({0.0, 1.0}, {0.0, 0.0}, SledgeScene::pull(0.0), kSledgeMu);
  const Search search(s, {}, fall(1.0), h);
  ASSERT_TRUE(search.found);
  EXPECT_FALSE(search.found.force);
  EXPECT_NEAR(search.found.theta * h, std::sqrt(2.0 / kSledgeG), kRoot);
  // ġ at the root: −√(2 g · 1 m); the slope is one of the last bracket.
  EXPECT_NEAR(search.found.slope, -std::sqrt(2.0 * kSledgeG), 1e-4);
  EXPECT_EQ(search.search.contact(search.phase, search.found), s.key());
}

TEST(SwitchSearch, FindsNothingInAStepThatEndsBefore) {
  SledgeScene s({0.0, 1.0}, {0.0, 0.0}, SledgeScene::pull(0.0), kSledgeMu);
  EXPECT_FALSE(Search(s, {}, fall(1.0), 0.44).found);  // it closes at 0.447 s
}

TEST(SwitchSearch, FindsAGapThatClosesAndOpensBetweenTwoSamples) {
  // g = 25 (t − 0.45)² − 1e-4 in a step of 1 s: closed for 4 ms, samples are 125 ms apart.
  const Motion dip{[](double t) { return Vector2d(0.0, 25.0 * (t - 0.45) * (t - 0.45) - 1e-4); },
                   [](double t) { return Vector2d(0.0, 50.0 * (t - 0.45)); },
                   [](double) { return Vector2d(0.0, 50.0); }};
  SledgeScene s(dip.q(0.0), dip.u(0.0), SledgeScene::pull(0.0), kSledgeMu);
  const Search search(s, {}, dip, 1.0);
  ASSERT_TRUE(search.found);
  // Either the root or, before it, a look at the minimum that the step is to be cut to.
  EXPECT_NEAR(search.found.theta, 0.45, 2.1e-3);
}

TEST(SwitchSearch, FindsTheEndOfASlip) {
  constexpr double h = 0.5;
  SledgeScene s({0.0, 0.0}, {2.0, 0.0}, SledgeScene::pull(0.0), kSledgeMu);
  const Search search(s, {heldSledge(s, 1.0)}, slide(2.0, 0.0), h);
  ASSERT_TRUE(search.found);
  EXPECT_FALSE(search.found.force);
  EXPECT_NEAR(search.found.theta * h, 2.0 / (kSledgeMu * kSledgeG), kRoot);
  EXPECT_NEAR(search.found.slope, -kSledgeMu * kSledgeG, 1e-4);
}

TEST(SwitchSearch, FindsWhereTheNormalForceEnds) {
  constexpr double h = 0.8;  // λ_N = g − 20 t
  SledgeScene s({0.0, 0.0}, {0.0, 0.0}, lifted(20.0), kSledgeMu);
  const Search search(s, {heldSledge(s)}, kRest, h);
  ASSERT_TRUE(search.found);
  EXPECT_TRUE(search.found.force);
  EXPECT_NEAR(search.found.theta * h, kSledgeG / 20.0, kWidth);
}

TEST(SwitchSearch, FindsWhereFrictionReachesItsBound) {
  constexpr double h = 1.0;  // |λ_T| = 8 t against μ g = 5
  SledgeScene s({0.0, 0.0}, {0.0, 0.0}, lifted(0.0, 8.0), kSledgeMu);
  const Search search(s, {heldSledge(s)}, kRest, h);
  ASSERT_TRUE(search.found);
  EXPECT_TRUE(search.found.force);
  EXPECT_NEAR(search.found.theta * h, kSledgeMu * kSledgeG / 8.0, kWidth);
}

TEST(SwitchSearch, ComparesRootsOfForcesAndSlips) {
  // The slip ends at 2 = μ (g t − c t²/2), the force at g/c. One of the two is first.
  for (const double c : {20.0, 40.0}) {
    SledgeScene s({0.0, 0.0}, {2.0, 0.0}, lifted(c), kSledgeMu);
    const double h = 0.7,
                 slipEnd =
                     (kSledgeG - std::sqrt(kSledgeG * kSledgeG - 2.0 * c * 2.0 / kSledgeMu)) / c;
    const Search search(s, {heldSledge(s, 1.0)}, slide(2.0, c), h);
    ASSERT_TRUE(search.found) << c;
    const bool slip = std::isfinite(slipEnd) && slipEnd < kSledgeG / c;
    EXPECT_EQ(search.found.force, !slip) << c;
    EXPECT_NEAR(search.found.theta * h, slip ? slipEnd : kSledgeG / c, kWidth) << c;
  }
}

TEST(SwitchSearch, WatchesNothingOfAContactThatHoldsForGood) {
  SledgeScene s({0.0, 0.0}, {0.0, 0.0}, SledgeScene::pull(1.0), kSledgeMu);
  const Search search(s, {heldSledge(s)}, kRest, 1.0);
  EXPECT_TRUE(search.search.any());
  EXPECT_FALSE(search.search.gaps());
  EXPECT_FALSE(search.found);
}

}  // namespace
}  // namespace dynamy
