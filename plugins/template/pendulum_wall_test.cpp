// Test of the template plug-in: the pendulum bounces as in the closed form.
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
  EXPECT_NE(type->attributes.find("on"), nullptr);  // every simple contact has it
}

}  // namespace
}  // namespace dynamy
