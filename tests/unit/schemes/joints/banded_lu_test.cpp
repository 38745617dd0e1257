// BandedLu against dense LU, whole and in parts.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <dynamy/schemes/joints/banded_lu.hpp>
#include <random>

namespace dynamy {
namespace {

/// Two parts of 7 and 5 rows with half band width 3; rows of joints have zeros on the diagonal.
constexpr int kRows = 12, kBand = 3, kFirst = 7;

Eigen::MatrixXd twoParts(BandedLu& lu, double corner) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(kRows, kRows);
  const int ends[] = {kFirst, kRows};
  lu.reset(kRows, kBand, ends);
  for (int i = 0; i < kRows; ++i)
    for (int j = 0; j < kRows; ++j) {
      if (std::abs(i - j) > kBand || (i < kFirst) != (j < kFirst)) continue;
      A(i, j) = i == j && i % 3 == 0 ? 0.0 : number(random);
      if (i == kRows - 1) A(i, j) *= corner;
      lu.at(i, j) = A(i, j);
    }
  return A;
}

TEST(BandedLu, SolvesEachPartForAnyNumberOfColumns) {
  BandedLu lu;
  const Eigen::MatrixXd A = twoParts(lu, 1.0);
  ASSERT_TRUE(lu.factor());
  for (const int columns : {1, 2, 3, 6}) {
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const RowMajor B = RowMajor::Random(kRows, columns);
    RowMajor X = B;
    lu.solve(X.data(), kFirst, kRows, columns);
    EXPECT_EQ(X.topRows(kFirst), B.topRows(kFirst)) << "the other part stays as it is";
    lu.solve(X.data(), 0, kFirst, columns);
    // Condition about 1e2, 12 rows: 1e-13 of the solution.
    EXPECT_LT((A * X - B).cwiseAbs().maxCoeff(), 1e-13 * (1.0 + X.cwiseAbs().maxCoeff()));
  }
}

TEST(BandedLu, CountsItsMultiplications) {
  // A tridiagonal matrix that needs no exchange of rows: one multiplication for each of its n − 1
  // eliminations, and 2 (n − 1) for each right-hand side.
  constexpr int kN = 5;
  BandedLu lu;
  const int end = kN;
  lu.reset(kN, 1, {&end, 1});
  for (int i = 0; i < kN; ++i)
    for (int j = std::max(0, i - 1); j <= std::min(kN - 1, i + 1); ++j)
      lu.at(i, j) = i == j ? 4.0 : 1.0;
  ASSERT_TRUE(lu.factor());
  EXPECT_EQ(lu.multiplications(), kN - 1);
  std::vector<double> x(3 * kN, 1.0);
  lu.solve(x.data(), 0, kN, 3);
  EXPECT_EQ(lu.multiplications(), (kN - 1) + 3 * 2 * (kN - 1));
}

TEST(BandedLu, TellsThatAPartIsSingular) {
  BandedLu lu;
  twoParts(lu, 0.0);
  EXPECT_FALSE(lu.factor());
}

}  // namespace
}  // namespace dynamy
