/// Turning a whole scene by an exact angle turns its results: quarter turns about the axes map x,
/// y, z onto each other, so that both scenes can be written down without rounding.
#include <gtest/gtest.h>

#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

/// A box thrown onto a floor; the scene turned by the cyclic map x → y → z → x, `turns` times.
std::string thrownBox(int turns) {
  const auto v = [&](double a, double b, double c) {
    double in[3] = {a, b, c};
    std::rotate(in, in + (3 - turns) % 3, in + 3);
    return std::to_string(in[0]) + " " + std::to_string(in[1]) + " " + std::to_string(in[2]);
  };
  // The body axes are turned with the scene: all its vectors, and its quaternion's vector part.
  const auto p = [&] { return "0.8 " + v(0.48, -0.2, 0.3); };
  return R"(<dynamy version="1"><systems>
    <RigidBody name="box" position=")" +
         v(0.1, -0.2, 0.5) + "\" orientation=\"" + p() + "\" velocity=\"" + v(1.5, 0.5, -1.0) +
         "\" angularVelocity=\"" + v(1.0, 2.0, -0.5) + "\"><Box size=\"" + v(0.4, 0.3, 0.2) +
         R"(" mass="1" material="wood"/></RigidBody>
    <Ground name="world"><HalfSpace normal=")" +
         v(0, 0, 1) + R"(" material="floor"/></Ground>
  </systems><forces><Gravity acceleration=")" +
         v(0, 0, -9.81) + R"("/></forces>
  <elements><Contact between="wood floor"><UnilateralCoulomb mu="0.4" epsilonN="0.3"/></Contact></elements>
  <simulation until="1" step="1e-3"><MoreauMidpoint/></simulation></dynamy>)";
}

Vec3 back(Vec3 a, int turns) {
  for (int i = 0; i < turns; ++i) a = Vec3(a.y(), a.z(), a.x());
  return a;
}

class FrameInvariance : public testing::TestWithParam<int> {};

TEST_P(FrameInvariance, ATurnedSceneGivesTurnedResults) {
  const int turns = GetParam();
  Scene straight("straight", {.text = thrownBox(0)}), turned("turned", {.text = thrownBox(turns)});
  // Until the first impact rounding only; impacts of corners amplify it by some 10 each, and the
  // tangents chosen for friction differ. 0.25 s hold free flight and the first impact.
  double worst = 0.0;
  for (int i = 0; i < 400; ++i) {
    straight.step(1e-3), turned.step(1e-3);
    const Eigen::VectorXd a = straight.q("box"), b = turned.q("box");
    const Eigen::VectorXd ua = straight.u("box"), ub = turned.u("box");
    worst = std::max({worst, (back(b.head<3>(), turns) - a.head<3>()).norm(),
                      (back(b.tail<3>(), turns) - a.tail<3>()).norm(), std::abs(a[3] - b[3]),
                      (back(ub.head<3>(), turns) - ua.head<3>()).norm(),
                      (back(ub.tail<3>(), turns) - ua.tail<3>()).norm()});
  }
  EXPECT_LT(worst, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Turns, FrameInvariance, testing::Values(1, 2));

}  // namespace
}  // namespace dynamy::reference
