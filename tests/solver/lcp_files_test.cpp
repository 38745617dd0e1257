// The plain complementarity problems of the collection: each solved by Lemke, or named with the
// reason; judged by min(w, z) from its definition and, up to 6 unknowns, by all solutions.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <algorithm>
#include <cstdio>
#include <dynamy/io/fclib/fclib_file.hpp>
#include <dynamy/solver/automatic.hpp>
#include <filesystem>
#include <map>

#include "support/enumeration.hpp"

namespace dynamy {
namespace {
namespace fs = std::filesystem;

std::vector<fs::path> files() {
  std::vector<fs::path> out;
  const fs::path folder = fs::path(DYNAMY_SOURCE_DIR) / ".." / "shared" / "fclib" / "lcp";
  if (!fs::is_directory(folder)) return out;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".hdf5") out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

/// max |min(w_i, z_i)| / max |q_i|.
double error(const FclibProblem& p, const Eigen::VectorXd& z) {
  const Eigen::VectorXd w = p.W * z + p.q;
  return w.cwiseMin(z).lpNorm<Eigen::Infinity>() / p.q.lpNorm<Eigen::Infinity>();
}

/// What pivoting alone says where it does not solve.
const std::map<std::string, LcpOutcome> kNotByPivoting = {
    // w₂ = z₁ − 1, w₃ = 1 − z₁ give z₁ = 1, and w₁ = −z₂ − z₃ − 1e-4 is negative always.
    {"lcp_Pang_isolated_sol_perturbed", LcpOutcome::infeasible},
    // A game of two with matrices of positive numbers: z_r enters and stops nobody.
    {"lcp_CPS_3", LcpOutcome::ray}};

TEST(LcpFiles, ArePivotedOrNamed) {
  if (files().empty()) GTEST_SKIP() << "no collection of problems beside the source tree";
  std::printf("| problem | n | zero diagonals | pivots | max min(w, z) / max q | solutions |\n");
  for (const fs::path& file : files()) {
    const FclibProblem p = readFclib(file);
    const std::string name = file.stem().string();
    const RowMatrix M = Eigen::MatrixXd(p.W);
    Lemke lemke;
    Eigen::VectorXd z = Eigen::VectorXd::Zero(p.rows());
    const LcpOutcome outcome =
        lemke.solve({M.data(), M.rows(), M.cols()}, {p.q.data(), p.q.size()}, view(z));
    const bool small = p.rows() <= 6;
    const auto oracle = small ? enumeration::lcp(M, p.q) : enumeration::Solutions{};
    std::printf("| %s | %d | %d | %d | %.1e | %s |\n", name.c_str(), p.rows(),
                static_cast<int>((M.diagonal().array() == 0.0).count()), lemke.pivots(),
                error(p, z), small ? std::to_string(oracle.all.size()).c_str() : "");
    const auto named = kNotByPivoting.find(name);
    EXPECT_EQ(outcome, named == kNotByPivoting.end() ? LcpOutcome::solved : named->second) << name;
    // Conditions of the bases up to 1e3 (tobenna), times rounding.
    if (outcome == LcpOutcome::solved) {
      EXPECT_LE(error(p, z), 1e-12) << name;
    }
    if (outcome == LcpOutcome::infeasible) {
      EXPECT_TRUE(oracle.all.empty()) << name;
    }
    if (small && outcome != LcpOutcome::infeasible) {
      EXPECT_FALSE(oracle.all.empty()) << name;
    }
  }
}

TEST(LcpFiles, AreSolvedByTheSolversThatUsersMeet) {
  if (files().empty()) GTEST_SKIP() << "no collection of problems beside the source tree";
  for (const fs::path& file : files()) {
    const FclibProblem p = readFclib(file);
    const std::string name = file.stem().string();
    const bool exists = name != "lcp_Pang_isolated_sol_perturbed";
    const auto given = inclusionProblem(p);
    LemkeSolver lemke;
    Automatic automatic;
    for (InclusionSolver* solver :
         {static_cast<InclusionSolver*>(&lemke), static_cast<InclusionSolver*>(&automatic)}) {
      Eigen::VectorXd z = Eigen::VectorXd::Zero(p.rows());
      const SolveReport report = solver->solve(given->problem(), view(z));
      EXPECT_EQ(report.ok(), exists) << name << ", " << report.method;
      // E_u ≤ 1e-10, ρ of the rows and the numbers of q differ by up to 1e3.
      if (exists) {
        EXPECT_LE(error(p, z), 1e-7) << name << ", " << report.method;
      }
      if (!exists) {
        EXPECT_EQ(report.method, "Lemke: there is no solution");
      }
    }
  }
}

}  // namespace
}  // namespace dynamy
