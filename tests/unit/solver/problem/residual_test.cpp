// Residuals: zero at solutions, independent of units, honest about rounding.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <dynamy/solver/problem/given_problem.hpp>
#include <iostream>

#include "unit/solver/inclusion_fixture.hpp"
#include "unit/solver/laws.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr unsigned kResidualSeed = 3;
using fixture::kCoulomb;
using fixture::kUnilateral;

Residuals residualsOf(const InclusionProblem& p, const VectorXd& Lambda) {
  std::vector<double> scratch;
  return residuals(p, view(Lambda), scratch);
}

TEST(Residuals, VanishAtTheSolution) {
  // [2 −1; −1 2] Λ = (2, 0): Λ = (4/3, 2/3).
  fixture::Inclusion x(fixture::symmetricRoot(MatrixXd{{2.0, -1.0}, {-1.0, 2.0}}), kUnilateral);
  const Residuals r = residualsOf(x.pose(VectorXd{{-2.0, 0.0}}), VectorXd{{4.0 / 3.0, 2.0 / 3.0}});
  EXPECT_LE(r.largest(), 1e-15);
  EXPECT_LE(r.energy, 1e-30);  // squares of rounding
}

TEST(Residuals, MeasureTheErrorOfOneContactExactly) {
  // G = 2, c = −1: Λ = 1/2. At Λ = 1/4: ξ = −1/2, ρ = 1/2, e = 1/4.
  fixture::Inclusion x(MatrixXd::Constant(1, 1, std::sqrt(2.0)), kUnilateral);
  const Residuals r = residualsOf(x.pose(VectorXd{{-1.0}}), VectorXd{{0.25}});
  EXPECT_NEAR(r.Eu, 0.5, 1e-15);       // (1/4)/ρ / u_ref
  EXPECT_NEAR(r.Ef, 0.5, 1e-15);       // (1/4) / max(1/4, ρ u_ref = 1/2)
  EXPECT_NEAR(r.energy, 0.25, 1e-15);  // (1/16)/ρ / (ρ c²)
  EXPECT_EQ(r.worst, 0);
}

TEST(Residuals, DoNotDependOnUnits) {
  std::mt19937 random(kResidualSeed);
  std::cout << "seed " << kResidualSeed << '\n';
  const MatrixXd Wt = fixture::randomMatrix(random, 6, 8), mass = fixture::randomMass(random, 8);
  const VectorXd c = fixture::randomMatrix(random, 6, 1),
                 Lambda = fixture::randomMatrix(random, 6, 1);
  // Units of mass, and of velocity by length and time: powers of four, so that Cholesky's square
  // roots scale exactly as well. Λ goes with mass · velocity.
  Residuals reference;
  for (const auto& [m, v] :
       {std::pair{1.0, 1.0}, {1024.0, 1.0}, {1.0, 1.0 / 4096.0}, {1.0 / 64.0, 16384.0}}) {
    fixture::Inclusion x({m * mass});
    x.contact(kCoulomb, Wt.topRows(3));
    x.contact(kCoulomb, Wt.bottomRows(3));
    const Residuals r = residualsOf(x.pose(v * c), m * v * Lambda);
    if (m == 1.0 && v == 1.0) reference = r;
    EXPECT_EQ(r.Ef, reference.Ef);
    EXPECT_EQ(r.Eu, reference.Eu);
    EXPECT_EQ(r.energy, reference.energy);
  }
  EXPECT_GT(reference.Eu, 0.01);
}

TEST(Residuals, AcceptZeroInASceneWithoutForces) {
  fixture::Inclusion x(MatrixXd::Identity(2, 2), kUnilateral);
  InclusionProblem& p = x.pose(VectorXd::Zero(2));
  for (const double uRef : {1.0, 1e-300, 0.0}) {
    p.uRef = uRef;
    EXPECT_EQ(residualsOf(p, VectorXd::Zero(2)).largest(), 0.0);
  }
}

TEST(Residuals, SeeALightBodyBesideAHeavyOne) {
  // Unit velocities asked of 1e-6 kg and 1e6 kg; the light contact gets no percussion at all.
  fixture::Inclusion x({MatrixXd::Constant(1, 1, 1e-6), MatrixXd::Constant(1, 1, 1e6)});
  x.contact(kUnilateral, MatrixXd{{1.0, 0.0}});
  x.contact(kUnilateral, MatrixXd{{0.0, 1.0}});
  const Residuals r = residualsOf(x.pose(VectorXd{{-1.0, -1.0}}), VectorXd{{0.0, 1e6}});
  EXPECT_NEAR(r.Eu, 1.0, 1e-15);
  EXPECT_EQ(r.worst, 0);
}

