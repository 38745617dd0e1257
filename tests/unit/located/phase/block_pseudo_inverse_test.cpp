#include <gtest/gtest.h>

#include <dynamy/located/phase/block_pseudo_inverse.hpp>
#include <random>

namespace dynamy {
namespace {

/// `n` symmetric blocks of `m` rows, of rank m, or m − 1 where `redundant`; row i of block k is row
/// k + n i of the matrix.
Eigen::MatrixXd interleaved(int n, int m, bool redundant) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n * m, n * m);
  for (int k = 0; k < n; ++k) {
    Eigen::MatrixXd J(m, m + 2);
    for (Eigen::Index i = 0; i < J.size(); ++i) J.data()[i] = normal(random);
    if (redundant) J.row(m - 1) = J.row(0) - J.row(1);
    const Eigen::MatrixXd G = J * J.transpose();
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < m; ++j) A(k + n * i, k + n * j) = G(i, j);
  }
  return A;
}

void expectSameAsWhole(const Eigen::MatrixXd& A, int blocks) {
  BlockPseudoInverse divided(1e-10);
  PseudoInverse whole(1e-10);
  divided.compute(A), whole.compute(A);
  EXPECT_EQ(divided.blocks(), blocks);
  EXPECT_EQ(divided.rank(), whole.rank());
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(A.rows(), -1.0, 2.0);
  Eigen::VectorXd x, y;
  divided.solve(b, x), whole.solve(b, y);
  // Rounding: 1e-16 times the condition of random 6 × 8 Gaussian rows squared, below 1e4 here.
  EXPECT_LT((x - y).norm(), 1e-11 * y.norm());
}

TEST(BlockPseudoInverse, BlocksHaveTheSolutionOfTheWhole) {
  expectSameAsWhole(interleaved(8, 6, false), 8);
}

TEST(BlockPseudoInverse, RedundantRowsOfEachBlockShareAsInTheWhole) {
  expectSameAsWhole(interleaved(8, 6, true), 8);
}

TEST(BlockPseudoInverse, ABlockThatIsRoundingBesideTheOthersHasNoPart) {
  Eigen::MatrixXd A = interleaved(8, 6, false);
  A(0, 0) = 1e-14;  // row 0 alone, since its other entries are zero
  A.row(0).tail(47).setZero(), A.col(0).tail(47).setZero();
  expectSameAsWhole(A, 9);
}

TEST(BlockPseudoInverse, SmallMatricesAreDecomposedWhole) {
  BlockPseudoInverse divided(1e-10);
  PseudoInverse whole(1e-10);
  const Eigen::MatrixXd A = interleaved(2, 6, true);
  divided.compute(A), whole.compute(A);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(A.rows());
  Eigen::VectorXd x, y;
  divided.solve(b, x), whole.solve(b, y);
  EXPECT_EQ(divided.blocks(), 1);
  EXPECT_EQ(x, y);
}

/// A matrix of fewer blocks after one of more uses none of those before.
TEST(BlockPseudoInverse, BlocksOfTheMatrixBeforeAreForgotten) {
  BlockPseudoInverse divided(1e-10);
  divided.compute(interleaved(8, 6, false));
  const Eigen::MatrixXd A = interleaved(3, 8, false);
  divided.compute(A);
  EXPECT_EQ(divided.blocks(), 3);
  EXPECT_EQ(divided.rank(), 24);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(24);
  Eigen::VectorXd x;
  divided.solve(b, x);
  // As above: condition below 1e4.
  EXPECT_LT((A * x - b).norm(), 1e-11 * b.norm());
}

}  // namespace
}  // namespace dynamy
