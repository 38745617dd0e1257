// Coefficients of Radau IIA of order 5: order conditions, collocation, and their transformation.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/located/phase/radau_method.hpp>

namespace dynamy {
namespace {

/// Sums of three numbers below 1, and of their products with T, whose condition is below 10.
constexpr double kRadauRounding = 1e-15, kTransformed = 1e-13;

TEST(RadauMethod, HasAQuadratureOfOrderFive) {
  const RadauMethod& m = radauMethod();
  for (int k = 0; k <= 4; ++k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) sum += m.weights[i] * std::pow(m.nodes[i], k);
    EXPECT_NEAR(sum, 1.0 / (k + 1), kRadauRounding) << k;
  }
  EXPECT_EQ(m.nodes[2], 1.0);
}

// With A = T Λ⁻¹ T⁻¹ the stages are those of collocation: A c^k = c^(k+1)/(k+1).
TEST(RadauMethod, SeparatesTheStagesOfCollocation) {
  const RadauMethod& m = radauMethod();
  Eigen::Matrix3d Lambda;
  Lambda << m.gamma, 0.0, 0.0, 0.0, m.alpha, -m.beta, 0.0, m.beta, m.alpha;
  const Eigen::Matrix3d inverse = m.T * Lambda * m.TInverse;  // A⁻¹
  for (int k = 0; k < 3; ++k) {
    Eigen::Vector3d power, integral;
    for (int i = 0; i < 3; ++i) {
      const double c = m.nodes[static_cast<std::size_t>(i)];
      power[i] = std::pow(c, k), integral[i] = std::pow(c, k + 1) / (k + 1);
    }
    EXPECT_NEAR((inverse * integral - power).norm(), 0.0, kTransformed) << k;
  }
}

// The product of the eigenvalues is det A⁻¹ = 60 [hairer_wanner1996, IV.5].
TEST(RadauMethod, HasTheEigenvaluesOfItsMatrix) {
  const RadauMethod& m = radauMethod();
  EXPECT_NEAR(m.gamma * (m.alpha * m.alpha + m.beta * m.beta), 60.0, 60.0 * kTransformed);
  EXPECT_NEAR(m.gamma + 2.0 * m.alpha, 9.0, 9.0 * kTransformed);
}

}  // namespace
}  // namespace dynamy
