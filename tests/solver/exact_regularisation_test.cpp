// Three derivations of one scheme: exact regularisation, augmented Lagrangian, uncoupling; and the
// common steps r of the book.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <dynamy/solver/proximal_newton.hpp>

#include "unit/solver/inclusion_fixture.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr unsigned kRegularisationSeed = 12;

/// Λ = prox_C(−r x): the law with a spring of stiffness r in series, deflected by x.
VectorXd regularised(const InclusionProblem& p, double r, const VectorXd& x) {
  VectorXd Lambda = VectorXd::Zero(p.rows());
  const VectorXd steps = VectorXd::Constant(p.rows(), r);
  for (int i = 0; i < p.size(); ++i)
    p.law(i).prox(p.input(i), steps.data(), x.data() + p.row0(i), Lambda.data() + p.row0(i));
  return Lambda;
}

/// Contacts with discs, intervals, without friction, and a joint.
class ExactRegularisation : public ::testing::Test {
 protected:
  ExactRegularisation() {
    std::mt19937 random(kRegularisationSeed);
    x_.contact(coulomb_, fixture::randomMatrix(random, 3, 14));
    x_.contact(coulomb_, fixture::randomMatrix(random, 2, 14));
    x_.contact(smooth_, fixture::randomMatrix(random, 1, 14));
    x_.contact(joint_, fixture::randomMatrix(random, 2, 14));
    x_.contact(given_, fixture::randomMatrix(random, 2, 14));
    VectorXd c = fixture::randomMatrix(random, 10, 1);
    c[0] = c[3] = c[5] = -1.0;
    p_ = &x_.pose(c);
    G_ = x_.dense(), c_ = c;
    Lambda_ = VectorXd::Zero(10);
    ProximalNewtonOptions options;
    options.tolerance = 1e-13;
    EXPECT_TRUE(ProximalNewton(options).solve(*p_, view(Lambda_)).ok());
    xi_ = G_ * Lambda_ + c_;
  }
  UnilateralCoulomb coulomb_{0.0, 0.0, 0.4};
  Unilateral smooth_;
  Bilateral joint_;
  GivenFriction given_{0.3, 0.3};
  fixture::Inclusion x_{std::vector<MatrixXd>{MatrixXd::Identity(14, 14)}};
  InclusionProblem* p_ = nullptr;
  MatrixXd G_;
  VectorXd c_, Lambda_, xi_;
};

TEST_F(ExactRegularisation, CompensatedDeflectionGivesTheLawForEveryStiffness) {
  // x = ξ − Λ/r: the spring's own deflection is taken back.
  for (const double r : {1e-3, 0.1, 1.0, 10.0, 1e3})
    EXPECT_LE((regularised(*p_, r, xi_ - Lambda_ / r) - Lambda_).norm(), 1e-11 * (1.0 + r)) << r;
}

TEST_F(ExactRegularisation, WithoutCompensationTheErrorFallsWithTheStiffness) {
  // x = ξ: (G + 1/r)Λ + c, the law with a compliance. First order in 1/r.
  double last = 0.0;
  for (const double r : {1e3, 1e4, 1e5}) {
    VectorXd Lambda = Lambda_;
    // Newton on Λ = prox(−r (GΛ + c)) by plain substitution in G: damped fixed point of the
    // compensated form of G + 1/r.
    const MatrixXd soft = G_ + MatrixXd::Identity(10, 10) / r;
    const double step = 1.0 / soft.rowwise().lpNorm<1>().maxCoeff();
    for (int k = 0; k < 200000; ++k) {
      const VectorXd next = regularised(*p_, step, soft * Lambda + c_ - Lambda / step);
      const double change = (next - Lambda).norm();
      Lambda = next;
      if (change < 1e-15) break;
    }
    EXPECT_LE((regularised(*p_, r, G_ * Lambda + c_) - Lambda).norm(), 1e-9 * r / 1e3);
    const double error = (G_ * (Lambda - Lambda_)).norm();
    if (last > 0.0) {
      EXPECT_NEAR(last / error, 10.0, 0.5) << r;
    }
    last = error;
  }
}

