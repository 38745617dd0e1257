/// One scene, told in different ways: order of elements, form of the Delassus operator, minimal or
/// absolute coordinates.
#include <gtest/gtest.h>

#include <dynamy/solver/prox_solvers.hpp>
#include <reference/order.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

constexpr const char* kSystems[] = {
    R"(<PlanarBody name="block" position="0 0 0.3" angle="0.4" velocity="1 0 0"><Box size="0.4 0.2 0.2" mass="1" material="wood"/></PlanarBody>)",
    R"(<PointMass name="ball" plane="xz" position="1 0 0.5" velocity="-1 0 0" mass="0.3"><Sphere radius="0.1" material="ball"/></PointMass>)",
    R"(<Ground name="world"><HalfSpace material="floor"/></Ground>)"};
constexpr const char* kElements[] = {
    R"(<Contact between="wood floor"><UnilateralCoulomb mu="0.3" epsilonN="0.2"/></Contact>)",
    R"(<Contact between="ball floor"><UnilateralCoulomb mu="0.1" epsilonN="0.7"/></Contact>)",
    R"(<NoContact between="ball wood"/>)"};

std::string ordered(const std::array<int, 3>& order) {
  std::string systems, elements;
  for (const int i : order) systems += kSystems[i], elements += kElements[i];
  return "<dynamy version=\"1\"><systems>" + systems +
         "</systems><forces><Gravity/></forces><elements>" + elements +
         "</elements><simulation until=\"1\" step=\"1e-3\"><MoreauMidpoint/></simulation></dynamy>";
}

TEST(SameResult, WhateverTheOrderOfTheElements) {
  Scene one("one", {.text = ordered({0, 1, 2})}), other("other", {.text = ordered({2, 1, 0})});
  one.run(1.0, 1e-3), other.run(1.0, 1e-3);
  // Sums are formed in another order: rounding, amplified by a few impacts.
  for (const char* name : {"block", "ball"}) {
    EXPECT_NEAR((one.q(name) - other.q(name)).norm(), 0.0, 1e-9) << name;
    EXPECT_NEAR((one.u(name) - other.u(name)).norm(), 0.0, 1e-8) << name;
  }
}

class DelassusForm : public testing::TestWithParam<const char*> {};

TEST_P(DelassusForm, AssembledAndMatrixFreeGiveOneMotion) {
  const auto setup = [](Delassus::Form form) {
    SceneSetup out{.form = form};
    out.solver = std::make_unique<ProxGaussSeidel>(ProxOptions{.tolerance = 1e-13});
    return out;
  };
  Scene a(GetParam(), setup(Delassus::Form::assembled)),
      b(GetParam(), setup(Delassus::Form::matrixFree));
  double worst = 0.0;
  for (int i = 0; i < 1000; ++i) {
    a.step(1e-3), b.step(1e-3);
    worst = std::max(worst, (a.state().q - b.state().q).lpNorm<Eigen::Infinity>());
  }
  // The same sweeps in another arithmetic: rounding, and impacts of corners amplify it by some 10
  // to 100 each.
  EXPECT_LT(worst, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Models, DelassusForm,
                         testing::Values("falling_box", "rocking_block", "double_pendulum",
                                         "newtons_cradle", "slide_to_roll"));

TEST(SameResult, InMinimalAndInAbsoluteCoordinatesWithOrderOne) {
  for (const Scheme scheme : kBothSchemes) {
    const std::vector<double> dt = halvings(1e-3, 5);
    std::vector<double> pendulum, both;
    for (const double h : dt) {
      Scene one("pendulum", {.scheme = scheme});
      one.run(1.0, h);
      const double phi = one.q("minimal")[0];
      pendulum.push_back((one.q("bob") - Eigen::Vector2d(std::sin(phi), -std::cos(phi))).norm());

      Scene two("double_pendulum", {.scheme = scheme});
      two.run(1.0, h);
      const Eigen::VectorXd q = two.q("minimal");
      both.push_back((two.q("lower") - Eigen::Vector2d(std::sin(q[0]) + std::sin(q[1]),
                                                       -std::cos(q[0]) - std::cos(q[1])))
                         .norm());
    }
    EXPECT_NEAR(fitOrder(dt, pendulum).order, 1.0, 0.15) << fitOrder(dt, pendulum);
    EXPECT_NEAR(fitOrder(dt, both).order, 1.0, 0.15) << fitOrder(dt, both);
  }
}

}  // namespace
}  // namespace dynamy::reference
