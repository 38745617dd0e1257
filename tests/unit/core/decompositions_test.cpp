#include <gtest/gtest.h>

#include <dynamy/core/decompositions.hpp>

namespace dynamy {
namespace {

/// Eigen binds a reference to nothing there (undefined-behaviour sanitizer).
TEST(Decompositions, SolveNoRightSides) {
  const Eigen::MatrixXd A{{2.0, 0.0, 1.0}, {0.0, 1.0, 0.0}};
  PseudoInverse inverse;
  inverse.compute(A);
  EXPECT_EQ(inverse.solve(Eigen::MatrixXd(2, 0)).rows(), 3);
  EXPECT_EQ(inverse.solve(Eigen::MatrixXd(2, 0)).cols(), 0);
  PivotedQr qr;
  qr.compute(A);
  EXPECT_EQ(qr.solve(Eigen::MatrixXd(2, 0)).rows(), 3);
}

TEST(Decompositions, PseudoInverseOfAProductIsThatOfTheMatrix) {
  std::srand(3);
  Eigen::MatrixXd X = Eigen::MatrixXd::Random(30, 7), Y = Eigen::MatrixXd::Random(30, 7);
  X.col(6) = X.col(0) - 2.0 * X.col(3);  // the product has the rank 6
  const Eigen::VectorXd b = Eigen::VectorXd::Random(30);
  ProductPseudoInverse product(1e-10);
  product.compute(X, Y);
  PseudoInverse whole(1e-10);
  whole.compute(X * Y.transpose());
  EXPECT_EQ(product.rank(), 6);
  EXPECT_EQ(whole.rank(), 6);
  Eigen::VectorXd x, y;
  product.solve(b, x), whole.solve(b, y);
  // Rounding times the condition, some 1e3.
  EXPECT_LT((x - y).norm(), 1e-11 * y.norm());
}

}  // namespace
}  // namespace dynamy
