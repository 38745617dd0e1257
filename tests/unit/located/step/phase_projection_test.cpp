#include <gtest/gtest.h>

#include <dynamy/located/step/phase_projection.hpp>

#include "unit/located/sledge.hpp"

namespace dynamy {
namespace {

using fixture::SledgeScene;

constexpr double kProjectionTolerance = 1e-6;

/// A sledge that slides on the floor, held, at height z with the vertical speed w.
struct Drifted {
  Drifted(double z, double w)
      : scene({0, z}, {1, w}, SledgeScene::pull(0.0), 0.5), projection(parts) {
    scene.system->gTol(1.0);
    scene.evaluate(scene.x);
    parts.norm.start(*scene.system, scene.x, 0, kProjectionTolerance, 1.0,
                     scene.system->slot(0).contacts);
    parts.motion.prepare(*scene.system, dormandPrince8(), nullptr);
    Held held;
    held.key = scene.key(), held.slips = true, held.sign = 1.0;
    parts.motion.phase.held = {held};
    parts.motion.rekey();
    parts.probe.prepare(*scene.system, scene.x);
    to.x = scene.x;
    EXPECT_FALSE(step.evaluate(to));
  }
  SledgeScene scene;
  LocatedParts parts;
  PhaseProjection projection;
  PhasePoint from, to;
  StepReport report;
  StepRecord record;
  std::vector<Held> startHeld;
  LocatedStep step{*scene.system, scene.solver, report, parts, from, to, record, startHeld, {}};
};

TEST(PhaseProjection, BringsADriftedContactBack) {
  // A hundredth of the tolerance: above the part that waits, below that which checks the bias.
  Drifted drifted(1e-8, -1e-8);
  bool missing = true;
  ASSERT_FALSE(drifted.projection.take(drifted.step, drifted.to, missing));
  EXPECT_FALSE(missing);
  EXPECT_NEAR(drifted.to.x.q[1], 0.0, 1e-22);
  EXPECT_NEAR(drifted.to.x.u[1], 0.0, 1e-22);
  EXPECT_EQ(drifted.to.x.u[0], 1.0);
}

TEST(PhaseProjection, LeavesASmallDriftAsItIs) {
  Drifted drifted(1e-10, 0.0);
  bool missing = true;
  ASSERT_FALSE(drifted.projection.take(drifted.step, drifted.to, missing));
  EXPECT_EQ(drifted.to.x.q[1], 1e-10);
}

}  // namespace
}  // namespace dynamy
