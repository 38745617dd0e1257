// Lemke as an inclusion solver: which laws become complementarity exactly, and honesty about discs.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cstdio>
#include <dynamy/solver/automatic.hpp>
#include <dynamy/solver/problem/given_problem.hpp>
#include <numbers>

#include "inclusion_fixture.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// An interval [a, b] of impulses that does not hold 0: a given force with play.
class ForceLimits final : public SetValuedForceLaw {
 public:
  ForceLimits(double a, double b) : a_(a), b_(b) {}
  int dim(int) const override { return 1; }
  bool unilateral() const override { return false; }
  RowKind rowKind(int) const override { return RowKind::joint; }
  void prox(const LawInput&, const double* r, const double* xi, double* Lambda) const override {
    Lambda[0] = std::min(std::max(Lambda[0] - r[0] * xi[0], a_), b_);
  }
  Status status(const LawInput&, const double*) const override { return Status::locked; }

 private:
  double a_, b_;
};

const LemkeOptions kAlone{.polish = false};

struct Answer {
  SolveReport report;
  VectorXd Lambda;
};
Answer solveByLemke(const InclusionProblem& p, const LemkeOptions& options = kAlone) {
  Answer a{{}, VectorXd::Zero(p.rows())};
  a.report = LemkeSolver(options).solve(p, view(a.Lambda));
  return a;
}

TEST(LemkeSolver, SolvesContactsWithoutFriction) {
  const Unilateral law;
  fixture::Inclusion x(fixture::symmetricRoot(MatrixXd{{2.0, -1.0}, {-1.0, 2.0}}), law);
  const Answer a = solveByLemke(x.pose(VectorXd{{-2.0, 0.0}}));
  EXPECT_TRUE(a.report.ok());
  EXPECT_EQ(a.report.method, "Lemke");
  EXPECT_LE((a.Lambda - VectorXd{{4.0 / 3.0, 2.0 / 3.0}}).norm(), 1e-14);
}

TEST(LemkeSolver, SolvesPlanarFrictionInAllStates) {
  const UnilateralCoulomb law(0.0, 0.0, 0.5);
  fixture::Inclusion x(std::vector<MatrixXd>{MatrixXd::Identity(2, 2)});
  x.contact(law, MatrixXd::Identity(2, 2));
  const auto Lambda = [&](double cN, double cT) {
    const Answer a = solveByLemke(x.pose(VectorXd{{cN, cT}}));
    EXPECT_TRUE(a.report.ok());
    return a.Lambda;
  };
  EXPECT_LE((Lambda(1.0, 3.0)).norm(), 0.0);
  EXPECT_LE((Lambda(-1.0, 0.3) - VectorXd{{1.0, -0.3}}).norm(), 1e-15);
  EXPECT_LE((Lambda(-1.0, 2.0) - VectorXd{{1.0, -0.5}}).norm(), 1e-15);
  EXPECT_LE((Lambda(-1.0, -2.0) - VectorXd{{1.0, 0.5}}).norm(), 1e-15);
}

TEST(LemkeSolver, EliminatesJointsAndRedundantOnes) {
  // Two points of mass 1 tied together, twice; the first is pushed into the floor with 2 m/s: the
  // floor carries both, the ties transmit half, in any share.
  const Unilateral floor;
  const Bilateral tie;
  fixture::Inclusion x({MatrixXd::Identity(1, 1), MatrixXd::Identity(1, 1)});
  x.contact(floor, MatrixXd{{1.0, 0.0}});
  x.contact(tie, MatrixXd{{1.0, -1.0}});
  x.contact(tie, MatrixXd{{1.0, -1.0}});
  const Answer a = solveByLemke(x.pose(VectorXd{{-2.0, 0.0, 0.0}}));
  EXPECT_TRUE(a.report.ok());
  EXPECT_NEAR(a.Lambda[0], 4.0, 1e-13);
  EXPECT_NEAR(a.Lambda[1] + a.Lambda[2], -2.0, 1e-13);
}

