/// Newton's cradle: balls in a row, one simultaneous impact with Newton's law (N03: complementarity
/// by enumeration of all contact states).
#include <gtest/gtest.h>

#include <numeric>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

std::string row(int balls) {
  std::string text = R"(<dynamy version="1"><parameter name="e" value="1"/><systems>)";
  for (int i = 0; i < balls; ++i)
    text += "<PointMass name=\"b" + std::to_string(i) + "\" plane=\"xz\" position=\"" +
            std::to_string(i) + " 0 0\" velocity=\"" +
            (i == 0 || (balls == 5 && i == 1) ? "1" : "0") +
            " 0 0\" mass=\"1\"><Sphere radius=\"0.5\" material=\"steel\"/></PointMass>";
  return text + R"(</systems><elements>
    <Contact between="steel steel"><Unilateral epsilonN="{e}"/></Contact></elements>
  <simulation until="1" step="1e-3"><MoreauMidpoint/></simulation></dynamy>)";
}

struct Case {
  int balls;
  double e;
  std::vector<double> after;
};
class Cradle : public testing::TestWithParam<Case> {};

TEST_P(Cradle, LeavesOneImpactWithTheVelocitiesOfNewtonsLaw) {
  const Case& c = GetParam();
  for (const Scheme scheme : kBothSchemes) {
    Scene scene("row",
                {.set = {{"e", std::to_string(c.e)}}, .scheme = scheme, .text = row(c.balls)});
    scene.step(1e-3);
    for (int i = 0; i < c.balls; ++i)
      // Solver tolerance 1e-10 of the impulse; the direct solve leaves rounding.
      EXPECT_NEAR(scene.u("b" + std::to_string(i))[0], c.after[static_cast<std::size_t>(i)], 1e-10)
          << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, Cradle,
                         testing::Values(Case{3, 0.0, {1.0 / 3, 1.0 / 3, 1.0 / 3}},
                                         Case{3, 0.5, {0, 0.5, 0.5}},
                                         Case{3, 1.0, {-1.0 / 3, 2.0 / 3, 2.0 / 3}},
                                         Case{5, 0.0, {0.4, 0.4, 0.4, 0.4, 0.4}},
                                         Case{5, 0.5, {0.1, 0.1, 0.6, 0.6, 0.6}},
                                         Case{5, 1.0, {-0.2, -0.2, 0.8, 0.8, 0.8}}));

}  // namespace
}  // namespace dynamy::reference
