#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <dynamy/io/run_files/run_difference.hpp>

namespace dynamy {
namespace {

/// Signal x of two runs, 0 … 10 s.
template <class First, class Second>
std::pair<SignalTable, SignalTable> twoRuns(First&& first, Second&& second) {
  SignalTable a, b;
  a.signals = b.signals = {{"x", ""}};
  a.columns.resize(1), b.columns.resize(1);
  for (int i = 0; i <= 1000; ++i) {
    const double t = 0.01 * i;
    a.t.push_back(t), b.t.push_back(t);
    a.columns[0].push_back(first(t)), b.columns[0].push_back(second(t));
  }
  return {a, b};
}

/// sin t, and the same off by `error`(t).
template <class Error>
std::pair<SignalTable, SignalTable> sines(Error&& error) {
  return twoRuns([](double t) { return std::sin(t); },
                 [&](double t) { return std::sin(t) + error(t); });
}

TEST(RunDifference, FindsTheRateOfExponentialGrowthAndWhereItEnds) {
  const auto [a, b] = sines([](double t) { return 1e-9 * std::exp(1.2 * t); });
  const RunDifference d = runDifference(a, b);
  EXPECT_TRUE(d.chaotic);
  // Exact up to rounding of sin t, 1e-16 of at least 1e-9.
  EXPECT_NEAR(d.growth, 1.2, 1e-6);
  EXPECT_NEAR(d.horizon, std::log(RunDifference::kLost * 2.0 / 1e-9) / 1.2, 1e-3);
}

TEST(RunDifference, FindsTheRateAlsoWhereTheMotionIsLostHalfway) {
  // From 4 s on the difference is as large as the signal.
  const auto [a, b] = sines([](double t) { return std::min(1.0, 1e-9 * std::exp(5.0 * t)); });
  const RunDifference d = runDifference(a, b);
  EXPECT_TRUE(d.chaotic);
  EXPECT_NEAR(d.growth, 5.0, 1e-6);
  EXPECT_NEAR(d.horizon, std::log(RunDifference::kLost * 2.0 / 1e-9) / 5.0, 0.1);
}

TEST(RunDifference, DoesNotTakeAPowerForChaos) {
  const auto [a, b] = sines([](double t) { return 1e-9 * std::pow(t, 4); });
  const RunDifference d = runDifference(a, b);
  EXPECT_FALSE(d.chaotic);
  EXPECT_TRUE(std::isinf(d.horizon));
  EXPECT_NEAR(d.signals[0].difference, 1e-5, 1e-12);
}

TEST(RunDifference, AJumpThatComesALittleLaterLosesNothing) {
  // A status that jumps between two rows; and one that jumps two rows later.
  for (const double later : {0.007, 0.025}) {
    const auto [a, b] = twoRuns([](double t) { return t > 0.495 ? 3.0 : 0.0; },
                                [&](double t) { return t > 0.495 + later ? 3.0 : 0.0; });
    EXPECT_EQ(std::isinf(runDifference(a, b).horizon), later < 0.01) << later;
  }
}

TEST(RunDifference, ComparesAtCommonInstantsAlone) {
  SignalTable a, b;
  a.signals = b.signals = {{"x", "m"}};
  a.t = {0.0, 0.5, 0.5, 1.0}, a.columns = {{0.0, -1.0, 1.0, 2.0}};  // an impact at 0.5 s
  b.t = {0.0, 0.4, 0.4, 0.5, 1.0}, b.columns = {{0.0, -9.0, 9.0, 1.5, 2.25}};
  const RunDifference d = runDifference(a, b);
  EXPECT_EQ(d.signals[0].end, 2.0);
  EXPECT_EQ(d.signals[0].difference, 0.25);
  EXPECT_EQ(d.signals[0].largest, 0.5);
  EXPECT_EQ(d.signals[0].t, 0.5);
}

}  // namespace
}  // namespace dynamy