TEST(LemkeSolver, KeepsForceLimits) {
  // ξ = Λ + c, Λ in [1, 3]: −c clamped.
  const ForceLimits law(1.0, 3.0);
  fixture::Inclusion x(MatrixXd::Identity(1, 1), law);
  for (const auto& [c, expected] : {std::pair{-2.0, 2.0}, {-5.0, 3.0}, {4.0, 1.0}}) {
    const Answer a = solveByLemke(x.pose(VectorXd{{c}}));
    EXPECT_TRUE(a.report.ok()) << c;
    EXPECT_NEAR(a.Lambda[0], expected, 1e-14);
  }
}

TEST(LemkeSolver, KeepsForceLimitsOfOneSide) {
  const ForceLimits below(-HUGE_VAL, 3.0), above(2.0, HUGE_VAL), given(2.0, 2.0);
  fixture::Inclusion x(std::vector<MatrixXd>{MatrixXd::Identity(3, 3)});
  x.contact(below, MatrixXd{{1.0, 0.0, 0.0}});
  x.contact(above, MatrixXd{{0.0, 1.0, 0.0}});
  x.contact(given, MatrixXd{{0.0, 0.0, 1.0}});
  const Answer a = solveByLemke(x.pose(VectorXd{{-5.0, -1.0, 9.0}}));
  EXPECT_TRUE(a.report.ok());
  EXPECT_LE((a.Lambda - VectorXd{{3.0, 2.0, 2.0}}).norm(), 1e-14);
}

TEST(LemkeSolver, SolvesGivenFrictionOfOneRow) {
  const GivenFriction law(2.0, 2.0);
  fixture::Inclusion x(MatrixXd::Identity(1, 1), law);
  for (const auto& [c, expected] : {std::pair{-0.1, 0.1}, {-5.0, 0.2}, {5.0, -0.2}}) {
    const Answer a = solveByLemke(x.pose(VectorXd{{c}}, 0.1));  // a Δt = 0.2
    EXPECT_TRUE(a.report.ok()) << c;
    EXPECT_NEAR(a.Lambda[0], expected, 1e-15);
  }
}

TEST(LemkeSolver, SaysThatAPolygonIsNoDisc) {
  const UnilateralCoulomb law(0.0, 0.0, 0.5);
  fixture::Inclusion x(std::vector<MatrixXd>{MatrixXd::Identity(3, 3)});
  x.contact(law, MatrixXd::Identity(3, 3));
  // 15° from a vertex of the octagon: its force points to the vertex.
  const double angle = std::numbers::pi / 12.0;
  const InclusionProblem& p =
      x.pose(VectorXd{{-1.0, 2.0 * std::cos(angle), 2.0 * std::sin(angle)}});
  const Answer alone = solveByLemke(p);
  EXPECT_EQ(alone.report.status, SolveStatus::stalled);
  EXPECT_EQ(alone.report.method, "Lemke, 8 facets");
  EXPECT_GT(alone.report.residuals.Eu, 0.01);
  EXPECT_LE((alone.Lambda - VectorXd{{1.0, -0.5, 0.0}}).norm(), 1e-14);
  const Answer polished = solveByLemke(p, {});
  EXPECT_TRUE(polished.report.ok());
  // 1e-10 of u_ref, G = I.
  EXPECT_LE(
      (polished.Lambda - VectorXd{{1.0, -0.5 * std::cos(angle), -0.5 * std::sin(angle)}}).norm(),
      1e-9);
}

TEST(LemkeSolver, SolvesTheDiscWhereItSticksOrHitsAVertex) {
  const UnilateralCoulomb law(0.0, 0.0, 0.5);
  fixture::Inclusion x(std::vector<MatrixXd>{MatrixXd::Identity(3, 3)});
  x.contact(law, MatrixXd::Identity(3, 3));
  EXPECT_TRUE(solveByLemke(x.pose(VectorXd{{-1.0, 0.1, 0.2}})).report.ok());
  EXPECT_TRUE(solveByLemke(x.pose(VectorXd{{-1.0, 0.0, 2.0}})).report.ok());
}

