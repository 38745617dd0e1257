#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/io/replay/plot_scale.hpp>
#include <limits>
#include <numeric>

namespace dynamy {
namespace {

TEST(NiceTicks, AreMultiplesOfOneTwoOrFive) {
  EXPECT_EQ(niceTicks(0, 3, 7).values, (std::vector<double>{0, 0.5, 1, 1.5, 2, 2.5, 3}));
  EXPECT_EQ(niceTicks(0, 10, 6).values, (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(niceTicks(-7, 7, 5).values, (std::vector<double>{-5, 0, 5}));
}

TEST(NiceTicks, AreFewAndInsideForRangesOfAnySize) {
  for (double size = 1e-12; size < 1e12; size *= 1.7) {
    for (const double lo : {0.0, -size / 3, 5 * size}) {
      const Ticks ticks = niceTicks(lo, lo + size, 6);
      ASSERT_GE(ticks.values.size(), 2u) << lo << ' ' << size;
      ASSERT_LE(ticks.values.size(), 6u) << lo << ' ' << size;
      EXPECT_GE(ticks.values.front(), lo - 1e-8 * size);  // ticks on the border count as inside
      EXPECT_LE(ticks.values.back(), lo + size + 1e-8 * size);
    }
  }
}

TEST(NiceTicks, EndForAnEmptyOrInfiniteRange) {
  EXPECT_EQ(niceTicks(2, 2, 5).values.size(), 1u);
  EXPECT_EQ(niceTicks(0, std::numeric_limits<double>::infinity(), 5).values.size(), 1u);
}

TEST(TickLabel, HasTheDecimalsOfTheStep) {
  EXPECT_EQ(tickLabel(0.5, 0.5), "0.5");
  EXPECT_EQ(tickLabel(1, 0.5), "1.0");
  EXPECT_EQ(tickLabel(0.25, 0.05), "0.25");
  EXPECT_EQ(tickLabel(-20, 10), "-20");
  EXPECT_EQ(tickLabel(0, 2e-6), "0");
  EXPECT_EQ(tickLabel(2e-6, 2e-6), "2e-6");
  EXPECT_EQ(tickLabel(1.5e6, 5e5), "1.5e6");
}

TEST(Thinned, KeepsShortCurvesWhole) {
  const std::vector<double> t{0, 1, 2}, y{0, 5, 0};
  EXPECT_EQ(thinned(t, y, 10), (std::vector<std::size_t>{0, 1, 2}));
}

TEST(Thinned, KeepsEndsAndEveryPeakOfOnePoint) {
  std::vector<double> t(100000), y(t.size(), 0.0);
  std::iota(t.begin(), t.end(), 0.0);
  y[12345] = 7;
  y[77777] = -3;
  const auto kept = thinned(t, y, 500);
  EXPECT_LE(kept.size(), 2000u);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  EXPECT_EQ(kept.front(), 0u);
  EXPECT_EQ(kept.back(), 99999u);
  for (const std::size_t peak : {12345u, 77777u}) {
    EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), peak)) << peak;
  }
}

TEST(Thinned, KeepsAPointThatIsNotANumber) {
  std::vector<double> t(10000), y(t.size(), 1.0);
  std::iota(t.begin(), t.end(), 0.0);
  y[5000] = std::nan("");
  const auto kept = thinned(t, y, 100);
  EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), 5000u));
}

TEST(Thinned, EndsWhenAllTimesAreEqual) {
  const std::vector<double> t(1000, 2.0), y(1000, 1.0);
  EXPECT_LE(thinned(t, y, 10).size(), 40u);
}

}  // namespace
}  // namespace dynamy
