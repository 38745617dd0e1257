// Five small scenes on which a solver of inclusions shows its character: iterations over r,
// coplanar points, a column, Painlevé's rod, a cradle. Figures are printed as tables for
// theory 4.10.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <cmath>
#include <cstdio>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/solver/automatic.hpp>
#include <dynamy/solver/impact/impact_law.hpp>
#include <dynamy/solver/problem/given_problem.hpp>
#include <fstream>
#include <support/gravity.hpp>

#include "support/enumeration.hpp"
#include "unit/solver/inclusion_fixture.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// ---- 1: iterations over r ----------------------------------------------------------------------

/// Sweeps of prox Jacobi with the common r on [2 1; 1 2], eigenvalues 1 and 3; −1: diverged.
int sweeps(double r) {
  const Unilateral law;
  fixture::Inclusion x(fixture::symmetricRoot(MatrixXd{{2.0, 1.0}, {1.0, 2.0}}), law);
  VectorXd Lambda = VectorXd::Zero(2);
  // Relaxation::exact is 1/2 here. Λ = (2, 1) > 0; both eigenvectors are in it.
  const SolveReport report = ProxJacobi({1e-10, 100000, Relaxation::exact, 2.0 * r})
                                 .solve(x.pose(VectorXd{{-5.0, -4.0}}), view(Lambda));
  return report.ok() ? report.iterations : -1;
}

TEST(BookExamples, IterationsOverRHaveTheirMinimumWhereTheTheorySays) {
  std::printf("| r | spectral radius | sweeps |\n");
  int best = 1 << 30;
  double bestR = 0.0;
  for (int k = 1; k <= 33; ++k) {
    const double r = 0.02 * k, radius = std::max(std::abs(1.0 - r), std::abs(1.0 - 3.0 * r));
    const int n = sweeps(r);
    std::printf("| %.2f | %.2f | %d |\n", r, radius, n);
    ASSERT_GT(n, 0) << r;
    // ln(1e-10)/ln ρ sweeps from errors of size 1; the full test is made in steps of an eighth.
    const double predicted = std::log(1e-10) / std::log(radius);
    EXPECT_GE(n, 0.9 * predicted - 3.0) << r;
    EXPECT_LE(n, 1.2 * predicted + 4.0) << r;
    if (n < best) best = n, bestR = r;
  }
  EXPECT_NEAR(bestR, 0.5, 0.021);  // 2/(λ_min + λ_max)
  EXPECT_EQ(sweeps(0.6733), -1);   // beyond 2/λ_max = 2/3
}

/// Draws theory 4.10's figure again; run by hand.
TEST(BookExamples, DISABLED_DrawIterationsOverR) {
  std::ofstream out(std::string(DYNAMY_SOURCE_DIR) + "/doc/figures/sweeps_over_r.svg");
  const auto x = [](double r) { return 60.0 + 600.0 * r / 0.7; };
  const auto y = [](double n) { return 320.0 - 100.0 * std::log10(n); };
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 700 370\" "
         "font-family=\"sans-serif\" "
         "font-size=\"14\">\n<rect width=\"700\" height=\"370\" fill=\"white\"/>\n";
  for (const int n : {1, 10, 100, 1000})
    out << "<path d=\"M60 " << y(n) << "H660\" stroke=\"#ddd\"/><text x=\"52\" y=\"" << y(n) + 5
        << "\" text-anchor=\"end\">" << n << "</text>\n";
  for (int k = 0; k <= 7; ++k)
    out << "<text x=\"" << x(0.1 * k) << "\" y=\"340\" text-anchor=\"middle\">0." << k
        << "</text>\n";
  out << "<path d=\"M" << x(2.0 / 3.0)
      << " 20V320\" stroke=\"#c33\" stroke-dasharray=\"5 4\"/><text x=\"" << x(2.0 / 3.0) - 6
      << "\" y=\"34\" fill=\"#c33\" text-anchor=\"end\">2/λmax</text>\n<polyline fill=\"none\" "
         "stroke=\"#06c\" stroke-width=\"2\" points=\"";
  for (int k = 8; k <= 331; ++k) out << x(0.002 * k) << ',' << y(sweeps(0.002 * k)) << ' ';
  out << "\"/>\n<text x=\"360\" y=\"362\" text-anchor=\"middle\">r</text><text x=\"60\" "
         "y=\"14\">sweeps "
         "to 1e-10, prox Jacobi on [2 1; 1 2]</text>\n</svg>\n";
}

