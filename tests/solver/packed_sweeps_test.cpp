// Packed Gauss–Seidel: closed forms, contacts of every kind, and the same bits on every processor.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <dynamy/law/rolling_friction.hpp>
#include <dynamy/solver/local/packed_kernels.hpp>
#include <dynamy/solver/packed_gauss_seidel.hpp>
#include <iostream>

#include "solver/fclib_checker.hpp"
#include "support/contact_problems.hpp"
#include "unit/solver/inclusion_fixture.hpp"
#include "unit/solver/laws.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr unsigned kPackedSeed = 11;
using fixture::kBilateral;
using fixture::kUnilateral;

/// n cubes of side 1 on each other, mass and inertia of a cube, four corners each. ξ = γ^E with the
/// weight of 1 ms; `pull` of it along x.
struct CubeStack {
  CubeStack(int n, double mu, double pull) : law(0.0, 0.0, mu), x(masses(n)), c(12 * n) {
    VectorXd v = VectorXd::Zero(6 * n);
    for (int b = 0; b < n; ++b) v[6 * b + 2] = -kWeight, v[6 * b] = pull * kWeight;
    for (int b = 0; b < n; ++b)
      for (int corner = 0; corner < 4; ++corner) {
        const double X = (corner & 1) ? 0.5 : -0.5, Y = (corner & 2) ? 0.5 : -0.5;
        MatrixXd Wt = MatrixXd::Zero(3, 6 * n);
        Wt.middleCols(6 * b, 6) = contactRows({X, Y, -0.5}, 1.0);
        if (b > 0) Wt.middleCols(6 * (b - 1), 6) = contactRows({X, Y, 0.5}, -1.0);
        x.contact(law, Wt);
        c.segment(12 * b + 3 * corner, 3) = Wt * v;
      }
  }
  static std::vector<MatrixXd> masses(int n) {
    const VectorXd M{{1.0, 1.0, 1.0, 1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0}};
    return std::vector<MatrixXd>(static_cast<std::size_t>(n), MatrixXd(M.asDiagonal()));
  }
  static constexpr double kWeight = 9.81e-3;  ///< of a cube in 1 ms [N s]
  UnilateralCoulomb law;
  fixture::Inclusion x;
  VectorXd c;
};

SolveReport solve(fixture::Inclusion& x, const VectorXd& c, double tolerance, VectorXd& Lambda,
                  double momentum = 0.9, Delassus::Form form = Delassus::Form::automatic) {
  Lambda = VectorXd::Zero(c.size());
  return PackedGaussSeidel({.tolerance = tolerance, .maxIterations = 200000, .momentum = momentum})
      .solve(x.pose(c, 1.0, form), view(Lambda));
}

TEST(PackedGaussSeidel, CarriesAStackByItsWeight) {
  // Normal forces on one level sum up to the weight above, friction to the pull above.
  CubeStack stack(5, 0.6, 0.05);
  VectorXd L;
  ASSERT_TRUE(solve(stack.x, stack.c, 1e-10, L).ok());
  for (int level = 0; level < 5; ++level) {
    double N = 0.0, T = 0.0;
    for (int corner = 0; corner < 4; ++corner)
      N += L[12 * level + 3 * corner], T += L[12 * level + 3 * corner + 1];
    // E_u ≤ 1e-10 of the weight's velocity per contact; the slowest mode of five cubes has a
    // stiffness of about 1/100 of a contact's.
    EXPECT_NEAR(N, (5 - level) * CubeStack::kWeight, 1e-7 * CubeStack::kWeight) << level;
    EXPECT_NEAR(T, -0.05 * (5 - level) * CubeStack::kWeight, 1e-7 * CubeStack::kWeight) << level;
  }
}

