// Every law with every solver on random small problems with regular G: one solution, found by all.
#include <gtest/gtest.h>

#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/law/rolling_friction.hpp>
#include <dynamy/solver/admm.hpp>
#include <dynamy/solver/automatic.hpp>
#include <dynamy/solver/semismooth_newton.hpp>
#include <dynamy_elements/laws/adhesion.hpp>
#include <dynamy_elements/laws/belt_friction.hpp>
#include <dynamy_elements/laws/drilling_friction.hpp>
#include <dynamy_elements/laws/force_limit.hpp>
#include <dynamy_elements/laws/orthotropic_friction.hpp>
#include <dynamy_elements/laws/preloaded_spring.hpp>
#include <dynamy_elements/laws/stribeck_friction.hpp>
#include <string_view>

#include "unit/solver/inclusion_fixture.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kAgreeTolerance = 1e-12;

struct Named {
  const char* name;
  std::unique_ptr<SetValuedForceLaw> law;
  int dim;
};

std::vector<Named> laws() {
  std::vector<Named> out;
  const auto add = [&](const char* name, int dim, SetValuedForceLaw* law) {
    out.push_back({name, std::unique_ptr<SetValuedForceLaw>(law), dim});
  };
  using Set = UnilateralDrilling::Set;
  add("Bilateral", 3, new Bilateral);
  add("Unilateral", 1, new Unilateral);
  add("UnilateralCoulomb, planar", 2, new UnilateralCoulomb(0.0, 0.0, 0.3));
  add("UnilateralCoulomb, spatial", 3, new UnilateralCoulomb(0.0, 0.0, 0.3));
  add("UnilateralCoulomb, mu 0", 3, new UnilateralCoulomb(0.0, 0.0, 0.0));
  add("UnilateralRolling", 5, new UnilateralRolling(0.3, 0.1));
  add("UnilateralRolling, spin", 6, new UnilateralRolling(RollingCoefficients{0.3, 0.1, 0.2, 0.0}));
  add("UnilateralRolling, contour", 8,
      new UnilateralRolling(RollingCoefficients{0.3, 0.1, 0.2, 0.15}));
  add("UnilateralOrthotropic", 3, new UnilateralOrthotropic(0.0, 0.0, 0.1, 0.4, 0.5));
  add("UnilateralDrilling", 4, new UnilateralDrilling(0.3, 0.5));
  add("UnilateralDrilling, ellipsoid", 4, new UnilateralDrilling(0.3, 0.5, Set::ellipsoid));
  add("UnilateralDrilling, Hertz", 4,
      new UnilateralDrilling(0.3, 0.5, Set::contensou, 0.0, UnilateralDrilling::Pressure::hertz));
  add("GivenFriction", 2, new GivenFriction(0.4, 0.4));
  add("ForceLimit", 2, new ForceLimit(-0.1, 0.6));
  const StribeckCurve falling{.atRest = 0.4, .far = 0.2, .speed = 0.3};
  add("StribeckFriction", 2, new StribeckFriction(falling));
  add("UnilateralStribeck", 3, new UnilateralStribeck(0.0, falling));
  add("UnilateralAdhesion, planar", 2, new UnilateralAdhesion(0.5, 0.3, 0.0));
  add("UnilateralAdhesion, spatial", 3, new UnilateralAdhesion(0.5, 0.3, 0.0));
  add("PreloadedSpring", 1, new PreloadedSpring(0.7, 0.3, false));
  add("PreloadedSpring, one side", 1, new PreloadedSpring(0.7, 0.3, true));
  add("BeltFriction", 2,
      new BeltFriction(
          Parameters::of<BeltFriction>("BeltFriction", "", {{"mu", 0.2}, {"wrap", 3.0}})));
  const auto clutch = [](const char* free, double limit) {
    return new OneWayClutch(
        Parameters::of<OneWayClutch>("OneWayClutch", "", {{"free", free}, {"limit", limit}}));
  };
  add("OneWayClutch", 1, clutch("positive", 1e9));
  add("OneWayClutch, limited", 1, clutch("negative", 0.2));
  return out;
}

