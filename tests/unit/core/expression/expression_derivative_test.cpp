#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <cmath>
#include <dynamy/core/expression/expression.hpp>
#include <limits>
#include <numbers>
#include <ostream>
#include <string>
#include <string_view>

namespace dynamy {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Closed forms of f and its derivatives in one variable.
struct Case {
  const char* text;
  double x;
  double f, f1, f2;
};

/// Name of a case in lists of tests: letters and digits of its text, the code of any other
/// character, since these disturb the test driver.
void PrintTo(const Case& c, std::ostream* out) {
  if (*c.text == '\0') *out << "empty";
  for (const char letter : std::string_view(c.text)) {
    const unsigned char code = static_cast<unsigned char>(letter);
    if (std::isalnum(code) != 0) {
      *out << letter;
    } else {
      *out << '_' << static_cast<int>(code) << '_';
    }
  }
}

SymbolTable oneVariable() {
  SymbolTable symbols;
  symbols.variable("x");
  return symbols;
}

// A few roundings of terms not much larger than the result; closed form and sweep round
// differently.
void expectClose(double actual, double expected, const std::string& what) {
  EXPECT_NEAR(actual, expected, 32.0 * kEpsilon * (1.0 + std::abs(expected))) << what;
}

class ExpressionDerivative : public testing::TestWithParam<Case> {};

TEST_P(ExpressionDerivative, EqualsTheClosedForm) {
  const Case& c = GetParam();
  Expression f = Expression::compile(c.text, oneVariable());
  const double v = 1.5;
  const double w = -0.25;
  expectClose(f.value(&c.x), c.f, c.text);
  expectClose(f.derivative(&c.x, &v), c.f1 * v, c.text);
  expectClose(f.secondDerivative(&c.x, &v, &w), c.f2 * v * w, c.text);
}

double sec2(double x) { return 1.0 / (std::cos(x) * std::cos(x)); }
double sech2(double x) { return 1.0 / (std::cosh(x) * std::cosh(x)); }
const double kS = std::sqrt(1.0 - 0.36);  // cos of asin 0.6
const double kL = std::log(2.0);

INSTANTIATE_TEST_SUITE_P(
    AllFunctions, ExpressionDerivative,
    testing::Values(
        Case{"sin(x)", 0.7, std::sin(0.7), std::cos(0.7), -std::sin(0.7)},
        Case{"cos(x)", 0.7, std::cos(0.7), -std::sin(0.7), -std::cos(0.7)},
        Case{"tan(x)", 0.7, std::tan(0.7), sec2(0.7), 2 * std::tan(0.7) * sec2(0.7)},
        Case{"asin(x)", 0.6, std::asin(0.6), 1 / kS, 0.6 / (kS * kS * kS)},
        Case{"acos(x)", 0.6, std::acos(0.6), -1 / kS, -0.6 / (kS * kS * kS)},
        Case{"atan(x)", 2.0, std::atan(2.0), 0.2, -4.0 / 25},
        Case{"sinh(x)", 0.7, std::sinh(0.7), std::cosh(0.7), std::sinh(0.7)},
        Case{"cosh(x)", 0.7, std::cosh(0.7), std::sinh(0.7), std::cosh(0.7)},
        Case{"tanh(x)", 0.7, std::tanh(0.7), sech2(0.7), -2 * std::tanh(0.7) * sech2(0.7)},
        Case{"exp(x)", 0.7, std::exp(0.7), std::exp(0.7), std::exp(0.7)},
        Case{"log(x)", 4.0, std::log(4.0), 0.25, -1.0 / 16},
        Case{"log10(x)", 10.0, 1.0, 0.1 / std::numbers::ln10, -0.01 / std::numbers::ln10},
        Case{"sqrt(x)", 4.0, 2.0, 0.25, -1.0 / 32}, Case{"abs(x)", -3.0, 3.0, -1.0, 0.0},
        Case{"sign(x)", -3.0, -1.0, 0.0, 0.0}, Case{"floor(x)", 2.5, 2.0, 0.0, 0.0},
        Case{"ceil(x)", 2.5, 3.0, 0.0, 0.0}, Case{"mod(x,2)", 5.0, 1.0, 1.0, 0.0},
        Case{"step(x)", 5.0, 1.0, 0.0, 0.0}, Case{"x^3", -2.0, -8.0, 12.0, -12.0},
        Case{"x^-2", 2.0, 0.25, -0.25, 0.375}, Case{"x^1.5", 4.0, 8.0, 3.0, 0.375},
        Case{"x^9", -1.0, -1.0, 9.0, -72.0}, Case{"2^x", 3.0, 8.0, 8 * kL, 8 * kL* kL},
        Case{"x^x", 2.0, 4.0, 4 * (1 + kL), 4 * ((1 + kL) * (1 + kL) + 0.5)},
        Case{"1/x", 2.0, 0.5, -0.25, 0.25}, Case{"x/(1+x)", 1.0, 0.5, 0.25, -0.25},
        Case{"hypot(x,3)", 4.0, 5.0, 0.8, 9.0 / 125},
        Case{"atan2(x,3)", 4.0, std::atan2(4.0, 3.0), 3.0 / 25, -24.0 / 625},
        Case{"atan2(3,x)", 4.0, std::atan2(3.0, 4.0), -3.0 / 25, 24.0 / 625},
        // 2 + 4 s²(3 − 2s) with s = (x − 1)/2 at s = ¼: slope 24 s(1 − s)/2, second (24 − 48 s)/4.
        Case{"smoothstep(x,1,2,3,6)", 1.5, 2.625, 2.25, 3.0},
        Case{"smoothstep(x,1,2,3,6)", 0.0, 2.0, 0.0, 0.0},
        Case{"smoothstep(x,1,2,3,6)", 4.0, 6.0, 0.0, 0.0},
        Case{"clamp(x^2,0,1)", 0.5, 0.25, 1.0, 2.0}, Case{"clamp(x,0,1)", 2.0, 1.0, 0.0, 0.0},
        Case{"sin(x^2)", 0.9, std::sin(0.81), 1.8 * std::cos(0.81),
             2 * std::cos(0.81) - 3.24 * std::sin(0.81)},
        Case{"exp(-x)*cos(2*x)", 0.4, std::exp(-0.4) * std::cos(0.8),
             -std::exp(-0.4) * (std::cos(0.8) + 2 * std::sin(0.8)),
             std::exp(-0.4) * (4 * std::sin(0.8) - 3 * std::cos(0.8))},
        Case{"log(1+sqrt(x))", 4.0, std::log(3.0), 1.0 / 12, -5.0 / 288}));

// One-sided choices: documented in doc/theory/05_expressions.md.
INSTANTIATE_TEST_SUITE_P(
    OneSidedChoices, ExpressionDerivative,
    testing::Values(Case{"abs(x)", 0.0, 0.0, 1.0, 0.0}, Case{"min(x,2*x)", 0.0, 0.0, 1.0, 0.0},
                    Case{"max(3*x,x)", 0.0, 0.0, 3.0, 0.0}, Case{"sign(x)", 0.0, 0.0, 0.0, 0.0},
                    Case{"step(x)", 0.0, 1.0, 0.0, 0.0}, Case{"hypot(x,0)", 0.0, 0.0, 0.0, 0.0},
                    Case{"clamp(x,0,1)", 0.0, 0.0, 1.0, 0.0},
                    Case{"mod(x,1)", 2.0, 0.0, 1.0, 0.0}));

TEST(ExpressionDerivative, IsZeroWhereAnInfiniteSlopeMeetsAConstantArgument) {
  // √(x²): the slope of the root is infinite, that of x² zero; the product is taken as zero, not
  // NaN.
  Expression f = Expression::compile("sqrt(x^2)", oneVariable());
  const double x = 0.0;
  const double v = 1.0;
  EXPECT_EQ(f.derivative(&x, &v), 0.0);
}

TEST(ExpressionDerivative, IsFiniteForTheForceOfHertzAtZeroPenetration) {
  Expression f = Expression::compile("1e9*x^1.5", oneVariable());
  const double x = 0.0;
  const double v = 1.0;
  EXPECT_EQ(f.derivative(&x, &v), 0.0);
}

TEST(ExpressionDerivative, HasTheMixedTermsOfTwoVariables) {
  SymbolTable symbols;
  symbols.variable("x");
  symbols.variable("y");
  const double x = 0.8, y = 1.7;
  const std::array<double, 2> in{x, y}, v{1.0, 0.5}, w{-2.0, 3.0};

  // f = sin(x) y²: H = [−sin x y², 2 y cos x; 2 y cos x, 2 sin x]
  Expression f = Expression::compile("sin(x)*y^2", symbols);
  expectClose(f.derivative(in.data(), v.data()),
              std::cos(x) * y * y * v[0] + 2 * y * std::sin(x) * v[1], "f'");
  expectClose(f.secondDerivative(in.data(), v.data(), w.data()),
              -std::sin(x) * y * y * v[0] * w[0] +
                  2 * y * std::cos(x) * (v[0] * w[1] + v[1] * w[0]) + 2 * std::sin(x) * v[1] * w[1],
              "f''");

  // f = xʸ: f_xy = x^(y−1) (1 + y ln x)
  Expression p = Expression::compile("x^y", symbols);
  const double l = std::log(x), g = std::pow(x, y);
  expectClose(p.secondDerivative(in.data(), v.data(), w.data()),
              y * (y - 1) * g / (x * x) * v[0] * w[0] +
                  g / x * (1 + y * l) * (v[0] * w[1] + v[1] * w[0]) + g * l * l * v[1] * w[1],
              "power");

  // f = √(x² + y²) = r: H = (n⊥ n⊥ᵀ) / r with n⊥ = (−y, x)/r
  Expression r = Expression::compile("hypot(x,y)", symbols);
  const double length = std::hypot(x, y);
  const double nv = (-y * v[0] + x * v[1]) / length, nw = (-y * w[0] + x * w[1]) / length;
  expectClose(r.secondDerivative(in.data(), v.data(), w.data()), nv * nw / length, "hypot");

  // f = x/y: H = [0, −1/y²; −1/y², 2x/y³]
  Expression q = Expression::compile("x/y", symbols);
  expectClose(q.secondDerivative(in.data(), v.data(), w.data()),
              -(v[0] * w[1] + v[1] * w[0]) / (y * y) + 2 * x * v[1] * w[1] / (y * y * y), "x/y");

  // f = atan2(y, x): H = [2xy, y²−x²; y²−x², −2xy]/r⁴
  Expression a = Expression::compile("atan2(y,x)", symbols);
  const double r4 = std::pow(length, 4);
  expectClose(
      a.secondDerivative(in.data(), v.data(), w.data()),
      (2 * x * y * (v[0] * w[0] - v[1] * w[1]) + (y * y - x * x) * (v[0] * w[1] + v[1] * w[0])) /
          r4,
      "atan2");
}

/// Two links of lengths a, b with point masses m1, m2 at their ends; angles from the vertical.
class DoublePendulum : public testing::Test {
 protected:
  static constexpr double kA = 0.6, kB = 0.4, kM1 = 1.2, kM2 = 0.7;
  static SymbolTable symbols() {
    SymbolTable s;
    for (const char* name : {"q1", "q2", "u1", "u2"}) s.variable(name);
    s.constant("a", kA);
    s.constant("b", kB);
    s.constant("m1", kM1);
    s.constant("m2", kM2);
    return s;
  }
  const std::array<double, 4> x_{0.3, -1.1, 2.0, -3.5};
};

TEST_F(DoublePendulum, HasItsMassMatrixInTheKineticEnergy) {
  Expression T = Expression::compile(
      "m1/2*(a*u1)^2 + m2/2*((a*cos(q1)*u1 + b*cos(q2)*u2)^2 + (a*sin(q1)*u1 + b*sin(q2)*u2)^2)",
      symbols());
  const std::array<double, 4> e1{0, 0, 1, 0}, e2{0, 0, 0, 1}, f1{1, 0, 0, 0};
  const double delta = x_[0] - x_[1];
  // M = ∂²T/∂u²
  expectClose(T.secondDerivative(x_.data(), e1.data(), e1.data()), (kM1 + kM2) * kA * kA, "M11");
  expectClose(T.secondDerivative(x_.data(), e1.data(), e2.data()), kM2 * kA * kB * std::cos(delta),
              "M12");
  expectClose(T.secondDerivative(x_.data(), e2.data(), e2.data()), kM2 * kB * kB, "M22");
  // ∂T/∂q1 = −m2 a b sin(q1 − q2) u1 u2
  expectClose(T.derivative(x_.data(), f1.data()), -kM2 * kA * kB * std::sin(delta) * x_[2] * x_[3],
              "dT/dq1");
}

TEST_F(DoublePendulum, HasTheAccelerationTermOfAGapAsSecondDerivativeAlongTheVelocity) {
  // g = d − a sin q1 − b sin q2: ġ = −a cos q1 u1 − b cos q2 u2, uᵀ g″ u = a sin q1 u1² + b sin q2
  // u2²
  Expression gap = Expression::compile("0.9 - a*sin(q1) - b*sin(q2)", symbols());
  const std::array<double, 4> u{x_[2], x_[3], 0, 0};
  expectClose(gap.derivative(x_.data(), u.data()),
              -kA * std::cos(x_[0]) * x_[2] - kB * std::cos(x_[1]) * x_[3], "gap rate");
  expectClose(gap.secondDerivative(x_.data(), u.data(), u.data()),
              kA * std::sin(x_[0]) * x_[2] * x_[2] + kB * std::sin(x_[1]) * x_[3] * x_[3],
              "gap acceleration");
}

}  // namespace
}  // namespace dynamy