TEST(PackedGaussSeidel, LetsACubeSlide) {
  // Pulled by its weight with μ = ½: γ_x^E = (1 − μ) g Δt and no other motion; moments balance by
  // unequal N.
  CubeStack stack(1, 0.5, 1.0);
  VectorXd L;
  ASSERT_TRUE(solve(stack.x, stack.c, 1e-12, L).ok());
  const VectorXd xi = stack.x.dense() * L + stack.c;
  for (int corner = 0; corner < 4; ++corner) {
    EXPECT_NEAR(xi[3 * corner], 0.0, 1e-10 * CubeStack::kWeight);
    EXPECT_NEAR(xi[3 * corner + 1], 0.5 * CubeStack::kWeight, 1e-10 * CubeStack::kWeight);
    EXPECT_NEAR(L[3 * corner + 1], -0.5 * L[3 * corner], 1e-10 * CubeStack::kWeight);
  }
}

/// Rows of Λ, ξ of one contact with Coulomb friction fulfil the law to `small`.
void expectCoulomb(double mu, const VectorXd& L, const VectorXd& xi, double small) {
  const auto k = L.size() - 1;
  EXPECT_GE(L[0], 0.0);
  EXPECT_GE(xi[0], -small);
  EXPECT_NEAR(L[0] * xi[0], 0.0, small);
  if (k == 0) return;
  EXPECT_LE(L.tail(k).norm(), mu * L[0] + small);
  // −ξ_T·Λ_T = μ N |ξ_T|: friction is at its limit and opposes the slip.
  EXPECT_NEAR(-xi.tail(k).dot(L.tail(k)), mu * L[0] * xi.tail(k).norm(), small);
}

TEST(PackedGaussSeidel, SolvesContactsOfEveryKindBesideEachOther) {
  // Blocks of 6, 3, 1 and 9 velocities with full masses; rows on one to three of them: in batches
  // (one to three rows, one or two blocks of at most six) and apart (the large block, three blocks,
  // a joint, rolling, given friction). The laws themselves are the truth.
  std::mt19937 random(kPackedSeed);
  std::cout << "seed " << kPackedSeed << '\n';
  const double mu = 0.2, brake = 0.3;
  const UnilateralCoulomb coulomb(0.0, 0.0, mu);
  const GivenFriction given(brake, brake);
  const UnilateralRolling rolling(mu, 0.1);
  const std::vector<int> sizes = {6, 6, 3, 1, 9, 6};
  std::vector<MatrixXd> masses;
  for (const int n : sizes) masses.push_back(fixture::randomMass(random, n));
  fixture::Inclusion x(masses);
  const auto rows = [&](int dim, std::initializer_list<int> blocks) {
    MatrixXd Wt = MatrixXd::Zero(dim, 31);
    for (const int b : blocks)
      Wt.middleCols(x.mass.u0(b), x.mass.nu(b)) =
          fixture::randomMatrix(random, dim, x.mass.nu(b)) / 3.0;
    return Wt;
  };
  x.contact(coulomb, rows(3, {0, 1})), x.contact(coulomb, rows(3, {1}));
  x.contact(coulomb, rows(2, {2, 3})), x.contact(kUnilateral, rows(1, {0, 2}));
  x.contact(coulomb, rows(3, {4, 5})), x.contact(coulomb, rows(3, {0, 1, 5}));
  x.contact(kBilateral, rows(3, {1, 4})), x.contact(given, rows(2, {2, 5}));
  x.contact(rolling, rows(5, {4, 5}));
  VectorXd c = fixture::randomMatrix(random, 25, 1), L;
  for (const int normal : {0, 3, 6, 8, 9, 12, 20}) c[normal] = -std::abs(c[normal]);
  for (const auto form : {Delassus::Form::assembled, Delassus::Form::matrixFree}) {
    const SolveReport report = solve(x, c, 1e-12, L, 0.9, form);
    ASSERT_TRUE(report.ok()) << solveStatusText(report.status) << report.residuals.largest();
    const VectorXd xi = x.dense() * L + c;
    // E_u ≤ 1e-12 of max|c|, forces of at most some hundred times that.
    const double small = 1e-9 * c.lpNorm<Eigen::Infinity>();
    for (const auto& [first, dim] : {std::pair{0, 3}, {3, 3}, {6, 2}, {8, 1}, {9, 3}, {12, 3}})
      expectCoulomb(mu, L.segment(first, dim), xi.segment(first, dim), small);
    EXPECT_LE(xi.segment(15, 3).norm(), small);
    EXPECT_LE(L.segment(18, 2).norm(), brake + small);
    EXPECT_NEAR(-xi.segment(18, 2).dot(L.segment(18, 2)), brake * xi.segment(18, 2).norm(), small);
    expectCoulomb(mu, L.segment(20, 3), xi.segment(20, 3), small);
  }
}

