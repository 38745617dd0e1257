// The plug-in to copy: the pendulum bounces as the closed form says.
#include <gtest/gtest.h>

#include <support/load_model.hpp>

namespace dynamy {
namespace {

TEST(PendulumWall, SwingsTurnWhereTheClosedFormSays) {
  LoadedModel loaded("plugins/template/pendulum_wall.xml");
  Simulation simulation(loaded.model());
  simulation.run();
  expectChecksHold(simulation);
}

TEST(PendulumWall, DescribesItself) {
  LoadedModel loaded("plugins/template/pendulum_wall.xml");
  const RegisteredType* type = loaded.registry().find("PendulumWall");
  ASSERT_NE(type, nullptr);
  EXPECT_EQ(type->library, "pendulum_wall");
  EXPECT_NE(type->attributes.find("distance"), nullptr);
  EXPECT_NE(type->attributes.find("on"), nullptr);  // what every simple contact has
}

}  // namespace
}  // namespace dynamy
