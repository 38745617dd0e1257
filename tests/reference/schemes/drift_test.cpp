/// Drift over long times and its stabilisation (F02): a pendulum in Cartesian coordinates, where
/// index 1 and 2 leave the circle by 4e-2 m in 10 s.
#include <gtest/gtest.h>

#include <reference/schemes/scheme_table.hpp>

namespace dynamy::reference {
namespace {

struct KeptSwing {
  double length = 0.0, energy = 0.0;  ///< largest | |r| − l | [m] and |T + V − E0| [J]
};
KeptSwing swing(const std::string& scheme, double t, double dt) {
  Scene scene("pendulum", {.text = modelWith(scheme, kRodPendulum)});
  const double start = scene.energy();
  KeptSwing out;
  scene.run(t, dt, [&] {
    out.length = std::max(out.length, std::abs(scene.q("bob").norm() - 1.0));
    out.energy = std::max(out.energy, std::abs(scene.energy() - start));
  });
  EXPECT_TRUE(scene.solved());
  return out;
}

const char* const kStabilised[] = {"EnergyMomentum", "StaggeredMoreau", "NonsmoothRattle"};

TEST(Drift, IsNoneInTheStabilisedSchemes) {
  // Mark: 1e-8 m and 1e-3 J. Joints are projected to a tenth of g_tol = 1e-12 m.
  for (const char* scheme : kStabilised) {
    const KeptSwing kept = swing(scheme, 10.0, 1e-3);
    EXPECT_LT(kept.length, 1e-12) << scheme;
    EXPECT_LT(kept.energy, 1e-3) << scheme;
  }
}

TEST(LongDrift, IsNoneInTheStabilisedSchemesOver1000Seconds) {
  for (const char* scheme : kStabilised) {
    const KeptSwing kept = swing(scheme, 1000.0, 1e-3);
    EXPECT_LT(kept.length, 1e-12) << scheme;
    EXPECT_LT(kept.energy, 1e-3) << scheme;
    RecordProperty(scheme, numberText(kept.energy));
  }
}

TEST(Drift, OfAWrongStartIsAskedBackNoFasterThanTheCap) {
  // 5 cm too long, cap 0.1 m/s: the rod shortens by 0.1 m/s and takes 0.5 s to its length.
  std::string text =
      modelWith("StaggeredMoreau joints=\"stabilised\" project=\"none\" cap=\"0.1\"", kRodPendulum);
  Scene scene("pendulum", {.text = text});
  scene.state().q << 0.0, -1.05;
  double before = 1.05, fastest = 0.0;
  scene.run(0.45, 1e-3, [&] {
    const double length = scene.q("bob").norm();
    fastest = std::max(fastest, std::abs(length - before) / 1e-3), before = length;
  });
  EXPECT_NEAR(fastest, 0.1, 1e-9);
  EXPECT_NEAR(before, 1.005, 1e-3);  // within a step of the cap's speed at either end
  scene.run(1.0, 1e-3);
  EXPECT_NEAR(scene.q("bob").norm(), 1.0, 1e-12);
  EXPECT_LT(scene.u("bob").norm(), 1e-12);  // at rest: what was asked back is not kept as speed
}

}  // namespace
}  // namespace dynamy::reference