TEST(Residuals, TakeRoundingOfCForASolution) {
  fixture::Inclusion x(MatrixXd::Identity(2, 2), kUnilateral);
  InclusionProblem& p = x.pose(VectorXd{{-1e-17, 2e-17}});
  p.cNoise = {4e-17, 4e-17};
  EXPECT_EQ(residualsOf(p, VectorXd::Zero(2)).largest(), 0.0);
  p.cNoise = {1e-18, 1e-18};
  EXPECT_GT(residualsOf(p, VectorXd::Zero(2)).largest(), 0.1);
}

TEST(Residuals, CountNoContactBelowTheRoundingOfItsOwnSum) {
  // Two contacts press one body with 1e9 from both sides: ξ = ±(Λ₁ − Λ₂) + c is known to 4ε·2e9 =
  // 1.8e-6 only, and c asks for ±1.
  fixture::Inclusion x(MatrixXd{{1.0, 0.0}, {-1.0, 0.0}}, kUnilateral);
  InclusionProblem& p = x.pose(VectorXd{{-1.0, 1.0}});
  EXPECT_EQ(residualsOf(p, VectorXd{{1e9 + 1.0 + 1e-6, 1e9}}).largest(), 0.0);
  EXPECT_GT(residualsOf(p, VectorXd{{1e9 + 1.0 + 1e-5, 1e9}}).largest(), 5e-6);
}

TEST(Residuals, JudgeAContactWhoseDiagonalBlockIsZero) {
  // w = (z₂ − 1, −z₁ + 2): row sums are 1, so ρ = 1. At z = 0 the first one misses by 1, at (2, 1)
  // nothing does.
  std::vector<GivenContact> contacts;
  for (int i = 0; i < 2; ++i) contacts.push_back({std::make_unique<Unilateral>(), 1});
  GivenProblem given(std::move(contacts), MatrixXd{{0.0, 1.0}, {-1.0, 0.0}}.sparseView(),
                     VectorXd{{-1.0, 2.0}});
  const Residuals none = residualsOf(given.problem(), VectorXd::Zero(2));
  EXPECT_EQ(none.worst, 0);
  EXPECT_EQ(none.Eu, 1.0 / given.problem().uRef);
  EXPECT_GT(none.Ef, 0.0);
  EXPECT_GT(none.energy, 0.0);
  EXPECT_EQ(residualsOf(given.problem(), VectorXd{{2.0, 1.0}}).largest(), 0.0);
}

TEST(Residuals, ScaleAZeroDiagonalBlockByItsRow) {
  // The same problem with z and w in other units.
  for (const double unit : {1.0, 1024.0, 1.0 / 4096.0}) {
    std::vector<GivenContact> contacts;
    for (int i = 0; i < 2; ++i) contacts.push_back({std::make_unique<Unilateral>(), 1});
    GivenProblem given(std::move(contacts), MatrixXd{{0.0, unit}, {-unit, 0.0}}.sparseView(),
                       VectorXd{{-1.0, 2.0}});
    EXPECT_EQ(residualsOf(given.problem(), VectorXd{{1.5 / unit, 1.0 / unit}}).Eu, 0.5);
  }
}

TEST(Residuals, TellThatAContactOfFixedBodiesCannotBeHeldApart) {
  // A row of zeros: no percussion moves anything. Leaving is fine, closing is not.
  std::vector<GivenContact> contacts;
  contacts.push_back({std::make_unique<Unilateral>(), 1});
  GivenProblem given(std::move(contacts), MatrixXd{{0.0}}.sparseView(), VectorXd{{-1.0}});
  EXPECT_EQ(residualsOf(given.problem(), VectorXd{{0.0}}).Eu, 1.0);
  given.problem().c[0] = 1.0;
  EXPECT_EQ(residualsOf(given.problem(), VectorXd{{0.0}}).Eu, 0.0);
}

TEST(Residuals, OfAnEmptyProblemAreZero) {
  fixture::Inclusion x(std::vector<MatrixXd>{MatrixXd::Identity(1, 1)});
  EXPECT_EQ(residualsOf(x.pose(VectorXd(0)), VectorXd(0)).largest(), 0.0);
}

}  // namespace
}  // namespace dynamy
