// Thousands of small problems against all solutions by enumeration: who claims a solution must have
// one. Counts of the oracleSolvers are printed, not asserted, except where theory promises a solution.
#include <gtest/gtest.h>

#include <cstdio>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/solver/admm.hpp>
#include <dynamy/solver/automatic.hpp>
#include <dynamy/solver/problem/given_problem.hpp>
#include <dynamy/solver/prox_block_metric.hpp>
#include <dynamy/solver/semismooth_newton.hpp>
#include <dynamy/solver/successive_laws.hpp>
#include <functional>
#include <map>
#include <random>

#include "support/enumeration.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr unsigned kOracleSeed = 20;
/// Residuals are 1e-10 of u_ref; conditions of 1e4 between ξ and the numbers of the laws are seen.
constexpr double kRight = 1e-6;

class Numbers {
 public:
  explicit Numbers(unsigned seed) : random_(seed) {}
  double operator()() { return static_cast<double>(random_()) / 2147483648.0 - 1.0; }
  MatrixXd matrix(int rows, int cols) {
    MatrixXd A(rows, cols);
    for (double& x : A.reshaped()) x = (*this)();
    return A;
  }
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

 private:
  std::mt19937 random_;
};

enum class Family { definite, singular, singularOutside, skew, nonNegative, any };
const std::map<Family, const char*> kNames = {{Family::definite, "positive definite"},
                                              {Family::singular, "semidefinite, c in the range"},
                                              {Family::singularOutside, "semidefinite, any c"},
                                              {Family::skew, "semidefinite and skew"},
                                              {Family::nonNegative, "entries not negative"},
                                              {Family::any, "any matrix"}};

MatrixXd matrixOf(Family family, int n, Numbers& number) {
  const int rank = family == Family::definite ? n + 2 : 1 + number.below(n);
  const MatrixXd S = number.matrix(n, rank), A = number.matrix(n, n);
  switch (family) {
    case Family::definite:
    case Family::singular:
    case Family::singularOutside:
      return S * S.transpose();
    case Family::skew:
      return S * S.transpose() + A - A.transpose();
    case Family::nonNegative:
      return A.cwiseAbs();
    case Family::any:
      break;
  }
  return A;
}
VectorXd vectorOf(Family family, const MatrixXd& M, Numbers& number) {
  const auto n = static_cast<int>(M.rows());
  if (family == Family::singular) return M * number.matrix(n, 1);
  return number.matrix(n, 1);
}

struct Verdicts {
  int right = 0, honest = 0, noSolution = 0, proven = 0, falseClaims = 0;
};

std::vector<std::pair<const char*, std::unique_ptr<InclusionSolver>>> oracleSolvers() {
  std::vector<std::pair<const char*, std::unique_ptr<InclusionSolver>>> out;
  out.emplace_back("Lemke", std::make_unique<LemkeSolver>(LemkeOptions{.polish = false}));
  ProximalNewtonOptions newton;
  newton.maxNewton = 100, newton.maxPatient = 100, newton.maxIterations = 500;
  out.emplace_back("proximal Newton", std::make_unique<ProximalNewton>(newton));
  AutomaticOptions automatic;
  automatic.maxNewton = 100, automatic.maxPatient = 100, automatic.maxIterations = 500;
  out.emplace_back("Automatic", std::make_unique<Automatic>(automatic));
  ProxOptions sweeps;
  sweeps.maxIterations = 2000;
  out.emplace_back("Gauss-Seidel", std::make_unique<ProxGaussSeidel>(sweeps));
  out.emplace_back("block metric", std::make_unique<ProxBlockMetric>(sweeps));
  out.emplace_back("successive laws",
                   std::make_unique<SuccessiveLaws>(SuccessiveOptions{1e-10, 50, 200}));
  SemismoothOptions semismooth;
  out.emplace_back("Alart-Curnier Newton", std::make_unique<SemismoothNewton>(semismooth));
  semismooth.formulation = SemismoothOptions::Formulation::fischerBurmeister;
  out.emplace_back("Fischer-Burmeister", std::make_unique<SemismoothNewton>(semismooth));
  out.emplace_back("ADMM", std::make_unique<Admm>(AdmmOptions{.maxIterations = 1000}));
  return out;
}

void print(const char* family, const char* solver, const Verdicts& n) {
  std::printf("| %s | %s | %d | %d | %d | %d | %d |\n", family, solver, n.right, n.honest,
              n.noSolution, n.proven, n.falseClaims);
}
void printHead(const char* what) {
  std::printf(
      "seed %u, %s\n| problems | solver | solved | said no | no solution | proven | false claims "
      "|\n",
      kOracleSeed, what);
}

