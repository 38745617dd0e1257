// Force laws: projection, its derivative, status and natural map, against closed forms, against the
// inequality that defines a projection, and against differences.
#include <gtest/gtest.h>
#include <dynamy/law/standard_laws.hpp>

#include <cmath>
#include <dynamy/law/convex_sets.hpp>
#include <functional>
#include <random>
#include <vector>

namespace dynamy {
namespace {

constexpr unsigned kSeed = 20;

/// A reservoir known by its support function alone: ellipse with semi-axes a, b (times N).
class EllipseLaw final : public NormalTimesReservoir {
 public:
  EllipseLaw(double a, double b) : a_(a), b_(b) {}
  int dim(int geometric) const override { return geometric; }
  double support(const LawInput&, int, const double* y, double* gradient,
                 double* hessian) const override {
    const double A = a_ * a_, B = b_ * b_, S = std::sqrt(A * y[0] * y[0] + B * y[1] * y[1]);
    const double g[2] = {A * y[0] / S, B * y[1] / S};
    if (gradient) gradient[0] = g[0], gradient[1] = g[1];
    if (hessian) {
      hessian[0] = (A - g[0] * g[0]) / S;
      hessian[1] = hessian[2] = -g[0] * g[1] / S;
      hessian[3] = (B - g[1] * g[1]) / S;
    }
    return S;
  }

