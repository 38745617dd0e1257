#include <gtest/gtest.h>

#include "scenes.hpp"

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
  EXPECT_EQ(t.rows.front()[0], 0.0);           // before the first step nothing pushes
  EXPECT_NEAR(t.rows.back()[0], 10.0, 1e-12);  // m g, solved exactly but for rounding
}

}  // namespace
}  // namespace dynamy