// ---- 2: block on coplanar points ---------------------------------------------------------------

/// A block of 2 kg, 2 m long and 0.4 m high, on n points of its base; velocities x, z, rotation.
struct Block {
  Block(int n, double mu) : law(0.0, 0.0, mu), x(std::vector<MatrixXd>{mass()}) {
    for (int k = 0; k < n; ++k) {
      const double at = -1.0 + 2.0 * k / (n - 1.0);
      x.contact(law, MatrixXd{{0.0, 1.0, at}, {1.0, 0.0, 0.2}});
    }
  }
  static MatrixXd mass() {
    return Eigen::Vector3d(2.0, 2.0, 2.0 * (4.0 + 0.16) / 12.0).asDiagonal();
  }
  /// One step of 10 ms from rest under weight and a horizontal force in the base plane.
  InclusionProblem& pose(double pull) {
    uFree = 0.01 * Eigen::Vector3d(pull / 2.0, -kG, pull * 0.2 / mass()(2, 2));
    const auto n = static_cast<int>(x.contacts.size());
    x.pose(VectorXd::Zero(2 * n));
    VectorXd c(2 * n);
    x.contacts.gamma(view(std::as_const(uFree)), view(c));
    return x.pose(c);
  }
  VectorXd uEnd(const VectorXd& Lambda) {
    VectorXd u = uFree;
    x.G.addVelocity(Lambda.data(), view(u));
    return u;
  }
  UnilateralCoulomb law;
  fixture::Inclusion x;
  VectorXd uFree;
};

TEST(BookExamples, CoplanarPointsCarryTheWeightAndSlipAtMuWhateverTheStart) {
  const double weight = 0.01 * 2.0 * kG, mu = 0.4;
  for (const int n : {2, 3, 5, 9, 17}) {
    Block block(n, mu);
    for (const double part : {0.5, 0.999, 1.001, 2.0}) {
      const InclusionProblem& p = block.pose(part * mu * 2.0 * kG);
      VectorXd first;
      std::mt19937 random(7);
      for (int start = 0; start < 4; ++start) {
        VectorXd Lambda = VectorXd::Zero(2 * n);
        if (start > 0) Lambda = weight * fixture::randomMatrix(random, 2 * n, 1);
        ProxGaussSeidel sweeps({1e-12, 200000, Relaxation::exact, 1.0});
        ASSERT_TRUE(sweeps.solve(p, view(Lambda)).ok()) << n;
        const VectorXd u = block.uEnd(Lambda);
        double N = 0.0;
        for (int k = 0; k < n; ++k) N += Lambda[2 * k];
        // 1e-12 of u_ref, 0.1 m/s, times masses of 2 kg and lever arms.
        EXPECT_NEAR(N, weight, 1e-10);
        const double slip = std::max(0.0, part - 1.0) * mu * 0.01 * kG;
        EXPECT_NEAR(u[0], slip, 1e-10) << n << ", " << part;
        if (start == 0) first = u;
        EXPECT_LE((u - first).norm(), 1e-10);
      }
      VectorXd Lambda = VectorXd::Zero(2 * n);
      EXPECT_TRUE(LemkeSolver(LemkeOptions{.polish = false}).solve(p, view(Lambda)).ok()) << n;
      EXPECT_LE((block.uEnd(Lambda) - first).norm(), 1e-10);
    }
  }
}

// ---- 3: column of spheres ----------------------------------------------------------------------

/// n spheres of 1 kg on each other; contacts numbered from the top or from the ground.
int columnSweeps(int n, bool fromTop, VectorXd* out = nullptr) {
  const Unilateral law;
  fixture::Inclusion x(std::vector<MatrixXd>(n, MatrixXd::Identity(1, 1)));
  VectorXd c = VectorXd::Zero(n);
  for (int k = 0; k < n; ++k) {
    const int sphere = fromTop ? k : n - 1 - k;  // 0: the top one
    MatrixXd Wt = MatrixXd::Zero(1, n);
    Wt(0, sphere) = 1.0;
    if (sphere + 1 < n)
      Wt(0, sphere + 1) = -1.0;
    else
      c[k] = -kG;
    x.contact(law, Wt);
  }
  VectorXd Lambda = VectorXd::Zero(n);
  const SolveReport report =
      ProxGaussSeidel({1e-6, 1000000, Relaxation::exact, 1.0}).solve(x.pose(c), view(Lambda));
  EXPECT_TRUE(report.ok());
  if (out) *out = Lambda;
  return report.iterations;
}

