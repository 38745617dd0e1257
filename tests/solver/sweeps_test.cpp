// Block Gauss–Seidel, Anderson's acceleration and the honest end of sweeps.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/law/rolling_friction.hpp>
#include <dynamy/solver/block_gauss_seidel.hpp>
#include <dynamy/solver/local/local_iteration.hpp>
#include <iostream>
#include <numbers>

#include "solver/fclib_checker.hpp"
#include "support/contact_problems.hpp"
#include "unit/solver/inclusion_fixture.hpp"
#include "unit/solver/laws.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr unsigned kSweepsSeed = 5;
using fixture::kBilateral;
using fixture::kUnilateral;

struct Result {
  SolveReport report;
  VectorXd Lambda;
};

Result solve(const FclibProblem& problem, const ProxOptions& options) {
  const auto given = inclusionProblem(condensed(problem));
  const FclibRule rule;
  given->problem().rule = &rule;
  Result out{{}, VectorXd::Zero(problem.rows())};
  out.report = BlockGaussSeidel(options).solve(given->problem(), view(out.Lambda));
  return out;
}

TEST(BlockGaussSeidel, SolvesTheKeptProblems) {
  for (const auto& [name, problem] : keptProblems()) {
    if (name.starts_with("stack")) continue;  // not by plain sweeps
    for (const bool symmetric : {false, true}) {
      const ProxOptions options{.tolerance = 1e-8, .symmetric = symmetric};
      const Result x = solve(problem, options);
      EXPECT_TRUE(x.report.ok()) << name << ": " << solveStatusText(x.report.status);
      // Another order of summation than the checker's.
      EXPECT_LE(fclibResidual(problem, x.Lambda), 1.01e-8) << name;
    }
  }
}

TEST(BlockGaussSeidel, SolvesOneContactInOneSweep) {
  for (unsigned seed = 1; seed < 50; ++seed) {
    const FclibProblem problem = randomProblem(3, 1, 6, 0.4, 0.0, seed);
    const Result x = solve(problem, {.tolerance = 1e-12});
    EXPECT_TRUE(x.report.ok()) << seed;
    EXPECT_LE(x.report.iterations, 1) << seed;
  }
}

TEST(BlockGaussSeidel, SolvesContactsThatHaveNoClosedForm) {
  // Rolling contacts, 5 rows, on bodies with 6 velocities each: one body alone, then coupled ones.
  std::mt19937 random(kSweepsSeed);
  std::cout << "seed " << kSweepsSeed << '\n';
  const UnilateralRolling law(0.4, 0.1);
  for (const int n : {1, 4}) {
    fixture::Inclusion x(std::vector<MatrixXd>{MatrixXd::Identity(8 * n, 8 * n)});
    for (int i = 0; i < n; ++i) x.contact(law, fixture::randomMatrix(random, 5, 8 * n) / n);
    VectorXd c = fixture::randomMatrix(random, 5 * n, 1);
    for (int i = 0; i < n; ++i) c[5 * i] = -std::abs(c[5 * i]);
    VectorXd Lambda = VectorXd::Zero(5 * n);
    const SolveReport report =
        BlockGaussSeidel({.tolerance = 1e-12}).solve(x.pose(c), view(Lambda));
    EXPECT_TRUE(report.ok()) << solveStatusText(report.status);
    if (n == 1) {
      EXPECT_LE(report.iterations, 2);
    }
  }
}

TEST(BlockGaussSeidel, GivesOneResultInBothFormsOfG) {
  std::mt19937 random(kSweepsSeed);
  std::cout << "seed " << kSweepsSeed << '\n';
  const UnilateralCoulomb law(0.0, 0.0, 0.3);
  fixture::Inclusion x(std::vector<MatrixXd>{MatrixXd::Identity(20, 20), MatrixXd::Identity(4, 4)});
  for (int i = 0; i < 4; ++i) x.contact(law, fixture::randomMatrix(random, 3, 24));
  const VectorXd c = fixture::randomMatrix(random, 12, 1);
  VectorXd L[2] = {VectorXd::Zero(12), VectorXd::Zero(12)};
  int k = 0;
  for (const auto form : {Delassus::Form::assembled, Delassus::Form::matrixFree})
    EXPECT_TRUE(BlockGaussSeidel({.tolerance = 1e-13, .anderson = 4})
                    .solve(x.pose(c, 1.0, form), view(L[k++]))
                    .ok());
  // E_u ≤ 1e-13 twice over the least eigenvalue of G, about 3.
  EXPECT_LE((L[0] - L[1]).norm(), 1e-12 * (L[0].norm() + c.norm()));
}

