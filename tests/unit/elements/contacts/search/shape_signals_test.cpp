// Signals of contacts between shapes and of joints: forces of bodies at rest, and units.
#include <gtest/gtest.h>

#include <string>
#include <unit/elements/blocks/block_scene.hpp>

namespace dynamy {
namespace {

/// Smallest and largest value of a signal of bodies at rest, from the start on.
std::pair<double, double> extremes(const std::string& bodies, const std::string& signal,
                                   const std::string& simulation) {
  BlockScene scene(R"(<dynamy version="1"><systems>
    <Ground name="table"><Box size="2 2 0.2" position="0 0 -0.1" material="m"/></Ground>)" +
                   bodies + R"(</systems><forces><Gravity acceleration="0 0 -10"/></forces>
    <elements><Contact between="m m"><UnilateralCoulomb mu="0.5"/></Contact></elements>
    <simulation until="0.2" )" +
                   simulation + R"(/>
    <check signal=")" +
                   signal + R"(" measure="min" between="-1e9 1e9"/>
    <check signal=")" +
                   signal + R"(" measure="max" between="-1e9 1e9"/></dynamy>)");
  Simulation s(scene.model());
  EXPECT_EQ(s.run().ended, RunReport::Ended::finished) << s.report().reason;
  const auto results = s.checks();
  return {results[0].got, results[1].got};
}

TEST(ShapeSignals, TheForceOfAPairIsTheWeightThatItCarries) {
  const std::string box = R"(<RigidBody name="box" position="0.1 0 0.1"><Box size="0.4 0.3 0.2"
    mass="3" material="m"/></RigidBody>)",
                    lid = R"(<RigidBody name="lid" position="0.1 0 0.25"><Box size="0.3 0.3 0.1"
    mass="2" material="m"/></RigidBody>)",
                    ring = R"(<RigidBody name="ring" position="0 0 0.05"><Torus radius="0.3"
    tube="0.05" mass="4" material="m"/></RigidBody>)";
  const std::tuple<std::string, const char*, double> cases[] = {
      {box + lid, "table-box.lambda_N", 50.0},
      {box + lid, "box-lid.lambda_N", 20.0},
      {ring, "ring-table.lambda_N", 40.0}};  // more than 32 places, which have no signals
  for (const char* simulation : {R"(tolerance="1e-8")", R"(step="1e-3")"})
    for (const auto& [bodies, signal, weight] : cases) {
      const auto [least, most] = extremes(bodies, signal, simulation);
      // What steps leave of gaps is pushed out in the next one: 1e-6 of the weight.
      EXPECT_NEAR(least, weight, 1e-6 * weight) << signal << ' ' << simulation;
      EXPECT_NEAR(most, weight, 1e-6 * weight) << signal << ' ' << simulation;
    }
}

TEST(ShapeSignals, OfRowsAboutAnAxisAreMomentsAndAngularVelocities) {
  BlockScene scene(R"(<dynamy version="1"><systems><Ground name="world"/>
    <RigidBody name="rod" mass="1" inertia="1 1 1"/><RigidBody name="sled" mass="1" inertia="1 1 1"/>
    </systems><elements>
    <Revolute name="hinge" between="world rod" axis="0 1 0"><GivenFriction force="1"/></Revolute>
    <JointMotor name="motor" between="world rod" axis="0 1 0" speed="1" limit="2"/>
    <JointStop name="stop" between="world rod" axis="0 1 0" upper="1"/>
    <Prismatic name="guide" between="world sled" axis="1 0 0"/>
    <JointMotor name="drive" between="world sled" axis="1 0 0" speed="1" limit="2"/>
    </elements><simulation until="1" step="1e-3" coordinates="absolute"/></dynamy>)");
  const auto unit = [&](const char* name) {
    const NamedSignal* s = scene.model().signal(name);
    return s == nullptr ? std::string("missing") : std::string(unitText(s->signal.unit));
  };
  for (const char* name : {"motor.lambda_T", "stop.upper.lambda_N", "hinge.angles.lambda_T1",
                           "hinge.friction.lambda_T"})
    EXPECT_EQ(unit(name), "N m") << name;
  EXPECT_EQ(unit("motor.gamma_T"), "rad/s");
  EXPECT_EQ(unit("stop.upper.g"), "rad");
  EXPECT_EQ(unit("hinge.lambda_T1"), "N");
  EXPECT_EQ(unit("drive.lambda_T"), "N");
  EXPECT_EQ(unit("drive.gamma_T"), "m/s");
}

}  // namespace
}  // namespace dynamy