TEST(LemkeSolver, TurnsAPuckTowardsTheMiddleOfAnEdge) {
  // A puck of 1 kg, μ = 0.3, that starts at 30 % of the way from a vertex to the middle of an edge.
  const UnilateralCoulomb law(0.0, 0.0, 0.3);
  for (const int facets : {4, 8, 16}) {
    fixture::Inclusion x(std::vector<MatrixXd>{MatrixXd::Identity(3, 3)});
    x.contact(law, MatrixXd::Identity(3, 3));
    const double middle = std::numbers::pi / facets;
    Eigen::Vector2d u(std::cos(0.3 * middle), std::sin(0.3 * middle));
    LemkeSolver solver(LemkeOptions{.facets = facets, .polish = false});
    while (u.norm() > 0.1) {
      VectorXd Lambda = VectorXd::Zero(3);
      solver.solve(x.pose(VectorXd{{-0.001, u[0], u[1]}}), view(Lambda));
      ASSERT_EQ(solver.outcome(), LcpOutcome::solved);
      // Least bound: in the middle of an edge.
      EXPECT_GE(Lambda.tail(2).norm(), 0.3 * Lambda[0] * std::cos(middle) * (1.0 - 1e-9));
      u += Lambda.tail(2);
    }
    const double heading = std::atan2(u[1], u[0]);
    std::printf("%d facets: the puck turns by %.1f degrees\n", facets,
                (heading - 0.3 * middle) * 180.0 / std::numbers::pi);
    EXPECT_NEAR(heading, middle, 4e-3);  // it chatters by μ g Δt = 3e-4 of 0.1 m/s
  }
}

TEST(LemkeSolver, ProvesThatAProblemHasNoSolution) {
  std::vector<GivenContact> contacts;
  for (int i = 0; i < 2; ++i) contacts.push_back({std::make_unique<Unilateral>(), 1});
  GivenProblem given(std::move(contacts), MatrixXd{{1.0, -1.0}, {-1.0, 1.0}}.sparseView(),
                     VectorXd{{-1.0, -1.0}});
  const Answer a = solveByLemke(given.problem(), {});
  EXPECT_EQ(a.report.status, SolveStatus::stalled);
  EXPECT_EQ(a.report.method, "Lemke: there is no solution");
}

TEST(LemkeSolver, GivesTheSameForBlockRowsAndDenseG) {
  // 30 planar contacts in a row, 60 rows dense; 40: block rows.
  for (const int n : {30, 40}) {
    std::vector<GivenContact> contacts;
    MatrixXd G = 2.0 * MatrixXd::Identity(2 * n, 2 * n);
    G.diagonal(2).setConstant(-0.9), G.diagonal(-2).setConstant(-0.9);
    VectorXd c = VectorXd::Constant(2 * n, -1.0);
    for (int i = 0; i < n; ++i)
      contacts.push_back({std::make_unique<UnilateralCoulomb>(0.0, 0.0, 0.3), 2});
    GivenProblem given(std::move(contacts), G.sparseView(), c);
    EXPECT_EQ(given.problem().G->dense() != nullptr, n == 30);
    const Answer a = solveByLemke(given.problem());
    EXPECT_TRUE(a.report.ok()) << n;
  }
}

TEST(Automatic, AsksLemkeForZeroDiagonalBlocks) {
  // w₁ = z₂ − 1, w₂ = 1 − z₁ + z₂: sweeps cannot move z₁.
  std::vector<GivenContact> contacts;
  for (int i = 0; i < 2; ++i) contacts.push_back({std::make_unique<Unilateral>(), 1});
  GivenProblem given(std::move(contacts), MatrixXd{{0.0, 1.0}, {-1.0, 1.0}}.sparseView(),
                     VectorXd{{-1.0, 1.0}});
  VectorXd Lambda = VectorXd::Zero(2);
  const SolveReport report = Automatic().solve(given.problem(), view(Lambda));
  EXPECT_TRUE(report.ok());
  EXPECT_EQ(report.method, "Lemke");
  EXPECT_LE((Lambda - VectorXd{{2.0, 1.0}}).norm(), 1e-15);
}

}  // namespace
}  // namespace dynamy
