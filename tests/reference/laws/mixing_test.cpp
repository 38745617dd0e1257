/// Values of materials that mix to the law of a pair: each rule against the way of a block that
/// slides down with the mixed friction, s = ½ g (sin α − μ cos α) t², and a ball that rebounds.
#include <gtest/gtest.h>

#include <dynamy/law/pair_laws.hpp>
#include <numbers>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

/// A block of wood on a slope of ice at 45°, with what `rules` say of the two.
std::string slope(const std::string& rules) {
  return R"(<dynamy version="1">
  <systems>
    <PlanarBody name="block" mass="2" inertia="1"><Point material="wood"/></PlanarBody>
    <Ground name="world"><HalfSpace normal="-1 0 1" material="ice"/></Ground>
  </systems>
  <forces><Gravity acceleration="0 0 -9.81"/></forces>
  <elements>)" +
         rules + R"(</elements>
  <simulation until="1" step="0.01"/>
</dynamy>)";
}

/// The way that the block has slid after a second [m].
double way(const std::string& rules) {
  Scene scene("slope", {.text = slope(rules)});
  scene.run(1.0, 0.01);
  EXPECT_TRUE(scene.solved());
  return scene.q("block").head<2>().norm();
}

/// ½ g (sin α − μ cos α) t² at 45° and 1 s [m].
double slid(double mu) { return 0.5 * 9.81 * std::sqrt(0.5) * (1.0 - mu); }

/// Constant acceleration is exact for the scheme; the solver finds the friction of each of 100
/// steps to 1e-10 of g Δt, which is less than 1e-10 · 9.81 t²/2 of way, with a factor of two.
constexpr double kWay = 1e-9;

const char* const kValues = R"(<Material name="wood" mu="0.4"/><Material name="ice" mu="0.9"/>)";

struct Rule {
  const char* name;
  double mu;  ///< of 0.4 and 0.9
};

class Mixing : public testing::TestWithParam<Rule> {};

TEST_P(Mixing, LetsABlockSlideWithTheMixedFriction) {
  const std::string rule = "<Contacts mixing=\"" + std::string(GetParam().name) + "\"/>";
  EXPECT_NEAR(way(kValues + rule), slid(GetParam().mu), kWay);
  EXPECT_NEAR(way(rule + kValues), slid(GetParam().mu), kWay) << "rules stand in any order";
}

INSTANTIATE_TEST_SUITE_P(Rules, Mixing,
                         testing::Values(Rule{"min", 0.4}, Rule{"max", 0.9}, Rule{"mean", 0.65},
                                         Rule{"geometric", 0.6}, Rule{"product", 0.36}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(MixedMaterials, GiveWayToTheLawOfTheirPair) {
  const std::string own =
      R"(<Contacts mixing="max"/><Contact between="ice wood"><UnilateralCoulomb mu="0.1"/></Contact>)";
  EXPECT_NEAR(way(kValues + own), slid(0.1), kWay);
}

TEST(MixedMaterials, ReboundByTheRuleOfRestitution) {
  // Down with √(2 g h), up with ε of it: again at the height ε² h. Mixed ε = max(0.5, 0.2).
  Scene scene("rebound", {.text = R"(<dynamy version="1">
    <systems>
      <PointMass name="ball" position="0 0 1" mass="1"><Point material="rubber"/></PointMass>
      <Ground name="world"><HalfSpace material="ice"/></Ground>
    </systems>
    <forces><Gravity acceleration="0 0 -8"/></forces>
    <elements>
      <Material name="rubber" mu="0.3" epsilonN="0.5"/><Material name="ice" mu="0.1" epsilonN="0.2"/>
      <Contacts mixing="min" restitution="max"/>
    </elements>
    <simulation until="1" tolerance="1e-8"/>
  </dynamy>)"});
  Model& model = scene.model();
  model.readyScheme();
  // Impact at √(2 h/g) = 0.5 s with 4 m/s; 0.25 s later at rest in 0.25 m. The tolerance of the
  // run, times the few units of length and speed.
  scene.run(0.75, 0.75);
  EXPECT_NEAR(scene.q("ball")[2], 0.25, 1e-7);
  EXPECT_NEAR(scene.u("ball")[2], 0.0, 1e-6);
}

TEST(MixedMaterials, NeedNoTangentsWithoutFriction) {
  Scene scene("slope",
              {.text = slope(R"(<Material name="wood" mu="0.4"/><Material name="ice" mu="0"/>
                                      <Contacts mixing="geometric"/>)")});
  EXPECT_EQ(scene.system().evaluate(scene.state()).contacts.rows(), 1);
  scene.run(1.0, 0.01);
  EXPECT_NEAR(scene.q("block").head<2>().norm(), slid(0.0), kWay);
}

TEST(MixedMaterials, TellWhichRuleNoPairRestsOn) {
  Scene scene("slope",
              {.text = slope(std::string(kValues) +
                             R"(<Contacts mixing="min"/><Material name="lead" mu="1"/>)")});
  const PairLaws& laws = scene.model().pairLaws();
  ASSERT_EQ(laws.found().size(), 1u);
  EXPECT_EQ(laws.found().begin()->first, PairLaws::Names("ice", "wood"));
  EXPECT_EQ(laws.found().begin()->second.text, "UnilateralCoulomb mu=0.4 epsilonN=0");
  ASSERT_EQ(laws.idle().size(), 1u);
  EXPECT_EQ(laws.idle()[0]->name(), "lead");
}

TEST(MixedMaterials, MayBeCalledLikeABody) {
  EXPECT_NO_THROW(Scene("slope", {.text = slope(std::string(kValues) +
                                                R"(<Contacts mixing="min"/>
                                                <Material name="block" mu="1"/>)")}));
}

}  // namespace
}  // namespace dynamy::reference