TEST(BookExamples, SweepsOfAColumnGrowWithTheSquareInEitherOrder) {
  std::printf("| spheres | sweeps from the top | from the ground |\n");
  int last[2] = {};
  for (const int n : {5, 10, 20, 40, 80}) {
    VectorXd Lambda;
    const int count[2] = {columnSweeps(n, true, &Lambda), columnSweeps(n, false)};
    std::printf("| %d | %d | %d |\n", n, count[0], count[1]);
    // The k-th contact carries k weights; 1e-6 of g comes back times |G⁻¹| = n²/2.
    for (int k = 0; k < n; ++k) EXPECT_NEAR(Lambda[k], (k + 1) * kG, 1e-5 * n * n);
    // ρ = cos²(π/(2n + 1)) in both orders: sweeps ~ n², an exponent of 2 between doubled n.
    for (int order = 0; order < 2; ++order) {
      if (n >= 20) {
        EXPECT_NEAR(std::log2(double(count[order]) / last[order]), 2.0, 0.25) << n;
      }
      last[order] = count[order];
    }
  }
}

// ---- 4: Painlevé's rod -------------------------------------------------------------------------

/// G of the end of a slender rod, 1 kg and 2 m, at θ from the horizontal: N and T of one contact.
MatrixXd rod(double theta) {
  const double c = std::cos(theta), s = std::sin(theta);
  return MatrixXd{{1.0 + 3.0 * c * c, 3.0 * s * c}, {3.0 * s * c, 1.0 + 3.0 * s * s}};
}
std::unique_ptr<GivenProblem> rodProblem(const MatrixXd& G, const VectorXd& c, double mu) {
  std::vector<GivenContact> contacts;
  contacts.push_back({std::make_unique<UnilateralCoulomb>(0.0, 0.0, mu), 2});
  return std::make_unique<GivenProblem>(std::move(contacts), G.sparseView(), c);
}

TEST(BookExamples, PainlevesRodTurnsParadoxicalAtMuFourThirds) {
  // G_NN − μ G_NT ∝ 1 + 3 cos θ (cos θ − μ sin θ) vanishes first for μ = 4/3, at tan θ = 2.
  double least = 1e300, at = 0.0;
  for (double theta = 0.01; theta < 1.57; theta += 1e-4) {
    const MatrixXd G = rod(theta);
    const double mu = G(0, 0) / G(0, 1);
    if (mu < least) least = mu, at = theta;
  }
  EXPECT_NEAR(least, 4.0 / 3.0, 1e-7);  // flat minimum, squares of the grid
  EXPECT_NEAR(std::tan(at), 2.0, 1e-3);
}

TEST(BookExamples, PainlevesRodHasThreeSolutionsAndEverySolverNamesOne) {
  const MatrixXd G = rod(std::atan(2.0));
  const double mu = 2.0;
  const VectorXd c{{0.1, 1.0}};
  const auto oracle = enumeration::coulomb(G, c, VectorXd{{mu}});
  ASSERT_EQ(oracle.all.size(), 3u);  // open, slip, stick
  const auto given = rodProblem(G, c, mu);
  ProximalNewton newton;
  LemkeSolver lemke;
  ProxGaussSeidel sweeps;
  Automatic automatic;
  int seen[3] = {};
  for (InclusionSolver* solver :
       {static_cast<InclusionSolver*>(&newton), static_cast<InclusionSolver*>(&lemke),
        static_cast<InclusionSolver*>(&sweeps), static_cast<InclusionSolver*>(&automatic)})
    for (int start = 0; start < 40; ++start) {
      VectorXd Lambda{{0.05 * start, -0.02 * start * (start % 3)}};
      const SolveReport report = solver->solve(given->problem(), view(Lambda));
      if (!report.ok()) continue;
      double nearest = 1e300;
      int which = 0;
      for (int k = 0; k < 3; ++k) {
        const double d = (oracle.all[static_cast<std::size_t>(k)] - Lambda).norm();
        if (d < nearest) nearest = d, which = k;
      }
      EXPECT_LE(nearest, 1e-7) << start;  // 1e-10 of 1 m/s, times the condition
      ++seen[which];
    }
  std::printf("open %d, stick %d, slip %d times\n", seen[0], seen[1], seen[2]);
  EXPECT_GT((seen[0] > 0) + (seen[1] > 0) + (seen[2] > 0), 1) << "the start decides";
}