 private:
  double a_, b_;
};

LawInput input(int dim, double dt = 1.0, const double* gammaA = kZeroRows.data()) {
  return {.dim = dim, .dt = dt, .gammaA = gammaA};
}

TEST(Bilateral, LeavesTheArgumentAsItIs) {
  const double r[2] = {2.0, 2.0}, xi[2] = {0.5, -1.0};
  double Lambda[2] = {3.0, 4.0};
  Bilateral().prox(input(2), r, xi, Lambda);
  EXPECT_EQ(Lambda[0], 2.0);
  EXPECT_EQ(Lambda[1], 6.0);
}

TEST(Unilateral, CutsThePullingForce) {
  const double r = 1.0, closing = -2.0, opening = 2.0;
  double push = 0.0, pull = 1.0;
  const Unilateral law(0.5);
  law.prox(input(1), &r, &closing, &push);
  law.prox(input(1), &r, &opening, &pull);
  EXPECT_EQ(push, 2.0);
  EXPECT_EQ(pull, 0.0);
  double epsilon = 0.0;
  law.epsilon(1, &epsilon);
  EXPECT_EQ(epsilon, 0.5);
}

TEST(UnilateralCoulomb, CutsFrictionAtTheDiscOfTheNewNormalForce) {
  const UnilateralCoulomb law(0.0, 0.0, 0.5);
  const double r[3] = {1.0, 1.0, 1.0}, xi[3] = {-4.0, -3.0, -4.0};
  double Lambda[3] = {0.0, 0.0, 0.0};
  law.prox(input(3), r, xi, Lambda);
  EXPECT_EQ(Lambda[0], 4.0);
  // Radius 0.5 · 4 = 2 along (3, 4)/5; two roundings.
  EXPECT_NEAR(Lambda[1], 1.2, 1e-15);
  EXPECT_NEAR(Lambda[2], 1.6, 1e-15);
}

TEST(UnilateralCoulomb, GivesNoFrictionWithoutPressure) {
  const UnilateralCoulomb law(0.0, 0.0, 0.5);
  const double r[2] = {1.0, 1.0}, xi[2] = {1.0, -3.0};
  double Lambda[2] = {0.5, 0.2};
  law.prox(input(2), r, xi, Lambda);
  EXPECT_EQ(Lambda[0], 0.0);
  EXPECT_EQ(Lambda[1], 0.0);
}

TEST(UnilateralCoulomb, UsesTheMetricOfUnequalSteps) {
  // Stationarity of (z − x)ᵀR⁻¹(z − x) on the circle: R⁻¹(z − x) is parallel to x.
  const UnilateralCoulomb law(0.0, 0.0, 1.0);
  const double r[2] = {1.0, 5.0};
  double x[2] = {3.0, 4.0};
  law.project(input(3), 2.0, r, 2, x);
  const double cross = (3.0 - x[0]) / r[0] * x[1] - (4.0 - x[1]) / r[1] * x[0];
  EXPECT_NEAR(std::hypot(x[0], x[1]), 2.0, 1e-14);  // one scaling of a number of size 2
  EXPECT_NEAR(cross, 0.0, 1e-13);                   // numbers of size 10 times 1e-15 of the root
}

TEST(UnilateralCoulomb, TellsSeparatingStickAndSlipApart) {
  const UnilateralCoulomb law(0.0, 0.0, 0.5);
  const double separating[3] = {-1.0, 0.0, 0.0}, stick[3] = {2.0, 0.5, 0.5},
               slip[3] = {2.0, 1.0, 1.0};
  EXPECT_EQ(law.status(input(3), separating), Status::separating);
  EXPECT_EQ(law.status(input(3), stick), Status::stick);
  EXPECT_EQ(law.status(input(3), slip), Status::slip);
}

TEST(UnilateralCoulomb, HasANaturalMapThatVanishesAtSolutions) {
  const UnilateralCoulomb law(0.0, 0.0, 0.5);
  const double sliding[3] = {2.0, -0.6, -0.8}, xiSliding[3] = {0.0, 1.5, 2.0};
  const double sticking[3] = {2.0, 0.1, -0.3}, xiSticking[3] = {0.0, 0.0, 0.0};
  const double open[3] = {0.0, 0.0, 0.0}, xiOpen[3] = {1.0, 7.0, -2.0};
  double e[3];
  for (const auto& [Lambda, xi] :
       {std::pair{sliding, xiSliding}, std::pair{sticking, xiSticking}, std::pair{open, xiOpen}}) {
    law.naturalMap(input(3), 0.7, xi, Lambda, e);
    for (const double value : e) EXPECT_NEAR(value, 0.0, 1e-15);  // rounding of numbers of size 2
  }
}

TEST(UnilateralCoulomb, HasANaturalMapThatSeesAWrongSlidingDirection) {
  const UnilateralCoulomb law(0.0, 0.0, 0.5);
  const double Lambda[3] = {2.0, 0.6, 0.8}, xi[3] = {0.0, 1.5, 2.0};
  double e[3];
  law.naturalMap(input(3), 0.7, xi, Lambda, e);
  EXPECT_GT(std::hypot(e[0], e[1], e[2]), 0.1);
}

TEST(GivenFriction, TakesTheStaticForceAtRestAndTheKineticOneInMotion) {
  const GivenFriction law(3.0, 2.0);
  const double r = 1.0, xi = -10.0, atRest = 0.0, moving = 1.0;
  double held = 0.0, dragged = 0.0;
  law.prox(input(1, 0.1, &atRest), &r, &xi, &held);
  law.prox(input(1, 0.1, &moving), &r, &xi, &dragged);
  EXPECT_DOUBLE_EQ(held, 0.3);
  EXPECT_DOUBLE_EQ(dragged, 0.2);
}

TEST(GivenFriction, IsAbsentInAPureImpact) {
  const GivenFriction law(3.0, 2.0);
  const double r = 1.0, xi = -10.0;
  double Lambda = 1.0;
  law.prox(input(1, 0.0), &r, &xi, &Lambda);
  EXPECT_EQ(Lambda, 0.0);
}

// ---- properties of every prox ------------------------------------------------------------------

class EveryLaw : public ::testing::Test {
 protected:
  void forEach(const std::function<void(const SetValuedForceLaw&, int)>& check) {
    check(Bilateral(), 3);
    check(Unilateral(), 1);
    check(UnilateralCoulomb(0.0, 0.0, 0.4), 2);
    check(UnilateralCoulomb(0.0, 0.0, 0.4), 3);
    check(GivenFriction(1.0, 1.0), 2);
    check(EllipseLaw(0.8, 0.2), 3);
  }
  double number() { return std::normal_distribution<double>(0.0, 2.0)(random_); }
  std::mt19937 random_{kSeed};
};

TEST_F(EveryLaw, ProjectsTwiceAsOnce) {
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  forEach([this](const SetValuedForceLaw& law, int dim) {
    for (int trial = 0; trial < 500; ++trial) {
      const double r[3] = {0.5, 0.5, 0.5}, xi[3] = {number(), number(), number()}, zero[3] = {};
      double once[3] = {number(), number(), number()}, twice[3];
      law.prox(input(dim), r, xi, once);
      std::copy(once, once + 3, twice);
      law.prox(input(dim), r, zero, twice);
      // Rounding of a boundary point; the Newton iteration of a support function stops at
      // 1e-15 of numbers of size 10, where a second projection sees the square root of curvature.
      for (int i = 0; i < dim; ++i) EXPECT_NEAR(twice[i], once[i], 1e-12) << trial;
    }
  });
}

TEST_F(EveryLaw, HasTheDerivativeOfItsProjection) {
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  forEach([this](const SetValuedForceLaw& law, int dim) {
    int kinks = 0;
    for (int trial = 0; trial < 200; ++trial) {
      const double rho = 0.7, r[3] = {rho, rho, rho};
      double xi[3] = {number(), number(), number()}, L[3] = {number(), number(), number()};
      double A[9], B[9];
      ASSERT_TRUE(law.proxDerivative(input(dim), rho, xi, L, A, B));
      const auto F = [&](const double* lambda, const double* x, int i) {
        double p[3] = {lambda[0], lambda[1], lambda[2]};
        law.prox(input(dim), r, x, p);
        return lambda[i] - p[i];
      };
      bool kink = false;
      const double d = 1e-5;
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j) {
          double Lp[3] = {L[0], L[1], L[2]}, Lm[3] = {L[0], L[1], L[2]};
          double xp[3] = {xi[0], xi[1], xi[2]}, xm[3] = {xi[0], xi[1], xi[2]};
          Lp[j] += d, Lm[j] -= d, xp[j] += d, xm[j] -= d;
          const double a = (F(Lp, xi, i) - F(Lm, xi, i)) / (2.0 * d);
          const double b = (F(L, xp, i) - F(L, xm, i)) / (2.0 * d);
          // d² times third derivatives (size 1/N², N ≥ 1e-2 in most trials) and rounding 1e-15/d.
          kink = kink || std::abs(a - A[i * dim + j]) > 1e-5 || std::abs(b - B[i * dim + j]) > 1e-5;
        }
      kinks += kink ? 1 : 0;
    }
    // A trial within d of an edge of the set (probability about 1e-5) or with N near 0 may differ.
    EXPECT_LE(kinks, 2);
  });
}

TEST_F(EveryLaw, OfConstantSetIsNonExpansive) {
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  const GivenFriction disc(1.0, 1.0);
  const Unilateral half;
  for (int trial = 0; trial < 500; ++trial) {
    const double r[2] = {1.0, 1.0}, zero[2] = {};
    double a[2] = {number(), number()}, b[2] = {number(), number()};
    const double before = std::hypot(a[0] - b[0], a[1] - b[1]), before0 = std::abs(a[0] - b[0]);
    double a0 = a[0], b0 = b[0];
    disc.prox(input(2), r, zero, a);
    disc.prox(input(2), r, zero, b);
    half.prox(input(1), r, zero, &a0);
    half.prox(input(1), r, zero, &b0);
    EXPECT_LE(std::hypot(a[0] - b[0], a[1] - b[1]), before + 1e-15);  // one rounding
    EXPECT_LE(std::abs(a0 - b0), before0);
  }
}

TEST(NormalTimesReservoir, FindsTheNearestPointOfAnEllipse) {
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 random(kSeed);
  std::normal_distribution<double> number(0.0, 2.0);
  const EllipseLaw law(0.8, 0.05);
  for (int trial = 0; trial < 2000; ++trial) {
    const double N = std::abs(number(random)), r[2] = {0.3, 1.7};
    const double z[2] = {number(random), number(random)};
    double x[2] = {z[0], z[1]};
    law.project(input(3), N, r, 2, x);
    const double a = 0.8 * N, b = 0.05 * N;
    const double level = std::hypot(x[0] / a, x[1] / b);
    if (std::hypot(z[0] / a, z[1] / b) <= 1.0) {
      EXPECT_EQ(x[0], z[0]);
      EXPECT_EQ(x[1], z[1]);
      continue;
    }
    // On the boundary, with R⁻¹(z − x) along its normal (x/a², y/b²). The dual stops at 1e-15 |z|,
    // or where f no longer falls (a relative 1e-7 in ν at worst); 1e-6 allows for the ratio a/b.
    const double n[2] = {x[0] / (a * a), x[1] / (b * b)};
    const double d[2] = {(z[0] - x[0]) / r[0], (z[1] - x[1]) / r[1]};
    const double sine =
        (d[0] * n[1] - d[1] * n[0]) / (std::hypot(d[0], d[1]) * std::hypot(n[0], n[1]));
    EXPECT_NEAR(level, 1.0, 1e-6) << z[0] << " " << z[1] << " N " << N;
    EXPECT_NEAR(sine, 0.0, 1e-5) << z[0] << " " << z[1] << " N " << N;
  }
}

TEST(NormalTimesReservoir, FallsTogetherWithCoulombForADisc) {
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 random(kSeed);
  std::normal_distribution<double> number(0.0, 2.0);
  const EllipseLaw disc(0.4, 0.4);
  const UnilateralCoulomb coulomb(0.0, 0.0, 0.4);
  for (int trial = 0; trial < 500; ++trial) {
    const double r[3] = {1.0, 0.5, 0.5}, xi[3] = {number(random), number(random), number(random)};
    double a[3] = {1.0, 0.3, -0.4}, b[3] = {1.0, 0.3, -0.4};
    disc.prox(input(3), r, xi, a);
    coulomb.prox(input(3), r, xi, b);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-13);  // rounding of numbers of size 10
  }
}

