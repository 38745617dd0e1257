// Steps of a fixed length keep the energy of mechanisms in coordinates of joints (theory 39.11).
#include <gtest/gtest.h>
#include <cmath>
#include <support/bounded_run.hpp>

namespace dynamy {
namespace {

std::string pendulum(int links, const std::string& elements, double step) {
  std::string bodies, hinges;
  for (int i = 0; i < links; ++i) {
    const std::string name = "b" + std::to_string(i);
    bodies += "<PlanarBody name=\"" + name + "\" mass=\"1\" inertia=\"0.1\" position=\"" +
              std::to_string(i + 0.5) + " 0 0\"/>";
    hinges += "<Revolute name=\"h" + std::to_string(i) + "\" between=\"" +
              (i == 0 ? "world" : "b" + std::to_string(i - 1)) + ' ' + name + "\" at=\"" +
              std::to_string(i) + " 0 0\"/>";
  }
  return "<dynamy version=\"1\"><systems><Ground name=\"world\"/>" + bodies +
         "</systems><forces><Gravity/></forces><elements>" + hinges + elements +
         "</elements><simulation until=\"10\" step=\"" + std::to_string(step) +
         "\" coordinates=\"minimal\"/><record signals=\"b0.omega b0.x\" every=\"1\"/></dynamy>";
}

TEST(KeptEnergy, OfPendulumsIsExactWhateverTheStep) {
  // Let go level, 10 to 1000 steps of 10 ms: m g l/2 and more move to and fro. Rounding of 1000 steps,
  // each of 1e-15 of T + V, which is up to 30 J.
  for (const int links : {1, 2, 3}) {
    BoundedRun run(pendulum(links, "", 1e-2));
    run.run();
    ASSERT_TRUE(run.finished()) << run.report().reason;
    EXPECT_FALSE(run.report().qualified()) << links;
    EXPECT_LT(std::abs(run.report().energy.discretisation), 1e-10) << links;
  }
}

TEST(KeptEnergy, LeavesVelocitiesThatADrivePrescribes) {
  BoundedRun run(pendulum(2,
                          "<JointDrive between=\"world b0\" at=\"0 0 0\" coordinate=\"angle\" "
                          "motion=\"3*t\"/>",
                          1e-2));
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
  EXPECT_LT(std::abs(run.report().energy.discretisation), 1e-9);
}

}  // namespace
}  // namespace dynamy
