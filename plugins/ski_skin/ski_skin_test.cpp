// A friction law given by the support function of one convex set fulfils the definitions of a law,
// and skis stop where the closed form predicts.
#include <gtest/gtest.h>

#include <dynamy/testing/check_element.hpp>
#include <support/load_model.hpp>

namespace dynamy {
namespace {

TEST(SkiSkin, FulfilsTheDefinitionsOfALaw) {
  LoadedModel loaded("plugins/ski_skin/ski_skin.xml");
  const Verdict verdict = checkModel(loaded.model());
  EXPECT_TRUE(verdict) << verdict.message();
}

TEST(SkiSkin, GlidesForwardsAndHoldsBackwards) {
  LoadedModel loaded("plugins/ski_skin/ski_skin.xml");
  Simulation simulation(loaded.model());
  const RunReport& report = simulation.run();
  EXPECT_EQ(report.solver.unconverged, 0);
  expectChecksHold(simulation);
}

}  // namespace
}  // namespace dynamy
