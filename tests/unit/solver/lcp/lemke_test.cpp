// Lemke's pivoting: solutions, rays, proofs that there is none, degenerate problems.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/solver/lcp/lemke.hpp>

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Pivoted {
  LcpOutcome outcome;
  VectorXd z, w;
  int pivots;
};
Pivoted pivot(const MatrixXd& matrix, const VectorXd& q, int maxPivots = 10000) {
  const RowMatrix M = matrix;
  Lemke lemke;
  VectorXd z = VectorXd::Constant(q.size(), -7.0);
  const LcpOutcome outcome =
      lemke.solve({M.data(), M.rows(), M.cols()}, view(q), view(z), maxPivots);
  return {outcome, z, M * z + q, lemke.pivots()};
}

TEST(Lemke, TakesZeroWhereQIsNotNegative) {
  const Pivoted a = pivot(MatrixXd::Constant(2, 2, -3.0), VectorXd{{0.0, 1.0}});
  EXPECT_EQ(a.outcome, LcpOutcome::solved);
  EXPECT_EQ(a.z.norm(), 0.0);
  EXPECT_EQ(a.pivots, 0);
}

TEST(Lemke, SolvesTheEmptyProblem) {
  EXPECT_EQ(pivot(MatrixXd(0, 0), VectorXd(0)).outcome, LcpOutcome::solved);
}

TEST(Lemke, SolvesTwoCoupledContacts) {
  // [2 −1; −1 2] z = (2, 0).
  const Pivoted a = pivot(MatrixXd{{2.0, -1.0}, {-1.0, 2.0}}, VectorXd{{-2.0, 0.0}});
  EXPECT_EQ(a.outcome, LcpOutcome::solved);
  EXPECT_LE((a.z - VectorXd{{4.0 / 3.0, 2.0 / 3.0}}).norm(), 1e-15);
}

TEST(Lemke, SolvesAProblemThatDoesNotDependOnUnits) {
  // Units of z and w by contact: S M S, S q.
  const MatrixXd M{{2.0, -1.0, 0.5}, {-1.0, 2.0, 0.0}, {0.3, 0.0, 1.0}};
  const VectorXd q{{-2.0, -0.1, 0.4}}, S{{1e-9, 1.0, 1e6}};
  const Pivoted one = pivot(M, q),
                other = pivot(S.asDiagonal() * M * S.asDiagonal(), S.asDiagonal() * q);
  EXPECT_EQ(one.outcome, LcpOutcome::solved);
  EXPECT_EQ(other.outcome, LcpOutcome::solved);
  EXPECT_LE((S.asDiagonal() * other.z - one.z).norm(), 1e-12);  // |S| spans 1e15
}

TEST(Lemke, DoesNotCycleAmongEqualContacts) {
  // n equal contacts on one body, rank one: every ratio is a tie.
  for (const int n : {2, 5, 20}) {
    const Pivoted a = pivot(MatrixXd::Ones(n, n), VectorXd::Constant(n, -1.0));
    EXPECT_EQ(a.outcome, LcpOutcome::solved);
    EXPECT_NEAR(a.z.sum(), 1.0, 1e-14);
    EXPECT_GE(a.z.minCoeff(), 0.0);
    EXPECT_LE(a.pivots, 2 * n);
  }
}

TEST(Lemke, SolvesMurtysProblemOfManyPivots) {
  // M lower triangular, 1 on and 2 below the diagonal, q = −1: z = (1, 0, …), w_i = 1.
  for (const int n : {6, 12}) {
    MatrixXd M = MatrixXd::Identity(n, n);
    M.triangularView<Eigen::StrictlyLower>().setConstant(2.0);
    const Pivoted a = pivot(M, VectorXd::Constant(n, -1.0));
    EXPECT_EQ(a.outcome, LcpOutcome::solved);
    EXPECT_LE((a.z - VectorXd::Unit(n, 0)).norm(), 1e-12);
  }
}