/// x lies in C: its own prox without a step.
bool unchanged(const SetValuedForceLaw& law, const LawInput& in, std::vector<double> x) {
  const std::vector<double> r(x.size(), 1.0), none(x.size(), 0.0), before = x;
  law.prox(in, r.data(), none.data(), x.data());
  return x == before;
}

TEST(SimpleSets, AreThoseOfTheProjection) {
  using Shape = SimpleSet::Shape;
  const double moving[1] = {1.0}, high = kInfinity;
  EXPECT_EQ(Bilateral().simpleSet(input(3)).shape, Shape::all);
  const SimpleSet normal = Unilateral().simpleSet(input(1));
  EXPECT_EQ(normal.shape, Shape::interval);
  EXPECT_EQ(normal.lower, 0.0);
  EXPECT_EQ(normal.upper, high);
  const UnilateralCoulomb coulomb(0.0, 0.0, 0.25);
  EXPECT_EQ(coulomb.simpleSet(input(1)).shape, Shape::interval);
  const SimpleSet cone = coulomb.simpleSet(input(3));
  ASSERT_EQ(cone.shape, Shape::friction);
  EXPECT_TRUE(unchanged(coulomb, input(3), {2.0, 0.0, 2.0 * cone.upper}));
  EXPECT_FALSE(unchanged(coulomb, input(3), {2.0, 0.0, 2.1 * cone.upper}));
  const GivenFriction brake(2.0, 1.5);
  for (const double* gammaA : {kZeroRows.data(), static_cast<const double*>(moving)}) {
    const LawInput in = input(1, 0.1, gammaA);
    const SimpleSet ball = brake.simpleSet(in);
    ASSERT_EQ(ball.shape, Shape::ball);
    EXPECT_TRUE(unchanged(brake, in, {ball.upper}));
    EXPECT_FALSE(unchanged(brake, in, {1.01 * ball.upper}));
  }
  EXPECT_EQ(EllipseLaw(1.0, 2.0).simpleSet(input(3)).shape, Shape::other);
}

}  // namespace
}  // namespace dynamy
