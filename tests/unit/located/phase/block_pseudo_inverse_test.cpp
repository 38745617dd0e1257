#include <gtest/gtest.h>

#include <algorithm>
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
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(A.rows(), -1.0, 2.0);
  Eigen::VectorXd x, y;
  divided.solve(b, x), whole.solve(b, y);
  EXPECT_EQ(divided.rank(), whole.rank());
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
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(24);
  Eigen::VectorXd x;
  divided.solve(b, x);
  EXPECT_EQ(divided.rank(), 24);
  // As above: condition below 1e4.
  EXPECT_LT((A * x - b).norm(), 1e-11 * b.norm());
}

/// Where rows are known to follow from others, these are solved alone.
TEST(BlockPseudoInverse, ImpliedRowsNeedNoOrthogonalDecomposition) {
  const Eigen::MatrixXd A = interleaved(8, 6, true);
  BlockPseudoInverse first(1e-10), later(1e-10);
  // In the range of A: each block's last row is the difference of its first two.
  const Eigen::VectorXd b = A * Eigen::VectorXd::LinSpaced(A.rows(), -1.0, 2.0);
  Eigen::VectorXd x, y;
  first.compute(A);
  first.solve(b, x);
  std::vector<char> implied(static_cast<std::size_t>(A.rows()), 0);
  first.findImplied(implied);
  EXPECT_EQ(std::count(implied.begin(), implied.end(), 1), 8);
  later.compute(A, implied);
  later.solve(b, y);
  EXPECT_EQ(later.rank(), 40);
  // As above; the square of the condition is corrected twice.
  EXPECT_LT((x - y).norm(), 1e-11 * x.norm());
  implied.assign(implied.size(), 0);
  later.findImplied(implied);  // nothing new where no rank was found
  EXPECT_EQ(std::count(implied.begin(), implied.end(), 1), 0);
}

/// Rows that contradict each other, or imply no others, are solved as if nothing were known.
TEST(BlockPseudoInverse, RowsThatAreNotImpliedAreNotLeftOut) {
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(48, -1.0, 2.0);
  for (const bool redundant : {true, false}) {
    const Eigen::MatrixXd A = interleaved(8, 6, redundant);
    BlockPseudoInverse known(1e-10), unknown(1e-10);
    std::vector<char> implied(48, 0);
    std::fill(implied.end() - 8, implied.end(), 1);  // the last row of each block
    Eigen::VectorXd x, y;
    unknown.compute(A), unknown.solve(b, x);
    known.compute(A, implied), known.solve(b, y);
    EXPECT_EQ(known.rank(), unknown.rank());
    EXPECT_LT((x - y).norm(), 1e-11 * x.norm());
  }
}

TEST(BlockPseudoInverse, MayBeFilledInByGroups) {
  const Eigen::MatrixXd A = interleaved(8, 6, true);
  BlockPseudoInverse filled(1e-10), whole(1e-10);
  std::vector<int> group(48);
  for (int i = 0; i < 48; ++i) group[static_cast<std::size_t>(i)] = i % 8;
  filled.begin(group);
  for (int i = 0; i < 48; ++i)
    for (int j = i % 8; j < 48; j += 8) filled.at(i, j) = A(i, j);
  EXPECT_EQ(filled.matrix(), A);
  EXPECT_EQ(filled.blocks(), 8);
  filled.compute(), whole.compute(A);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(48);
  Eigen::VectorXd x, y;
  filled.solve(b, x), whole.solve(b, y);
  EXPECT_EQ(x, y);
}

}  // namespace
}  // namespace dynamy
