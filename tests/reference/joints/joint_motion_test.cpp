/// Motions of bodies in joints against closed forms: Cardan's relation, screws, planes.
#include <gtest/gtest.h>

#include <dynamy/core/rotation.hpp>
#include <numbers>
#include <reference/joints/joint_scene.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

constexpr double kBend = 0.6;  // between the shafts [rad]

/// Input shaft along x, turned as told; output shaft in the x-y plane, bent by kBend. The cross
/// stands upright in the input's yoke at the start.
std::string shafts(const std::string& scheme) {
  return jointScene(
      "<Ground name=\"input\" rotation=\"3*t\" axis=\"1 0 0\"/>"
      "<RigidBody name=\"output\" mass=\"1\" inertia=\"0.02 0.1 0.1\" euler=\"0 0 0.6\" "
      "angularVelocity=\"" +
          std::to_string(3.0 * std::cos(kBend)) + " 0 0\"/>",
      "",
      "<Universal between=\"input output\" at=\"0 0 0\" axis=\"0 0 1\" axisB=\"" +
          std::to_string(std::sin(kBend)) + ' ' + std::to_string(-std::cos(kBend)) +
          " 0\"/><Revolute name=\"bearing\" between=\"world output\" at=\"0 0 0\" axis=\"" +
          std::to_string(std::cos(kBend)) + ' ' + std::to_string(std::sin(kBend)) + " 0\"/>",
      scheme);
}

TEST(UniversalJoint, TurnsTheOutputByCardansRelation) {
  // a·b = 0 with a = (0, −sin ψ1, cos ψ1), b perpendicular to the output:  tan ψ2 = tan ψ1 cos β.
  // Axes with six digits: 1e-6. Nine rows for six velocities: three depend on the others.
  //
  // The output's speed moves by 3 (1/cos β − cos β) = 1.16 rad/s in a quarter of a turn. Schemes of
  // second order: amplitude 1.16/3 rad, times (ωΔt)²/2 with ω = 6 for the second harmonic, is 7e-6.
  // Moreau's rule holds the rate at q^M with u^E: Δt/2 of the change of speed, 5.8e-4.
  for (const auto& [scheme, tolerance] :
       {std::pair{"<EnergyMomentum/>", 1.5e-5}, std::pair{"<StaggeredMoreau/>", 1.5e-5},
        std::pair{"<MoreauMidpoint/>", 1.2e-3}}) {
    SCOPED_TRACE(scheme);
    Scene s("shafts", {.text = shafts(scheme)});
    double worst = 0.0;
    s.run(2.0, 1e-3, [&] {
      const Eigen::VectorXd q = s.q("output");
      const Vec3 y = rotationMatrix(q.data() + 3).col(1), axis(std::cos(kBend), std::sin(kBend), 0);
      const Vec3 y0(-std::sin(kBend), std::cos(kBend), 0.0);
      const double psi2 = std::atan2(y.z(), y.dot(y0));
      const double psi1 = 3.0 * s.state().t;
      const double expected = std::atan2(std::sin(psi1) * std::cos(kBend), std::cos(psi1));
      worst = std::max(worst, std::abs(std::remainder(psi2 - expected, 2.0 * std::numbers::pi)));
    });
    EXPECT_TRUE(s.solved());
    EXPECT_LT(worst, tolerance);
  }
}

TEST(Screw, FallsByItsOwnInertia) {
  // (m + J/h²) z̈ = −m g,  h = pitch/2π.
  const double m = 2.0, J = 0.003, h = 0.2 / (2.0 * std::numbers::pi), g = 9.81;
  const double a = m * g / (m + J / (h * h));
  for (const char* scheme : {"<EnergyMomentum/>", "<StaggeredMoreau/>", "<MoreauMidpoint/>"}) {
    SCOPED_TRACE(scheme);
    Scene s("nut",
            {.text = jointScene(
                 "<RigidBody name=\"nut\" mass=\"2\" inertia=\"0.1 0.1 0.003\"/>", "<Gravity/>",
                 "<Screw between=\"world nut\" axis=\"0 0 1\" pitch=\"0.2\"/>", scheme)});
    s.run(1.0, 1e-2);
    EXPECT_TRUE(s.solved());
    // Constant acceleration and exact rotations: rounding of 100 steps, solver 1e-10.
    EXPECT_NEAR(s.q("nut")[2], -0.5 * a, 1e-8);
    EXPECT_NEAR(s.u("nut")[2], -a, 1e-8);
    EXPECT_NEAR(s.u("nut")[5], -a / h, 1e-6);
  }
}

TEST(Screw, IsHeldByFrictionAboutItsAxis) {
  // It holds while the moment exceeds m g h.
  const double limit = 2.0 * 9.81 * 0.2 / (2.0 * std::numbers::pi);
  const auto speed = [](double moment) {
    Scene s("nut",
            {.text = jointScene(
                 "<RigidBody name=\"nut\" mass=\"2\" inertia=\"0.1 0.1 0.003\"/>", "<Gravity/>",
                 "<Screw between=\"world nut\" axis=\"0 0 1\" pitch=\"0.2\"><ForceLimit "
                 "lower=\"" +
                     std::to_string(-moment) + "\" upper=\"" + std::to_string(moment) +
                     "\"/></Screw>")});
    s.run(0.1, 1e-2);
    EXPECT_TRUE(s.solved());
    return s.u("nut")[2];
  };
  EXPECT_NEAR(speed(1.001 * limit), 0.0, 1e-10);
  // What friction leaves over: 0.1 % of the fall without it, in 0.1 s.
  EXPECT_LT(speed(0.999 * limit), -1e-5);
}

TEST(PlanarJoint, MakesABodyInSpaceAPlanarOne) {
  // The same rod on the same spring, as PlanarBody (which turns about -y) and as RigidBody.
  const std::string spring =
      "<Gravity/><SpringDamper between=\"world rod\" pointA=\"0.3 0 1\" pointB=\"0.2 0 0.1\" "
      "stiffness=\"40\" length=\"0.3\"/>";
  Scene space("space",
              {.text = jointScene("<RigidBody name=\"rod\" mass=\"1\" inertia=\"0.3 0.1 0.2\" "
                                  "velocity=\"0.4 0 -0.2\" angularVelocity=\"0 2 0\"/>",
                                  spring, "<PlanarJoint between=\"world rod\" axis=\"0 1 0\"/>",
                                  "<StaggeredMoreau/>")});
  Scene plane("plane", {.text = jointScene("<PlanarBody name=\"rod\" mass=\"1\" inertia=\"0.1\" "
                                           "velocity=\"0.4 0 -0.2\" angularVelocity=\"-2\"/>",
                                           spring, "", "<StaggeredMoreau/>")});
  for (Scene* s : {&space, &plane}) s->run(1.0, 1e-3);
  EXPECT_TRUE(space.solved());
  const Eigen::VectorXd a = space.q("rod"), b = plane.q("rod");
  const SystemHandle h = plane.model().topology().system(1);
  ASSERT_EQ(h.nq, 3);
  // The same scheme, joint rows solved to 1e-10 a step.
  EXPECT_NEAR(a[0], b[0], 1e-8);
  EXPECT_NEAR(a[2], b[1], 1e-8);
  EXPECT_NEAR(a[1], 0.0, 1e-10);
  EXPECT_NEAR(std::remainder(2.0 * std::atan2(a[5], a[3]) + b[2], 2.0 * std::numbers::pi), 0.0,
              1e-8);
}

}  // namespace
}  // namespace dynamy::reference