TEST(PackedGaussSeidel, SolvesProblemsWithoutBodiesByTheBlock) {
  for (const auto& [name, problem] : keptProblems()) {
    if (name.starts_with("stack")) continue;  // not by plain sweeps
    const auto given = inclusionProblem(condensed(problem));
    const FclibRule rule;
    given->problem().rule = &rule;
    VectorXd Lambda = VectorXd::Zero(given->problem().rows());
    const SolveReport report =
        PackedGaussSeidel({.tolerance = 1e-8}).solve(given->problem(), view(Lambda));
    EXPECT_TRUE(report.ok()) << name << ": " << solveStatusText(report.status);
    // Another order of summation than the checker's.
    EXPECT_LE(fclibResidual(problem, Lambda), 1.01e-8) << name;
  }
}

TEST(PackedGaussSeidel, ReportsTheResidualOfTheBestSweepsWhenTheyAreSpent) {
  CubeStack stack(20, 0.6, 0.0);
  InclusionProblem& p = stack.x.pose(stack.c);
  std::vector<double> scratch;
  double before = std::numeric_limits<double>::infinity();
  for (const int most : {10, 100, 1000}) {
    VectorXd L = VectorXd::Zero(240);
    const SolveReport report =
        PackedGaussSeidel({.tolerance = 1e-10, .maxIterations = most}).solve(p, view(L));
    EXPECT_EQ(report.status, SolveStatus::maxIterations);
    EXPECT_EQ(report.iterations, most);
    EXPECT_EQ(report.residuals.largest(), residuals(p, view(std::as_const(L)), scratch).largest());
    EXPECT_LT(report.residuals.largest(), before);
    before = report.residuals.largest();
  }
}

TEST(PackedGaussSeidel, NeedsFewerSweepsWithMomentum) {
  // (4.25): slow modes shrink by 1/(1 − β) = 10 times as much; a third of that is asked.
  CubeStack stack(8, 0.6, 0.3);
  VectorXd L;
  const int plain = solve(stack.x, stack.c, 1e-2, L, 0.0).iterations;
  const int moved = solve(stack.x, stack.c, 1e-2, L, 0.9).iterations;
  EXPECT_LT(3 * moved, plain);
}

TEST(PackedGaussSeidel, GoesBackWhereMomentumDiverges) {
  // With all of the last change the corners of cubes diverge by 1.15 a sweep.
  CubeStack stack(8, 0.6, 0.0);
  VectorXd L;
  const SolveReport report = solve(stack.x, stack.c, 1e-6, L, 1.0);
  EXPECT_TRUE(report.ok()) << report.residuals.largest();
}

TEST(PackedGaussSeidel, StartsFromZeroWhereTheStartIsWorse) {
  CubeStack stack(3, 0.6, 0.0);
  InclusionProblem& p = stack.x.pose(stack.c);
  VectorXd L = VectorXd::Constant(36, 1e3);
  const SolveReport far = PackedGaussSeidel({.tolerance = 1e-2}).solve(p, view(L));
  VectorXd zero = VectorXd::Zero(36);
  const SolveReport cold = PackedGaussSeidel({.tolerance = 1e-2}).solve(p, view(zero));
  EXPECT_TRUE(far.ok());
  EXPECT_EQ(far.iterations, cold.iterations);
  EXPECT_EQ(L, zero);
}

