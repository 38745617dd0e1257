#include <gtest/gtest.h>

#include <dynamy/core/expression/expression.hpp>
#include <limits>
#include <string>
#include <vector>

namespace dynamy {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Instants at which a formula of t (and x) changes its branch, from `t` on, at most `most`.
std::vector<double> instants(const std::string& formula, double t = 0.0, int most = 4) {
  SymbolTable symbols;
  symbols.variable("t");
  symbols.variable("x");
  const Expression f = Expression::compile(formula, symbols);
  std::vector<double> out;
  for (int i = 0; i < most; ++i) {
    t = f.set().nextInstant(t, 0);
    if (t == kNever) break;
    out.push_back(t);
  }
  return out;
}

using Times = std::vector<double>;

// Instants are quotients of numbers of the formulas, exact here or rounded once.

TEST(ExpressionInstants, AreWhereFormulasOfTimeJump) {
  EXPECT_EQ(instants("step(t - 0.5)"), Times({0.5}));
  EXPECT_EQ(instants("step(t - 0.5) - step(t - 1)"), Times({0.5, 1.0}));
  EXPECT_EQ(instants("t < 2 ? 3 : t^2"), Times({2.0}));
  EXPECT_EQ(instants("3 <= 2*t && t < 4"), Times({1.5, 4.0}));
  EXPECT_EQ(instants("sign(1 - t)"), Times({1.0}));
  EXPECT_EQ(instants("floor(2*t)", 0.1, 3), Times({0.5, 1.0, 1.5}));
  EXPECT_EQ(instants("ceil(-t)", 0.1, 2), Times({1.0, 2.0}));
  EXPECT_EQ(instants("mod(t, 0.25) < 0.125", 0.0, 4), Times({0.125, 0.25, 0.375, 0.5}));
}

TEST(ExpressionInstants, AreWhereFormulasOfTimeHaveKinks) {
  EXPECT_EQ(instants("abs(t - 1)"), Times({1.0}));
  EXPECT_EQ(instants("clamp((t - 1)/2, 0, 1)"), Times({1.0, 3.0}));
  EXPECT_EQ(instants("min(2*max(t - 0.5, 0), 0.25)"), Times({0.5, 0.625}));
  EXPECT_EQ(instants("smoothstep(t, 1, 0, 3, 5)"), Times({1.0, 3.0}));
  EXPECT_EQ(instants("sin(2*pi*clamp(t - 1, 0, 1))"), Times({1.0, 2.0}));
  EXPECT_EQ(instants("x*step(t - 1)"), Times({1.0}));
}

TEST(ExpressionInstants, AreNoneWhereNothingChanges) {
  EXPECT_EQ(instants("sin(t) + t^2"), Times());
  EXPECT_EQ(instants("step(1 - 2)*t"), Times());
  EXPECT_EQ(instants("step(t - 0.5)", 0.5), Times());
  // The state, or what is not affine in t, is not foreseen.
  EXPECT_EQ(instants("step(x - 1)"), Times());
  EXPECT_EQ(instants("step(x - t)"), Times());
  EXPECT_EQ(instants("step(sin(t))"), Times());
}

TEST(ExpressionInstants, DoNotComeAgainRightBehind) {
  EXPECT_EQ(instants("step(t - 3)", 3.0 * (1.0 + 1e-15)), Times());
  EXPECT_EQ(instants("floor(t)", 1.0 - 1e-15, 1), Times({2.0}));
}

}  // namespace
}  // namespace dynamy
