// Sparse block LU against a dense one.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <dynamy/solver/newton/block_lu.hpp>
#include <random>

namespace dynamy {
namespace {

/// A chain of n blocks with some far couplings; unsymmetric, blocks diagonally dominant.
template <int B>
struct RandomSystem {
  std::vector<int> first{0}, column;
  Eigen::MatrixXd K;
  explicit RandomSystem(int n, unsigned seed) : K(Eigen::MatrixXd::Zero(n * B, n * B)) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        if (std::abs(i - j) > 1 && (i * 7 + j * 3) % 11 != 0) continue;
        column.push_back(j);
        for (int r = 0; r < B; ++r)
          for (int k = 0; k < B; ++k) K(i * B + r, j * B + k) = number(random);
      }
      K.block(i * B, i * B, B, B) += n * Eigen::MatrixXd::Identity(B, B);
      first.push_back(static_cast<int>(column.size()));
    }
  }
};

template <int B>
void compareWithDense() {
  const int n = 23;
  const RandomSystem<B> system(n, 5);
  BlockLu<B> lu;
  for (int repeat = 0; repeat < 2; ++repeat) {
    lu.analyse(system.first, system.column);
    lu.setZero();
    for (int i = 0; i < n; ++i)
      for (int e = system.first[i]; e < system.first[i + 1]; ++e)
        lu.at(i, system.column[e]) = system.K.template block<B, B>(i * B, system.column[e] * B);
    ASSERT_TRUE(lu.factor());
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n * B, -1.0, 1.0);
    std::vector<typename BlockLu<B>::Vector> x(n);
    for (int i = 0; i < n; ++i) x[i] = b.segment(i * B, B);
    lu.solve(x);
    const Eigen::VectorXd expected = system.K.partialPivLu().solve(b);
    // Dominant diagonal: no growth, a few hundred roundings of numbers below one.
    for (int i = 0; i < n; ++i) EXPECT_LT((x[i] - expected.segment(i * B, B)).norm(), 1e-13) << i;
  }
  EXPECT_EQ(lu.analyses(), 1) << "the same pattern is analysed once";
}

TEST(BlockLu, SolvesAsADenseLuDoes) {
  compareWithDense<2>();
  compareWithDense<3>();
  compareWithDense<6>();
}

TEST(BlockLu, TellsASingularPivot) {
  BlockLu<2> lu;
  lu.analyse({0, 1}, {0});
  lu.setZero();
  EXPECT_FALSE(lu.factor());
}

/// What a level leaves of three blocks, of which two are updated.
template <int B>
std::vector<double> updated(SubtractProducts subtract) {
  constexpr int kNumbers = 2 * B * B;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<Eigen::Array2d> X(3 * B * B), Y(2 * B * B), K(B * B);  // aligned as those of BlockLu
  for (auto* numbers : {&X, &Y, &K})
    for (Eigen::Array2d& x : *numbers) x = {number(random), number(random)};
  const std::vector<Eigen::Array2d> before = X;
  const int place[] = {2, 1, 0}, row[] = {0, 2};
  subtract(X.data()->data(), place, row, 2, Y.data()->data(), K.data()->data());
  for (int f = 0; f < 2; ++f)
    for (int lane = 0; lane < 2; ++lane)
      for (int c = 0; c < B; ++c)
        for (int r = 0; r < B; ++r) {
          const int at = place[row[f]] * B * B + c * B + r;
          double expected = before[at][lane];
          for (int k = 0; k < B; ++k)
            expected -= Y[f * B * B + k * B + r][lane] * K[c * B + k][lane];
          EXPECT_NEAR(X[at][lane], expected, 1e-15 * (B + 1)) << f << ' ' << r << ' ' << c;
        }
  return {X.data()->data(), X.data()->data() + 3 * kNumbers};
}

template <int B>
void levelsGiveTheSameBits() {
  const std::vector<double> plain = updated<B>(productLevels<B>().front());
  for (const SubtractProducts level : productLevels<B>()) EXPECT_EQ(updated<B>(level), plain);
}

TEST(BlockLu, ProductsHaveTheSameBitsOnEveryLevel) {
  levelsGiveTheSameBits<2>();
  levelsGiveTheSameBits<3>();
  levelsGiveTheSameBits<6>();
}

}  // namespace
}  // namespace dynamy