TEST(PackedKernels, PassOverBatchesThatCarryNothing) {
  // The normal row of each contact moves a body of its own; the second batch has c_N > 0: open. What
  // is passed over keeps its bits, and a sweep over all gives it the same: Λ = 0.
  std::vector<PackedBatch> batches(3);
  for (std::size_t at = 0; at < batches.size(); ++at)
    for (int k = 0; k < kLanes; ++k) {
      batches[at].a[0][k] = batches[at].rN[k] = 1.0, batches[at].c[0][k] = at == 1 ? 1.0 : -1.0;
      batches[at].bodyA[k] = 1 + kLanes * static_cast<int>(at) + k;
    }
  for (const PackedKernels& level : packedLevels()) {
    std::vector<PackedBatch> some = batches, all = batches;
    std::vector<PackedVelocity> v(25), w(25);
    level.sweep(some.data(), 3, v.data(), 0.0, false);  // Λ = 0 everywhere: nothing is swept
    EXPECT_EQ(std::memcmp(some.data(), batches.data(), 3 * sizeof(PackedBatch)), 0);
    for (const bool every : {true, false, false}) {
      level.sweep(some.data(), 3, v.data(), 0.0, every);
      level.sweep(all.data(), 3, w.data(), 0.0, true);
    }
    EXPECT_EQ(std::memcmp(some.data(), all.data(), 3 * sizeof(PackedBatch)), 0);
    EXPECT_EQ(std::memcmp(v.data(), w.data(), 25 * sizeof(PackedVelocity)), 0);
    EXPECT_EQ(some[0].Lambda[0][0], 1.0);
  }
}

TEST(PackedKernels, GiveTheSameBitsOnEveryLevel) {
  // Three sweeps over random batches, whose bodies overlap from batch to batch, and the measures.
  std::mt19937 random(kPackedSeed);
  std::cout << "seed " << kPackedSeed << ", " << packedLevels().size() << " levels\n";
  std::normal_distribution<double> normal;
  const auto fill = [&](Lanes& lanes) {
    for (double& x : lanes) x = normal(random);
  };
  std::vector<PackedBatch> batches(5);
  for (std::size_t at = 0; at < batches.size(); ++at) {
    PackedBatch& b = batches[at];
    for (Lanes& row : b.a) fill(row);
    for (Lanes& row : b.b) fill(row);
    for (Lanes& row : b.c) fill(row);
    fill(b.dT), fill(b.dS);
    for (int k = 0; k < kLanes; ++k) {
      b.rN[k] = b.rT[k] = 0.05, b.rho[k] = 0.04, b.mu[k] = 0.1 * k;
      b.bodyA[k] = 1 + k, b.bodyB[k] = k < 2 ? 0 : 9 + (k + static_cast<int>(at)) % 8;
    }
    for (int k = 0; k < 2; ++k)  // no second body
      for (Lanes& row : b.b) row[k] = 0.0;
  }
  std::vector<std::vector<double>> found;
  for (const PackedKernels& level : packedLevels()) {
    std::vector<PackedBatch> mine = batches;
    std::vector<PackedVelocity> v(17);
    std::vector<double> numbers;
    for (const double beta : {0.0, 0.25, 0.4})
      numbers.push_back(level.sweep(mine.data(), 5, v.data(), beta, true));
    level.impulses(mine.data(), 5, v.data());
    PackedMeasure measure;
    level.measure(mine.data(), 5, v.data(), measure);
    numbers.insert(numbers.end(), {measure.velocity2, measure.force2, measure.Lambda2});
    for (const PackedVelocity& body : v) numbers.insert(numbers.end(), body.v, body.v + kLanes);
    for (const PackedBatch& b : mine)
      for (const Lanes& row : b.Lambda) numbers.insert(numbers.end(), row, row + kLanes);
    found.push_back(numbers);
  }
  for (const std::vector<double>& other : found) {
    ASSERT_EQ(other.size(), found[0].size());
    EXPECT_EQ(std::memcmp(other.data(), found[0].data(), other.size() * sizeof(double)), 0);
  }
  EXPECT_TRUE(std::isfinite(found[0][0]));
}

}  // namespace
}  // namespace dynamy
