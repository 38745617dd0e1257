// Forces that are not unique: which ones come out, and the smallest on request. Truth: −G⁺c where
// no set is active, the closed form of a table, quadratic optimality where a set is.
#include <gtest/gtest.h>

#include <Eigen/QR>
#include <dynamy/solver/automatic.hpp>
#include <iostream>

#include "planar_scene.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Solved {
  SolveReport report;
  VectorXd Lambda;
};

Solved solve(const InclusionProblem& p, bool minimal) {
  AutomaticOptions options;
  options.tolerance = 1e-12, options.minimalNorm = minimal;
  Automatic solver(options);
  Solved s;
  s.Lambda.setZero(p.rows());
  s.report = solver.solve(p, view(s.Lambda));
  EXPECT_TRUE(s.report.ok()) << solveStatusText(s.report.status);
  return s;
}

VectorXd pseudoInverseSolution(fixture::Inclusion& scene, const VectorXd& c) {
  return -scene.dense().completeOrthogonalDecomposition().solve(c);
}

/// A table with its centre of mass at (x, y) from the middle of the legs at (±0.5, ±0.4), height
/// 0.7; feet turned so that sweeps meet them in an uneven order.
std::unique_ptr<fixture::Inclusion> table(const SetValuedForceLaw& law, double x, double y) {
  auto scene = std::make_unique<fixture::Inclusion>(
      std::vector<MatrixXd>{Eigen::Vector<double, 6>(8, 8, 8, 0.6, 0.9, 1.1).asDiagonal()});
  for (int leg = 0; leg < 4; ++leg) {
    const double a = ((leg & 1) ? 0.5 : -0.5) - x, b = ((leg & 2) ? 0.4 : -0.4) - y, z = -0.7;
    MatrixXd Wt(3, 6);
    Wt << 0, 0, 1, b, -a, 0, 1, 0, 0, 0, z, -b, 0, 1, 0, -z, 0, a;
    scene->contact(law, Wt);
  }
  return scene;
}

VectorXd gravity(int contacts) {
  VectorXd c = VectorXd::Zero(3 * contacts);
  for (int i = 0; i < contacts; ++i) c[3 * i] = -9.81e-3;
  return c;
}

TEST(MinimalNorm, SharesTheLoadOfATableEvenly) {
  const UnilateralCoulomb law(0.0, 0.0, 0.5);
  auto scene = table(law, 0.0, 0.0);
  const Solved s = solve(scene->pose(gravity(4)), true);
  for (int leg = 0; leg < 4; ++leg) {
    // a of 1e-8 leaves 1e-8 of the force; 100 times that for the shape of the problem.
    EXPECT_NEAR(s.Lambda[3 * leg], 2.0 * 9.81e-3, 1e-6 * 2.0 * 9.81e-3);
    EXPECT_LT(s.Lambda.segment(3 * leg + 1, 2).norm(), 1e-6 * 2.0 * 9.81e-3);
  }
}

TEST(MinimalNorm, EqualsThePseudoInverseWhereNoSetIsActive) {
  const UnilateralCoulomb law(0.0, 0.0, 0.5);
  for (const auto& [x, y] : {std::pair{0.1, -0.05}, std::pair{0.0, 0.15}}) {
    auto scene = table(law, x, y);
    const VectorXd c = gravity(4);
    InclusionProblem& p = scene->pose(c);
    const VectorXd truth = pseudoInverseSolution(*scene, c);
    const Solved plain = solve(p, false), smallest = solve(p, true);
    EXPECT_LT((smallest.Lambda - truth).norm(), 1e-6 * truth.norm());
    RecordProperty("plain", std::to_string((plain.Lambda - truth).norm() / truth.norm()));
    std::cout << "table: distance from the smallest forces " << std::scientific
              << (plain.Lambda - truth).norm() / truth.norm() << " plain, "
              << (smallest.Lambda - truth).norm() / truth.norm() << " minimal; iterations "
              << plain.report.iterations << ", " << smallest.report.iterations << '\n';
    // Neither changes the velocities: residuals of both are at most 1e-12 u_ref.
    VectorXd change = plain.Lambda - smallest.Lambda, xi(12);
    p.G->apply(change.data(), xi.data());
    EXPECT_LT(xi.lpNorm<Eigen::Infinity>(), 1e-10 * p.uRef);
  }
}

TEST(MinimalNorm, KeepsInsideOfTheSets) {
  // Six collinear feet, a pull that would lift some of −G⁺c: smallest forces with Λ ≥ 0.
  // Optimality: Λ = max(0, Wᵀ y) for some y, so that on the feet that carry Λ is linear along the
  // beam.
  const Unilateral law;
  std::vector<fixture::PlanarBody> beam{{2.0, 0.7, {0.0, 0.0}}};
  fixture::PlanarScene scene(beam);
  for (int foot = 0; foot < 6; ++foot)
    scene.contact(law, 0, -1, {0.4 * foot - 1.0, -0.1}, Eigen::Vector2d::UnitY());
  const InclusionProblem& p = scene.move(Eigen::Vector3d(0.0, -1.0, -1.9));
  const VectorXd Lambda = solve(p, true).Lambda;
  ASSERT_EQ(p.rows(), 6);
  std::vector<int> carrying;
  for (int foot = 0; foot < 6; ++foot)
    if (Lambda[foot] > 1e-9) carrying.push_back(foot);
  ASSERT_GE(carrying.size(), 2U);
  EXPECT_LT(carrying.size(), 6U) << "the pull was meant to lift feet";
  for (std::size_t k = 2; k < carrying.size(); ++k) {
    const double step = Lambda[carrying[1]] - Lambda[carrying[0]];
    EXPECT_NEAR(Lambda[carrying[k]] - Lambda[carrying[k - 1]], step, 1e-5 * Lambda.norm());
  }
}

TEST(MinimalNorm, GivesTheLeastForcesOfRedundantJoints) {
  std::mt19937 random(7);
  const Bilateral law;
  fixture::Inclusion scene({fixture::randomMass(random, 6)});
  const MatrixXd S = fixture::randomMatrix(random, 10, 4) * fixture::randomMatrix(random, 4, 6);
  for (int i = 0; i < 5; ++i) scene.contact(law, S.middleRows(2 * i, 2));
  const VectorXd c = S * fixture::randomMatrix(random, 6, 1);
  InclusionProblem& p = scene.pose(c);
  const VectorXd truth = pseudoInverseSolution(scene, c);
  // λ_min/λ of the range is about 1e-3 here: O(a) is 1e-5.
  EXPECT_LT((solve(p, true).Lambda - truth).norm(), 1e-4 * truth.norm());
}

TEST(MinimalNorm, ChangesNothingWhereForcesAreUnique) {
  std::mt19937 random(8);
  const UnilateralCoulomb law(0.0, 0.0, 0.3);
  fixture::Inclusion scene({fixture::randomMass(random, 12)});
  for (int i = 0; i < 3; ++i) scene.contact(law, fixture::randomMatrix(random, 3, 12));
  VectorXd c = fixture::randomMatrix(random, 9, 1);
  for (int i = 0; i < 3; ++i) c[3 * i] = -1.0;
  const InclusionProblem& p = scene.pose(c);
  const VectorXd a = solve(p, false).Lambda, b = solve(p, true).Lambda;
  EXPECT_LT((a - b).norm(), 1e-9 * a.norm());
}

}  // namespace
}  // namespace dynamy
