// What no solver of the inclusion may depend on: units, the scale of single contacts, the order of
// the contacts. And what every solution fulfils.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/io/fclib/fclib_file.hpp>
#include <dynamy/solver/automatic.hpp>
#include <dynamy/solver/block_gauss_seidel.hpp>
#include <iostream>
#include <numeric>
#include <random>

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr unsigned kSeed = 77;
constexpr double kTolerance = 1e-13;
constexpr int kInstances = 40;

struct Way {
  const char* name;
  std::unique_ptr<InclusionSolver> (*make)();
};

void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }

/// n contacts of `dim` rows with a well-conditioned G and little friction: one solution.
struct Contacts {
  int dim;
  MatrixXd G;
  VectorXd c, mu;
  int size() const { return static_cast<int>(c.size()) / dim; }
};

class InclusionInvariance : public testing::TestWithParam<Way> {
 protected:
  void SetUp() override { std::cout << "seed " << kSeed << '\n'; }

  Contacts next() {
    Contacts x;
    x.dim = 2 + static_cast<int>(random() % 2);
    const int n = 1 + static_cast<int>(random() % 9), rows = n * x.dim;
    MatrixXd S(rows, 3 * rows);
    for (double& s : S.reshaped()) s = normal(random);
    x.G = S * S.transpose() / (3.0 * rows);
    x.c.resize(rows), x.mu.resize(n);
    for (double& c : x.c) c = normal(random);
    for (double& mu : x.mu) mu = 0.1 + 0.2 * std::abs(normal(random));
    return x;
  }
  VectorXd solve(const Contacts& x) {
    FclibProblem p;
    p.dim = x.dim, p.W = x.G.sparseView(), p.q = x.c, p.mu = x.mu;
    const auto given = inclusionProblem(p);
    VectorXd Lambda = VectorXd::Zero(x.c.size());
    const SolveReport report = GetParam().make()->solve(given->problem(), view(Lambda));
    EXPECT_TRUE(report.ok()) << solveStatusText(report.status) << ", E_u " << report.residuals.Eu;
    return Lambda;
  }

  std::mt19937 random{kSeed};
  std::normal_distribution<double> normal{0.0, 1.0};
};

TEST_P(InclusionInvariance, OfUnitsIsExact) {
  // Powers of two scale without rounding: every iterate is the same number.
  for (int k = 0; k < kInstances; ++k) {
    const Contacts x = next();
    const VectorXd Lambda = solve(x);
    for (const auto& [mass, speed] : {std::pair{10, 0}, {0, 10}, {-40, 3}, {37, -41}}) {
      Contacts y = x;
      y.G *= std::ldexp(1.0, -mass), y.c *= std::ldexp(1.0, speed);
      EXPECT_EQ(solve(y), VectorXd(std::ldexp(1.0, mass + speed) * Lambda)) << k;
    }
  }
}

TEST_P(InclusionInvariance, OfTheScaleOfSingleContacts) {
  // ξ_i → s_i ξ_i and Λ_i → Λ_i/s_i keep the work. s within 1/30 … 30: E_u of the slowest contact
  // then stands for 900 times 1e-13, and λ_min(G) ≈ 0.2 turns it into an error of Λ.
  for (int k = 0; k < kInstances; ++k) {
    const Contacts x = next();
    VectorXd s(x.c.size());
    for (int i = 0; i < x.size(); ++i)
      s.segment(i * x.dim, x.dim)
          .setConstant(std::pow(30.0, static_cast<double>(random()) / 2147483648.0 - 1.0));
    Contacts y = x;
    y.G = s.asDiagonal() * x.G * s.asDiagonal();
    y.c = s.cwiseProduct(x.c);
    const VectorXd a = solve(x), b = s.cwiseProduct(solve(y));
    EXPECT_LE((a - b).norm(), 1e-9 * (a.norm() + x.c.norm())) << k;
  }
}

TEST_P(InclusionInvariance, OfTheOrderOfContacts) {
  for (int k = 0; k < kInstances; ++k) {
    const Contacts x = next();
    std::vector<int> order(static_cast<std::size_t>(x.size()));
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    Contacts y = x;
    Eigen::PermutationMatrix<Eigen::Dynamic> P(x.c.size());
    for (int i = 0; i < x.size(); ++i) {
      y.mu[i] = x.mu[order[static_cast<std::size_t>(i)]];
      for (int r = 0; r < x.dim; ++r)
        P.indices()[order[static_cast<std::size_t>(i)] * x.dim + r] = i * x.dim + r;
    }
    y.G = P * x.G * P.transpose(), y.c = P * x.c;
    const VectorXd a = solve(x), b = P.transpose() * solve(y);
    // E_u ≤ 1e-13 over λ_min(G) ≈ 0.2, twice.
    EXPECT_LE((a - b).norm(), 1e-11 * (a.norm() + x.c.norm())) << k;
  }
}

TEST_P(InclusionInvariance, SolutionsFulfilTheLawOfEveryContact) {
  for (int k = 0; k < kInstances; ++k) {
    const Contacts x = next();
    const VectorXd Lambda = solve(x), xi = x.G * Lambda + x.c;
    // The tolerance of ξ and, over G_ii ≈ 1, of Λ; products once more.
    const double small = 1e-12 * (1.0 + x.c.norm() + Lambda.norm());
    for (int i = 0; i < x.size(); ++i) {
      const double N = Lambda[i * x.dim], xiN = xi[i * x.dim];
      const VectorXd T = Lambda.segment(i * x.dim + 1, x.dim - 1),
                     xiT = xi.segment(i * x.dim + 1, x.dim - 1);
      EXPECT_GE(N, 0.0);
      EXPECT_GE(xiN, -small);
      EXPECT_LE(std::min(N, xiN), small);
      EXPECT_LE(T.norm(), x.mu[i] * N + small);
      // Largest dissipation: −ξ_T ∈ N(Λ_T).
      EXPECT_LE(T.dot(xiT) + x.mu[i] * N * xiT.norm(), small * (1.0 + xiT.norm() + N)) << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Solvers, InclusionInvariance,
    testing::Values(Way{"Automatic",
                        [] {
                          return std::unique_ptr<InclusionSolver>(std::make_unique<Automatic>(
                              AutomaticOptions{.tolerance = kTolerance}));
                        }},
                    Way{"ProximalNewton",
                        [] {
                          return std::unique_ptr<InclusionSolver>(std::make_unique<ProximalNewton>(
                              ProximalNewtonOptions{.tolerance = kTolerance}));
                        }},
                    Way{"BlockGaussSeidel",
                        [] {
                          return std::unique_ptr<InclusionSolver>(
                              std::make_unique<BlockGaussSeidel>(
                                  ProxOptions{.tolerance = kTolerance, .anderson = 5}));
                        }}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace dynamy