TEST(BlockGaussSeidel, SolvesJointsAndGivenFrictionAsBlocks) {
  // Two joints of 3 rows and a brake: fixed sets, so that the minimum of ½ΛᵀGΛ + cᵀΛ is the truth.
  std::mt19937 random(kSweepsSeed);
  std::cout << "seed " << kSweepsSeed << '\n';
  const GivenFriction brake(0.2, 0.2);
  fixture::Inclusion x(std::vector<MatrixXd>{MatrixXd::Identity(12, 12)});
  x.contact(kBilateral, fixture::randomMatrix(random, 3, 12));
  x.contact(kBilateral, fixture::randomMatrix(random, 3, 12));
  x.contact(brake, fixture::randomMatrix(random, 2, 12));
  const VectorXd c = fixture::randomMatrix(random, 8, 1);
  VectorXd L = VectorXd::Zero(8);
  ASSERT_TRUE(BlockGaussSeidel({.tolerance = 1e-13}).solve(x.pose(c), view(L)).ok());
  const VectorXd xi = x.dense() * L + c;
  const double small = 1e-11 * c.norm();
  EXPECT_LE(xi.head(6).norm(), small);
  EXPECT_LE(L.tail(2).norm(), 0.2 + small);
  // ξ opposes Λ: −ξᵀΛ = 0.2 |ξ|.
  EXPECT_NEAR(-xi.tail(2).dot(L.tail(2)), 0.2 * xi.tail(2).norm(), small);
}

TEST(Anderson, SolvesALinearIterationInAsManyStepsAsUnknowns) {
  // x ← Bx + b with five unknowns: the memory of five spans all directions.
  std::mt19937 random(kSweepsSeed);
  std::cout << "seed " << kSweepsSeed << '\n';
  const int n = 5;
  const MatrixXd A = fixture::randomMatrix(random, n, n), B = 0.9 * A / A.norm();
  const VectorXd b = fixture::randomMatrix(random, n, 1),
                 solution = (MatrixXd::Identity(n, n) - B).partialPivLu().solve(b);
  const VectorXd weights = VectorXd::Ones(n);
  Anderson anderson;
  anderson.begin(n, weights.data(), n);
  VectorXd x = VectorXd::Zero(n);
  for (int k = 0; k <= n + 1; ++k) {
    const VectorXd g = B * x + b;
    anderson.next(x.data(), g.data(), x.data());
  }
  // The ridge of the normal equations, 1e-14, times their condition.
  EXPECT_LE((x - solution).norm(), 1e-6 * solution.norm());
}

TEST(Anderson, SavesHalfOfTheSweepsOfAStack) {
  const FclibProblem stack = boxStack(4, 1.0, 0.5, 0.1);
  const Result plain = solve(stack, {.tolerance = 1e-8, .maxIterations = 100000}),
               fast = solve(stack, {.tolerance = 1e-8, .maxIterations = 100000, .anderson = 10});
  std::cout << "sweeps " << plain.report.iterations << " and " << fast.report.iterations << '\n';
  EXPECT_TRUE(fast.report.ok());
  EXPECT_LE(fast.report.iterations, plain.report.iterations / 2);
  EXPECT_LE(fclibResidual(stack, fast.Lambda), 1.01e-8);
}

TEST(Anderson, TakesTheRoundingOfAnAlternatingIterationAway) {
  // Masses 1 : 10³, the heavy one on top. Jacobi with 1/G_ii has the eigenvalue −0.9995: each
  // rounding of Λ comes back 2000 times. Measured without acceleration: it stops near 1e-10.
  const double ratio = 1e3;
  fixture::Inclusion x({MatrixXd::Constant(1, 1, ratio), MatrixXd::Constant(1, 1, 1.0)});
  x.contact(kUnilateral, MatrixXd{{1.0, -1.0}});
  x.contact(kUnilateral, MatrixXd{{0.0, 1.0}});
  VectorXd L = VectorXd::Zero(2);
  const SolveReport report =
      ProxJacobi({.tolerance = 1e-12, .relaxation = Relaxation::exact, .anderson = 3})
          .solve(x.pose(VectorXd{{0.0, -9.81}}), view(L));
  EXPECT_TRUE(report.ok()) << report.residuals.Eu;
  EXPECT_LE(report.iterations, 30);
  EXPECT_NEAR(L[1], (1.0 + ratio) * 9.81, 1e-8 * ratio);
}

