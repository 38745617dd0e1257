// Problems that once crashed a solver, were read although they were corrupt, or were not solved
// although one of the methods at hand solves them: tests/data/hard_problems.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <dynamy/core/error.hpp>
#include <dynamy/solver/admm.hpp>
#include <dynamy/solver/automatic.hpp>
#include <dynamy/solver/diagnosis/diagnosis.hpp>
#include <dynamy/solver/lemke_solver.hpp>
#include <dynamy/solver/packed_gauss_seidel.hpp>
#include <dynamy/solver/prox_block_metric.hpp>
#include <dynamy/solver/semismooth_newton.hpp>
#include <dynamy/solver/successive_laws.hpp>
#include <filesystem>
#include <solver/fclib_checker.hpp>
#include <support/contact_problems.hpp>

namespace dynamy {
namespace {

FclibProblem hard(const std::string& name) {
  return readFclib(std::filesystem::path(DYNAMY_SOURCE_DIR) / "tests/data/hard_problems" /
                   (name + ".hdf5"));
}

/// Automatic to 1e-8 of FCLIB's measure; `Lambda` out.
SolveReport solve(const FclibProblem& problem, Eigen::VectorXd& Lambda) {
  const std::unique_ptr<GivenProblem> given = inclusionProblem(problem);
  const FclibRule rule;
  given->problem().rule = &rule;
  Automatic solver({.tolerance = 1e-8});
  Lambda.setZero(problem.rows());
  return solver.solve(given->problem(), view(Lambda));
}

TEST(HardProblems, WhatPivotingSolvesAutomaticSolves) {
  const FclibProblem problem = hard("only_pivoting_solves");
  Eigen::VectorXd Lambda;
  const SolveReport report = solve(problem, Lambda);
  EXPECT_TRUE(report.ok()) << attemptsText(report);
  EXPECT_LE(fclibResidual(problem, Lambda), 1e-8);
}

TEST(HardProblems, AContactWithoutLocalSolutionIsNoCrash) {
  for (const char* name : {"unsymmetric_without_local_solution", "scaled_without_local_solution"}) {
    const FclibProblem problem = hard(name);
    Eigen::VectorXd Lambda;
    const SolveReport report = solve(problem, Lambda);
    ASSERT_TRUE(Lambda.allFinite()) << name;
    // The checker sums in another order: some roundings of numbers 1e16 times the tolerance.
    EXPECT_NEAR(fclibResidual(problem, Lambda), report.residuals.given,
                1e-8 + 1e-6 * report.residuals.given)
        << name;
  }
}

TEST(HardProblems, TheMeasureOfNoForcesDoesNotDependOnTheUnitOfVelocity) {
  FclibProblem problem = hard("velocities_1e160");
  const auto measure = [&] {
    const std::unique_ptr<GivenProblem> given = inclusionProblem(problem);
    const FclibRule rule;
    given->problem().rule = &rule;
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(problem.rows());
    std::vector<double> scratch;
    return residuals(given->problem(), view(zero), scratch);
  };
  const Residuals huge = measure();
  EXPECT_GT(huge.given, 0.0);
  problem.q *= std::ldexp(1.0, -531);  // about 1e-160, without rounding
  const Residuals usual = measure();
  // Scaled squares round once more each.
  EXPECT_NEAR(huge.given / usual.given, 1.0, 1e-14);
  EXPECT_NEAR(huge.Eu / usual.Eu, 1.0, 1e-14);
  problem.q *= std::ldexp(1.0, -531);
  EXPECT_NEAR(measure().given / usual.given, 1.0, 1e-14);
}

TEST(HardProblems, NoContactIsSolvedAndDiagnosed) {
  const FclibProblem problem = hard("zero_contacts");
  ASSERT_EQ(problem.contacts(), 0);
  Eigen::VectorXd Lambda;
  const SolveReport report = solve(problem, Lambda);
  EXPECT_TRUE(report.ok());
  const std::unique_ptr<GivenProblem> given = inclusionProblem(problem);
  Automatic solver;
  EXPECT_TRUE(diagnose(given->problem(), {Lambda.data(), 0}, report, solver).findings.empty());
}

TEST(HardProblems, CorruptPointersAreRefused) {
  EXPECT_THROW(hard("decreasing_pointers"), ModelError);
}

/// Wants nothing more after `calls` questions, and counts them.
class Impatient final : public StoppingRule {
 public:
  explicit Impatient(int calls) : left_(calls) {}
  double measure(const InclusionProblem&, const double*, const double*) const override {
    return -1.0;
  }
  bool enough() const override { return --left_ < 0; }
  int asked() const { return -left_; }

 private:
  mutable int left_;
};

TEST(HardProblems, EverySolverEndsSoonAfterItIsToldTo) {
  // Twelve redundant contacts; the tolerance is out of reach, so that every solver wants to go on.
  FclibProblem problem = randomProblem(3, 12, 20, 0.6, 0.0, 4);
  constexpr double kNever = 1e-30;
  std::map<std::string, std::unique_ptr<InclusionSolver>> all;
  all["Automatic"] = std::make_unique<Automatic>(AutomaticOptions{.tolerance = kNever});
  const ProxOptions sweeps{.tolerance = kNever};
  all["BlockGaussSeidel"] = std::make_unique<BlockGaussSeidel>(sweeps);
  all["PackedGaussSeidel"] =
      std::make_unique<PackedGaussSeidel>(PackedOptions{.tolerance = kNever});
  all["ProxGaussSeidel"] = std::make_unique<ProxGaussSeidel>(sweeps);
  all["ProxJacobi"] = std::make_unique<ProxJacobi>(sweeps);
  all["ProxBlockMetric"] = std::make_unique<ProxBlockMetric>(sweeps);
  all["ProximalNewton"] =
      std::make_unique<ProximalNewton>(ProximalNewtonOptions{.tolerance = kNever});
  SemismoothOptions newton;
  newton.tolerance = kNever;
  all["SemismoothNewton"] = std::make_unique<SemismoothNewton>(newton);
  all["Lemke"] = std::make_unique<LemkeSolver>(LemkeOptions{.tolerance = kNever});
  all["Admm"] = std::make_unique<Admm>(AdmmOptions{.tolerance = kNever});
  all["SuccessiveLaws"] = std::make_unique<SuccessiveLaws>(SuccessiveOptions{.tolerance = kNever});
  for (const int patience : {0, 1, 7}) {
    for (const auto& [name, solver] : all) {
      const std::unique_ptr<GivenProblem> given = inclusionProblem(problem);
      const Impatient rule(patience);
      given->problem().rule = &rule;
      Eigen::VectorXd Lambda = Eigen::VectorXd::Zero(problem.rows());
      const SolveReport report = solver->solve(given->problem(), view(Lambda));
      EXPECT_FALSE(report.ok()) << name;
      // One iteration a question; ten sweeps make the start of the Newton methods, ten stages end.
      EXPECT_LE(report.iterations, patience + 20) << name;
      EXPECT_LE(rule.asked(), 20) << name;
    }
  }
}

}  // namespace
}  // namespace dynamy
