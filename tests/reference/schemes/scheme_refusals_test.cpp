/// What a scheme's definition does not hold it says itself (OneStep::lacks), and a run that asks
/// for it ends with these words.
#include <gtest/gtest.h>

#include <dynamy/simulation/run/simulation.hpp>
#include <reference/schemes/scheme_table.hpp>

namespace dynamy::reference {
namespace {

/// Reason why a run of this model failed, or "".
std::string reasonOf(const std::string& scheme, const std::string& sections,
                     const std::string& law = "") {
  Scene scene("model", {.text = modelWith(scheme, sections, law)});
  Simulation run(scene.model());
  const RunReport& report = run.run();
  return report.ended == RunReport::Ended::failed ? report.reason : "";
}
/// A point thrown on a table with friction.
std::string thrownPoint(double mu) {
  return "<systems><PointMass name=\"p\" plane=\"xz\" position=\"0 0 0.1\" velocity=\"1 0 0\" "
         "mass=\"1\"><Point material=\"m\"/></PointMass><Ground name=\"world\"><HalfSpace "
         "material=\"m\"/></Ground></systems><forces><Gravity/></forces><elements><Contact "
         "between=\"m m\"><UnilateralCoulomb mu=\"" +
         numberText(mu) + "\"/></Contact></elements>";
}

TEST(SchemeRefusal, OfConstraintIndexIsAContactThatCloses) {
  EXPECT_NE(reasonOf("ConstraintIndex", droppedBall(0.0))
                .find("<ConstraintIndex> refuses: a unilateral contact closes"),
            std::string::npos);
}

TEST(SchemeRefusal, OfStewartAndTrinkleIsARebound) {
  EXPECT_NE(reasonOf("StewartTrinkle", droppedBall(0.5))
                .find("<StewartTrinkle> refuses: a contact with restitution closes, and this "
                      "scheme knows no rebound"),
            std::string::npos);
  EXPECT_EQ(reasonOf("StewartTrinkle", droppedBall(0.0)), "");
}

TEST(SchemeRefusal, OfPaoliAndSchatzmanIsFrictionAtAnImpact) {
  EXPECT_NE(reasonOf("PaoliSchatzman", thrownPoint(0.3))
                .find("<PaoliSchatzman> refuses: a contact with friction is hit"),
            std::string::npos);
  EXPECT_EQ(reasonOf("PaoliSchatzman", droppedBall(0.5)), "");
  // A contact that lasts is no impact, whatever the curvature.
  EXPECT_EQ(reasonOf("PaoliSchatzman", Bowl::sections(0.2)), "");
}

TEST(SchemeRefusal, OfSchemesWithALawOfTheirOwnIsAnImpactLaw) {
  for (const char* scheme : {"StewartTrinkle", "PaoliSchatzman"})
    for (const char* law : {"<PoissonImpact/>", "<EnergeticImpact/>", "<SequentialImpact/>"})
      EXPECT_NE(reasonOf(scheme, droppedBall(0.0), law).find("no impact law"), std::string::npos)
          << scheme << law;
  EXPECT_EQ(reasonOf("MoreauMidpoint", droppedBall(0.5), "<PoissonImpact/>"), "");
}

}  // namespace
}  // namespace dynamy::reference