/// L(u, Λ) = ½(u − u_f)ᵀM(u − u_f) + Σ (|x|² − dist²_C(x) − |Λ|²)/(2r), x = Λ − r ξ(u), for one
/// contact without friction and one friction interval of fixed size.
struct Lagrangian {
  Eigen::Matrix2d M{{2.0, 0.3}, {0.3, 1.0}};
  Eigen::Matrix2d W{{1.0, 0.2}, {0.5, 1.0}};
  Eigen::Vector2d uFree{-1.0, 3.0}, r{0.7, 0.2};
  static Eigen::Vector2d prox(const Eigen::Vector2d& x) {
    return {std::max(x[0], 0.0), std::clamp(x[1], -0.6, 0.6)};
  }
  double operator()(const Eigen::Vector2d& u, const Eigen::Vector2d& Lambda) const {
    const Eigen::Vector2d d = u - uFree, x = Lambda - r.cwiseProduct(W.transpose() * u),
                          away = x - prox(x);
    double value = 0.5 * d.dot(M * d);
    for (int i = 0; i < 2; ++i)
      value += (x[i] * x[i] - away[i] * away[i] - Lambda[i] * Lambda[i]) / (2.0 * r[i]);
    return value;
  }
};

TEST(AugmentedLagrangian, HasTheProxEquationsAsItsGradient) {
  const Lagrangian L;
  const Eigen::Vector2d u(0.4, 0.7), Lambda(0.9, -0.3);
  const Eigen::Vector2d x = Lambda - L.r.cwiseProduct(L.W.transpose() * u);
  const Eigen::Vector2d byU = L.M * (u - L.uFree) - L.W * Lagrangian::prox(x),
                        byLambda = (Lagrangian::prox(x) - Lambda).cwiseQuotient(L.r);
  constexpr double h = 1e-6;  // central differences of a quadratic: rounding, 1e-16/h
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector2d e = h * Eigen::Vector2d::Unit(i);
    EXPECT_NEAR((L(u + e, Lambda) - L(u - e, Lambda)) / (2.0 * h), byU[i], 1e-8);
    EXPECT_NEAR((L(u, Lambda + e) - L(u, Lambda - e)) / (2.0 * h), byLambda[i], 1e-8);
  }
}

TEST(AugmentedLagrangian, HasItsSaddleWhereTheInclusionIsSolved) {
  const Lagrangian L;
  const Unilateral contact;
  const GivenFriction friction(0.6, 0.6);
  fixture::Inclusion x(std::vector<MatrixXd>{L.M});
  x.contact(contact, L.W.transpose().row(0));
  x.contact(friction, L.W.transpose().row(1));
  const VectorXd c = L.W.transpose() * L.uFree;
  VectorXd Lambda = VectorXd::Zero(2);
  ASSERT_TRUE(ProximalNewton().solve(x.pose(c), view(Lambda)).ok());
  const Eigen::Vector2d at = Lambda, u = L.uFree + L.M.inverse() * L.W * at;
  std::mt19937 random(kRegularisationSeed);
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Vector2d d = 0.3 * fixture::randomMatrix(random, 2, 1);
    EXPECT_GE(L(u + d, at), L(u, at) - 1e-9);  // minimum in u
    EXPECT_LE(L(u, at + d), L(u, at) + 1e-9);  // maximum in Λ
  }
}

TEST(Uncoupling, GivesTheExactLocalSolutionWithTheInverseDiagonal) {
  // G_ii Λ + s, any start: one prox with r = 1/G_ii, another r takes more.
  const double G = 2.5, s = -1.7;
  for (const double start : {0.0, 3.0, 100.0})
    EXPECT_NEAR(std::max(0.0, start - (G * start + s) / G), -s / G, 1e-13);
}

TEST(Relaxation, OptimalIsTheFastestCommonStep) {
  // r = 2/(λ_min + λ_max): 1/2 for [2 1; 1 2] with 1 and 3.
  const Bilateral law;
  fixture::Inclusion x(fixture::symmetricRoot(MatrixXd{{2.0, 1.0}, {1.0, 2.0}}), law);
  std::vector<double> r;
  relaxation(x.pose(VectorXd::Ones(2)), Relaxation::optimal, 1.0, r);
  // Power iteration stops at 1e-6 of λ.
  EXPECT_NEAR(r[0], 0.5, 1e-5);
  EXPECT_EQ(r[0], r[1]);
}

TEST(Relaxation, OptimalStaysBelowTheLimitOnASingularMatrix) {
  const Unilateral law;
  fixture::Inclusion x(MatrixXd::Ones(3, 1), law);
  InclusionProblem& p = x.pose(VectorXd::Constant(3, -1.0));
  std::vector<double> r;
  relaxation(p, Relaxation::optimal, 1.0, r);
  EXPECT_NEAR(r[0], 1.9 / 3.0, 1e-6);
  VectorXd Lambda = VectorXd::Zero(3);
  EXPECT_TRUE(ProxJacobi({1e-10, 10000, Relaxation::optimal, 1.0}).solve(p, view(Lambda)).ok());
}

}  // namespace
}  // namespace dynamy