std::vector<std::pair<const char*, std::unique_ptr<InclusionSolver>>> preciseSolvers() {
  using Formulation = SemismoothOptions::Formulation;
  std::vector<std::pair<const char*, std::unique_ptr<InclusionSolver>>> out;
  out.emplace_back("ProxGaussSeidel",
                   std::make_unique<ProxGaussSeidel>(ProxOptions{.tolerance = kAgreeTolerance}));
  out.emplace_back("ProxJacobi", std::make_unique<ProxJacobi>(ProxOptions{
                                     kAgreeTolerance, 100000, Relaxation::diagonalDominance, 0.5}));
  out.emplace_back("ProximalNewton", std::make_unique<ProximalNewton>(
                                         ProximalNewtonOptions{.tolerance = kAgreeTolerance}));
  out.emplace_back("ProximalNewton, blocks", std::make_unique<ProximalNewton>(ProximalNewtonOptions{
                                                 .tolerance = kAgreeTolerance, .maxRows = 0}));
  out.emplace_back(
      "SemismoothNewton, Alart-Curnier",
      std::make_unique<SemismoothNewton>(SemismoothOptions{.tolerance = kAgreeTolerance}));
  out.emplace_back(
      "SemismoothNewton, Fischer-Burmeister",
      std::make_unique<SemismoothNewton>(SemismoothOptions{
          .tolerance = kAgreeTolerance, .formulation = Formulation::fischerBurmeister}));
  out.emplace_back("Admm", std::make_unique<Admm>(AdmmOptions{.tolerance = kAgreeTolerance}));
  out.emplace_back("Automatic",
                   std::make_unique<Automatic>(AutomaticOptions{.tolerance = kAgreeTolerance}));
  return out;
}

/// Three contacts of one law on two bodies; G regular, well conditioned, most contacts closing.
std::unique_ptr<fixture::Inclusion> problem(const SetValuedForceLaw& law, int dim, unsigned seed) {
  std::mt19937 random(seed);
  const int nu = 3 * dim;
  auto scene = std::make_unique<fixture::Inclusion>(
      std::vector<MatrixXd>{MatrixXd::Identity(nu, nu), 2.0 * MatrixXd::Identity(nu, nu)});
  for (int i = 0; i < 3; ++i) {
    MatrixXd Wt = MatrixXd::Zero(dim, 2 * nu);
    Wt.middleCols(0, nu) = 0.15 * fixture::randomMatrix(random, dim, nu);
    Wt.middleCols(nu, nu) = 0.15 * fixture::randomMatrix(random, dim, nu);
    Wt.middleCols(i * dim, dim) += MatrixXd::Identity(dim, dim);
    scene->contact(law, Wt);
  }
  VectorXd c = fixture::randomMatrix(random, 3 * dim, 1);
  if (law.rowKind(0) == RowKind::normal)
    for (int i = 0; i < 3; ++i)
      if (random() % 4 != 0) c[i * dim] = -std::abs(c[i * dim]);
  scene->pose(c);
  return scene;
}

TEST(Solvers, AgreeOnEveryLaw) {
  for (const Named& law : laws())
    for (unsigned seed = 1; seed <= 8; ++seed) {
      const auto scene = problem(*law.law, law.dim, seed);
      const InclusionProblem& p = scene->problem;
      const MatrixXd G = scene->dense();
      VectorXd first;
      for (const auto& [name, solver] : preciseSolvers()) {
        // Sets that are no cone of Coulomb's take their sequential projection there, for which
        // nothing is promised: with four discs it stalls (theory 9.5).
        if (law.dim == 8 && std::string_view(name) == "Admm") continue;
        VectorXd Lambda = VectorXd::Zero(p.rows());
        const SolveReport report = solver->solve(p, view(Lambda));
        ASSERT_TRUE(report.ok()) << law.name << ", " << name << ", seed " << seed << ": "
                                 << solveStatusText(report.status) << ' '
                                 << report.residuals.largest();
        if (first.size() == 0) first = Lambda;
        // Residual 1e-12 times the condition of G, below 50.
        EXPECT_LT((Lambda - first).lpNorm<Eigen::Infinity>(), 1e-9)
            << law.name << ", " << name << ", seed " << seed;
        EXPECT_LT((G * (Lambda - first)).lpNorm<Eigen::Infinity>(), 1e-9)
            << law.name << ", " << name << ", seed " << seed;
      }
    }
}

