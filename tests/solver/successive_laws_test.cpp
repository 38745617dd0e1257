// The book's successive solution of the laws, and the non-diagonal R: rates, limits, agreement.
#include <gtest/gtest.h>

#include <cstdio>
#include <dynamy/solver/automatic.hpp>
#include <dynamy/solver/prox_block_metric.hpp>
#include <dynamy/solver/successive_laws.hpp>

#include "unit/solver/inclusion_fixture.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr unsigned kSuccessiveSeed = 5;

/// One planar contact with G_NN = G_TT = 1, G_NT = 1/2.
struct OneContact {
  explicit OneContact(double mu)
      : law(0.0, 0.0, mu), x(std::vector<MatrixXd>{MatrixXd::Identity(2, 2)}) {
    x.contact(law, fixture::symmetricRoot(MatrixXd{{1.0, 0.5}, {0.5, 1.0}}));
  }
  UnilateralCoulomb law;
  fixture::Inclusion x;
};

TEST(SuccessiveLaws, ContractWithMuTimesTheCouplingOfOneSlidingContact) {
  for (const double mu : {0.2, 0.6, 1.0}) {
    OneContact one(mu);
    const InclusionProblem& p = one.x.pose(VectorXd{{-1.0, 4.0}});
    // Slips forward, Λ_T = −μΛ_N: Λ_N = 1/(1 − μ/2).
    const double N = 1.0 / (1.0 - 0.5 * mu);
    double last = 0.0;
    for (int rounds = 1; rounds <= 6; ++rounds) {
      SuccessiveLaws solver(SuccessiveOptions{1e-15, rounds, 2000});
      VectorXd Lambda = VectorXd::Zero(2);
      solver.solve(p, view(Lambda));
      const double error = std::abs(Lambda[0] - N);
      if (rounds > 1) {
        EXPECT_NEAR(error / last, 0.5 * mu, 1e-9) << mu;  // rounding of 1e-13 numbers
      }
      last = error;
    }
  }
}

TEST(SuccessiveLaws, FailForLargeMuAlthoughTheSolutionIsUnique) {
  // Slips backward: Λ_N = 1/(1 + μ/2). The rounds jump between Λ_N = 1 and 0 for μ/2 > 1.
  for (const double mu : {1.5, 3.0}) {
    OneContact one(mu);
    const InclusionProblem& p = one.x.pose(VectorXd{{-1.0, -9.0}});
    VectorXd Lambda = VectorXd::Zero(2), other = VectorXd::Zero(2);
    const SolveReport report = SuccessiveLaws().solve(p, view(Lambda));
    EXPECT_EQ(report.ok(), mu < 2.0);
    if (mu > 2.0) {
      EXPECT_EQ(report.status, SolveStatus::maxIterations);
    }
    EXPECT_TRUE(Automatic().solve(p, view(other)).ok());
    EXPECT_NEAR(other[0], 1.0 / (1.0 + 0.5 * mu), 1e-9);
  }
}

TEST(SuccessiveLaws, AgreeWithTheOtherSolversForSmallMu) {
  std::mt19937 random(kSuccessiveSeed);
  std::printf("seed %u\n", kSuccessiveSeed);
  const UnilateralCoulomb law(0.0, 0.0, 0.1);
  const Bilateral joint;
  const GivenFriction friction(0.2, 0.2);
  for (int trial = 0; trial < 20; ++trial) {
    const int n = 3;
    fixture::Inclusion x(std::vector<MatrixXd>{fixture::randomMass(random, 12)});
    for (int i = 0; i < n; ++i) x.contact(law, fixture::randomMatrix(random, 3, 12));
    x.contact(joint, fixture::randomMatrix(random, 1, 12));
    x.contact(friction, fixture::randomMatrix(random, 1, 12));
    VectorXd c = fixture::randomMatrix(random, 3 * n + 2, 1);
    for (int i = 0; i < n; ++i) c[3 * i] = -std::abs(c[3 * i]);
    const InclusionProblem& p = x.pose(c);
    VectorXd a = VectorXd::Zero(c.size()), b = a;
    SuccessiveLaws solver(SuccessiveOptions{1e-10, 200, 100000});
    EXPECT_TRUE(solver.solve(p, view(a)).ok()) << trial;
    EXPECT_TRUE(Automatic().solve(p, view(b)).ok()) << trial;
    // 1e-10 of u_ref each; ξ answers an error of e with up to κ(G) e, 1e3 here.
    EXPECT_LE((x.dense() * (a - b)).norm(), 1e-6) << trial;
    EXPECT_LE(solver.rounds(), 40) << trial;
  }
}

