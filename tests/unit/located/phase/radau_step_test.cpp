// One step of Radau IIA of order 5 against its function of stability and its order conditions.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/located/phase/radau_step.hpp>
#include <limits>

namespace dynamy {
namespace {

using Eigen::VectorXd;

VectorXd one(double value) { return VectorXd::Constant(1, value); }

/// Relative to 1 and to the numbers of the tests, which are of size 1.
constexpr double kTolerance = 1e-10;
/// Newton's iteration ends when the rest is below a small part of the tolerance: 1e-10 here, and
/// the numbers below are amplified by nothing.
constexpr double kStageSolved = 1e-10;

/// R(z) of the method [hairer_wanner1996, IV.5]: y⁺ = R(hλ) y for y' = λy.
double stability(double z) {
  return (1.0 + z * (2.0 / 5.0 + z / 20.0)) / (1.0 - z * (3.0 / 5.0 - z * (3.0 / 20.0 - z / 60.0)));
}

struct Step {
  RadauStep radau;
  bool good;
};

Step step(const RadauStep::Field& field, double y, double h, double t = 0.0) {
  Step out{RadauStep(), false};
  out.radau.prepare(one(1.0), kTolerance);
  VectorXd f(1);
  EXPECT_TRUE(field(t, one(y), -1, f));
  out.good = out.radau.take(field, t, one(y), f, one(0.0), h, false);
  return out;
}

RadauStep::Field linearField(double rate) {
  return [rate](double, const VectorXd& y, int, VectorXd& f) {
    f = rate * y;
    return true;
  };
}

TEST(RadauStep, OfALinearEquationIsItsFunctionOfStability) {
  for (const double rate : {0.5, -1.0, -10.0, -1e3, -1e6}) {
    const Step s = step(linearField(rate), 1.0, 1.0);
    ASSERT_TRUE(s.good) << rate;
    EXPECT_NEAR(s.radau.end()[0], stability(rate), kStageSolved) << rate;
  }
}

TEST(RadauStep, DampsWhatIsInfinitelyStiff) {
  // L-stable: R(−∞) = 0. At z = −1e8, |R| = 3/|z| to leading order.
  const Step s = step(linearField(-1e8), 1.0, 1.0);
  ASSERT_TRUE(s.good);
  EXPECT_LT(std::abs(s.radau.end()[0]), 1e-7);
}

TEST(RadauStep, PassesThroughAPolynomialOfDegreeThree) {
  const RadauStep::Field field = [](double t, const VectorXd&, int, VectorXd& f) {
    f = one(3.0 * t * t - t);
    return true;
  };
  const Step s = step(field, 2.0, 0.5, 1.0);
  ASSERT_TRUE(s.good);
  const auto exact = [](double t) { return 2.0 + t * t * t - 1.0 - 0.5 * (t * t - 1.0); };
  VectorXd y;
  for (const double theta : {0.0, 0.3, 0.8, 1.0}) {
    s.radau.dense(theta, y);
    EXPECT_NEAR(y[0], exact(1.0 + 0.5 * theta), kStageSolved) << theta;
  }
}

TEST(RadauStep, SolvesItsStagesWhereTheEquationIsNotLinear) {
  // y' = −y³/2, y(0) = 1: y = 1/√(1 + t). The local error of order 5 is C h⁶: halving divides it
  // by 2⁶ = 64, here within a factor of two.
  const RadauStep::Field field = [](double, const VectorXd& y, int, VectorXd& f) {
    f = one(-0.5 * y[0] * y[0] * y[0]);
    return true;
  };
  const auto error = [&](double h) {
    const Step s = step(field, 1.0, h);
    EXPECT_TRUE(s.good);
    return s.good ? std::abs(s.radau.end()[0] - 1.0 / std::sqrt(1.0 + h)) : 0.0;
  };
  const double ratio = error(0.4) / error(0.2);
  EXPECT_GT(ratio, 32.0);
  EXPECT_LT(ratio, 128.0);
}

TEST(RadauStep, KeepsTheJacobianWhileNewtonsMethodContracts) {
  Step s = step(linearField(-2.0), 1.0, 0.1);
  ASSERT_TRUE(s.good);
  EXPECT_TRUE(s.radau.tookJacobian());
  ASSERT_NE(s.radau.kept(), nullptr);
  EXPECT_EQ(s.radau.kept()->t, 0.0);
  const VectorXd y = s.radau.end();
  ASSERT_TRUE(s.radau.take(linearField(-2.0), 0.1, y, -2.0 * y, one(0.0), 0.1, false));
  EXPECT_FALSE(s.radau.tookJacobian());
  EXPECT_NEAR(s.radau.end()[0], stability(-0.2) * stability(-0.2), kStageSolved);
  s.radau.forget();
  ASSERT_TRUE(s.radau.take(linearField(-2.0), 0.1, y, -2.0 * y, one(0.0), 0.1, false));
  EXPECT_TRUE(s.radau.tookJacobian());
}

TEST(RadauStep, ReportsTheFastestRate) {
  // Two decoupled rates: the power method finds the larger one.
  RadauStep radau;
  radau.prepare(VectorXd::Ones(2), kTolerance);
  const RadauStep::Field field = [](double, const VectorXd& y, int, VectorXd& f) {
    f = Eigen::Vector2d(-1.0 * y[0], -400.0 * y[1]);
    return true;
  };
  const VectorXd y = VectorXd::Ones(2), f = Eigen::Vector2d(-1.0, -400.0);
  ASSERT_TRUE(radau.take(field, 0.0, y, f, VectorXd::Zero(2), 0.01, false));
  EXPECT_NEAR(radau.fastest(), 400.0, 0.2 * 400.0);  // the promise of the header
}

TEST(RadauStep, RefusesFieldsThatCannotBeEvaluated) {
  const auto refused = [](double, const VectorXd&, int stage, VectorXd& f) {
    f = one(0.0);
    return stage < 1;
  };
  EXPECT_FALSE(step(refused, 1.0, 0.1).good);
  const auto nan = [](double, const VectorXd&, int stage, VectorXd& f) {
    f = one(stage == 1 ? std::numeric_limits<double>::quiet_NaN() : 0.0);
    return true;
  };
  EXPECT_FALSE(step(nan, 1.0, 0.1).good);
}

}  // namespace
}  // namespace dynamy