TEST(BookExamples, PainlevesRodSticksAtOnceWhereItCannotSlip) {
  // c_N < 0 in the paradoxical range: no slip, no take-off; an impact without collision.
  const MatrixXd G = rod(std::atan(2.0));
  const VectorXd c{{-0.1, 1.0}};
  const auto oracle = enumeration::coulomb(G, c, VectorXd{{2.0}});
  ASSERT_EQ(oracle.all.size(), 1u);
  const auto given = rodProblem(G, c, 2.0);
  for (const bool pivots : {true, false}) {
    VectorXd Lambda = VectorXd::Zero(2);
    const SolveReport report = pivots ? LemkeSolver().solve(given->problem(), view(Lambda))
                                      : Automatic().solve(given->problem(), view(Lambda));
    EXPECT_TRUE(report.ok()) << pivots;
    EXPECT_LE((Lambda - oracle.all[0]).norm(), 1e-8);
  }
}

TEST(BookExamples, PainlevesRodHasNoForceWhileItSlides) {
  // On the level of forces sliding goes on, Λ_T = −μΛ_N: w = (G_NN − μG_NT) z + c_N with a negative
  // factor has no solution for c_N < 0 and two for c_N > 0.
  const MatrixXd G = rod(std::atan(2.0));
  const double factor = G(0, 0) - 2.0 * G(0, 1);
  ASSERT_LT(factor, 0.0);
  for (const double cN : {-0.1, 0.1}) {
    const RowMatrix M{{factor}};
    const VectorXd q{{cN}};
    VectorXd z(1);
    Lemke lemke;
    const LcpOutcome outcome = lemke.solve({M.data(), 1, 1}, view(q), view(z));
    const auto all = enumeration::lcp(M, q).all;
    EXPECT_EQ(all.size(), cN < 0.0 ? 0u : 2u);
    EXPECT_EQ(outcome, cN < 0.0 ? LcpOutcome::infeasible : LcpOutcome::solved);
  }
}

// ---- 5: Newton's cradle ------------------------------------------------------------------------

TEST(BookExamples, NewtonsCradleOfThreeBallsLeavesWithTheVelocitiesOfTheTable) {
  for (const double epsilon : {0.0, 0.5, 1.0}) {
    const Unilateral law(epsilon);
    fixture::Inclusion x(std::vector<MatrixXd>(3, MatrixXd::Identity(1, 1)));
    x.contact(law, MatrixXd{{-1.0, 1.0, 0.0}});
    x.contact(law, MatrixXd{{0.0, -1.0, 1.0}});
    InclusionProblem& p = x.pose(VectorXd::Zero(2));
    VectorXd u{{1.0, 0.0, 0.0}};
    x.contacts.gamma(view(std::as_const(u)), {p.gammaA.data(), 2});
    p.gammaFree = p.gammaA, p.uRef = 1.0;
    VectorXd Lambda = VectorXd::Zero(2);
    LemkeSolver lemke;
    EXPECT_TRUE(NewtonImpact().solve(p, lemke, view(Lambda)).ok());
    x.G.addVelocity(Lambda.data(), view(u));
    // Λ = G⁻¹(1 + ε, 0) = (1 + ε)(2/3, 1/3).
    const VectorXd expected{
        {1.0 - (1.0 + epsilon) * 2.0 / 3.0, (1.0 + epsilon) / 3.0, (1.0 + epsilon) / 3.0}};
    EXPECT_LE((u - expected).norm(), 1e-14) << epsilon;
  }
}

}  // namespace
}  // namespace dynamy
