/// Units are free: lengths × 2^a, masses × 2^b, times × 2^c scale all numbers without rounding, so
/// results must agree bit for bit where every operation is a product, a sum or a square root, and
/// the solvers have no hidden scale.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

std::string number(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

/// Box thrown onto a rough floor, in units L, M, T of the metre, kilogram, second.
std::string scene(double L, double M, double T) {
  const auto v = [](double s, double a, double b, double c) {
    return number(s * a) + " " + number(s * b) + " " + number(s * c);
  };
  return "<dynamy version=\"1\"><systems><RigidBody name=\"box\" position=\"" + v(L, 0, 0, 0.5) +
         "\" orientation=\"0.8 0.48 -0.2 0.3\" velocity=\"" + v(L / T, 1.5, 0.5, -1) +
         "\" angularVelocity=\"" + v(1 / T, 1, 2, -0.5) + "\"><Box size=\"" +
         v(L, 0.5, 0.25, 0.125) + "\" mass=\"" + number(M) + "\" material=\"wood\"/></RigidBody>" +
         "<Ground name=\"world\"><HalfSpace material=\"floor\"/></Ground></systems>" +
         "<forces><Gravity acceleration=\"" + v(L / T / T, 0, 0, -9.75) +
         "\"/></forces><elements>" +
         "<Contact between=\"wood floor\"><UnilateralCoulomb mu=\"0.4\" "
         "epsilonN=\"0.3\"/></Contact>" +
         "</elements><simulation until=\"" + number(T) + "\" step=\"" + number(T / 1024) +
         "\"><MoreauMidpoint/></simulation></dynamy>";
}

class UnitScaling : public testing::TestWithParam<std::array<int, 3>> {};

TEST_P(UnitScaling, PowersOfTwoScaleTheResultOnly) {
  const double L = std::ldexp(1.0, GetParam()[0]), M = std::ldexp(1.0, GetParam()[1]),
               T = std::ldexp(1.0, GetParam()[2]);
  Scene one("one", {.text = scene(1, 1, 1)}), other("other", {.text = scene(L, M, T)});
  double worst = 0.0;
  for (int i = 0; i < 1024; ++i) {
    one.step(1.0 / 1024), other.step(T / 1024);
    const Eigen::VectorXd q = one.q("box"), p = other.q("box"), u = one.u("box"),
                          w = other.u("box");
    worst = std::max(
        {worst, (p.head<3>() / L - q.head<3>()).norm(), (p.tail<4>() - q.tail<4>()).norm(),
         (w.head<3>() * T / L - u.head<3>()).norm(), (w.tail<3>() * T - u.tail<3>()).norm()});
  }
  EXPECT_EQ(worst, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Units, UnitScaling,
                         testing::Values(std::array{10, 0, 0}, std::array{0, 10, 0},
                                         std::array{0, 0, 10}, std::array{-10, -20, 5}));

}  // namespace
}  // namespace dynamy::reference