/// Solves with every solver; `error` judges Λ, `exists`: the oracle found a solution.
void solveAll(std::vector<std::pair<const char*, std::unique_ptr<InclusionSolver>>>& all,
              InclusionProblem& p, bool exists, const std::function<double(const VectorXd&)>& error,
              std::vector<Verdicts>& counts) {
  for (std::size_t k = 0; k < all.size(); ++k) {
    VectorXd Lambda = VectorXd::Zero(p.rows());
    const SolveReport report = all[k].second->solve(p, view(Lambda));
    Verdicts& n = counts[k];
    n.noSolution += !exists;
    n.proven += !exists && report.method == "Lemke: there is no solution";
    if (exists) {
      EXPECT_NE(report.method, "Lemke: there is no solution");
    }
    // Forces without bound may hide anything in rounding: also judged.
    const bool right = report.ok() && exists && error(Lambda) <= kRight;
    n.right += right;
    n.honest += exists && !report.ok();
    n.falseClaims += report.ok() && !right;
    if (report.ok() && !right)
      std::printf("false claim of %s: error %.2e, |Lambda| %.2e, E_u %.1e, %s\n", all[k].first,
                  error(Lambda), Lambda.norm(), report.residuals.Eu, exists ? "" : "no solution");
  }
}

std::unique_ptr<GivenProblem> lcpProblem(const MatrixXd& M, const VectorXd& q) {
  std::vector<GivenContact> contacts;
  for (Eigen::Index i = 0; i < q.size(); ++i)
    contacts.push_back({std::make_unique<Unilateral>(), 1});
  return std::make_unique<GivenProblem>(std::move(contacts), M.sparseView(), q);
}

TEST(Oracle, EnumerationFindsTheSolutionsOfSmallExamples) {
  // z = 0 and z = 1/2 … of w = −2z + 1: both (w, z) = (1, 0) and (0, 1/2).
  EXPECT_EQ(enumeration::lcp(MatrixXd{{-2.0}}, VectorXd{{1.0}}).all.size(), 2u);
  EXPECT_TRUE(enumeration::lcp(MatrixXd{{-1.0}}, VectorXd{{-1.0}}).all.empty());
  // Two legs of one body: the solution set is a segment with two ends.
  EXPECT_EQ(enumeration::lcp(MatrixXd::Ones(2, 2), VectorXd::Constant(2, -1.0)).all.size(), 2u);
  // One contact, G = I, c = (−1, 2), μ = 1/2: slips forward with Λ = (1, −1/2).
  const auto slip =
      enumeration::coulomb(MatrixXd::Identity(2, 2), VectorXd{{-1.0, 2.0}}, VectorXd{{0.5}});
  ASSERT_EQ(slip.all.size(), 1u);
  EXPECT_LT((slip.all[0] - VectorXd{{1.0, -0.5}}).norm(), 1e-15);
}

TEST(Oracle, ComplementarityProblemsHaveNoFalseSolutions) {
  auto all = oracleSolvers();
  Numbers number(kOracleSeed);
  printHead("complementarity problems of 1 to 6 unknowns");
  for (const auto& [family, name] : kNames) {
    std::vector<Verdicts> counts(all.size());
    int solvable = 0;
    for (int trial = 0; trial < 400; ++trial) {
      const int n = 1 + number.below(6);
      const MatrixXd M = matrixOf(family, n, number);
      const VectorXd q = vectorOf(family, M, number);
      const auto oracle = enumeration::lcp(M, q);
      solvable += !oracle.all.empty();
      const auto given = lcpProblem(M, q);
      solveAll(
          all, given->problem(), !oracle.all.empty(),
          [&](const VectorXd& z) {
            const VectorXd w = M * z + q;
            double error = w.cwiseMin(z).cwiseAbs().maxCoeff();
            // Semidefinite: w is the same for all solutions.
            if (family <= Family::singularOutside && !oracle.all.empty())
              error = std::max(error, (w - (M * oracle.all[0] + q)).norm());
            return error;
          },
          counts);
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
      print(name, all[k].first, counts[k]);
      EXPECT_EQ(counts[k].falseClaims, 0) << name << ", " << all[k].first;
    }
    // For semidefinite M (copositive-plus) Lemke finds a solution or proves that there is none.
    if (family <= Family::skew) {
      EXPECT_EQ(counts[0].right, solvable) << name;
    }
  }
}

