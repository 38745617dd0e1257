// Closed forms of one contact against an oracle that scans the direction of slip: no line and no
// formula is shared (the solver looks for the size of the slip velocity, the oracle for its angle).
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/solver/local/local_solution.hpp>
#include <iostream>
#include <numbers>
#include <random>

namespace dynamy {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr unsigned kLocalSeed = 2024;
using SetShape = SimpleSet::Shape;

struct Problem {
  MatrixXd D;
  VectorXd b;
  double mu;
};
struct Answer {
  LocalReport report;
  VectorXd Lambda;
};

SimpleSet cone(double mu) { return {SetShape::friction, 0.0, mu}; }

LocalSolutions prepared(const MatrixXd& D, const SimpleSet& set) {
  const RowMatrix rows = D;
  LocalSolutions local;
  local.add(rows.data(), static_cast<int>(D.rows()), set);
  return local;
}
Answer first(const Problem& p) {
  Answer out{{}, VectorXd::Zero(p.b.size())};
  out.report = prepared(p.D, cone(p.mu)).solve(0, p.b.data(), out.Lambda.data());
  return out;
}
std::vector<Answer> all(const Problem& p) {
  LocalReport reports[LocalSolutions::kMaxSolutions];
  double Lambda[3 * LocalSolutions::kMaxSolutions];
  const int n = prepared(p.D, cone(p.mu)).all(0, p.b.data(), reports, Lambda);
  std::vector<Answer> out;
  for (int i = 0; i < n; ++i)
    out.push_back({reports[i], Eigen::Map<VectorXd>(Lambda + i * p.b.size(), p.b.size())});
  return out;
}

/// How far Λ is from the law, each condition over the size of its own terms.
double violation(const Problem& p, const VectorXd& L) {
  const VectorXd xi = p.D * L + p.b, size = p.D.cwiseAbs() * L.cwiseAbs() + p.b.cwiseAbs() +
                                            VectorXd::Constant(p.b.size(), 1e-300);
  const int k = static_cast<int>(L.size()) - 1;
  const double N = L[0], T = L.tail(k).norm(), slip = xi.tail(k).norm(), allT = size.tail(k).norm(),
               scale = p.b.norm() / p.D.norm();
  double worst = std::max(0.0, -N / scale);
  worst = std::max(worst, std::max(0.0, -xi[0] / size[0]));
  if (N > 0.0) worst = std::max(worst, std::abs(xi[0]) / size[0]);
  if (N > 0.0) worst = std::max(worst, (T - p.mu * N) / (p.mu * N + 1e-300));
  // Slips: ξ_T against Λ_T, and Λ_T on the circle.
  if (slip > 1e-9 * allT && N > 0.0 && p.mu > 0.0) {
    worst = std::max(worst, (xi.tail(k) / slip + L.tail(k) / (p.mu * N)).norm() * slip / allT);
  }
  return worst;
}

/// Directions e of slip: ξ_N = 0 gives Λ = N (1, μe), N = −b_N/(D_NN + μ D_NT e); then ξ_T ∥ −e.
std::vector<VectorXd> scannedSlips(const Problem& p, int steps) {
  std::vector<VectorXd> out;
  const auto lambda = [&](double phi, double& across, double& along) {
    const Vector2d e(std::cos(phi), std::sin(phi));
    Vector3d direction(1.0, p.mu * e[0], p.mu * e[1]);
    const double stiffness = p.D.row(0) * direction;
    const Vector2d velocity =
        (-p.b[0] * (p.D * direction) + stiffness * p.b).tail<2>();  // times stiffness
    across = velocity[0] * e[1] - velocity[1] * e[0];
    along = velocity.dot(e) / stiffness;
    return VectorXd(direction * (-p.b[0] / stiffness));
  };
  const double step = 2.0 * std::numbers::pi / steps;
  double before, after, along;
  lambda(0.0, before, along);
  for (int k = 0; k < steps; ++k, before = after) {
    lambda((k + 1) * step, after, along);
    if ((before > 0.0) == (after > 0.0)) continue;
    double low = k * step, high = (k + 1) * step, value;
    for (int it = 0; it < 60; ++it) {
      const double middle = 0.5 * (low + high);
      lambda(middle, value, along);
      ((value > 0.0) == (before > 0.0) ? low : high) = middle;
    }
    const VectorXd L = lambda(0.5 * (low + high), value, along);
    if (L.allFinite() && L[0] > 0.0 && along < 0.0) out.push_back(L);
  }
  return out;
}

std::vector<VectorXd> oracle(const Problem& p, int steps = 4000) {
  std::vector<VectorXd> out;
  const Eigen::Index n = p.b.size();
  if (p.b[0] >= 0.0) out.push_back(VectorXd::Zero(n));
  const VectorXd stick = -p.D.fullPivLu().solve(p.b);
  if (stick[0] > 0.0 && stick.tail(n - 1).norm() <= p.mu * stick[0]) out.push_back(stick);
  if (n == 3) {
    for (const VectorXd& L : scannedSlips(p, steps)) out.push_back(L);
  } else {
    for (const double e : {1.0, -1.0}) {
      const Vector2d direction(1.0, p.mu * e);
      const VectorXd L = direction * (-p.b[0] / (p.D.row(0) * direction));
      if (L[0] > 0.0 && e * (p.D * L + p.b)[1] < 0.0) out.push_back(L);
    }
  }
  return out;
}

double distance(const VectorXd& a, const VectorXd& b) {
  return (a - b).norm() / std::max({a.norm(), b.norm(), 1e-300});
}

struct Randoms {
  std::mt19937 random;
  std::normal_distribution<double> normal = {};
  double operator()() { return normal(random); }
  double logUniform(double low, double high) {
    std::uniform_real_distribution<double> x(std::log(low), std::log(high));
    return std::exp(x(random));
  }
  MatrixXd matrix(int n, int m) {
    MatrixXd A(n, m);
    for (double& x : A.reshaped()) x = normal(random);
    return A;
  }
  /// SSᵀ plus an unsymmetric part of relative size `skew`.
  Problem problem(int n, double skew) {
    const MatrixXd S = matrix(n, n + 2), A = matrix(n, n);
    Problem p{S * S.transpose(), matrix(n, 1), logUniform(0.05, 3.0)};
    p.D += skew * (A - A.transpose());
    return p;
  }
};

/// Compares with the oracle; counts how often there were several solutions or none.
void compare(const Problem& p, int instance, int& several, int& none) {
  const std::vector<Answer> answers = all(p);
  const std::vector<VectorXd> truth = oracle(p);
  // Both sides sum a few products; close roots multiply the rounding, which 1e-7 covers.
  for (const Answer& x : answers) {
    EXPECT_LE(violation(p, x.Lambda), 1e-9)
        << instance << ": case " << static_cast<int>(x.report.found) << ", a " << x.report.a
        << "\nD\n"
        << p.D << "\nb " << p.b.transpose() << " mu " << p.mu;
  }
  for (std::size_t i = 0; i < truth.size(); ++i) {
    double nearest = 1e300, twin = 1e300;
    for (const Answer& x : answers) nearest = std::min(nearest, distance(x.Lambda, truth[i]));
    for (std::size_t j = 0; j < truth.size(); ++j)
      if (j != i) twin = std::min(twin, distance(truth[i], truth[j]));
    if (twin < 1e-3) continue;  // nearly a double root: either, both or none may be found
    EXPECT_LE(nearest, 1e-6) << instance << ": missed " << truth[i].transpose() << "\nD\n"
                             << p.D << "\nb " << p.b.transpose() << " mu " << p.mu;
  }
  several += answers.size() > 1, none += answers.empty();
  // The one that is chosen: take-off, stick, smallest a.
  const Answer chosen = first(p);
  if (answers.empty()) {
    EXPECT_EQ(chosen.report.found, LocalCase::noSolution);
  } else {
    EXPECT_EQ(chosen.report.found, answers[0].report.found);
    EXPECT_EQ(chosen.Lambda, answers[0].Lambda);
    for (const Answer& x : answers) EXPECT_GE(x.report.a, 0.0);
    for (std::size_t i = 1; i < answers.size(); ++i)
      EXPECT_LE(answers[i - 1].report.a, answers[i].report.a) << instance;
  }
}

TEST(LocalSolution, IsThatOfTheOracleForSymmetricBlocks) {
  Randoms random{std::mt19937(kLocalSeed)};
  std::cout << "seed " << kLocalSeed << '\n';
  int several = 0, none = 0;
  for (int i = 0; i < 4000; ++i) compare(random.problem(i % 4 == 0 ? 2 : 3, 0.0), i, several, none);
  EXPECT_EQ(none, 0) << "a positive definite block has a solution for every b";
  EXPECT_GT(several, 10);
}

TEST(LocalSolution, IsThatOfTheOracleForUnsymmetricBlocks) {
  Randoms random{std::mt19937(kLocalSeed + 1)};
  std::cout << "seed " << kLocalSeed + 1 << '\n';
  int several = 0, none = 0;
  for (int i = 0; i < 4000; ++i) {
    Problem p = random.problem(i % 4 == 0 ? 2 : 3, random.logUniform(0.1, 5.0));
    compare(p, i, several, none);
  }
  EXPECT_GT(several, 10);
}

TEST(LocalSolution, IsThatOfTheOracleNearAJam) {
  // μ|D_NT| from 0.9 to 1.1 of D_NN, with b both ways.
  Randoms random{std::mt19937(kLocalSeed + 2)};
  std::cout << "seed " << kLocalSeed + 2 << '\n';
  int several = 0, none = 0;
  for (int i = 0; i < 4000; ++i) {
    Problem p = random.problem(i % 4 == 0 ? 2 : 3, i % 2 ? 0.5 : 0.0);
    const double across = p.D.row(0).tail(p.b.size() - 1).norm();
    p.mu = (0.9 + 0.2 * (i % 100) / 99.0) * p.D(0, 0) / across;
    compare(p, i, several, none);
  }
  EXPECT_GT(several, 5);
}

TEST(LocalSolution, DoesNotDependOnUnits) {
  // Powers of two scale every operation without rounding: [D] = 1/kg, [b] = m/s.
  Randoms random{std::mt19937(kLocalSeed + 3)};
  std::cout << "seed " << kLocalSeed + 3 << '\n';
  for (int i = 0; i < 4000; ++i) {
    const Problem p = random.problem(i % 4 == 0 ? 2 : 3, i % 3 == 0 ? 0.7 : 0.0);
    const Answer one = first(p);
    const int mass = i % 80 - 40, speed = i % 74 - 37;  // 1e-12 … 1e12
    const Problem other{std::ldexp(1.0, -mass) * p.D, std::ldexp(1.0, speed) * p.b, p.mu};
    const Answer scaled = first(other);
    EXPECT_EQ(one.report.found, scaled.report.found) << i;
    EXPECT_EQ(std::ldexp(1.0, mass + speed) * one.Lambda, scaled.Lambda) << i;
  }
}

TEST(LocalSolution, HoldsAtExtremeRatios) {
  // Rows of D from 1e-6 to 1e6, b from 1e-12 to 1e12: the oracle would need as many angles.
  Randoms random{std::mt19937(kLocalSeed + 4)};
  std::cout << "seed " << kLocalSeed + 4 << '\n';
  for (int i = 0; i < 20000; ++i) {
    Problem p = random.problem(3, 0.0);
    const double tangent = random.logUniform(1e-3, 1e3);
    const Vector3d row(1.0, tangent, i % 2 ? tangent : tangent * random.logUniform(1e-2, 1e2));
    p.D = row.asDiagonal() * p.D * row.asDiagonal();
    for (double& x : p.b) x *= random.logUniform(1e-12, 1e12);
    const Answer x = first(p);
    ASSERT_NE(x.report.found, LocalCase::noSolution);
    EXPECT_LE(violation(p, x.Lambda), 1e-9) << i << "\nD\n" << p.D << "\nb " << p.b.transpose();
  }
}

TEST(LocalSolution, FindsStickAndSlipOfAPlanarJam) {
  // D = [1 −2; −2 5], b = (1, −3), μ = 1: take-off; stick −D⁻¹b = (1, 1); slip Λ_N(1 − 2) = −1:
  // Λ = (1, 1), the same point on the edge. With b_T = −3.5: stick (2, 1.5), slip (1, 1), ξ_T =
  // −0.5.
  const Problem p{MatrixXd{{1.0, -2.0}, {-2.0, 5.0}}, VectorXd{{1.0, -3.5}}, 1.0};
  const std::vector<Answer> x = all(p);
  ASSERT_EQ(x.size(), 3u);
  EXPECT_EQ(x[0].report.found, LocalCase::takeOff);
  EXPECT_EQ(x[1].report.found, LocalCase::stick);
  EXPECT_LT(distance(x[1].Lambda, VectorXd{{2.0, 1.5}}), 1e-14);
  EXPECT_EQ(x[2].report.found, LocalCase::slip);
  EXPECT_LT(distance(x[2].Lambda, VectorXd{{1.0, 1.0}}), 1e-14);
  EXPECT_NEAR(x[2].report.a, 0.5, 1e-14);
}

TEST(LocalSolution, SaysThatThereIsNone) {
  // b_N < 0: no take-off. D̂ = −1: stick has Λ_T = b_T = −1, Λ_N = 1 + 3 Λ_T < 0. Slip with e = 1:
  // Λ_N (1 − 1.5) = 1, pulls; e = −1: Λ = (0.4, −0.2), ξ_T = 0.2 − 1 < 0 along Λ_T.
  const Problem p{MatrixXd{{1.0, -3.0}, {0.0, -1.0}}, VectorXd{{-1.0, -1.0}}, 0.5};
  EXPECT_TRUE(oracle(p).empty());
  VectorXd Lambda = VectorXd::Constant(2, 7.0);
  const LocalReport report = prepared(p.D, cone(p.mu)).solve(0, p.b.data(), Lambda.data());
  EXPECT_EQ(report.found, LocalCase::noSolution);
  EXPECT_EQ(Lambda, VectorXd::Constant(2, 7.0)) << "left as it is";
}

TEST(LocalSolution, SticksWithTheShortestForceWhereATangentHasNoInertia) {
  const Problem p{Vector3d(2.0, 4.0, 0.0).asDiagonal().toDenseMatrix(), Vector3d(-2.0, 1.0, 0.0),
                  0.5};
  const Answer x = first(p);
  EXPECT_EQ(x.report.found, LocalCase::stick);
  EXPECT_EQ(x.Lambda, VectorXd(Vector3d(1.0, -0.25, 0.0)));
  // Driven along the free tangent: slip, Λ_T on the circle.
  const Problem driven{p.D, Vector3d(-2.0, 1.0, 1.0), 0.5};
  EXPECT_LE(violation(driven, first(driven).Lambda), 1e-12);
  // No tangent has any: the force only opposes the motion.
  const Problem free{Vector3d(2.0, 0.0, 0.0).asDiagonal().toDenseMatrix(), Vector3d(-2.0, 3.0, 4.0),
                     0.5};
  EXPECT_LT(distance(first(free).Lambda, Vector3d(1.0, -0.3, -0.4)), 1e-15);
}

TEST(LocalSolution, OfFixedSetsIsTheirProjection) {
  Randoms random{std::mt19937(kLocalSeed + 5)};
  std::cout << "seed " << kLocalSeed + 5 << '\n';
  for (int i = 0; i < 4000; ++i) {
    Problem p = random.problem(2, 0.0);
    const double radius = random.logUniform(1e-3, 10.0);
    Vector2d L;
    const LocalReport report =
        prepared(p.D, {SetShape::ball, 0.0, radius}).solve(0, p.b.data(), L.data());
    ASSERT_NE(report.found, LocalCase::notSimple);
    // −ξ ∈ N(Λ): ξ = 0 inside, ξ = −aΛ with a ≥ 0 on the circle.
    const Vector2d xi = p.D * L + p.b;
    const double size = p.b.norm();
    EXPECT_LE(L.norm(), radius * (1.0 + 1e-14));
    EXPECT_LE((xi + report.a * L).norm(), 1e-12 * size) << i;
    EXPECT_GE(report.a, 0.0);
    if (report.a > 0.0) {
      EXPECT_NEAR(L.norm(), radius, 1e-14 * radius);
    }
  }
  double Lambda = 0.0;
  const double b = -6.0;
  const LocalSolutions limit =
      prepared(MatrixXd::Constant(1, 1, 2.0), {SetShape::interval, -1.0, 2.0});
  EXPECT_EQ(limit.solve(0, &b, &Lambda).found, LocalCase::slip);
  EXPECT_EQ(Lambda, 2.0);
  const double small = -1.0;
  EXPECT_EQ(limit.solve(0, &small, &Lambda).found, LocalCase::stick);
  EXPECT_EQ(Lambda, 0.5);
}

TEST(LocalSolution, OfAJointIsItsInverse) {
  Randoms random{std::mt19937(kLocalSeed + 6)};
  std::cout << "seed " << kLocalSeed + 6 << '\n';
  for (const int n : {1, 2, 3, 5, 6}) {
    const Problem p = random.problem(n, 0.3);
    VectorXd L(n);
    EXPECT_EQ(prepared(p.D, {SetShape::all}).solve(0, p.b.data(), L.data()).found,
              LocalCase::stick);
    EXPECT_LT((p.D * L + p.b).norm(), 1e-12 * p.D.norm() * L.norm());
  }
  const MatrixXd redundant = MatrixXd::Ones(2, 2);
  EXPECT_FALSE(prepared(redundant, {SetShape::all}).simple(0));
}

}  // namespace
}  // namespace dynamy
