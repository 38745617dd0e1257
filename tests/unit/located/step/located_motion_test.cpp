// LocatedMotion on a sledge of 1 kg with closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/located/step/located_motion.hpp>

#include "unit/located/sledge.hpp"

namespace dynamy {
namespace {

using fixture::kSledgeMu, fixture::SledgeScene;

constexpr double kMotionTolerance = 1e-10;

/// Steps a motion through a scene, with the state kept between the steps.
class Stepping {
 public:
  explicit Stepping(SledgeScene& scene) : scene_(scene) { motion.aim({kMotionTolerance, 1.0}); }
  /// Takes one step, at most up to `until`.
  void step(double until) {
    StepReport report;
    LocatedMotion::Start start;
    start.goesOn = started_ && motion.endsAt(*scene_.system, scene_.x);
    start.held = started_ ? &held : nullptr, start.scaled = started_;
    const Refusal refusal =
        motion.advance(*scene_.system, scene_.solver, scene_.x, start, until - scene_.x.t, report);
    ASSERT_FALSE(refusal) << refusal.why;
    const State& end = motion.end();
    scene_.x.t = end.t, scene_.x.q = end.q, scene_.x.u = end.u;
    motion.keep(held);
    motion.report(*scene_.system, scene_.x, report);
    impacts += report.counts.impacts, switches += report.counts.switches, started_ = true;
  }
  /// Continues a run of another motion.
  void resume(const LocatedMotion& other) {
    const ErrorNorm& norm = other.parts().norm;
    other.keep(held);
    motion.scales(*scene_.system, norm.time(), norm.times());
    started_ = true;
  }
  LocatedMotion motion{LocatedSettings{}};
  HeldState held;
  int impacts = 0, switches = 0;

 private:
  SledgeScene& scene_;
  bool started_ = false;
};

// Newton's method leaves the rounding of t² at the root of a gap, some 1e-15.
TEST(LocatedMotion, EndsAStepAtTheImpactOfAFall) {
  SledgeScene scene({0, 1}, {0, 0}, SledgeScene::pull(0.0), kSledgeMu);
  Stepping run(scene);
  while (run.impacts == 0) ASSERT_NO_FATAL_FAILURE(run.step(1.0));
  EXPECT_NEAR(scene.x.t, std::sqrt(2.0 / SledgeScene::kG), 1e-14);
  EXPECT_NEAR(scene.x.u[1], 0.0, 1e-14);
  EXPECT_EQ(run.switches, 1);
}

// The speed is linear in time and the way quadratic: both are exact for these methods.
TEST(LocatedMotion, EndsAStepWhereSlipEnds) {
  SledgeScene scene({0, 0}, {1, 0}, SledgeScene::pull(0.0), kSledgeMu);
  Stepping run(scene);
  while (run.switches == 0) ASSERT_NO_FATAL_FAILURE(run.step(1.0));
  const double a = kSledgeMu * SledgeScene::kG;
  EXPECT_NEAR(scene.x.t, 1.0 / a, 1e-14);
  EXPECT_NEAR(scene.x.q[0], 0.5 / a, 1e-14);
  ASSERT_EQ(run.held.held.size(), 1u);
  EXPECT_FALSE(run.held.held[0].slips);
}

TEST(LocatedMotion, ContinuesARunOfAnotherInstanceWithTheSameBits) {
  const auto force = [](double t, ConstVec q, ConstVec) {
    return Eigen::Vector2d(8.0 * std::sin(3.0 * t) - q[0], -SledgeScene::kG);
  };
  SledgeScene scene({0, 0.2}, {1, 0}, force, kSledgeMu), copy({0, 0.2}, {1, 0}, force, kSledgeMu);
  Stepping whole(scene), first(copy), second(copy);
  constexpr double kUntil = 4.0;
  for (int n = 0; scene.x.t < kUntil; ++n) {
    ASSERT_NO_FATAL_FAILURE(whole.step(kUntil));
    if (n == 5) second.resume(first.motion);
    ASSERT_NO_FATAL_FAILURE((n < 5 ? first : second).step(kUntil));
    EXPECT_EQ(copy.x.t, scene.x.t) << n;
    EXPECT_EQ(copy.x.q, scene.x.q) << n;
    EXPECT_EQ(copy.x.u, scene.x.u) << n;
  }
  EXPECT_GE(whole.switches, 5);
}

TEST(LocatedMotion, LeavesTheStateAsItWasWhereAStepIsRefused) {
  // A force that is not a number from 0.3 s on: no step goes past it.
  const auto force = [](double t, ConstVec, ConstVec) {
    return Eigen::Vector2d(t < 0.3 ? 0.0 : std::nan(""), -SledgeScene::kG);
  };
  SledgeScene scene({0, 0}, {1, 0}, force, 0.1);
  LocatedMotion motion{LocatedSettings{}};
  motion.aim({kMotionTolerance, 1.0});
  HeldState held;
  bool started = false;
  Refusal refusal;
  for (int n = 0; n < 1000 && !refusal; ++n) {
    const State before = scene.x;
    StepReport report;
    LocatedMotion::Start start;
    start.goesOn = started && motion.endsAt(*scene.system, scene.x);
    start.held = started ? &held : nullptr;
    refusal = motion.advance(*scene.system, scene.solver, scene.x, start, 1.0 - scene.x.t, report);
    EXPECT_EQ(scene.x.t, before.t);
    EXPECT_EQ(scene.x.q, before.q);
    if (refusal) break;
    scene.x.t = motion.end().t, scene.x.q = motion.end().q, scene.x.u = motion.end().u;
    motion.keep(held), started = true;
  }
  EXPECT_EQ(refusal.kind, Refusal::Kind::stalled);
  EXPECT_LT(scene.x.t, 0.3);
  EXPECT_NEAR(scene.x.t, 0.3, 1e-3);
}

}  // namespace
}  // namespace dynamy
