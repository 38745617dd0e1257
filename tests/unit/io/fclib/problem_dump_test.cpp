// Copies of inclusion problems in FCLIB's layout: the same solution after joints are eliminated and
// rows are added, and refusals.
#include <gtest/gtest.h>

#include <dynamy/io/fclib/problem_dump.hpp>
#include <dynamy/law/rolling_friction.hpp>
#include <dynamy/solver/automatic.hpp>
#include <unit/solver/inclusion_fixture.hpp>

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd solved(const InclusionProblem& p) {
  Automatic solver({.tolerance = 1e-13});
  VectorXd Lambda = VectorXd::Zero(p.rows());
  const SolveReport report = solver.solve(p, view(Lambda));
  EXPECT_TRUE(report.ok() || report.residuals.largest() < 1e-11);
  return Lambda;
}

/// Contacts of `laws` on a random body of 12 freedoms, all closing.
struct DumpScene {
  explicit DumpScene(const std::vector<const SetValuedForceLaw*>& laws) : random(3) {
    inclusion = std::make_unique<fixture::Inclusion>(
        std::vector<MatrixXd>{fixture::randomMass(random, 16)});
    int rows = 0;
    for (const SetValuedForceLaw* law : laws) {
      const int dim = law->dim(3);
      inclusion->contact(*law, fixture::randomMatrix(random, dim, 16));
      rows += dim;
    }
    VectorXd c = fixture::randomMatrix(random, rows, 1);
    InclusionProblem& p = inclusion->pose(c);
    for (int i = 0; i < p.size(); ++i)
      if (p.law(i).unilateral()) c[p.row0(i)] = -1.0;
    inclusion->pose(c);
  }
  std::mt19937 random;
  std::unique_ptr<fixture::Inclusion> inclusion;
};

/// Largest difference of Λ between the problem and its copy, relative.
double difference(const InclusionProblem& p, const FclibCopy& copy, const VectorXd& Lambda) {
  const VectorXd again = solved(inclusionProblem(copy.problem)->problem());
  double largest = 0.0;
  for (std::size_t k = 0; k < copy.contact.size(); ++k) {
    const int i = copy.contact[k], dim = p.dim(i);
    const auto first = static_cast<Eigen::Index>(k) * copy.problem.dim;
    largest =
        std::max(largest, (again.segment(first, dim) - Lambda.segment(p.row0(i), dim)).norm());
    largest =
        std::max(largest, again.segment(first + dim, copy.problem.dim - dim).norm());  // added rows
  }
  return largest / Lambda.norm();
}

TEST(ProblemDump, EliminatesJointsAndAddsRowsWithoutChangingTheForces) {
  const UnilateralCoulomb friction(0.0, 0.0, 0.4);
  const Unilateral smooth;
  const Bilateral joint;
  DumpScene scene({&friction, &joint, &smooth, &friction});
  const InclusionProblem& p = scene.inclusion->problem;
  const VectorXd Lambda = solved(p);
  const FclibCopy copy = fclibCopy(p, view(Lambda));
  EXPECT_EQ(copy.refused, "");
  EXPECT_EQ(copy.problem.dim, 3);
  EXPECT_EQ(copy.contact, (std::vector<int>{0, 2, 3}));
  EXPECT_EQ(copy.problem.mathInfo, "3 joint rows eliminated");
  // 1e-13 in the residual; the condition of G is below 1e4.
  EXPECT_LT(difference(p, copy, Lambda), 1e-9);
}

TEST(ProblemDump, KeepsRollingFriction) {
  const UnilateralRolling rolling(0.3, 0.05);
  const UnilateralCoulomb friction(0.0, 0.0, 0.4);
  DumpScene scene({&rolling, &friction});
  const InclusionProblem& p = scene.inclusion->problem;
  const VectorXd Lambda = solved(p);
  const FclibCopy copy = fclibCopy(p, view(Lambda));
  EXPECT_EQ(copy.problem.dim, 5);
  EXPECT_EQ(copy.problem.mu, VectorXd(Eigen::Vector2d(0.3, 0.4)));
  EXPECT_EQ(copy.problem.muRolling, VectorXd(Eigen::Vector2d(0.05, 0.0)));
  EXPECT_LT(difference(p, copy, Lambda), 1e-9);
}

TEST(ProblemDump, WritesContactsWithoutFrictionAsAComplementarityProblem) {
  const Unilateral smooth;
  DumpScene scene({&smooth, &smooth, &smooth});
  const InclusionProblem& p = scene.inclusion->problem;
  const VectorXd Lambda = solved(p);
  const FclibCopy copy = fclibCopy(p, view(Lambda));
  EXPECT_EQ(copy.problem.dim, 1);
  EXPECT_LT(difference(p, copy, Lambda), 1e-9);
}

TEST(ProblemDump, RefusesWhatTheLayoutCannotHold) {
  const GivenFriction given(1.0, 1.0);
  const UnilateralCoulomb friction(0.0, 0.0, 0.4);
  const Bilateral joint;
  DumpScene mixed({&friction, &given}), joints({&joint, &joint});
  const VectorXd zero = VectorXd::Zero(6);
  const FclibCopy a = fclibCopy(mixed.inclusion->problem, view(zero)),
                  b = fclibCopy(joints.inclusion->problem, view(zero));
  EXPECT_EQ(a.refusedAt, 1);
  EXPECT_NE(a.refused.find("has no law"), std::string::npos) << a.refused;
  EXPECT_EQ(b.refused, "it has joints only");
}

}  // namespace
}  // namespace dynamy