/// One spatial contact whose block of G_TT has the eigenvalues 1 and `ratio`.
struct Skewed {
  explicit Skewed(double ratio, double mu)
      : law(0.0, 0.0, mu), x(std::vector<MatrixXd>{MatrixXd::Identity(3, 3)}) {
    MatrixXd turn = MatrixXd::Identity(3, 3);
    turn.bottomRightCorner(2, 2) = Eigen::Rotation2Dd(0.6).toRotationMatrix();
    const Eigen::Vector3d lambda(1.0, 1.0, ratio);
    x.contact(law, fixture::symmetricRoot(turn * lambda.asDiagonal() * turn.transpose()));
  }
  UnilateralCoulomb law;
  fixture::Inclusion x;
};

TEST(ProxBlockMetric, NeedsOneSweepWhereTheDiagonalCreeps) {
  std::printf("| eigenvalues of G_TT | sweeps, diagonal | sweeps, metric |\n");
  for (const double ratio : {1.0, 10.0, 100.0, 1000.0}) {
    Skewed s(ratio, 0.5);
    const InclusionProblem& p = s.x.pose(VectorXd{{-1.0, 2.0, -3.0}});
    VectorXd a = VectorXd::Zero(3), b = a;
    const SolveReport diagonal = ProxGaussSeidel({1e-10, 100000, Relaxation::exact, 1.0})
                                     .solve(p, view(a)),
                      metric = ProxBlockMetric().solve(p, view(b));
    EXPECT_TRUE(diagonal.ok());
    EXPECT_TRUE(metric.ok());
    std::printf("| 1 : %g | %d | %d |\n", ratio, diagonal.iterations, metric.iterations);
    // Normal and tangent do not feel each other here: the second sweep is the test of the first.
    EXPECT_LE(metric.iterations, 2);
    if (ratio >= 100.0) {
      EXPECT_GE(diagonal.iterations, 20);
    }
    EXPECT_LE((s.x.dense() * (a - b)).norm(), 1e-6);  // 1e-10 of 3 m/s, times the condition
  }
}

TEST(ProxBlockMetric, SolvesFrictionOfGivenSizeExactly) {
  const GivenFriction law(1.0, 1.0);
  fixture::Inclusion x(std::vector<MatrixXd>{MatrixXd::Identity(2, 2)});
  const MatrixXd G{{3.0, 1.0}, {1.0, 0.5}};
  x.contact(law, fixture::symmetricRoot(G));
  VectorXd Lambda = VectorXd::Zero(2);
  const SolveReport report = ProxBlockMetric().solve(x.pose(VectorXd{{5.0, -4.0}}), view(Lambda));
  EXPECT_TRUE(report.ok());
  EXPECT_LE(report.iterations, 2);
  // −ξ is a positive multiple of Λ on the circle.
  const VectorXd xi = G * Lambda + VectorXd{{5.0, -4.0}};
  EXPECT_NEAR(Lambda.norm(), 1.0, 1e-12);
  EXPECT_NEAR(Lambda[0] * xi[1] - Lambda[1] * xi[0], 0.0, 1e-9);
  EXPECT_LT(Lambda.dot(xi), 0.0);
}

TEST(ProxBlockMetric, GivesTheVelocitiesOfTheDiagonalOne) {
  std::mt19937 random(kSuccessiveSeed + 1);
  std::printf("seed %u\n", kSuccessiveSeed + 1);
  const UnilateralCoulomb law(0.0, 0.0, 0.3);
  const Unilateral smooth;
  const Bilateral joint;
  int diagonal = 0, metric = 0;
  for (int trial = 0; trial < 30; ++trial) {
    fixture::Inclusion x(std::vector<MatrixXd>{fixture::randomMass(random, 20)});
    for (int i = 0; i < 4; ++i) x.contact(law, fixture::randomMatrix(random, 3, 20));
    x.contact(smooth, fixture::randomMatrix(random, 1, 20));
    x.contact(joint, fixture::randomMatrix(random, 2, 20));
    VectorXd c = fixture::randomMatrix(random, 15, 1);
    for (int i = 0; i < 4; ++i) c[3 * i] = -std::abs(c[3 * i]);
    const InclusionProblem& p = x.pose(c);
    VectorXd a = VectorXd::Zero(15), b = a;
    const SolveReport
        one = ProxGaussSeidel({1e-10, 100000, Relaxation::exact, 1.0}).solve(p, view(a)),
        two = ProxBlockMetric({1e-10, 100000, Relaxation::exact, 1.0}).solve(p, view(b));
    EXPECT_TRUE(one.ok()) << trial;
    EXPECT_TRUE(two.ok()) << trial;
    EXPECT_LE((x.dense() * (a - b)).norm(), 1e-6) << trial;
    diagonal += one.iterations, metric += two.iterations;
  }
  std::printf("30 problems: %d sweeps with the diagonal, %d with the metric\n", diagonal, metric);
}

}  // namespace
}  // namespace dynamy
