// Sets of forces: their forms, the distance of a force from its bound, the gauge of a reservoir.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/located/phase/force_set.hpp>

namespace dynamy {
namespace {

using Form = ForceSet::Form;

/// Rounding of numbers of size 1 to 10.
constexpr double kSetRounding = 1e-14;

ForceSet setOf(const SetValuedForceLaw& law, int dim) {
  ForceSet set;
  EXPECT_TRUE(forceSet(law, {.dim = dim, .dt = 1.0}, set));
  return set;
}

double marginOf(const ForceSet& set, bool slips, const std::vector<double>& lambda) {
  const std::vector<double> gamma(lambda.size(), 0.0);
  double margin = 0.0;
  EXPECT_TRUE(set.margin(slips, lambda, lambda[0], gamma.data(), margin));
  return margin;
}

TEST(ForceSet, HasTheFormOfItsLaw) {
  EXPECT_EQ(setOf(Bilateral(), 2).form, Form::joint);
  EXPECT_EQ(setOf(Unilateral(), 1).form, Form::normal);
  EXPECT_EQ(setOf(UnilateralCoulomb(0.0, 0.0, 0.5), 3).form, Form::cone);
  EXPECT_EQ(setOf(GivenFriction(4.0, 3.0), 1).form, Form::given);
  EXPECT_TRUE(setOf(GivenFriction(0.0, 0.0), 1).idle());
}

TEST(ForceSet, OfAJointHasNoBound) {
  const std::vector<double> lambda = {1e9};
  double margin = 0.0;
  EXPECT_FALSE(setOf(Bilateral(), 1).margin(false, lambda, 1e9, lambda.data(), margin));
}

TEST(ForceSet, MeasuresTheDistanceOfAForceFromItsBound) {
  EXPECT_EQ(marginOf(setOf(Unilateral(), 1), false, {3.0}), 3.0);
  const ForceSet cone = setOf(UnilateralCoulomb(0.0, 0.0, 0.5), 3);
  // μ λ_N − |λ_T| = 0.5 · 12 − 5 in stick; λ_N alone in slip.
  EXPECT_NEAR(marginOf(cone, false, {12.0, 3.0, -4.0}), 1.0, kSetRounding);
  EXPECT_EQ(marginOf(cone, true, {12.0, 3.0, -4.0}), 12.0);
  EXPECT_NEAR(marginOf(setOf(GivenFriction(4.0, 4.0), 1), false, {-3.0}), 1.0, kSetRounding);
  EXPECT_NEAR(marginOf(setOf(GivenFriction(6.0, 6.0), 2), false, {3.0, 4.0}), 1.0, kSetRounding);
}

/// B = an ellipse with half-axes a and b: S_B(y) = √((a y₀)² + (b y₁)²).
class Ellipse final : public NormalTimesReservoir {
 public:
  static constexpr double a = 0.5, b = 0.2;
  int dim(int) const override { return 3; }
  double support(const LawInput&, int, const double* y, double* gradient,
                 double* hessian) const override {
    const double A = a * a, B = b * b, S = std::sqrt(A * y[0] * y[0] + B * y[1] * y[1]);
    const double g[2] = {A * y[0] / S, B * y[1] / S};
    if (gradient) gradient[0] = g[0], gradient[1] = g[1];
    if (hessian) {
      hessian[0] = (A - g[0] * g[0]) / S, hessian[3] = (B - g[1] * g[1]) / S;
      hessian[1] = hessian[2] = -g[0] * g[1] / S;
    }
    return S;
  }
};

TEST(ForceSet, HasTheGaugeOfAReservoir) {
  const Ellipse law;
  const ForceSet set = setOf(law, 3);
  EXPECT_EQ(set.form, Form::reservoir);
  EXPECT_EQ(set.upper, Ellipse::a);
  const double gamma[3] = {};
  for (const auto& x : {Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(-0.3, 2.0)}) {
    // ρ(x) = √((x₀/a)² + (x₁/b)²); Newton's method ends at a change of 1e-13.
    const double gauge = std::hypot(x[0] / Ellipse::a, x[1] / Ellipse::b);
    EXPECT_NEAR(set.gauge(2, x.data(), gamma), gauge, 1e-12 * gauge);
  }
}

TEST(ForceSet, ComparesSlipsByTheWidthsOfTheReservoir) {
  const Ellipse law;
  const double slip[2] = {3.0, 10.0};
  EXPECT_NEAR(setOf(law, 3).speed(2, slip), 5.0, kSetRounding);  // weights 1 and b/a = 0.4
}

/// Friction a(v) = 5 + 2v − v² + v³ of the speed v ≥ 0.
class OfSpeed final : public SetValuedForceLaw {
 public:
  int dim(int) const override { return 1; }
  bool unilateral() const override { return false; }
  RowKind rowKind(int) const override { return RowKind::friction; }
  void prox(const LawInput&, const double*, const double*, double*) const override {}
  Status status(const LawInput&, const double*) const override { return Status::slip; }
  SimpleSet simpleSet(const LawInput& in) const override {
    const double v = in.gammaA ? std::abs(in.gammaA[0]) : 0.0;
    const double a = 5.0 + 2.0 * v - v * v + v * v * v;
    return {SimpleSet::Shape::interval, -a, a};
  }
};

TEST(ForceSet, ContinuesFrictionPastTheEndOfASlipAsACubic) {
  const OfSpeed law;
  Held h;
  h.slips = true, h.sign = 1.0;
  for (const double v : {0.3, -0.1}) {
    double slip = v;
    ForceSet set;
    ASSERT_TRUE(slipForceSet(law, {.dim = 1, .dt = 1.0}, h, &slip, set));
    // The value at 0 is taken at the least slip of 1e-12.
    EXPECT_NEAR(set.upper, 5.0 + 2.0 * v - v * v + v * v * v, 1e-11) << v;
  }
}

TEST(ForceSet, OfALawWithoutDiscsHasOnePart) {
  std::vector<std::array<int, 2>> parts;
  statusParts(UnilateralCoulomb(0.0, 0.0, 0.5), 3, parts);
  EXPECT_EQ(parts, (std::vector<std::array<int, 2>>{{0, 3}}));
}

}  // namespace
}  // namespace dynamy
