#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <dynamy/core/expression/expression.hpp>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace dynamy {
namespace {

// Results of a handful of operations: each rounds by half an ulp, library functions by at most one.
constexpr double kRelative = 8.0 * std::numeric_limits<double>::epsilon();

void expectClose(double actual, double expected) {
  EXPECT_NEAR(actual, expected, kRelative * (1.0 + std::abs(expected)));
}

double constantOf(const std::string& text) { return evaluateConstant(text, SymbolTable()); }

SymbolTable xy() {
  SymbolTable symbols;
  symbols.variable("x");
  symbols.variable("y");
  symbols.constant("l", 0.5);
  return symbols;
}

Expression compileXy(const std::string& text) { return Expression::compile(text, xy()); }

double valueXy(const std::string& text, double x, double y) {
  const std::array<double, 2> in{x, y};
  return compileXy(text).value(in.data());
}

TEST(Expression, FollowsThePrecedenceOfMathematics) {
  EXPECT_EQ(constantOf("1+2*3"), 7.0);
  EXPECT_EQ(constantOf("(1+2)*3"), 9.0);
  EXPECT_EQ(constantOf("10-4-3"), 3.0);
  EXPECT_EQ(constantOf("16/4/2"), 2.0);
  EXPECT_EQ(constantOf("-2^2"), -4.0);
  EXPECT_EQ(constantOf("2^3^2"), 512.0);
  EXPECT_EQ(constantOf("2^-1"), 0.5);
  EXPECT_EQ(constantOf("--3"), 3.0);
  EXPECT_EQ(constantOf("2*-3"), -6.0);
  EXPECT_EQ(constantOf("1+1 < 3 && 2 > 1"), 1.0);
  EXPECT_EQ(constantOf("1 > 2 || !(1 >= 2)"), 1.0);
  EXPECT_EQ(constantOf("not 1 or 0 and 1"), 0.0);
  EXPECT_EQ(constantOf("0 ? 1 : 1 ? 2 : 3"), 2.0);
  EXPECT_EQ(constantOf("1 != 2"), 1.0);
  EXPECT_EQ(constantOf("1 == 2"), 0.0);
  EXPECT_EQ(constantOf("1 <= 1"), 1.0);
}

TEST(Expression, ReadsNumbersInEveryUsualForm) {
  EXPECT_EQ(constantOf("1"), 1.0);
  EXPECT_EQ(constantOf(".5"), 0.5);
  EXPECT_EQ(constantOf("5."), 5.0);
  EXPECT_EQ(constantOf("1.25e-3"), 1.25e-3);
  EXPECT_EQ(constantOf("1E3"), 1000.0);
  EXPECT_EQ(constantOf(" 1\n+\t1 "), 2.0);
}

TEST(Expression, ConvertsUnitsDirectlyBehindANumber) {
  expectClose(constantOf("30deg"), std::numbers::pi / 6.0);
  expectClose(constantOf("5mm"), 0.005);
  expectClose(constantOf("1ms"), 0.001);
  expectClose(constantOf("3rpm"), 3.0 * 2.0 * std::numbers::pi / 60.0);
  expectClose(constantOf("1e3N/m * 2mm"), 2.0);
  expectClose(constantOf("36km/h"), 10.0);
  expectClose(constantOf("2kN + 1N"), 2001.0);
  expectClose(constantOf("(2mm)^2"), 4e-6);
}

TEST(Expression, ReadsAUnitWithSlashOnlyIfItIsOne) {
  SymbolTable symbols;
  symbols.constant("n", 4.0);
  symbols.constant("m", 100.0);
  EXPECT_EQ(evaluateConstant("2cm/n", symbols), 0.005);              // 2 cm divided by n
  EXPECT_THROW(evaluateConstant("2m/n", symbols), ExpressionError);  // or 2 times m
  EXPECT_EQ(evaluateConstant("200N/m", symbols), 200.0);             // the unit N/m
  EXPECT_EQ(evaluateConstant("200N / m", symbols), 2.0);  // 200 N divided by the constant m
}

TEST(Expression, EvaluatesEveryFunctionLikeTheStandardLibrary) {
  const double x = 0.37;
  const double y = -1.9;
  EXPECT_EQ(valueXy("sin(x)", x, y), std::sin(x));
  EXPECT_EQ(valueXy("cos(x)", x, y), std::cos(x));
  EXPECT_EQ(valueXy("tan(x)", x, y), std::tan(x));
  EXPECT_EQ(valueXy("asin(x)", x, y), std::asin(x));
  EXPECT_EQ(valueXy("acos(x)", x, y), std::acos(x));
  EXPECT_EQ(valueXy("atan(x)", x, y), std::atan(x));
  EXPECT_EQ(valueXy("atan2(x,y)", x, y), std::atan2(x, y));
  EXPECT_EQ(valueXy("sinh(x)", x, y), std::sinh(x));
  EXPECT_EQ(valueXy("cosh(x)", x, y), std::cosh(x));
  EXPECT_EQ(valueXy("tanh(x)", x, y), std::tanh(x));
  EXPECT_EQ(valueXy("exp(x)", x, y), std::exp(x));
  EXPECT_EQ(valueXy("log(x)", x, y), std::log(x));
  EXPECT_EQ(valueXy("log10(x)", x, y), std::log10(x));
  EXPECT_EQ(valueXy("sqrt(x)", x, y), std::sqrt(x));
  EXPECT_EQ(valueXy("abs(y)", x, y), 1.9);
  EXPECT_EQ(valueXy("sign(y)", x, y), -1.0);
  EXPECT_EQ(valueXy("min(x,y,3)", x, y), y);
  EXPECT_EQ(valueXy("max(x,y,3)", x, y), 3.0);
  EXPECT_EQ(valueXy("floor(y)", x, y), -2.0);
  EXPECT_EQ(valueXy("ceil(y)", x, y), -1.0);
  expectClose(valueXy("mod(y,1)", x, y), 0.1);
  EXPECT_EQ(valueXy("hypot(x,y)", x, y), std::hypot(x, y));
  expectClose(valueXy("hypot(x,y,2)", x, y), std::hypot(x, y, 2.0));
  EXPECT_EQ(valueXy("pow(x,y)", x, y), std::pow(x, y));
  EXPECT_EQ(valueXy("x^2.5", x, y), std::pow(x, 2.5));
  EXPECT_EQ(valueXy("step(x)+step(y)", x, y), 1.0);
  EXPECT_EQ(valueXy("step(x)", 0.0, y), 1.0);
  EXPECT_EQ(valueXy("clamp(y,-1,1)", x, y), -1.0);
}

TEST(Expression, ComputesIntegerPowersByProducts) {
  for (int n = -9; n <= 9; ++n) {
    const double expected = std::pow(-1.3, n);
    // At most 9 roundings by half an ulp, relative.
    EXPECT_NEAR(valueXy("x^(" + std::to_string(n) + ")", -1.3, 0.0), expected,
                5.0 * std::numeric_limits<double>::epsilon() * std::abs(expected));
  }
}

TEST(Expression, LetsTheModelShadowPiAndE) {
  EXPECT_EQ(constantOf("pi"), std::numbers::pi);
  EXPECT_EQ(constantOf("1*e"), std::numbers::e);
  // Alone it is rather a parameter that was forgotten.
  EXPECT_THROW(constantOf("e"), ExpressionError);
  SymbolTable symbols;
  symbols.constant("e", 0.8);
  EXPECT_EQ(evaluateConstant("(1+e)/2", symbols), 0.9);
}

TEST(Expression, AcceptsDotsAndGreekLettersInNames) {
  SymbolTable symbols;
  symbols.constant("toy.phiM", 2.0);
  symbols.constant("μ", 0.3);
  EXPECT_EQ(evaluateConstant("toy.phiM*μ", symbols), 0.6);
}

TEST(Expression, GivesTheInnerScopeTheNameThatIsDefinedAgain) {
  SymbolTable symbols;
  symbols.constant("i", 1.0);
  symbols.constant("i", 2.0);
  EXPECT_EQ(evaluateConstant("i", symbols), 2.0);
}

TEST(Expression, TakesValueAndSlopeOfTheChosenBranchOnly) {
  const std::array<double, 2> x{-1.0, 0.0};
  const std::array<double, 2> v{1.0, 0.0};
  Expression f = compileXy("x > 0 ? sqrt(x) : 3*x");
  EXPECT_EQ(f.value(x.data()), -3.0);
  EXPECT_EQ(f.derivative(x.data(), v.data()), 3.0);
}

TEST(Expression, PassesNonFiniteResultsToTheCaller) {
  EXPECT_EQ(valueXy("1/x", 0.0, 0.0), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(valueXy("log(x)", -1.0, 0.0)));
  EXPECT_TRUE(std::isnan(valueXy("min(1,log(x))", -1.0, 0.0)));
  EXPECT_TRUE(std::isnan(valueXy("max(log(x),1)", -1.0, 0.0)));
}

TEST(ExpressionSet, SharesCommonPartsOfAllFormulas) {
  ExpressionCompiler compiler(xy());
  compiler.add("sin(x-y)*l");
  compiler.add("sin(x-y)*y");
  compiler.add("l*sin(x - y)");
  const ExpressionSet set = compiler.finish();
  // x − y, sin, · l, · y
  EXPECT_EQ(set.instructionCount(), 4);
  EXPECT_EQ(set.outputCount(), 3);
  EXPECT_EQ(set.inputCount(), 2);
}

TEST(ExpressionSet, FoldsConstantsAndLeavesOutWhatNobodyNeeds) {
  ExpressionCompiler compiler(xy());
  compiler.add("0*sin(x) + l^2*4 + x - x");
  compiler.add("2*l*y");
  const ExpressionSet set = compiler.finish();
  EXPECT_EQ(set.instructionCount(), 2);  // (1 + x) − x is kept: rounding forbids to drop it
  EXPECT_FALSE(set.isConstant(0));
  EXPECT_FALSE(set.isConstant(1));
}

TEST(ExpressionSet, KnowsWhichFormulaDependsOnWhichVariable) {
  ExpressionCompiler compiler(xy());
  compiler.add("l^2 + 3");
  compiler.add("x*l");
  compiler.add("y > 0 ? x : 1");
  compiler.add("y");
  const ExpressionSet set = compiler.finish();
  EXPECT_TRUE(set.isConstant(0));
  EXPECT_FALSE(set.dependsOn(0, 0));
  EXPECT_TRUE(set.dependsOn(1, 0));
  EXPECT_FALSE(set.dependsOn(1, 1));
  EXPECT_TRUE(set.dependsOn(2, 0));
  EXPECT_TRUE(set.dependsOn(2, 1));
  EXPECT_TRUE(set.dependsOn(3, 1));
  EXPECT_FALSE(set.dependsOn(3, 0));
  EXPECT_FALSE(set.dependsOn(3, 7));
}

TEST(ExpressionSet, RecognisesAffineFormulas) {
  ExpressionCompiler compiler(xy());
  const int plane = compiler.add("l - 3*x + y/4 - (2 - x)*l");
  const int product = compiler.add("x*y");
  const int sine = compiler.add("sin(y) + x");
  const ExpressionSet set = compiler.finish();
  const std::array<int, 2> both{0, 1};
  const std::array<int, 1> onlyX{0};
  EXPECT_TRUE(set.isAffine(plane, both));
  EXPECT_FALSE(set.isAffine(product, both));
  EXPECT_TRUE(set.isAffine(product, onlyX));
  EXPECT_FALSE(set.isAffine(sine, both));
  EXPECT_TRUE(set.isAffine(sine, onlyX));
}

TEST(ExpressionSet, StaysUsableAfterAFormulaWithAnError) {
  ExpressionCompiler compiler(xy());
  EXPECT_THROW(compiler.add("x*(y+"), ExpressionError);
  EXPECT_EQ(compiler.add("x+y"), 0);
  const ExpressionSet set = compiler.finish();
  EXPECT_EQ(set.instructionCount(), 1);
}

TEST(ExpressionSet, EvaluatesBitwiseTheSameInEveryMode) {
  ExpressionCompiler compiler(xy());
  compiler.add("atan2(x,y)^3 + exp(-x*y)/hypot(x,y) - tanh(x)^1.5");
  compiler.add("x");
  const ExpressionSet set = compiler.finish();
  ExpressionWorkspace work(set);
  const std::array<double, 2> x{0.4, 1.3};
  const std::array<double, 2> v{1.0, -2.0};
  std::array<double, 2> f0{}, f1{}, f2{}, d1{}, d2{}, dd{};
  set.eval(x.data(), f0.data(), work);
  set.evalD(x.data(), v.data(), f1.data(), d1.data(), work);
  EXPECT_EQ(f0, f1);
  set.evalDD(x.data(), v.data(), v.data(), f2.data(), d2.data(), d2.data(), dd.data(), work);
  EXPECT_EQ(f0, f2);
  EXPECT_EQ(d1, d2);
}

TEST(ExpressionSet, GivesTheGradientByColumns) {
  ExpressionCompiler compiler(xy());
  compiler.add("sin(x)*y^2");
  compiler.add("y");
  compiler.add("l");
  const ExpressionSet set = compiler.finish();
  ExpressionWorkspace work(set);
  const std::array<double, 2> x{0.7, 1.2};
  const std::array<int, 2> variables{1, 0};
  std::array<double, 3> f{};
  std::array<double, 6> J{};
  set.gradient(x.data(), variables, f.data(), J.data(), work);
  expectClose(f[0], std::sin(0.7) * 1.44);
  EXPECT_EQ(f[1], 1.2);
  EXPECT_EQ(f[2], 0.5);
  expectClose(J[0], std::sin(0.7) * 2.4);
  EXPECT_EQ(J[1], 1.0);
  EXPECT_EQ(J[2], 0.0);
  expectClose(J[3], std::cos(0.7) * 1.44);
  EXPECT_EQ(J[4], 0.0);
  EXPECT_EQ(J[5], 0.0);
}

}  // namespace
}  // namespace dynamy
