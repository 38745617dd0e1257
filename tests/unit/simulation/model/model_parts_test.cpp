/// What a Model holds: the choice of its scheme, and what its elements report of themselves.
#include <gtest/gtest.h>

#include <dynamy/schemes/energy_momentum.hpp>

#include "unit/simulation/scenes.hpp"

namespace dynamy {
namespace {

TEST(SchemeChoice, FollowsTheAccuracyIfNoSchemeWasNamed) {
  SimulationSettings s;
  s.step = 1e-3;
  SchemeChoice choice;
  choice.begin(s);
  EXPECT_EQ(choice.scheme().type(), "EnergyMomentum");
  choice.askTolerance(1e-5, s);
  EXPECT_EQ(choice.scheme().type(), "LocatedDormandPrince");
  EXPECT_EQ(s.step, 0.0);
  choice.askStep(1e-2, s);
  EXPECT_EQ(choice.scheme().type(), "EnergyMomentum");
  EXPECT_EQ(s.tolerance, 0.0);
}

TEST(SchemeChoice, KeepsANamedSchemeUntilATolerance) {
  SimulationSettings s;
  SchemeChoice choice;
  choice.name(std::make_unique<MoreauMidpoint>());
  const OneStep* named = &choice.scheme();
  choice.begin(s), choice.askStep(1e-2, s);
  EXPECT_EQ(&choice.scheme(), named);
  choice.askTolerance(1e-5, s);  // which a scheme of given steps cannot work to
  EXPECT_EQ(choice.scheme().type(), "LocatedDormandPrince");
}

TEST(SchemeChoice, RefusesStepsThatDoNotMoveTime) {
  SimulationSettings s;
  s.until = 1e6, s.step = 1e-10;
  SchemeChoice choice;
  choice.begin(s);
  EXPECT_THROW(choice.ready(1.0, s), ModelError);
}

TEST(SceneDescription, HasTheSignalsOfAllElementsByTheirFullNames) {
  Model m = scenes::ballOnFloor(1.0, 0.0, 0.5, 0.3, 1.0, 1e-3);
  m.build();
  SceneDescription d;
  d.describe(m);
  ASSERT_EQ(d.elements().size(), 2u);  // the ball and the floor
  EXPECT_TRUE(d.elements()[0].signals.empty());
  const NamedSignal* z = d.signal("ball.z");
  ASSERT_NE(z, nullptr);
  EXPECT_EQ(z->system, 0);
  EXPECT_EQ(z->contact, -1);
  EXPECT_EQ(d.signal("z"), nullptr);
  EXPECT_EQ(d.length(), 1.0);  // there is no frame and no shape
}

}  // namespace
}  // namespace dynamy
