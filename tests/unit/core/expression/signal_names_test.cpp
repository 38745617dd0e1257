#include <gtest/gtest.h>
#include <dynamy/core/expression/expression.hpp>
#include <dynamy/core/expression/expression_lexer.hpp>

namespace dynamy {
namespace {

TEST(SignalNames, AreDottedOrInBraces) {
  const auto names = signalNames("2*cart.x - { left/arm[2].phi }*k + sin(t)");
  ASSERT_EQ(names.size(), 2u);
  EXPECT_EQ(names[0].name, "cart.x");
  EXPECT_EQ(names[0].offset, 2u);
  EXPECT_EQ(names[1].name, "left/arm[2].phi");
  EXPECT_EQ(names[1].offset, 11u);
  EXPECT_EQ(names[1].length, 19u);
  EXPECT_TRUE(signalNames("2 ** cart.x").empty());
  const auto more = signalNames("1; a.x || b.y | c.z");
  ASSERT_EQ(more.size(), 3u);
  EXPECT_EQ(more[2].name, "c.z");
  EXPECT_EQ(more[2].offset, 16u);
}

TEST(SignalNames, AreToldFromFormulas) {
  for (const char* name : {"cart.x", " cart.vx ", "left/arm[2].phi", "a/b.c.d"})
    EXPECT_TRUE(isSignalName(name)) << name;
  for (const char* formula : {"", "x", "2.5", "a*b.c", "r/2", "1.x", "a.", "a .b", "2*r + 0.1"})
    EXPECT_FALSE(isSignalName(formula)) << formula;
}

TEST(SignalNames, InBracesAreVariables) {
  SymbolTable symbols;
  symbols.variable("left/arm.phi");
  Expression f = Expression::compile("3*{left/arm.phi}^2", symbols);
  const double x = 2.0, one = 1.0;
  EXPECT_EQ(f.value(&x), 12.0);
  EXPECT_EQ(f.derivative(&x, &one), 12.0);
}

}  // namespace
}  // namespace dynamy