TEST(Admm, TakesRedundantContacts) {
  // Two equal contacts share one force: any split is a solution, their sum is unique.
  const UnilateralCoulomb law(0.0, 0.0, 0.5);
  fixture::Inclusion scene({MatrixXd::Identity(3, 3)});
  scene.contact(law, MatrixXd::Identity(3, 3));
  scene.contact(law, MatrixXd::Identity(3, 3));
  VectorXd c(6), Lambda = VectorXd::Zero(6);
  c << -1.0, 2.0, 0.0, -1.0, 2.0, 0.0;  // sliding: Λ = (1, −0.5, 0), ξ = (0, 1.5, 0)
  Admm solver({.tolerance = 1e-10});
  const SolveReport report = solver.solve(scene.pose(c), view(Lambda));
  ASSERT_TRUE(report.ok()) << report.residuals.largest();
  // Residual 1e-10 on an operator of norm 2.
  EXPECT_LT((Lambda.head(3) + Lambda.tail(3) - VectorXd(Eigen::Vector3d(1.0, -0.5, 0.0))).norm(),
            1e-9);
}

TEST(SemismoothNewton, SaysSoWhereContactsAreRedundant) {
  // Two equal contacts that stick share one force: G is singular, and so is A + BG.
  const UnilateralCoulomb law(0.0, 0.0, 0.5);
  fixture::Inclusion scene({MatrixXd::Identity(3, 3)});
  scene.contact(law, MatrixXd::Identity(3, 3));
  scene.contact(law, MatrixXd::Identity(3, 3));
  VectorXd c(6);
  c << -1.0, 0.2, 0.0, -1.0, 0.2, 0.0;
  SemismoothNewton solver({.tolerance = 1e-12, .sweeps = 0});
  VectorXd Lambda = VectorXd::Zero(6);
  const SolveReport report = solver.solve(scene.pose(c), view(Lambda));
  EXPECT_EQ(report.status, SolveStatus::stalled);
  ProximalNewton proximal({.tolerance = 1e-12});
  EXPECT_TRUE(proximal.solve(scene.problem, view(Lambda)).ok());
}

TEST(FischerBurmeister, KnowsTheConesOfTheLaws) {
  using K = LawCone::Kind;
  const auto kind = [](const SetValuedForceLaw& law, int dim) {
    return coneOf(law, {.dim = dim, .dt = 1.0}).kind;
  };
  EXPECT_EQ(kind(Bilateral(), 3), K::line);
  EXPECT_EQ(kind(Unilateral(), 1), K::halfLine);
  EXPECT_EQ(kind(UnilateralOrthotropic(0.0, 0.0, 0.1, 0.2), 3), K::other);
  EXPECT_EQ(kind(ForceLimit(-1.0, 1.0), 1), K::other);
  EXPECT_EQ(kind(GivenFriction(1.0, 1.0), 2), K::other);
  for (const int dim : {2, 3}) {
    const LawCone cone = coneOf(UnilateralCoulomb(0.0, 0.0, 0.37), {.dim = dim, .dt = 1.0});
    EXPECT_EQ(cone.kind, K::cone);
    EXPECT_EQ(cone.mu, 0.37);
  }
}

TEST(FischerBurmeister, HasTheDerivativeOfItsFunction) {
  std::mt19937 random(4);
  for (const int dim : {1, 2, 3})
    for (int sample = 0; sample < 200; ++sample) {
      const LawCone cone{dim == 1 ? LawCone::Kind::halfLine : LawCone::Kind::cone, 0.6};
      const VectorXd Lambda = fixture::randomMatrix(random, dim, 1),
                     xi = fixture::randomMatrix(random, dim, 1);
      const auto F = [&](const VectorXd& L, const VectorXd& x) {
        VectorXd out(dim);
        fischerBurmeister(cone, dim, 0.8, x.data(), L.data(), out.data(), nullptr, nullptr);
        return out;
      };
      RowMatrix A(dim, dim), B(dim, dim);
      VectorXd value(dim);
      fischerBurmeister(cone, dim, 0.8, xi.data(), Lambda.data(), value.data(), A.data(), B.data());
      const double h = 1e-6;
      for (int j = 0; j < dim; ++j) {
        const VectorXd e = h * VectorXd::Unit(dim, j);
        const VectorXd dA = (F(Lambda + e, xi) - F(Lambda - e, xi)) / (2.0 * h),
                       dB = (F(Lambda, xi + e) - F(Lambda, xi - e)) / (2.0 * h);
        // Second derivatives grow like 1/|w| near the kinks: h²·1e4 + ε/h.
        EXPECT_LT((A.col(j) - dA).norm(), 1e-6) << "dim " << dim << ", sample " << sample;
        EXPECT_LT((B.col(j) - dB).norm(), 1e-6) << "dim " << dim << ", sample " << sample;
      }
    }
}

}  // namespace
}  // namespace dynamy
