#include <gtest/gtest.h>

#include "unit/simulation/scenes.hpp"

namespace dynamy {
namespace {

using namespace scenes;

Table recorded(Model& m) {
  m.build();
  Table table;
  Simulation s(m);
  s.record(table);
  s.run();
  return table;
}

TEST(Recorder, SamplesInsideOfStepsAndAtTheEnd) {
  Model m = ballOnFloor(1.0, 2.0, 0.0, 0.0, 0.25, 0.1);
  m.record.signals = {"ball.x", "ball.z"};
  m.record.every = 0.04;
  const Table t = recorded(m);
  const std::vector<double> expected = {0.0, 0.04, 0.08, 0.12, 0.16, 0.2, 0.24, 0.25};
  ASSERT_EQ(t.t.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_DOUBLE_EQ(t.t[i], expected[i]);
    EXPECT_NEAR(t.rows[i][0], 2.0 * expected[i], 1e-15);
  }
  // t = 0.04 lies before the kick of the first step: the scheme's own motion is still at rest.
  EXPECT_EQ(t.rows[1][1], 1.0);
}

TEST(Recorder, GivenInstantsAreAllRowsOrFurtherOnes) {
  const auto instants = [](double every) {
    Model m = ballOnFloor(1.0, 2.0, 0.0, 0.0, 0.25, 0.1);
    m.record.signals = {"ball.x"};
    m.record.at = {0.17, 0.0333, 0.2, 0.4}, m.record.every = every;
    const Table t = recorded(m);
    for (std::size_t i = 0; i < t.t.size(); ++i) EXPECT_NEAR(t.rows[i][0], 2.0 * t.t[i], 1e-15);
    return t.t;
  };
  EXPECT_EQ(instants(0.0), (std::vector<double>{0.0, 0.0333, 0.17, 0.2, 0.25}));
  EXPECT_EQ(instants(0.1), (std::vector<double>{0.0, 0.0333, 0.1, 0.17, 0.2, 0.25}));
}

TEST(Recorder, TheFirstRowHasTheForcesWithWhichTheMotionBegins) {
  // A ball of 1 kg that rests: 10 N, from the first row on, also as the smallest of all.
  Model m = ballOnFloor(0.0, 0.0, 0.0, 0.3, 0.25, 0.1);
  m.record.signals = {"floor.lambda_N", "floor.Lambda_N", "floor.status", "ball.z"};
  CheckSettings least;
  least.signal = "floor.lambda_N", least.measure = CheckSettings::Measure::min;
  least.low = 10.0 - 1e-12, least.high = 10.0 + 1e-12;  // rounding
  m.checks = {least};
  m.build();
  Table table;
  Simulation s(m);
  s.record(table);
  s.run();
  EXPECT_TRUE(s.checks()[0].pass) << s.checks()[0].got;
  ASSERT_GE(table.rows.size(), 3u);
  EXPECT_EQ(table.t[0], 0.0);
  EXPECT_NEAR(table.rows[0][0], 10.0, 1e-12);
  EXPECT_EQ(table.rows[0][1], 0.0);  // no step has had a percussion
  EXPECT_EQ(table.rows[0][2], table.rows[2][2]);
}

TEST(Recorder, AThousandRowsAreTheDefault) {
  Model m = ballOnFloor(1.0, 2.0, 0.0, 0.0, 0.5, 1e-3);
  EXPECT_EQ(recorded(m).t.size(), 1001u);
}

TEST(Recorder, AStarStandsForAllSignalsOfAnElementAndEachIsRecordedOnce) {
  Model m = ballOnFloor(1.0, 0.0, 0.5, 0.3, 0.1, 1e-2);
  m.build();
  const auto names = [&](std::vector<std::string> asked) {
    std::string out;
    for (const NamedSignal* s : chooseSignals(m, asked, {})) out += s->name + " ";
    return out;
  };
  EXPECT_EQ(names({"ball.*"}), "ball.x ball.z ball.vx ball.vz ");
  EXPECT_EQ(names({"ball.z", "ball.*"}), "ball.z ball.x ball.vx ball.vz ");
  EXPECT_EQ(names({}), names({"ball.*"}));
}

TEST(Recorder, UnknownSignalsAreAllNamedWithSuggestions) {
  Model m = ballOnFloor(1.0, 0.0, 0.5, 0.3, 0.1, 1e-2);
  m.build();
  try {
    chooseSignals(m, {"ball.zz", "ball.x", "floor.lambda_M"}, {});
    FAIL();
  } catch (const ModelError& e) {
    ASSERT_EQ(e.diagnostics().size(), 2u);
    EXPECT_EQ(e.diagnostics()[0].text, "no signal named \"ball.zz\"");
    EXPECT_EQ(e.diagnostics()[0].hint, "did you mean \"ball.z\"?");
    EXPECT_EQ(e.diagnostics()[1].hint, "did you mean \"floor.lambda_N\"?");
  }
}

TEST(Recorder, ContactForceOfARestingBallIsItsWeight) {
  Model m = ballOnFloor(0.0, 0.0, 0.0, 0.3, 0.1, 1e-2);
  m.record.signals = {"floor.lambda_N", "floor.g"};
  const Table t = recorded(m);
  EXPECT_NEAR(t.rows.front()[0], 10.0, 1e-12);  // that of the first step
  EXPECT_NEAR(t.rows.back()[0], 10.0, 1e-12);   // m g, solved exactly but for rounding
}

/// Keeps events and ledger.
class Diary final : public RecordSink {
 public:
  void row(double, std::span<const double>) override {}
  void frame(FilmInstant, std::span<const FramePose>, std::span<const ContactRecord>) override {}
  void event(const ContactEvent& e) override { events.push_back(e); }
  void ledger(const LedgerRow& row) override { rows.push_back(row); }
  bool wantsLedger() const override { return true; }
  std::vector<ContactEvent> events;
  std::vector<LedgerRow> rows;
};

Diary diaryOf(Model& m, RunReport& report) {
  m.build();
  Diary diary;
  Simulation s(m);
  s.record(diary);
  report = s.run();
  return diary;
}

TEST(RecordedEvents, TellEachImpactOnceWithItsSpeedAndImpulse) {
  Model m = ballOnFloor(1.0, 0.0, 0.5, 0.3, 1.0, 1e-4);
  RunReport report;
  const Diary diary = diaryOf(m, report);
  ASSERT_GE(diary.events.size(), 2u);
  long impacts = 0;
  for (const ContactEvent& e : diary.events) impacts += e.impact ? 1 : 0;
  EXPECT_EQ(impacts, report.contacts.impacts);
  const ContactEvent &first = diary.events[0], &second = diary.events[1];
  ASSERT_TRUE(first.impact && second.impact);  // lifting off after an impact is no event of its own
  // √(2 g h) with g = 10, h = 1; a step of 1e-4 s is late by at most g Δt, twice for its rounding
  EXPECT_NEAR(first.speed, std::sqrt(20.0), 2e-3);
  EXPECT_NEAR(second.speed, 0.5 * first.speed, 2e-3);
  EXPECT_NEAR(first.impulse, 1.5 * first.speed, 2e-3);  // m (1 + ε) v
}

TEST(RecordedEvents, TellWhenSlippingEnds) {
  Model m = ballOnFloor(0.0, 1.0, 0.0, 0.5, 1.0, 1e-3);
  RunReport report;
  const Diary diary = diaryOf(m, report);
  ASSERT_FALSE(diary.events.empty());
  const ContactEvent& last = diary.events.back();
  EXPECT_EQ(last.from, Status::slip);
  EXPECT_EQ(last.to, Status::stick);
  EXPECT_NEAR(last.t, 1.0 / (0.5 * 10.0), 2e-3);  // v/(μ g), two steps
}

TEST(RecordedLedger, BalancesInEveryRow) {
  Model m = ballOnFloor(1.0, 1.0, 0.5, 0.3, 1.0, 1e-3);
  RunReport report;
  const Diary diary = diaryOf(m, report);
  ASSERT_GT(diary.rows.size(), 300u);
  const auto sum = [](const LedgerRow& r) {
    double works = 0.0;
    for (std::size_t i = 2; i < 8; ++i) works += r.value[i];
    return r.value[0] + r.value[1] - works;
  };
  for (const LedgerRow& r : diary.rows) EXPECT_NEAR(sum(r), sum(diary.rows[0]), 1e-12) << r.t;
  EXPECT_EQ(diary.rows.front().t, 0.0);
  EXPECT_EQ(diary.rows.back().t, 1.0);
  EXPECT_NEAR(diary.rows.back().value[4], report.energy.normal, 1e-12);  // the same sums
}

}  // namespace
}  // namespace dynamy
