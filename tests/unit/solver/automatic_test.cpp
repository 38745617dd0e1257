// The choice of a solver: what it accepts, what it says, and that large problems agree with small
// forms.
#include <gtest/gtest.h>

#include <dynamy/solver/automatic.hpp>
#include <dynamy/solver/problem/given_problem.hpp>

#include "inclusion_fixture.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// n spatial contacts with G = SSᵀ of `rank`, once from bodies and once given.
class BothForms {
 public:
  BothForms(int n, int rank, unsigned seed) : law_(0.0, 0.0, 0.4) {
    std::mt19937 random(seed);
    const MatrixXd S = fixture::randomMatrix(random, 3 * n, rank) / std::sqrt(rank);
    bodies_ =
        std::make_unique<fixture::Inclusion>(std::vector<MatrixXd>{MatrixXd::Identity(rank, rank)});
    for (int i = 0; i < n; ++i) bodies_->contact(law_, S.middleRows(3 * i, 3));
    c = S * fixture::randomMatrix(random, rank, 1);
    for (int i = 0; i < n; ++i) c[3 * i] = -std::abs(c[3 * i]);
    std::vector<GivenContact> contacts;
    for (int i = 0; i < n; ++i)
      contacts.push_back({std::make_unique<UnilateralCoulomb>(0.0, 0.0, 0.4), 3});
    given = std::make_unique<GivenProblem>(std::move(contacts),
                                           MatrixXd(S * S.transpose()).sparseView(), c);
  }
  InclusionProblem& bodies(Delassus::Form form = Delassus::Form::automatic) {
    return bodies_->pose(c, 1.0, form);
  }
  VectorXd c;
  std::unique_ptr<GivenProblem> given;

 private:
  UnilateralCoulomb law_;
  std::unique_ptr<fixture::Inclusion> bodies_;
};

TEST(Automatic, BoundsTheWorkOnManyContactsAlone) {
  const Automatic bounded({.bounded = true}), exact({.bounded = false});
  EXPECT_FALSE(bounded.boundsWork(199));
  EXPECT_TRUE(bounded.boundsWork(200));
  EXPECT_FALSE(exact.boundsWork(100000));
}

TEST(GivenProblem, AnswersAsTheSameProblemWithBodiesDoes) {
  for (const int n : {5, 40}) {  // dense and block rows
    BothForms both(n, 30, 11);
    InclusionProblem& bodies = both.bodies();
    Delassus& given = *both.given->problem().G;
    const int rows = 3 * n;
    EXPECT_EQ(given.dense() != nullptr, n == 5);
    VectorXd x = VectorXd::LinSpaced(rows, -1.0, 1.0), a(rows), b(rows);
    bodies.G->apply(x.data(), a.data()), given.apply(x.data(), b.data());
    // Sums of 3n products of numbers of order one: a few hundred roundings.
    EXPECT_LT((a - b).lpNorm<Eigen::Infinity>(), 1e-13);
    bodies.G->rowSums(a.data()), given.rowSums(b.data());
    EXPECT_LT((a - b).lpNorm<Eigen::Infinity>(), 1e-12);
    given.applyAbsolute(x.data(), b.data());
    VectorXd Gx(rows);
    given.apply(x.data(), Gx.data());
    EXPECT_TRUE((b.array() >= Gx.array().abs() - 1e-14).all());
    std::vector<int> near;
    given.neighbours(2, near);
    EXPECT_EQ(static_cast<int>(near.size()), n);
    const BlockRows& blocks = bodies.G->blockRows();
    EXPECT_EQ(blocks.column.size(), given.blockRows().column.size());
  }
}

TEST(Automatic, SolvesBothFormsOfALargeProblem) {
  BothForms both(40, 60, 12);
  for (InclusionProblem* p : {&both.bodies(), &both.given->problem()}) {
    Automatic solver({.tolerance = 1e-10});
    VectorXd Lambda = VectorXd::Zero(120);
    const SolveReport report = solver.solve(*p, view(Lambda));
    EXPECT_TRUE(report.ok()) << solveStatusText(report.status);
    std::vector<double> scratch;
    EXPECT_LE(residuals(*p, {Lambda.data(), Lambda.size()}, scratch).largest(), 1e-10);
  }
}

