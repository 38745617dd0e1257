// Norms of numbers whose squares overflow or vanish.
#include <gtest/gtest.h>

#include <array>
#include <dynamy/core/safe_norm.hpp>

namespace dynamy {
namespace {

TEST(SafeNorm, IsTheSameInEveryUnit) {
  // 3² + 4² = 5²; a power of two scales without rounding, another size rounds a few times.
  for (const double unit : {1e-320, 1e-300, 1e-170, 1.0, 1e154, 1e300, 3e307}) {
    const std::array<double, 3> x{3.0 * unit, 0.0, -4.0 * unit};
    const double tolerance = unit < 1e-307 ? 1e-3 : 1e-15;  // denormals have few digits
    EXPECT_NEAR(safeNorm(x.data(), 3) / (5.0 * unit), 1.0, tolerance) << unit;
    SafeSum sum;
    for (const double value : x) sum.add(value);
    EXPECT_NEAR(sum.root() / (5.0 * unit), 1.0, tolerance) << unit;
  }
}

TEST(SafeNorm, PassesOnWhatIsNoNumber) {
  const double inf = std::numeric_limits<double>::infinity(),
               nan = std::numeric_limits<double>::quiet_NaN();
  const std::array<double, 2> infinite{1.0, -inf}, none{nan, 1.0}, zero{0.0, 0.0};
  EXPECT_EQ(safeNorm(infinite.data(), 2), inf);
  EXPECT_TRUE(std::isnan(safeNorm(none.data(), 2)));
  EXPECT_EQ(safeNorm(zero.data(), 2), 0.0);
  SafeSum sum;
  sum.add(nan), sum.add(1.0);
  EXPECT_TRUE(std::isnan(sum.root()));
  EXPECT_FALSE(sum.zero());
}

TEST(SafeNorm, RatioOfTwoSumsThatAreNoNumbersIsOne) {
  SafeSum a, b;
  for (int k = 0; k < 100; ++k) a.add(1.5e308), b.add(-1.5e308);  // roots of 1.5e309
  EXPECT_NEAR(a.over(b), 1.0, 1e-14);
}

}  // namespace
}  // namespace dynamy
