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

}  // namespace
}  // namespace dynamy