TEST(Lemke, ProvesThatNoSolutionExists) {
  // w = −z − 1; and z₁ = 1 with −z₂ − z₃ ≥ 1e-4, where the ray itself is no proof.
  EXPECT_EQ(pivot(MatrixXd{{-1.0}}, VectorXd{{-1.0}}).outcome, LcpOutcome::infeasible);
  EXPECT_EQ(pivot(MatrixXd{{0.0}}, VectorXd{{-1.0}}).outcome, LcpOutcome::infeasible);
  const MatrixXd M{{0.0, -1.0, -1.0}, {1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}};
  EXPECT_EQ(pivot(M, VectorXd{{-1e-4, -1.0, 1.0}}).outcome, LcpOutcome::infeasible);
  // Two contacts push one body apart, which the ends forbid: ones(2), c = (−1, −2) has a solution,
  // (1 −1; −1 1) with c = (−1, −1) none.
  EXPECT_EQ(pivot(MatrixXd{{1.0, -1.0}, {-1.0, 1.0}}, VectorXd{{-1.0, -1.0}}).outcome,
            LcpOutcome::infeasible);
}

TEST(Lemke, TheProofIsADirectionThatNoSolutionAllows) {
  const RowMatrix M{{1.0, -1.0}, {-1.0, 1.0}};
  const VectorXd q{{-1.0, -1.0}};
  Lemke lemke;
  VectorXd z(2);
  ASSERT_EQ(lemke.solve({M.data(), 2, 2}, view(q), view(z)), LcpOutcome::infeasible);
  const VectorXd h = lemke.direction();
  EXPECT_GE(h.minCoeff(), 0.0);
  EXPECT_LE((M.transpose() * h).maxCoeff(), 1e-9);
  EXPECT_LT(q.dot(h), -1e-3);
}

TEST(Lemke, SaysRayWhereNothingIsKnown) {
  // A game of two: z = (0, 0.1, 0.05, 0)… exists, but z_r enters with a column that stops nobody.
  MatrixXd M = MatrixXd::Zero(4, 4);
  M.topRightCorner(2, 2) << 10.0, 20.0, 30.0, 15.0;
  M.bottomLeftCorner(2, 2) << 10.0, 20.0, 30.0, 15.0;
  const Pivoted a = pivot(M, VectorXd::Constant(4, -1.0));
  EXPECT_EQ(a.outcome, LcpOutcome::ray);
  EXPECT_EQ(a.z, VectorXd::Constant(4, -7.0)) << "z is left alone";
}

TEST(Lemke, StopsAtTheLimitOfPivots) {
  const Pivoted a = pivot(MatrixXd{{2.0, -1.0}, {-1.0, 2.0}}, VectorXd{{-2.0, -1.0}}, 1);
  EXPECT_EQ(a.outcome, LcpOutcome::pivotLimit);
}

TEST(Lemke, SaysThatNumbersAreNotFinite) {
  EXPECT_EQ(pivot(MatrixXd{{1.0}}, VectorXd{{std::nan("")}}).outcome, LcpOutcome::notFinite);
  EXPECT_EQ(pivot(MatrixXd{{HUGE_VAL}}, VectorXd{{-1.0}}).outcome, LcpOutcome::notFinite);
}

TEST(Lemke, IsExactAfterManyPivots) {
  // A chain of 120 contacts, condition 6e3: rounding of the tableau is mended on the way.
  const int n = 120;
  MatrixXd M = 2.0 * MatrixXd::Identity(n, n);
  M.diagonal(1).setConstant(-1.0), M.diagonal(-1).setConstant(-1.0);
  VectorXd q = VectorXd::Zero(n);
  q[n - 1] = -1.0;
  const Pivoted a = pivot(M, q);
  EXPECT_EQ(a.outcome, LcpOutcome::solved);
  // z_k = (k + 1)/(n + 1).
  EXPECT_LE((a.z - VectorXd::LinSpaced(n, 1.0, n) / (n + 1.0)).lpNorm<Eigen::Infinity>(), 1e-12);
}

}  // namespace
}  // namespace dynamy
