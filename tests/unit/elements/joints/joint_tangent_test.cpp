// The closed form of Newton's matrix for joints against the one taken by differences.
#include <gtest/gtest.h>

#include <dynamy/schemes/joints/joint_newton.hpp>
#include <reference/scene.hpp>

namespace dynamy {
namespace {

/// Bodies that move and turn, heavy loads in the joints.
std::string model(const std::string& systems, const std::string& joints) {
  return "<dynamy version=\"1\"><systems>" + systems +
         "<Ground name=\"world\"/></systems><forces><Gravity/></forces><elements>" + joints +
         "</elements><simulation until=\"1\" step=\"1e-2\"><EnergyMomentum/></simulation></dynamy>";
}

/// K⁻¹ of unit vectors, in one way or the other; the way that was really taken.
JointNewton::Tangent responses(reference::Scene& scene, double dt, JointNewton::Tangent wanted,
                               std::vector<std::vector<double>>& out) {
  const State& x = scene.state();
  JointNewton newton;
  EXPECT_TRUE(newton.equations.begin(scene.system(), x, dt));
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(x.u.size());
  newton.equations.evaluate(scene.system(), none);
  EXPECT_TRUE(newton.linearise(scene.system(), none, wanted));
  const auto unknowns = static_cast<std::size_t>(newton.unknowns());
  out.assign(unknowns, std::vector<double>(unknowns, 0.0));
  for (std::size_t i = 0; i < unknowns; ++i) out[i][i] = 1.0, newton.solve(out[i].data());
  return newton.tangent();
}

void expectSame(const std::string& text) {
  constexpr double dt = 1e-2;
  reference::Scene scene("mechanism", {.text = text});
  scene.run(0.2, dt);  // joints then carry percussions, and bodies turn
  ASSERT_TRUE(scene.solved());
  std::vector<std::vector<double>> closed, differences;
  EXPECT_EQ(responses(scene, dt, JointNewton::Tangent::closedForm, closed),
            JointNewton::Tangent::closedForm);
  EXPECT_EQ(responses(scene, dt, JointNewton::Tangent::differences, differences),
            JointNewton::Tangent::differences);
  // Differences of 1e-7 are good to 1e-7 of the entries of K, whose condition is about 1e2 here.
  constexpr double kTolerance = 1e-5;
  for (std::size_t i = 0; i < closed.size(); ++i) {
    double size = 0.0;
    for (const double r : differences[i]) size = std::max(size, std::abs(r));
    for (std::size_t k = 0; k < closed[i].size(); ++k)
      EXPECT_NEAR(closed[i][k], differences[i][k], kTolerance * size) << i << ", " << k;
  }
}

/// Centre of mass beside the origin of its frames, no principal axes.
const std::string kBody =
    "<RigidBody name=\"body\" position=\"0.3 0.1 -0.2\" velocity=\"0.4 -1 0.2\" "
    "angularVelocity=\"2 -3 1\"><Box size=\"0.2 0.3 0.4\" position=\"0.1 0.05 0.02\" "
    "euler=\"20deg 30deg 0\" mass=\"1.2\"/></RigidBody>";

class JointTangent : public ::testing::TestWithParam<const char*> {};

TEST_P(JointTangent, OfABodyOnTheGroundIsThatOfDifferences) {
  expectSame(model(kBody, GetParam()));
}

TEST_P(JointTangent, OfTwoBodiesIsThatOfDifferences) {
  std::string joint = GetParam();
  joint.replace(joint.find("world"), 5, "other");
  const std::string other =
      "<RigidBody name=\"other\" position=\"0 0 0.1\" mass=\"2\" inertia=\"0.1 0.2 0.15\" "
      "velocity=\"1 0 -1\" angularVelocity=\"1 2 -2\"/>";
  expectSame(model(other + kBody, joint + "<Spherical between=\"world other\" at=\"0 0 0.5\"/>"));
}

INSTANTIATE_TEST_SUITE_P(
    All, JointTangent,
    ::testing::Values("<Spherical between=\"world body\" at=\"0 0 0\"/>",
                      "<Revolute between=\"world body\" at=\"0 0 0\" axis=\"0 1 0.5\"/>",
                      "<Prismatic between=\"world body\" axis=\"1 2 0\"/>",
                      "<Fixed between=\"world body\"/>",
                      "<Distance between=\"world body\" pointA=\"0 0 0.5\" pointB=\"0.1 0 0.1\"/>"),
    [](const auto& one) { return "Joint" + std::to_string(one.index); });

TEST(JointTangentInAPlane, OfRodsAndAPointMassIsThatOfDifferences) {
  expectSame(
      model("<PlanarBody name=\"rod\" position=\"0.5 0 0\" mass=\"1\" inertia=\"0.1\" "
            "angularVelocity=\"2\"/><PointMass name=\"bob\" plane=\"xz\" position=\"1 0 -1\" "
            "mass=\"3\"/>",
            "<Revolute between=\"world rod\" at=\"0 0 0\"/>"
            "<Distance between=\"rod bob\" pointA=\"0.5 0 0\"/>"));
}

TEST(JointTangentRefused, IsThatOfMasses) {
  // Coordinates do not offer theirs.
  reference::Scene scene("double_pendulum");
  std::vector<std::vector<double>> out;
  EXPECT_EQ(responses(scene, 1e-3, JointNewton::Tangent::closedForm, out),
            JointNewton::Tangent::masses);
}

}  // namespace
}  // namespace dynamy
