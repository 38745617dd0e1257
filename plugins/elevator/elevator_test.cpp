// Guide shoes as a plug-in and as formulas have the same contacts; effect of bent rails.
#include <gtest/gtest.h>

#include <dynamy/testing/check_element.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

std::string lift(const std::string& shoes, const std::string& cabin = "") {
  return "<dynamy version=\"1\"><plugin library=\"elevator\"/><systems><Ground name=\"world\"/>"
         "<PlanarBody name=\"cabin\" position=\"0.2 0 1\" mass=\"1600\" inertia=\"1500\" " +
         cabin + "/></systems><forces><Gravity/></forces><elements>" + shoes +
         "</elements><simulation until=\"1\" step=\"1e-3\"><MoreauMidpoint/></simulation></dynamy>";
}

const char* const kBent =
    R"xml(<GuideShoes name="shoes" on="cabin" width="2" height="3" play="1mm" x="0.2"
         left="0.01*sin(3*z)" right="0.02*z^2"><UnilateralCoulomb mu="0.12"/></GuideShoes>)xml";
const char* const kStraight =
    R"xml(<GuideShoes name="shoes" on="cabin" width="2" height="3" play="1mm" x="0.2">
         <UnilateralCoulomb mu="0.12"/></GuideShoes>)xml";
const char* const kFormulas =
    R"xml(<replicate count="8"><CoordinateContact name="shoe" on="cabin"
         gap="0.001 + {1-2*mod(i,2)}*(x - 0.2 - {(1-2*floor(i/4))*1.5}*sin(phi)
              - {(1-2*mod(floor(i/2),2))*1.0}*(1-cos(phi)))"
         slipVelocity="vz + omega*({(1-2*mod(floor(i/2),2))*1.0}*cos(phi) - {(1-2*floor(i/4))*1.5}*sin(phi))">
         <UnilateralCoulomb mu="0.12"/></CoordinateContact></replicate>)xml";

TEST(GuideShoes, HaveRowsThatFitTheirGaps) {
  Scene s("", {.text = lift(kBent)});
  const Verdict fits = checkContacts(s.model());
  EXPECT_TRUE(fits) << fits.message();
}

TEST(GuideShoes, AreTheSameAsFormulas) {
  const std::string moving = "velocity=\"0.05 0 -1\" angularVelocity=\"0.02\"";
  Scene plugin("", {.text = lift(kStraight, moving)}),
      formulas("", {.text = lift(kFormulas, moving)});
  for (int i = 0; i < 300; ++i) plugin.step(1e-3), formulas.step(1e-3);
  // The steps are equal except for rounding, 1e-16 of numbers up to 10 m/s, amplified by impacts.
  EXPECT_LT((plugin.state().q - formulas.state().q).norm(), 1e-12);
  EXPECT_LT((plugin.state().u - formulas.state().u).norm(), 1e-11);
  EXPECT_TRUE(plugin.solved() && formulas.solved());
}

TEST(GuideShoes, StickToTheRailThatTheyHit) {
  // ε = 0: the shoe crosses the play once and then stays at the rail.
  Scene s("", {.text = lift(kStraight, "velocity=\"0.1 0 -1\"")});
  s.run(0.1, 1e-4);
  EXPECT_NEAR(s.state().u[0], 0.0, 1e-12);
  // The shoe reaches the rail within a step: tolerance 0.1 m/s · 1e-4 s.
  EXPECT_NEAR(s.state().q[0], 0.201, 1.1e-5);
}

}  // namespace
}  // namespace dynamy::reference
