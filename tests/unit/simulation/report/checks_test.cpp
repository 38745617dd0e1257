#include <gtest/gtest.h>

#include <numbers>

#include "unit/simulation/scenes.hpp"

namespace dynamy {
namespace {

using namespace scenes;
using Measure = CheckSettings::Measure;

CheckSettings check(const std::string& signal, Measure measure, double low, double high) {
  CheckSettings c;
  c.signal = signal, c.measure = measure, c.low = low, c.high = high;
  return c;
}

double measured(Measure measure, double from, double to, double (*f)(double), int n = 1000) {
  CheckSettings c = check("s", measure, 0, 0);
  Measurement m(c);
  m.reserve(static_cast<std::size_t>(n) + 1);
  for (int i = 0; i <= n; ++i) {
    const double t = from + (to - from) * i / n;
    m.add(t, f(t));
  }
  return m.result();
}

double wave(double t) { return 3.0 + std::sin(2.0 * std::numbers::pi * t); }

TEST(Checks, PeriodIsTheDistanceOfUpwardCrossings) {
  // Linear interpolation of a sine at its steepest point: error of third order in the spacing.
  EXPECT_NEAR(measured(Measure::period, 0.1, 4.3, wave), 1.0, 1e-6);
}

TEST(Checks, PeriodOfAMonotonicSignalIsMissing) {
  EXPECT_TRUE(std::isnan(measured(Measure::period, 0, 1, [](double t) { return t; })));
}

TEST(Checks, ChatterAtTheLevelIsOneCrossing) {
  // ± 1 % of chatter on a triangle of period 1 that crosses slowly.
  const auto chatter = [](double t) {
    const double triangle = std::abs(2.0 * (t - std::floor(t)) - 1.0);
    return triangle + 0.01 * std::sin(400.0 * t);
  };
  // A crossing may move by the chatter over the slope: 0.01/2 at both ends of 4 periods.
  EXPECT_NEAR(measured(Measure::period, 0.0, 5.0, chatter, 5000), 1.0, 0.01 / 4);
}

TEST(Checks, MeanIsTheIntegralOverTheInterval) {
  // Trapezoids over whole periods of a sine are exact.
  EXPECT_NEAR(measured(Measure::mean, 0.0, 2.0, wave), 3.0, 1e-13);
}

TEST(Checks, CountCountsUpwardJumpsOfWholeNumbers) {
  EXPECT_EQ(measured(Measure::count, 0, 10, [](double t) { return std::fmod(std::floor(t), 3); }),
            7.0);  // 0 1 2 0 1 2 0 1 2 0 1: up twice in three rounds and once more
}

TEST(Checks, CountCountsChangesOfSignOfOtherSignals) {
  EXPECT_EQ(measured(Measure::count, 0.1, 2.1, [](double t) { return wave(t) - 3.0; }), 4.0);
}

TEST(Checks, FiguresDoNotDependOnTheRecording) {
  const auto run = [](double every) {
    Model m = ballOnFloor(1.0, 2.0, 0.5, 0.2, 1.0, 1e-3);
    m.record.every = every;
    m.checks = {check("ball.z", Measure::max, 0, 1), check("ball.z", Measure::mean, 0, 1),
                check("floor.status", Measure::count, 0, 10)};
    m.checks[0].from = 0.5;
    m.build();
    Table table;
    Simulation s(m);
    s.record(table);
    s.run();
    std::vector<double> got;
    for (const CheckResult& r : s.checks()) got.push_back(r.got);
    return got;
  };
  EXPECT_EQ(run(1e-3), run(0.3));
}

TEST(Checks, ValueIsInterpolatedByTheScheme) {
  Model m = ballOnFloor(1.0, 2.0, 0.5, 0.2, 1.0, 0.1);
  m.checks = {check("ball.x", Measure::value, 0.09, 0.11)};
  m.checks[0].at = 0.05;
  m.build();
  Simulation s(m);
  s.run();
  EXPECT_NEAR(s.checks()[0].got, 0.1, 1e-15);
  EXPECT_TRUE(s.checks()[0].pass);
}

TEST(Checks, AnIntervalNotReachedFails) {
  Model m = ballOnFloor(1.0, 2.0, 0.5, 0.2, 1.0, 0.1);
  m.checks = {check("ball.x", Measure::max, -100, 100)};
  m.checks[0].to = 2.0;
  m.build();
  Simulation s(m);
  s.run();
  EXPECT_FALSE(s.checks()[0].pass);
  EXPECT_EQ(s.checks()[0].note, "the run ended at 1 s");
}

TEST(Checks, UnknownSignalsAreModelErrors) {
  Model m = ballOnFloor(1.0, 2.0, 0.5, 0.2, 1.0, 0.1);
  m.checks = {check("bal.x", Measure::max, -100, 100)};
  m.build();
  EXPECT_THROW(Simulation{m}, ModelError);
}

}  // namespace
}  // namespace dynamy
