// Convergence of prox Jacobi (JOR) and Gauss–Seidel (SOR): spectral radii of the unprojected
// iterations from tables, limits of r, and divergence that is told.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <dynamy/solver/prox_solvers.hpp>

#include "unit/solver/inclusion_fixture.hpp"
#include "unit/solver/laws.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

using fixture::kBilateral;  // sets inactive: the prox is the identity
using fixture::kUnilateral;

/// Spectral radius of the iteration e ← B e, with B e_j from one sweep that starts at e_j (c = 0).
template <class Solver>
double convergenceFactor(const MatrixXd& G, Relaxation rule, double factor = 1.0) {
  fixture::Inclusion x(fixture::symmetricRoot(G), kBilateral);
  InclusionProblem& p = x.pose(VectorXd::Zero(G.rows()));
  MatrixXd B = MatrixXd::Identity(G.rows(), G.rows());
  std::vector<double> r;
  relaxation(p, rule, factor, r);
  Solver solver;
  for (Eigen::Index j = 0; j < B.cols(); ++j) {
    p.G->begin(B.col(j).data());
    solver.sweep(p, r.data(), B.col(j).data());
  }
  return Eigen::EigenSolver<MatrixXd>(B).eigenvalues().cwiseAbs().maxCoeff();
}

const MatrixXd kPlus{{2.0, 1.0}, {1.0, 2.0}}, kMinus{{2.0, -1.0}, {-1.0, 2.0}};
const MatrixXd kOnes = MatrixXd::Ones(3, 3) + 0.1 * MatrixXd::Identity(3, 3);
const MatrixXd kChain{{2.0, -1.0, 0.0}, {-1.0, 2.0, -1.0}, {0.0, -1.0, 2.0}};

constexpr double kTable = 1e-6;  // half a unit of the last digit given there

TEST(ProxJacobi, ConvergesByTheTableWithTheDiagonal) {
  EXPECT_NEAR(convergenceFactor<ProxJacobi>(kPlus, Relaxation::exact), 0.5, kTable);
  EXPECT_NEAR(convergenceFactor<ProxJacobi>(kMinus, Relaxation::exact), 0.5, kTable);
  EXPECT_NEAR(convergenceFactor<ProxJacobi>(kChain, Relaxation::exact), std::sqrt(0.5), kTable);
  EXPECT_NEAR(convergenceFactor<ProxJacobi>(kOnes, Relaxation::exact), 2.0 / 1.1,
              kTable);  // diverges
}

TEST(ProxJacobi, ConvergesByTheTableWithRowSums) {
  EXPECT_NEAR(convergenceFactor<ProxJacobi>(kPlus, Relaxation::rowSums), 2.0 / 3.0, kTable);
  EXPECT_NEAR(convergenceFactor<ProxJacobi>(kMinus, Relaxation::rowSums), 2.0 / 3.0, kTable);
  EXPECT_NEAR(convergenceFactor<ProxJacobi>(kOnes, Relaxation::rowSums), 0.967742, kTable);
  EXPECT_NEAR(convergenceFactor<ProxJacobi>(kChain, Relaxation::rowSums), 0.833333, kTable);
}

TEST(ProxJacobi, ConvergesByTheTableWithTheBestCommonStep) {
  // r = 2/(λ_max + λ_min) as a factor of 1/λ_max, which the power iteration knows to 1e-6; the
  // factor of the iteration follows with up to 2 λ_max r = 4 times that.
  const auto best = [](const MatrixXd& G) {
    const VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<MatrixXd>(G).eigenvalues();
    const double high = eigenvalues[G.rows() - 1];
    return convergenceFactor<ProxJacobi>(G, Relaxation::spectral,
                                         2.0 * high / (high + eigenvalues[0]));
  };
  EXPECT_NEAR(best(kPlus), 0.5, 5.0 * kTable);
  EXPECT_NEAR(best(kMinus), 0.5, 5.0 * kTable);
  EXPECT_NEAR(best(kOnes), 0.9375, 5.0 * kTable);
  EXPECT_NEAR(best(kChain), std::sqrt(0.5), 5.0 * kTable);
}

TEST(ProxGaussSeidel, ConvergesByTheTable) {
  EXPECT_NEAR(convergenceFactor<ProxGaussSeidel>(kPlus, Relaxation::exact), 0.25, kTable);
  EXPECT_NEAR(convergenceFactor<ProxGaussSeidel>(kMinus, Relaxation::exact), 0.25, kTable);
  EXPECT_NEAR(convergenceFactor<ProxGaussSeidel>(kOnes, Relaxation::exact), 0.866784, kTable);
  EXPECT_NEAR(convergenceFactor<ProxGaussSeidel>(kChain, Relaxation::exact), 0.5, kTable);
}

TEST(ProxJacobi, DivergesBeyondTwoOverTheLargestEigenvalueAndSaysSo) {
  // λ_max = 3 of [2 1; 1 2]: converges below r = 2/3, diverges above.
  fixture::Inclusion x(fixture::symmetricRoot(kPlus), kBilateral);
  for (const double r : {0.66, 0.6733}) {
    InclusionProblem& p = x.pose(VectorXd{{-1.0, -2.0}});
    VectorXd Lambda = VectorXd::Zero(2);
    const SolveReport report =
        ProxJacobi(ProxOptions{1e-10, 100000, Relaxation::exact, 2.0 * r}).solve(p, view(Lambda));
    EXPECT_EQ(report.ok(), r < 2.0 / 3.0) << r;
    EXPECT_EQ(report.status, r < 2.0 / 3.0 ? SolveStatus::solved : SolveStatus::diverged) << r;
  }
}

