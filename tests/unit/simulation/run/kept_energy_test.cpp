// Steps of a fixed length keep the energy of mechanisms in coordinates of joints (theory 39.11).
#include <gtest/gtest.h>
#include <cmath>
#include <support/bounded_run.hpp>

namespace dynamy {
namespace {

/// Links of 1 m in a row from x [m], hinged to each other and to the ground, that turn at `rate` at the start.
struct Links {
  std::string bodies, hinges;
  Links(const std::string& name, int n, double x, double rate) {
    for (int i = 0; i < n; ++i) {
      const std::string own = name + std::to_string(i);
      bodies += "<PlanarBody name=\"" + own + "\" mass=\"1\" inertia=\"0.1\" position=\"" +
                std::to_string(x + i + 0.5) + " 0 0\" velocity=\"0 0 " +
                std::to_string(-rate * (i + 0.5)) + "\" angularVelocity=\"" +
                std::to_string(i == 0 ? rate : -rate) + "\"/>";
      hinges += "<Revolute between=\"" + (i == 0 ? "world" : name + std::to_string(i - 1)) + ' ' +
                own + "\" at=\"" + std::to_string(x + i) + " 0 0\"/>";
    }
  }
};

std::string scene(const std::string& bodies, const std::string& forces, const std::string& elements,
                  double step, const std::string& signals) {
  return "<dynamy version=\"1\"><systems><Ground name=\"world\"/>" + bodies + "</systems><forces>" +
         forces + "</forces><elements>" + elements + "</elements><simulation until=\"10\" step=\"" +
         std::to_string(step) + "\" coordinates=\"minimal\"/><record signals=\"" + signals +
         "\" every=\"1\"/></dynamy>";
}

TEST(KeptEnergy, OfLinksThatTurnIsExactWhateverTheStep) {
  // Without forces T stays. Rounding of 1000 steps, each of 1e-15 of T, some 10 J, and what Newton's
  // iteration leaves, 1e-12 of a step's way.
  for (const int n : {2, 3, 4}) {
    const Links links("b", n, 0.0, 2.0);
    BoundedRun run(scene(links.bodies, "", links.hinges, 1e-2, "b0.x"));
    run.run();
    ASSERT_TRUE(run.finished()) << run.report().reason;
    EXPECT_GT(run.report().energy.kineticEnd, 1.0);
    EXPECT_LT(std::abs(run.report().energy.discretisation), 1e-9) << n;
  }
}

TEST(KeptEnergy, OfAMechanismIsNotTakenFromAnother) {
  // Slow links move as if the fast ones were not there, to what Newton's iteration leaves: 1e-13 of 20 m
  // in each of 5000 steps. Two links without weight move regularly, so that it does not grow.
  const Links slow("a", 2, 0.0, 0.5), fast("b", 3, 20.0, 2.0);
  BoundedRun alone(scene(slow.bodies, "", slow.hinges, 2e-3, "a1.x a1.z"));
  BoundedRun beside(
      scene(slow.bodies + fast.bodies, "", slow.hinges + fast.hinges, 2e-3, "a1.x a1.z"));
  alone.run(), beside.run();
  ASSERT_TRUE(alone.finished() && beside.finished());
  ASSERT_EQ(beside.report().steps, alone.report().steps);  // a divided step would be one for all
  for (std::size_t row = 0; row < alone.times().size(); ++row)
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(beside.value(row, k), alone.value(row, k), 1e-8) << row;
}

TEST(KeptEnergy, LeavesVelocitiesThatADrivePrescribes) {
  const Links links("b", 2, 0.0, 3.0);
  BoundedRun run(scene(links.bodies, "<Gravity/>",
                       links.hinges + "<JointDrive between=\"world b0\" at=\"0 0 0\" "
                                      "coordinate=\"angle\" motion=\"3*t\"/>",
                       1e-2, "b0.omega"));
  run.run();
  ASSERT_TRUE(run.finished()) << run.report().reason;
  for (std::size_t row = 1; row < run.times().size(); ++row)
    EXPECT_NEAR(std::abs(run.value(row, 0)), 3.0, 1e-9);  // the drive's own accuracy
}

TEST(KeptEnergy, CostsFewEvaluations) {
  // Twenty ball joints, 60 velocities: differences for a tangent would be 60 evaluations a step.
  std::string bodies, balls;
  for (int i = 0; i < 20; ++i) {
    const std::string name = "b" + std::to_string(i);
    bodies += "<RigidBody name=\"" + name +
              "\" mass=\"0.1\" inertia=\"5e-6 8.3e-5 8.3e-5\" position=\"" +
              std::to_string(0.1 * (i + 0.5)) + " 0 0\"/>";
    balls += "<Spherical between=\"" + std::string(i == 0 ? "world" : "b" + std::to_string(i - 1)) +
             ' ' + name + "\" at=\"" + std::to_string(0.1 * i) + " 0 0\"/>";
  }
  BoundedRun run(
      "<dynamy version=\"1\"><systems><Ground name=\"world\"/>" + bodies +
      "</systems><forces><Gravity/></forces><elements>" + balls +
      "</elements><simulation until=\"0.2\" step=\"1e-3\" coordinates=\"minimal\"/></dynamy>");
  run.run();
  ASSERT_TRUE(run.finished()) << run.report().reason;
  EXPECT_LT(run.report().cost.evaluations, 200 * 15);
}

}  // namespace
}  // namespace dynamy