/// G = SSᵀ of bodies; `skew` makes it not symmetric. c is a motion of the bodies.
struct CoulombCase {
  MatrixXd G;
  VectorXd c, mu;
};
CoulombCase coulombCase(int n, int rank, double muMax, double skew, Numbers& number) {
  CoulombCase x;
  const MatrixXd S = number.matrix(2 * n, rank), A = number.matrix(2 * n, 2 * n);
  x.G = S * S.transpose() + skew * (A - A.transpose());
  x.c = skew == 0.0 ? VectorXd(S * number.matrix(rank, 1)) : VectorXd(number.matrix(2 * n, 1));
  x.mu = 0.5 * muMax * (VectorXd::Ones(n) + number.matrix(n, 1));
  return x;
}
std::unique_ptr<GivenProblem> coulombProblem(const CoulombCase& x) {
  std::vector<GivenContact> contacts;
  for (const double mu : x.mu)
    contacts.push_back({std::make_unique<UnilateralCoulomb>(0.0, 0.0, mu), 2});
  return std::make_unique<GivenProblem>(std::move(contacts), x.G.sparseView(), x.c);
}

TEST(Oracle, PlanarFrictionHasNoFalseSolutions) {
  auto all = oracleSolvers();
  Numbers number(kOracleSeed + 1);
  struct Setting {
    const char* name;
    int rankMore;  // rank − rows
    double muMax, skew;
  };
  printHead("planar friction, 1 to 4 contacts");
  for (const Setting& kind : {Setting{"regular, mu < 0.5", 2, 0.5, 0.0},
                              {"regular, mu < 4", 2, 4.0, 0.0},
                              {"rank deficient, mu < 0.5", -1, 0.5, 0.0},
                              {"rank deficient, mu < 4", -1, 4.0, 0.0},
                              {"not symmetric, mu < 4", 2, 4.0, 0.5}}) {
    std::vector<Verdicts> counts(all.size());
    int solvable = 0, several = 0, problems = 0;
    for (int trial = 0; trial < 300; ++trial) {
      const int n = 1 + number.below(4);
      const CoulombCase x = coulombCase(n, 2 * n + kind.rankMore, kind.muMax, kind.skew, number);
      auto oracle = enumeration::coulomb(x.G, x.c, x.mu);
      if (oracle.all.empty() && !oracle.decided) {
        if (n > 2) continue;
        MatrixXd M;
        VectorXd q;
        enumeration::rightLeft(x.G, x.c, x.mu, M, q);
        oracle = enumeration::lcp(M, q);
      }
      ++problems;
      solvable += !oracle.all.empty();
      several += oracle.decided && oracle.all.size() > 1;
      const auto given = coulombProblem(x);
      solveAll(
          all, given->problem(), !oracle.all.empty(),
          [&](const VectorXd& L) { return enumeration::coulombError(x.G, x.c, x.mu, L); }, counts);
    }
    std::printf("%s: %d problems, %d with a solution, %d with several\n", kind.name, problems,
                solvable, several);
    for (std::size_t k = 0; k < all.size(); ++k) {
      print(kind.name, all[k].first, counts[k]);
      EXPECT_EQ(counts[k].falseClaims, 0) << kind.name << ", " << all[k].first;
    }
    // Motions of bodies always have a solution, and Lemke finds it: c lies in the range of W.
    if (kind.skew == 0.0) {
      EXPECT_EQ(solvable, problems) << kind.name;
      EXPECT_EQ(counts[0].right, problems) << kind.name;
    }
  }
}

TEST(Oracle, TheBooksComplementarityFormHasTheSolutionsOfTheStates) {
  Numbers number(kOracleSeed + 2);
  for (int trial = 0; trial < 200; ++trial) {
    const CoulombCase x = coulombCase(2, 6, 3.0, 0.0, number);
    const auto states = enumeration::coulomb(x.G, x.c, x.mu);
    MatrixXd M;
    VectorXd q;
    enumeration::rightLeft(x.G, x.c, x.mu, M, q);
    const auto book = enumeration::lcp(M, q);
    ASSERT_FALSE(book.all.empty());
    for (const VectorXd& z : book.all) {
      const VectorXd Lambda = enumeration::ofRightLeft(z, x.mu);
      double nearest = 1e300;
      for (const VectorXd& other : states.all) nearest = std::min(nearest, (other - Lambda).norm());
      // Two ways to solve regular systems of condition up to 1e4.
      EXPECT_LE(nearest, 1e-9 * (1.0 + Lambda.norm())) << trial;
    }
  }
}

}  // namespace
}  // namespace dynamy
