// Rules for r: the book's (4.59)–(4.60), exact steps, row sums, spectral.
#include <gtest/gtest.h>

#include <dynamy/solver/prox/relaxation.hpp>

#include "unit/solver/inclusion_fixture.hpp"
#include "unit/solver/laws.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

using fixture::kCoulomb;
using fixture::kUnilateral;

std::vector<double> rule(const MatrixXd& G, Relaxation which, double factor = 1.0) {
  fixture::Inclusion x(fixture::symmetricRoot(G), kUnilateral);
  std::vector<double> r;
  relaxation(x.pose(VectorXd::Ones(G.rows())), which, factor, r);
  return r;
}

// The root and its square: a few ε of numbers of size 1 … 4.
constexpr double kRelaxed = 1e-14;

TEST(Relaxation, TakesTheDiagonalOfADominantMatrix) {
  const MatrixXd G{{4.0, 1.0, 1.0}, {1.0, 2.5, -1.0}, {1.0, -1.0, 2.0}};
  const auto r = rule(G, Relaxation::diagonalDominance);
  EXPECT_NEAR(r[0], 1.0 / 4.0, kRelaxed);
  EXPECT_NEAR(r[1], 1.0 / 2.5, kRelaxed);
  EXPECT_NEAR(r[2], 1.0 / 2.0, 2e-14);
}

TEST(Relaxation, TakesRowSumsOfAllRowsIfOneIsNotDominant) {
  const MatrixXd G{{4.0, 1.0, 1.0}, {1.0, 2.0, -1.2}, {1.0, -1.2, 2.0}};
  const auto r = rule(G, Relaxation::diagonalDominance);
  EXPECT_NEAR(r[0], 1.0 / 6.0, kRelaxed);
  EXPECT_NEAR(r[1], 1.0 / 4.2, kRelaxed);
  EXPECT_NEAR(r[2], 1.0 / 4.2, kRelaxed);
}

TEST(Relaxation, TakesRowSumsAlwaysIfAskedTo) {
  const auto r = rule(MatrixXd{{2.0, -1.0}, {-1.0, 3.0}}, Relaxation::rowSums);
  EXPECT_NEAR(r[0], 1.0 / 3.0, kRelaxed);
  EXPECT_NEAR(r[1], 1.0 / 4.0, kRelaxed);
}

TEST(Relaxation, FindsTheSpectralRadius) {
  // λ = 1, 3; the power iteration stops at relative changes of 1e-6 (factor 1/9: error 1.2e-7).
  for (const double r : rule(MatrixXd{{2.0, 1.0}, {1.0, 2.0}}, Relaxation::spectral))
    EXPECT_NEAR(r, 1.0 / 3.0, 1e-6);
}

TEST(Relaxation, MultipliesByTheFactor) {
  EXPECT_NEAR(rule(MatrixXd{{2.0}}, Relaxation::exact, 1.5)[0], 0.75, kRelaxed);
}

TEST(Relaxation, GivesTheRowsOfADiscOneStep) {
  // One contact with G = [5 1 1; 1 2 0.5; 1 0.5 3]: λ_max of the lower block is (5 + √2)/2.
  const MatrixXd G{{5.0, 1.0, 1.0}, {1.0, 2.0, 0.5}, {1.0, 0.5, 3.0}};
  fixture::Inclusion x(std::vector<MatrixXd>{MatrixXd::Identity(3, 3)});
  x.contact(kCoulomb, fixture::symmetricRoot(G));
  InclusionProblem& p = x.pose(VectorXd::Ones(3));
  std::vector<double> r;
  relaxation(p, Relaxation::exact, 1.0, r);
  EXPECT_NEAR(r[0], 1.0 / 5.0, kRelaxed);
  EXPECT_EQ(r[1], r[2]);
  EXPECT_NEAR(r[1], 2.0 / (5.0 + std::sqrt(2.0)), kRelaxed);
  relaxation(p, Relaxation::rowSums, 1.0, r);
  EXPECT_EQ(r[1], r[2]);
  EXPECT_NEAR(r[1], 1.0 / 4.5, kRelaxed);  // the smaller of 1/3.5 and 1/4.5
}

TEST(Relaxation, GivesZeroToAContactThatNothingCanMove) {
  fixture::Inclusion x(std::vector<MatrixXd>{MatrixXd::Identity(1, 1)});
  x.contact(kUnilateral, MatrixXd::Zero(1, 1));
  std::vector<double> r;
  for (const auto which : {Relaxation::exact, Relaxation::rowSums, Relaxation::diagonalDominance,
                           Relaxation::spectral}) {
    relaxation(x.pose(VectorXd::Ones(1)), which, 1.0, r);
    EXPECT_EQ(r[0], 0.0);
  }
}

}  // namespace
}  // namespace dynamy
