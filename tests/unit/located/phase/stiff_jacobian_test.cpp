// The Jacobian of a linear equation by differences, and its factors.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <dynamy/located/phase/radau_method.hpp>
#include <dynamy/located/phase/stiff_jacobian.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Differences over the square root of rounding, 1.5e-8, of numbers of size 1.
constexpr double kDifference = 1e-7;

const Eigen::Matrix2d kJ = (Eigen::Matrix2d() << -1.0, 2.0, 0.5, -3.0).finished();

bool linear(double, const Eigen::VectorXd& y, int, Eigen::VectorXd& f) {
  f = kJ * y;
  return true;
}

StiffJacobian taken() {
  StiffJacobian out;
  const Eigen::VectorXd y = Eigen::Vector2d(1.0, -2.0);
  EXPECT_TRUE(out.take(linear, {0.5, y, kJ * y}, Eigen::VectorXd::Ones(2)));
  return out;
}

TEST(StiffJacobian, SolvesTheStepsOfTheMethod) {
  StiffJacobian J = taken();
  const double h = 0.1;
  J.factor(h);
  const RadauMethod& m = radauMethod();
  const Eigen::Matrix2d real = Eigen::Matrix2d::Identity() * (m.gamma / h) - kJ;
  const Eigen::VectorXd x = Eigen::Vector2d(3.0, 1.0);
  Eigen::VectorXd found;
  J.solve(real * x, found);
  EXPECT_NEAR((found - x).norm(), 0.0, kDifference);
  const std::complex<double> i(0.0, 1.0);
  const Eigen::Matrix2cd pair =
      Eigen::Matrix2cd::Identity() * ((m.alpha + i * m.beta) / h) - kJ.cast<std::complex<double>>();
  const Eigen::VectorXcd z = Eigen::Vector2cd(1.0 + 2.0 * i, -1.0 * i);
  EXPECT_NEAR((J.solve(Eigen::VectorXcd(pair * z)) - z).norm(), 0.0, kDifference);
}

TEST(StiffJacobian, KnowsItsPlaceUntilItIsForgotten) {
  StiffJacobian J = taken();
  EXPECT_TRUE(J.known());
  EXPECT_EQ(J.place().t, 0.5);
  J.forget();
  EXPECT_FALSE(J.known());
}

TEST(StiffJacobian, ReportsTheFastestRate) {
  // Eigenvalues −2 ± √2; the promise is 20 %.
  EXPECT_NEAR(taken().fastest(Eigen::VectorXd::Ones(2)), 2.0 + std::sqrt(2.0), 0.7);
  EXPECT_EQ(StiffJacobian().fastest(Eigen::VectorXd::Ones(2)), 0.0);
}

TEST(StiffJacobian, RefusesFieldsThatAreNotFinite) {
  StiffJacobian J;
  const auto nan = [](double, const Eigen::VectorXd& y, int, Eigen::VectorXd& f) {
    f.setConstant(y.size(), std::numeric_limits<double>::quiet_NaN());
    return true;
  };
  EXPECT_FALSE(J.take(nan, {0.0, Eigen::VectorXd::Ones(2), Eigen::VectorXd::Zero(2)},
                      Eigen::VectorXd::Ones(2)));
  EXPECT_FALSE(J.known());
}

}  // namespace
}  // namespace dynamy
