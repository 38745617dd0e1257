// Every solver on problems at the ends of what 64-bit numbers can hold: W of 1e-310 and 1e300, μ of
// 1e300, velocities of 1e±160, singular, indefinite and unsymmetric W, no contact at all. None may
// crash, run on for ever, or claim a solution that is none.
#include <gtest/gtest.h>

#include <dynamy/law/rolling_friction.hpp>
#include <dynamy/solver/admm.hpp>
#include <dynamy/solver/automatic.hpp>
#include <dynamy/solver/diagnosis/diagnosis.hpp>
#include <dynamy/solver/lemke_solver.hpp>
#include <dynamy/solver/packed_gauss_seidel.hpp>
#include <dynamy/solver/prox_block_metric.hpp>
#include <dynamy/solver/semismooth_newton.hpp>
#include <dynamy/solver/successive_laws.hpp>
#include <map>
#include <support/contact_problems.hpp>
#include <support/known_problems.hpp>

namespace dynamy {
namespace {

using Solvers = std::map<std::string, std::unique_ptr<InclusionSolver>>;

Solvers boundedSolvers() {
  Solvers out;
  const ProxOptions sweeps{.tolerance = 1e-8, .maxIterations = 300};
  out["Automatic"] = std::make_unique<Automatic>(
      AutomaticOptions{.tolerance = 1e-8, .maxNewton = 50, .maxPatient = 50, .maxIterations = 300});
  out["BlockGaussSeidel"] = std::make_unique<BlockGaussSeidel>(sweeps);
  out["PackedGaussSeidel"] =
      std::make_unique<PackedGaussSeidel>(PackedOptions{.tolerance = 1e-8, .maxIterations = 300});
  out["ProxGaussSeidel"] = std::make_unique<ProxGaussSeidel>(sweeps);
  out["ProxJacobi"] = std::make_unique<ProxJacobi>(sweeps);
  out["ProxBlockMetric"] = std::make_unique<ProxBlockMetric>(sweeps);
  out["ProximalNewton"] = std::make_unique<ProximalNewton>(ProximalNewtonOptions{
      .tolerance = 1e-8, .maxNewton = 50, .maxIterations = 300, .maxPatient = 50});
  SemismoothOptions newton;
  newton.tolerance = 1e-8;
  out["SemismoothNewton"] = std::make_unique<SemismoothNewton>(newton);
  newton.formulation = SemismoothOptions::Formulation::fischerBurmeister;
  out["FischerBurmeister"] = std::make_unique<SemismoothNewton>(newton);
  out["Lemke"] = std::make_unique<LemkeSolver>(LemkeOptions{.tolerance = 1e-8});
  out["Admm"] = std::make_unique<Admm>(AdmmOptions{.tolerance = 1e-8, .maxIterations = 300});
  out["SuccessiveLaws"] = std::make_unique<SuccessiveLaws>(
      SuccessiveOptions{.tolerance = 1e-8, .maxOuter = 20, .maxIterations = 100});
  return out;
}

/// Small problems of every kind, each with one part out of all proportion.
std::vector<FclibProblem> extremes() {
  std::vector<FclibProblem> base, out;
  for (const int dim : {2, 3})
    for (const int n : {0, 1, 3}) {
      base.push_back(randomProblem(dim, n, dim * n + 2, 0.5, 0.0, 7 + dim));
      base.push_back(randomProblem(dim, n, 1, 0.5, 0.3, 8 + dim));
    }
  FclibProblem indefinite = randomProblem(3, 2, 8, 0.8, 0.0, 5);
  indefinite.W = -indefinite.W;
  base.push_back(indefinite);
  FclibProblem rolling = randomProblem(5, 2, 12, 0.5, 0.0, 6);
  rolling.muRolling.setConstant(2, 0.1);
  base.push_back(rolling);
  FclibProblem lcp = randomProblem(1, 3, 5, 0.0, 0.0, 9);
  lcp.mu.resize(0);
  base.push_back(lcp);
  for (const FclibProblem& p : base) {
    out.push_back(p);
    for (const double size : {0.0, 1e-310, 1e-160, 1e160, 1e300}) {
      out.push_back(p), out.back().W = p.W * size;
      out.push_back(p), out.back().q = p.q * size;
      out.push_back(p), out.back().mu = p.mu * size;
      if (p.contacts() < 2) continue;
      // One contact alone.
      out.push_back(p), out.back().q.head(p.dim) *= size;
      Eigen::MatrixXd W = p.W;
      W.topRows(p.dim) *= size, W.leftCols(p.dim) *= size;
      out.push_back(p), out.back().W = W.sparseView();
    }
  }
  return out;
}

TEST(ExtremeNumbers, NoSolverCrashesOrClaimsASolutionThatIsNone) {
  // One object of each for all problems, so that nothing of the last problem is used for the next.
  const Solvers all = boundedSolvers();
  int at = 0;
  for (const FclibProblem& problem : extremes()) {
    Eigen::MatrixXd W = problem.W;
    ++at;
    if (!W.allFinite()) continue;  // GivenProblem refuses it
    const std::unique_ptr<GivenProblem> given = inclusionProblem(problem);
    for (const auto& [name, solver] : all) {
      Eigen::VectorXd Lambda = Eigen::VectorXd::Zero(given->problem().rows());
      const SolveReport report = solver->solve(given->problem(), view(Lambda));
      if (!report.ok() || problem.dim == 5) continue;
      const Missed missed = dynamy::missed(problem, Lambda);
      EXPECT_LE(missed.error, 1e-8 + missed.rounding) << name << ", problem " << at;
    }
  }
}

TEST(ExtremeNumbers, FclibsMeasureIsNoZeroForVelocitiesWhoseSquaresAreNoNumbers) {
  // u = r − s, r = 0: the measure is |P_K(s)|/|s|, for s inside of the cone 1.
  for (const double size : {1e-300, 1e-160, 1.0, 1e160, 1e300}) {
    FclibProblem p = randomProblem(3, 1, 3, 0.5, 0.0, 1);
    p.W = Eigen::MatrixXd(Eigen::MatrixXd::Identity(3, 3)).sparseView();
    p.q = Eigen::Vector3d(-size, 0.0, 0.1 * size);
    const std::unique_ptr<GivenProblem> given = inclusionProblem(p);
    const FclibRule rule;
    given->problem().rule = &rule;
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(3);
    std::vector<double> scratch;
    const Residuals r = residuals(given->problem(), view(zero), scratch);
    // The shift μ|ξ_T| = 0.05 moves the argument to (0.95, 0, −0.1): inside.
    EXPECT_NEAR(r.given, std::hypot(0.95, 0.1) / std::hypot(1.0, 0.1), 1e-14) << size;
    // E_u = |e|, as λ = 1 and u_ref = |q|.
    EXPECT_NEAR(r.Eu, std::hypot(0.95, 0.1) / std::hypot(1.0, 0.1), 1e-14) << size;
  }
}

TEST(ExtremeNumbers, ProblemsOfAnySizeOfVelocityAreSolvedAlike) {
  // The laws are cones: (s Λ, s ξ) solves s q. 2^±400 scales without rounding.
  FclibProblem p = randomProblem(3, 4, 14, 0.5, 0.0, 3);
  const Eigen::VectorXd q = p.q;
  for (const int power : {-400, 0, 400}) {
    p.q = std::ldexp(1.0, power) * q;
    const std::unique_ptr<GivenProblem> given = inclusionProblem(p);
    Automatic solver({.tolerance = 1e-10});
    Eigen::VectorXd Lambda = Eigen::VectorXd::Zero(12);
    EXPECT_TRUE(solver.solve(given->problem(), view(Lambda)).ok()) << power;
    EXPECT_LE(missed(p, Lambda).error, 1e-10 + missed(p, Lambda).rounding) << power;
  }
}

TEST(ExtremeNumbers, TheDiagnosisOfNoContactSaysNothing) {
  for (const int dim : {2, 3}) {
    const std::unique_ptr<GivenProblem> given =
        inclusionProblem(randomProblem(dim, 0, 1, 0.5, 0.0, 1));
    for (const auto& [name, solver] : boundedSolvers()) {
      Eigen::VectorXd none(0);
      const SolveReport report = solver->solve(given->problem(), view(none));
      EXPECT_TRUE(report.ok()) << name;
      const Diagnosis d = diagnose(given->problem(), {none.data(), 0}, report, *solver);
      EXPECT_TRUE(d.findings.empty()) << name << d.text();
      EXPECT_EQ(d.rows, 0);
    }
  }
}

TEST(ExtremeNumbers, TheDiagnosisSurvivesThem) {
  for (const FclibProblem& problem : extremes()) {
    const Eigen::MatrixXd W = problem.W;
    if (!W.allFinite()) continue;
    const std::unique_ptr<GivenProblem> given = inclusionProblem(problem);
    Automatic solver({.tolerance = 1e-8, .maxNewton = 20, .maxPatient = 20, .maxIterations = 100});
    Eigen::VectorXd Lambda = Eigen::VectorXd::Zero(given->problem().rows());
    const SolveReport report = solver.solve(given->problem(), view(Lambda));
    const Diagnosis d = diagnose(given->problem(), {Lambda.data(), Lambda.size()}, report, solver);
    EXPECT_LE(d.closed, d.contacts);
  }
}

}  // namespace
}  // namespace dynamy
