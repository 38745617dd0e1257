#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <cstdint>
#include <dynamy/core/expression/expression.hpp>
#include <dynamy/core/expression/unit_suffix.hpp>
#include <numbers>
#include <ostream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {
namespace {

SymbolTable toy() {
  SymbolTable symbols;
  symbols.variable("y");
  symbols.variable("phiM");
  symbols.variable("phiS");
  symbols.constant("hS", 0.02);
  return symbols;
}

struct Wrong {
  const char* text;
  const char* message;
  std::size_t offset, length;
  const char* suggestion;
};

/// Name of a case in lists of tests: letters and digits of its text, the code of any other
/// character, since these disturb the test driver.
void PrintTo(const Wrong& c, std::ostream* out) {
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

class WrongExpression : public testing::TestWithParam<Wrong> {};

TEST_P(WrongExpression, IsExplainedWithPlaceAndHint) {
  const Wrong& w = GetParam();
  try {
    Expression::compile(w.text, toy());
    FAIL() << w.text << " was accepted";
  } catch (const ExpressionError& error) {
    EXPECT_EQ(error.message(), w.message) << w.text;
    EXPECT_EQ(error.offset(), w.offset) << w.text;
    EXPECT_EQ(error.length(), w.length) << w.text;
    EXPECT_EQ(error.suggestion(), w.suggestion) << w.text;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Names, WrongExpression,
    testing::Values(Wrong{"2*phiX", "unknown symbol \"phiX\", known: hS phiM phiS y", 2, 4, "phiM"},
                    Wrong{"Y + 1", "unknown symbol \"Y\", known: hS phiM phiS y", 0, 1, "y"},
                    Wrong{"1 + z", "unknown symbol \"z\", known: hS phiM phiS y", 4, 1, ""},
                    Wrong{"sni(y)", "unknown function \"sni\"", 0, 3, "sin"},
                    Wrong{"ln(y)", "unknown function \"ln\"", 0, 2, "log"},
                    Wrong{"if(y, 1, 2)", "unknown function \"if\"", 0, 2, "condition ? a : b"},
                    Wrong{"2*frobnicate(y)", "unknown function \"frobnicate\"", 2, 10, ""},
                    Wrong{"y(2)", "\"y\" is not a function, a product needs \"*\"", 0, 1, ""},
                    Wrong{"pi(2)", "\"pi\" is not a function, a product needs \"*\"", 0, 2, ""},
                    Wrong{"sin + 1", "\"sin\" is a function and needs arguments in \"( )\"", 0, 3,
                          ""},
                    Wrong{"2*π", "unknown symbol \"π\", known: hS phiM phiS y", 2, 2, "pi"}));

INSTANTIATE_TEST_SUITE_P(
    Arguments, WrongExpression,
    testing::Values(Wrong{"1+atan2(y)", "atan2 takes 2 arguments, not 1", 2, 8, ""},
                    Wrong{"sin(y, 1)", "sin takes 1 argument, not 2", 0, 9, ""},
                    Wrong{"cos()", "cos takes 1 argument, not 0", 0, 5, ""},
                    Wrong{"min(1)", "min takes at least 2 arguments, not 1", 0, 6, ""},
                    Wrong{"hypot(1)", "hypot takes 2 or 3 arguments, not 1", 0, 8, ""},
                    Wrong{"clamp(y,0)", "clamp takes 3 arguments, not 2", 0, 10, ""},
                    Wrong{"step(y,0,0,1,5)", "step takes 1 argument, not 5", 0, 15, "smoothstep"}));

INSTANTIATE_TEST_SUITE_P(
    Structure, WrongExpression,
    testing::Values(Wrong{"", "the expression is empty", 0, 0, ""},
                    Wrong{"  ", "the expression is empty", 0, 2, ""},
                    Wrong{"1 +", "expected a number, a name or \"(\", found the end", 3, 0, ""},
                    Wrong{"1 + * 2", "expected a number, a name or \"(\", found \"*\"", 4, 1, ""},
                    Wrong{"2*(y + 1", "\"(\" is never closed", 2, 1, ""},
                    Wrong{"sin(y", "\"(\" is never closed", 3, 1, ""},
                    Wrong{"y + 1)", "\")\" closes nothing", 5, 1, ""},
                    Wrong{"()", "expected a number, a name or \"(\", found \")\"", 1, 1, ""},
                    Wrong{"min(1,)", "expected a number, a name or \"(\", found \")\"", 6, 1, ""},
                    Wrong{"2 y", "expected an operator, found \"y\"", 2, 1, "2*y"},
                    Wrong{"2(y)", "expected an operator, found \"(\"", 1, 1, "*"},
                    Wrong{"(y, 2)", "expected an operator, found \",\"", 2, 1, ""},
                    Wrong{"y ? 1", "\"?\" without \":\"", 2, 1, ""},
                    Wrong{"y : 1", "expected an operator, found \":\"", 2, 1, ""},
                    Wrong{"0 < y < 1", "comparisons cannot be chained, join two with \"and\"", 6, 1,
                          ""}));

INSTANTIATE_TEST_SUITE_P(Characters, WrongExpression,
                         testing::Values(Wrong{"y # 2", "unexpected character \"#\"", 2, 1, ""},
                                         Wrong{"y = 2", "unexpected character \"=\"", 2, 1, "=="},
                                         Wrong{"y**2", "unexpected character \"**\"", 1, 2, "^"},
                                         Wrong{"y & 1", "unexpected character \"&\"", 2, 1, "&&"},
                                         Wrong{"[y]", "unexpected character \"[\"", 0, 1, "("},
                                         Wrong{"y − 2", "unexpected character \"−\"", 2, 3, "-"},
                                         Wrong{"y ¤ 2", "expected an operator, found \"¤\"", 2, 2,
                                               "*"}));

INSTANTIATE_TEST_SUITE_P(
    Numbers, WrongExpression,
    testing::Values(Wrong{"1.2.3", "malformed number \"1.2.3\"", 0, 5, ""},
                    Wrong{"y+1..2", "malformed number \"1..2\"", 2, 4, ""},
                    Wrong{"1e+", "malformed number \"1e\"", 0, 2, ""},
                    Wrong{"2e999", "the number \"2e999\" is out of range", 0, 5, ""},
                    Wrong{"3kgs", "unknown unit \"kgs\" after a number", 1, 3, "kg"},
                    Wrong{"1+30degree", "unknown unit \"degree\" after a number", 4, 6, "deg"},
                    Wrong{"4in", "unknown unit \"in\" after a number, 1in is 0.0254m", 1, 2, ""},
                    Wrong{"2 m", "a blank stands before the unit \"m\"", 2, 1, "2m"},
                    Wrong{"1+2.5phiM", "unknown unit \"phiM\" after a number", 5, 4, "2.5*phiM"},
                    Wrong{"2mm^2", "a power directly after a unit is ambiguous", 3, 1, "(2mm)^"}));

TEST(ExpressionError, OfAUnitThatIsANameAsksForAProduct) {
  SymbolTable symbols;
  symbols.variable("t");
  symbols.constant("m", 0.4);
  for (const auto& [text, meant] : {std::pair("2t", "2*t"), {"1 + 0.5m", "0.5*m"}}) {
    try {
      Expression::compile(text, symbols);
      FAIL() << text;
    } catch (const ExpressionError& error) {
      EXPECT_EQ(error.suggestion(), meant);
    }
  }
  // A unit of two parts is a product only if both are names.
  const double x = 1.0;
  EXPECT_EQ(Expression::compile("2m/s", symbols).value(&x), 2.0);
  EXPECT_EQ(Expression::compile("2mm", symbols).value(&x), 0.002);
  symbols.constant("s", 5.0);
  EXPECT_THROW(Expression::compile("2m/s", symbols), ExpressionError);
}

TEST(ExpressionError, OfAVariableThatHidesAParameterNamesBoth) {
  SymbolTable symbols;
  symbols.constant("t", 0.4);
  symbols.variable("t");
  EXPECT_NO_THROW(Expression::compile("1 + 2", symbols));
  try {
    Expression::compile("2*t", symbols);
    FAIL();
  } catch (const ExpressionError& error) {
    EXPECT_EQ(error.message(),
              "\"t\" is a parameter of the model, and here a variable; rename the parameter");
  }
}

TEST(ExpressionError, ListsTheFirstNamesIfThereAreMany) {
  SymbolTable symbols;
  for (int i = 0; i < 13; ++i) symbols.variable("variable" + std::to_string(i));
  try {
    Expression::compile("variable", symbols);
    FAIL();
  } catch (const ExpressionError& error) {
    EXPECT_EQ(error.message(),
              "unknown symbol \"variable\", known: variable0 variable1 variable10 variable11 "
              "variable12 variable2 variable3 variable4 variable5 variable6 variable7 variable8 …");
    EXPECT_EQ(error.suggestion(), "variable0");
  }
}

TEST(ExpressionError, ReportsTheTextWithCaretsUnderTheWrongPart) {
  const std::string text = "μ + 2*phiX";
  SymbolTable symbols = toy();
  symbols.constant("μ", 0.3);
  try {
    Expression::compile(text, symbols);
    FAIL();
  } catch (const ExpressionError& error) {
    EXPECT_EQ(error.report(text),
              "unknown symbol \"phiX\", known: hS phiM phiS y μ — did you mean \"phiM\"?\n"
              "μ + 2*phiX\n"
              "      ^^^^");
  }
}

TEST(ExpressionError, IsRaisedIfAConstantContainsAVariable) {
  try {
    evaluateConstant("2*y", toy());
    FAIL();
  } catch (const ExpressionError& error) {
    EXPECT_EQ(error.message(),
              "the value must be constant, but the expression contains a variable");
    EXPECT_EQ(error.offset(), 0U);
    EXPECT_EQ(error.length(), 3U);
  }
}

TEST(ExpressionError, StopsADeepNestingBeforeTheStackDoes) {
  for (const std::string& piece : {std::string("("), std::string("-"), std::string("2^"),
                                   std::string("sin("), std::string("1?"), std::string("1?2:")}) {
    std::string text;
    for (int i = 0; i < 5000; ++i) text += piece;
    try {
      Expression::compile(text, toy());
      FAIL() << piece;
    } catch (const ExpressionError& error) {
      EXPECT_EQ(error.message(), "the expression is nested deeper than 200 levels") << piece;
    }
  }
}

TEST(ExpressionParser, SurvivesRandomTexts) {
  const std::vector<std::string> pieces = {
      "x",  "y",    "phiM",  "hS", "sin", "min", "atan2",  "(",   ")",
      "(",  ")",    ",",     "+",  "-",   "*",   "/",      "^",   "<",
      "<=", "==",   "&&",    "||", "!",   "?",   ":",      "1",   "2.5",
      "1e", "3mm",  "30deg", ".",  " ",   "e",   "pi",     "and", "π",
      "²",  "\xff", "\xe2",  "#",  "=",   "N/m", "1e3N/m", "_",   std::string(1, '\0')};
  const std::uint32_t seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::size_t> piece(0, pieces.size() - 1);
  std::uniform_int_distribution<int> length(0, 14);
  const double x[3] = {0.1, 0.2, 0.3};
  int accepted = 0;
  for (int run = 0; run < 3000; ++run) {
    std::string text;
    for (int i = length(random); i > 0; --i) text += pieces[piece(random)];
    try {
      Expression f = Expression::compile(text, toy());
      static_cast<void>(f.value(x));
      static_cast<void>(f.secondDerivative(x, x, x));
      ++accepted;
    } catch (const ExpressionError& error) {
      // Every error lies inside the text and says something.
      EXPECT_LE(error.offset() + error.length(), text.size()) << text;
      EXPECT_FALSE(error.message().empty());
      EXPECT_FALSE(error.report(text).empty());
    }
  }
  EXPECT_GT(accepted, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Endless, WrongExpression,
    testing::Values(Wrong{"y*(1/0)", "this part has no finite value", 3, 3, ""},
                    Wrong{"max(y, log(hS - 0.02))", "this part has no finite value", 7, 14, ""},
                    Wrong{"y > 0 ? y : 0/0", "this part has no finite value", 12, 3, ""},
                    Wrong{"1e200*1e200 + y", "this part has no finite value", 0, 11, ""}));

TEST(Expression, ABranchThatIsNeverTakenMayBeEndless) {
  Expression f = Expression::compile("hS > 0 ? 2*y : 1/0", toy());
  const double x[] = {3.0, 0.0, 0.0};
  EXPECT_EQ(f.value(x), 6.0);
}

TEST(UnitSuffix, HasFactorAndFamily) {
  const auto deg = parseUnitSuffix("deg");
  ASSERT_TRUE(deg.has_value());
  EXPECT_EQ(deg->factor, std::numbers::pi / 180.0);
  EXPECT_EQ(deg->family, UnitFamily::angle);
  const auto stiffness = parseUnitSuffix("N/m");
  ASSERT_TRUE(stiffness.has_value());
  EXPECT_EQ(stiffness->factor, 1.0);
  EXPECT_EQ(stiffness->family, UnitFamily::stiffness);
  EXPECT_FALSE(parseUnitSuffix("furlong").has_value());
  EXPECT_FALSE(parseUnitSuffix("").has_value());
}

TEST(UnitSuffix, KnowsTheSiUnitOfEveryFamily) {
  for (const std::string& name : unitSuffixes()) {
    const auto unit = parseUnitSuffix(name);
    ASSERT_TRUE(unit.has_value()) << name;
    const auto si = parseUnitSuffix(siUnit(unit->family));
    ASSERT_TRUE(si.has_value()) << name;
    EXPECT_EQ(si->factor, 1.0) << name;
    EXPECT_EQ(si->family, unit->family) << name;
  }
  EXPECT_EQ(siUnit(UnitFamily::none), "");
}

TEST(Quantity, KeepsTheFamilyOfItsUnit) {
  const Quantity angle = parseQuantity(" -30deg ");
  EXPECT_EQ(angle.value, -30.0 * (std::numbers::pi / 180.0));
  EXPECT_EQ(angle.family, UnitFamily::angle);
  EXPECT_EQ(parseQuantity("2.5").family, UnitFamily::none);
  EXPECT_EQ(parseQuantity("+2.5").value, 2.5);
}

TEST(Quantity, RejectsAnythingElseThanOneNumber) {
  for (const char* text : {"x", "1+2", "1 2", "-", "", "--1", "1)"}) {
    EXPECT_THROW(static_cast<void>(parseQuantity(text)), ExpressionError) << text;
  }
}

}  // namespace
}  // namespace dynamy