TEST(ProxJacobi, OnRedundantLegsContractsByHalfAtAnEighthAndDivergesAboveASixth) {
  // A plate on four legs (F16): G_ij = 1 + x_i x_j/J_y + y_i y_j/J_x = 1 ± 3 ± 3 has the
  // eigenvalues 0, 4, 12, 12, and the iteration the factors 1 − rλ; that of the null space is 1 and
  // moves nothing.
  MatrixXd G(4, 4);
  const double x[] = {1, 1, -1, -1}, y[] = {1, -1, 1, -1};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) G(i, j) = 1.0 + 3.0 * x[i] * x[j] + 3.0 * y[i] * y[j];
  const auto solve = [&](double r, VectorXd& Lambda) {
    fixture::Inclusion plate(fixture::symmetricRoot(G), kUnilateral);
    InclusionProblem& p = plate.pose(-(G * Eigen::Vector4d(0.4, 0.3, 0.2, 0.1)));
    // The diagonal is 7: r = factor/7. The start is off by an eigenvector of 12.
    ProxJacobi solver({.relaxation = Relaxation::exact, .factor = 7.0 * r});
    Lambda = Eigen::Vector4d(0.4 + 1e-3, 0.3 + 1e-3, 0.2 - 1e-3, 0.1 - 1e-3);
    return solver.solve(p, view(Lambda));
  };
  VectorXd Lambda;
  const SolveReport halved = solve(0.125, Lambda);
  EXPECT_EQ(halved.status, SolveStatus::solved);
  // From 1e-3 of Λ to 1e-10 by halves: log2(1e7) = 23.3 sweeps, and one test behind.
  EXPECT_LE(halved.iterations, 26);
  EXPECT_GE(halved.iterations, 20);
  EXPECT_LT((G * (Lambda - Eigen::Vector4d(0.4, 0.3, 0.2, 0.1))).norm(), 1e-8);
  EXPECT_FALSE(solve(0.17, Lambda).ok());
}

TEST(ProxJacobi, DivergesWithTheDiagonalOnNearlyParallelContactsAndSaysSo) {
  fixture::Inclusion x(fixture::symmetricRoot(kOnes), kBilateral);
  VectorXd Lambda = VectorXd::Zero(3);
  const SolveReport report = ProxJacobi(ProxOptions{1e-10, 10000, Relaxation::exact, 1.0})
                                 .solve(x.pose(VectorXd{{-1.0, -2.0, 1.0}}), view(Lambda));
  EXPECT_EQ(report.status, SolveStatus::diverged);
}

TEST(ProxJacobi, ConvergesWithTheBooksRuleOnASingularMatrix) {
  fixture::Inclusion x(MatrixXd::Ones(3, 1), kUnilateral);
  VectorXd Lambda = VectorXd::Zero(3);
  EXPECT_TRUE(ProxJacobi().solve(x.pose(VectorXd::Constant(3, -1.0)), view(Lambda)).ok());
  EXPECT_NEAR(Lambda.sum(), 1.0, 1e-10);
}

TEST(ProxGaussSeidel, ReportsNumbersThatAreNotFinite) {
  fixture::Inclusion x(MatrixXd::Identity(2, 2), kUnilateral);
  VectorXd Lambda = VectorXd::Zero(2);
  const SolveReport report =
      ProxGaussSeidel().solve(x.pose(VectorXd{{std::nan(""), -1.0}}), view(Lambda));
  EXPECT_EQ(report.status, SolveStatus::notFinite);
}

TEST(ProxGaussSeidel, SaysThatTheLimitOfSweepsWasReached) {
  fixture::Inclusion x(fixture::symmetricRoot(kOnes), kBilateral);
  VectorXd Lambda = VectorXd::Zero(3);
  const SolveReport report = ProxGaussSeidel(ProxOptions{1e-12, 3, Relaxation::exact, 1.0})
                                 .solve(x.pose(VectorXd{{-1.0, -2.0, 1.0}}), view(Lambda));
  EXPECT_EQ(report.status, SolveStatus::maxIterations);
  EXPECT_EQ(report.iterations, 3);
  EXPECT_GT(report.residuals.largest(), 1e-12);
}

TEST(ProxGaussSeidel, AcceptsASolutionAsStartWithoutASweep) {
  fixture::Inclusion x(fixture::symmetricRoot(kMinus), kUnilateral);
  VectorXd Lambda{{4.0 / 3.0, 2.0 / 3.0}};
  const SolveReport report = ProxGaussSeidel().solve(x.pose(VectorXd{{-2.0, 0.0}}), view(Lambda));
  EXPECT_TRUE(report.ok());
  EXPECT_TRUE(report.warmAccepted);
  EXPECT_EQ(report.iterations, 0);
}

}  // namespace
}  // namespace dynamy