TEST(Momentum, SavesAsManySweepsOfAColumnAsItsRootSays) {
  // tridiag(−1, 2, −1), n contacts that all carry: Gauss–Seidel has the largest eigenvalue
  // λ = cos²(π/(n + 1)), and with momentum the largest root of μ² − (1 + β)λμ + βλ = 0.
  const int n = 30;
  const double beta = 0.7, lambda = std::pow(std::cos(std::numbers::pi / (n + 1)), 2),
               half = 0.5 * (1.0 + beta) * lambda,
               root = half + std::sqrt(half * half - beta * lambda);
  MatrixXd S = MatrixXd::Zero(n, n + 1);
  for (int i = 0; i < n; ++i) S(i, i) = 1.0, S(i, i + 1) = -1.0;
  fixture::Inclusion x(S, kUnilateral);
  const auto sweeps = [&](double momentum, double tolerance) {
    VectorXd L = VectorXd::Zero(n);
    const SolveReport report = BlockGaussSeidel({.tolerance = tolerance, .momentum = momentum})
                                   .solve(x.pose(VectorXd::Constant(n, -1.0)), view(L));
    EXPECT_TRUE(report.ok()) << momentum;
    return report.iterations;
  };
  // Between two tolerances the start does not count. The last sweep is a whole one, and tests come
  // up to a tenth late: what is promised is 3.6, what is found 3.3 … 3.9.
  const auto between = [&](double momentum) {
    return static_cast<double>(sweeps(momentum, 1e-10) - sweeps(momentum, 1e-3));
  };
  EXPECT_NEAR(between(0.0) / between(beta), std::log(root) / std::log(lambda),
              0.1 * std::log(root) / std::log(lambda));
}

TEST(Momentum, IsGivenUpWhereItDiverges) {
  // Masses 1 : 10³: Jacobi has the eigenvalue −0.9995, with momentum the root −2.2.
  fixture::Inclusion x({MatrixXd::Constant(1, 1, 1e3), MatrixXd::Constant(1, 1, 1.0)});
  x.contact(kUnilateral, MatrixXd{{1.0, -1.0}});
  x.contact(kUnilateral, MatrixXd{{0.0, 1.0}});
  VectorXd L = VectorXd::Zero(2);
  const SolveReport report = ProxJacobi({.tolerance = 1e-6,
                                         .maxIterations = 100000,
                                         .relaxation = Relaxation::exact,
                                         .momentum = 0.7})
                                 .solve(x.pose(VectorXd{{0.0, -9.81}}), view(L));
  EXPECT_TRUE(report.ok()) << solveStatusText(report.status) << ' ' << report.residuals.Eu;
  // E_u ≤ 1e-6 of 9.81 m/s over the least eigenvalue of G, 5e-4.
  EXPECT_NEAR(L[1], 1001.0 * 9.81, 0.02 * 1001.0 * 9.81);
}

TEST(Sweeps, SayThatTheyStall) {
  // Two contacts press one body from both sides, and both ask for ξ ≥ 1: there is no solution.
  fixture::Inclusion x(MatrixXd{{1.0}, {-1.0}}, kUnilateral);
  VectorXd L = VectorXd::Zero(2);
  const SolveReport report =
      ProxGaussSeidel({.tolerance = 1e-10}).solve(x.pose(VectorXd{{-1.0, -1.0}}), view(L));
  EXPECT_EQ(report.status, SolveStatus::stalled);
  EXPECT_LT(report.iterations, 5000);
  EXPECT_GT(report.residuals.largest(), 0.1);
  // Accelerated, Λ runs away faster.
  L.setZero();
  const SolveReport fast = ProxGaussSeidel({.tolerance = 1e-10, .anderson = 5})
                               .solve(x.pose(VectorXd{{-1.0, -1.0}}), view(L));
  EXPECT_TRUE(fast.status == SolveStatus::diverged || fast.status == SolveStatus::stalled);
}

TEST(Sweeps, DoNotCallSlowProgressStalled) {
  // tridiag(−1, 2, −1), 60 contacts: 1.3e-3 of the error goes in a sweep.
  const int n = 60;
  MatrixXd S = MatrixXd::Zero(n, n + 1);
  for (int i = 0; i < n; ++i) S(i, i) = 1.0, S(i, i + 1) = -1.0;
  fixture::Inclusion x(S, kUnilateral);
  VectorXd L = VectorXd::Zero(n);
  const SolveReport report = ProxGaussSeidel({.tolerance = 1e-8, .maxIterations = 100000})
                                 .solve(x.pose(VectorXd::Constant(n, -1.0)), view(L));
  EXPECT_TRUE(report.ok()) << solveStatusText(report.status);
  EXPECT_GT(report.iterations, 2000);
}

}  // namespace
}  // namespace dynamy