TEST(Automatic, ImprovesAGoodStartByFewSteps) {
  BothForms both(40, 60, 13);
  Automatic solver({.tolerance = 1e-10});
  VectorXd Lambda = VectorXd::Zero(120);
  ASSERT_TRUE(solver.solve(both.given->problem(), view(Lambda)).ok());
  std::vector<double> scratch;
  const InclusionProblem& p = both.given->problem();
  const double before = residuals(p, {Lambda.data(), Lambda.size()}, scratch).largest();
  const SolveReport report = solver.solve(p, view(Lambda));
  EXPECT_TRUE(report.ok());
  EXPECT_LE(report.iterations, 3);
  EXPECT_LE(residuals(p, {Lambda.data(), Lambda.size()}, scratch).largest(), before);
}

TEST(Automatic, NeedsFewNewtonStepsFromANearbyStart) {
  BothForms both(40, 60, 14);
  Automatic solver({.tolerance = 1e-10});
  VectorXd Lambda = VectorXd::Zero(120);
  ASSERT_TRUE(solver.solve(both.given->problem(), view(Lambda)).ok());
  for (double& c : both.given->problem().c) c *= 1.0 + 1e-4;  // homogeneous: only the size changes
  const SolveReport report = solver.solve(both.given->problem(), view(Lambda));
  EXPECT_TRUE(report.ok());
  EXPECT_LE(report.newton, 4);
}

TEST(Automatic, SolvesOneContactInClosedForm) {
  const UnilateralCoulomb law(0.0, 0.0, 0.5);
  fixture::Inclusion spatial(std::vector<MatrixXd>{MatrixXd::Identity(3, 3)});
  spatial.contact(law, MatrixXd::Identity(3, 3));
  Automatic solver({.tolerance = 1e-12});
  VectorXd Lambda = VectorXd::Zero(3);
  SolveReport report = solver.solve(spatial.pose(Eigen::Vector3d(-1.0, 0.3, 0.0)), view(Lambda));
  EXPECT_EQ(report.method, "stick");
  EXPECT_LT((Lambda - VectorXd(Eigen::Vector3d(1.0, -0.3, 0.0))).norm(), 1e-15);
  Lambda.setOnes();
  report = solver.solve(spatial.pose(Eigen::Vector3d(1.0, 0.3, 0.0)), view(Lambda));
  EXPECT_EQ(report.method, "take-off");
  EXPECT_TRUE(Lambda.isZero(0.0));
  Lambda.setZero();
  report = solver.solve(spatial.pose(Eigen::Vector3d(-1.0, 2.0, 0.0)), view(Lambda));
  EXPECT_TRUE(report.ok());
  EXPECT_LT((Lambda - VectorXd(Eigen::Vector3d(1.0, -0.5, 0.0))).norm(), 1e-12);
}

/// Never content; has enough in the end, since other starts are many.
class Never final : public FclibRule {
 public:
  double measure(const InclusionProblem&, const double*, const double*) const override {
    return 1.0;
  }
  bool enough() const override { return --left_ < 0; }

 private:
  mutable long left_ = 5000;
};
/// Asks to stop at once.
class AtOnce final : public FclibRule {
 public:
  bool enough() const override { return true; }
};

TEST(Automatic, NeverCallsAnUnconvergedAnswerSolved) {
  BothForms both(40, 60, 15);
  const Never never;
  both.given->problem().rule = &never;
  Automatic solver({.tolerance = 1e-10, .maxNewton = 10, .maxPatient = 10, .maxIterations = 10});
  VectorXd Lambda = VectorXd::Zero(120);
  EXPECT_FALSE(solver.solve(both.given->problem(), view(Lambda)).ok());
  EXPECT_TRUE(Lambda.allFinite());
}

TEST(Automatic, StopsWhenTheRuleHasEnough) {
  BothForms both(40, 60, 16);
  const AtOnce atOnce;
  both.given->problem().rule = &atOnce;
  Automatic solver({.tolerance = 1e-14});
  VectorXd Lambda = VectorXd::Zero(120);
  const SolveReport report = solver.solve(both.given->problem(), view(Lambda));
  EXPECT_EQ(report.status, SolveStatus::maxIterations);
  EXPECT_LT(report.iterations, 20);
}

TEST(Automatic, DoesNotDependOnTheOrderOfEarlierProblems) {
  BothForms first(40, 60, 17), second(30, 60, 18);
  VectorXd alone = VectorXd::Zero(120), after = alone, other = VectorXd::Zero(90);
  Automatic fresh({.tolerance = 1e-10}), used({.tolerance = 1e-10});
  fresh.solve(first.given->problem(), view(alone));
  used.solve(second.given->problem(), view(other));
  used.solve(first.given->problem(), view(after));
  EXPECT_EQ(alone, after) << "a solver keeps no memory between steps";
}

}  // namespace
}  // namespace dynamy
