/// Known defects of many contacts at once: arches, balls in a row, long steps, jams.
#include <gtest/gtest.h>

#include <cmath>
#include <defects/defect_run.hpp>
#include <dynamy/io/files/output_file.hpp>

namespace dynamy::defects {
namespace {

TEST(KnownDefects, AnArchAboveItsLimitThicknessStandsAtAMillisecond) {
  // Eleven stones stand from t/R = 0.10490992 on, by linear programming of their equilibrium.
  for (const double more : {1.001, 1.01}) {
    DefectRun arch("models/masonry_arch.xml", {.set = {{"t", numberText(more * 0.10490992)}}});
    arch.run();
    knownDefect("arch_above_its_limit", [&] {
      for (const CheckResult& r : arch.simulation().checks())
        EXPECT_TRUE(r.pass) << more << " of the limit: " << r.measure << " of " << r.signal
                            << " is " << r.got << ", expected " << r.expected;
    });
  }
}

TEST(KnownDefects, ARandomSceneOfFiveBodiesTakesItsFirstStep) {
  // Two pairs on cylindrical joints, springs of 44 to 6e6 N/m, velocities of 300 m/s, a step of
  // 0.13 s. Whatever is reached in a bounded number of iterations is to be taken and reported.
  DefectRun scene("tests/data/defects/scene_3_54.xml", {.steps = 1, .iterations = 500});
  scene.run();
  knownDefect("no_step_and_no_word", [&] {
    EXPECT_NE(scene.report().reason, kUsedUp);
    EXPECT_GE(scene.report().steps, 1);
  });
}

TEST(LongKnownDefects, AJammedHopperTakesNoMoreNewtonStepsThanOneThatRuns) {
  // 300 balls fall on an outlet that is jammed or wide, in 215 steps.
  const auto hopper = [](double outlet) {
    std::string text = readWholeFile(DYNAMY_SOURCE_DIR "/tests/data/defects/jammed_hopper.xml");
    for (std::size_t at = 0; (at = text.find("0.12 0 0.5", at)) != std::string::npos; ++at)
      text.replace(at, 4, numberText(outlet));
    return text.substr(text.find("<dynamy"));
  };
  DefectRun wide(hopper(0.16), {.every = 0.1, .steps = 215});
  DefectRun jammed(hopper(0.12), {.every = 0.1, .steps = 215});
  wide.run(), jammed.run();
  std::printf("Newton steps: wide %ld, jammed %ld\n", wide.newtonSteps(), jammed.newtonSteps());
  // The same balls, in as many steps: three times leaves room for the contacts of a jam.
  knownDefect("jammed_hopper",
              [&] { EXPECT_LE(jammed.newtonSteps(), 3 * wide.newtonSteps() + 100); });
}

}  // namespace
}  // namespace dynamy::defects
