// Instants that are told, and elements that switch, in runs to a tolerance (theory 50.3): forces
// are constant between them, so that what is left over is rounding, at any tolerance.
#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>
#include <dynamy/simulation/report/signal_sampler.hpp>
#include <dynamy/system/announced_signals.hpp>
#include <reference/located/located_run.hpp>

namespace dynamy::reference {
namespace {

// Of a loose run: were a single instant missed by 1e-6 s, errors would be as large.
constexpr double kLooseTolerance = 1e-3;
constexpr double kInstantRounding = 1e-11;

/// A mass of 2 kg on a line, with elements `more` and force `f(t)`.
std::string line(const std::string& force, const std::string& more = "",
                 const std::string& start = "q0=\"0\" u0=\"0\"") {
  return "<dynamy version=\"1\"><systems><Coordinates name=\"body\" q=\"x\" M=\"2\" " + start +
         " h=\"" + force + "\"/></systems><elements>" + more +
         "</elements><simulation until=\"1\" step=\"1\"/></dynamy>";
}

TEST(LocatedInstants, OfAForceThatIsSwitchedOnAndOff) {
  // 6 N for 1 ms, in a step that would pass over it: 3 m/s² · 1 ms, and what is left of the time.
  LocatedRun run(line("6*step(t - 0.3) - 6*step(t - 0.301)"), kLooseTolerance, 2.0);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_NEAR(run.state().u[0], 3e-3, kInstantRounding);
  EXPECT_NEAR(run.state().q[0], 0.5 * 3.0 * 1e-6 + 3e-3 * 1.699, kInstantRounding);
  EXPECT_EQ(run.report().located.switches, 2);
}

TEST(LocatedInstants, OfAKink) {
  // A ramp of force from 0.5 s to 1 s: a = 3 (t − ½), then 1.5 m/s².
  LocatedRun run(line("6*clamp(t - 0.5, 0, 0.5)"), kLooseTolerance, 2.0);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_NEAR(run.state().u[0], 0.375 + 1.5, kInstantRounding);
  EXPECT_NEAR(run.state().q[0], 0.0625 + 0.375 + 0.75, kInstantRounding);
}

TEST(LocatedInstants, OfABrakeThatIsAppliedWhileItSlips) {
  // 3 m/s; from 0.25 s on 8 N: 4 m/s² until it stands after 0.75 s more.
  LocatedRun run(line("0",
                      R"xml(<CoordinateContact name="brake" on="body" slipVelocity="x_dot"
                      scale="step(t - 0.25)"><GivenFriction force="8"/></CoordinateContact>)xml",
                      "q0=\"0\" u0=\"3\""),
                 kLooseTolerance, 2.0);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_NEAR(run.state().q[0], 0.75 + 9.0 / 8.0, kInstantRounding);
  EXPECT_EQ(run.state().u[0], 0.0);
}

TEST(LocatedInstants, OfALatchThatGripsAndLetsGo) {
  // 5 m/s² until 2 m/s at 0.4 s; then 30 N against 10 N, −10 m/s², until half a metre per second is
  // left after 0.15 s more, where it is let go: 5 m/s² again for 0.3 s, and so on.
  LocatedRun run(line("10", R"xml(<CoordinateContact name="jaw" on="body" slipVelocity="x_dot"
                      engage="x_dot - 2" release="0.5 - x_dot"><GivenFriction force="30"/>
                      </CoordinateContact>)xml"),
                 kLooseTolerance, 0.95);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  // 0.4 + 0.15 + 0.3 s: engaged for the second time at 0.85 s, 0.1 s before the end.
  EXPECT_NEAR(run.state().u[0], 1.0, kInstantRounding);
  EXPECT_NEAR(run.state().q[0], 0.4 + 1.25 * 0.15 + 1.25 * 0.3 + 1.5 * 0.1, kInstantRounding);
}

TEST(LocatedInstants, OfARopeThatBreaksAndAGovernorThatTrips) {
  // elevator_rope_break: 2.5/1.15 m/s down until 0.5 s, free fall to 2.5 m/s, 0.6 g upwards.
  LocatedRun run("elevator_rope_break", 1e-6, 3.0);
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  const double g = 9.81, v0 = 2.5 / 1.15,
               way = 0.5 * v0 + (6.25 - v0 * v0) / (2.0 * g) + 6.25 / (1.2 * g);
  EXPECT_NEAR(run.signal("lift/cabin.z"), 8.0 - way, 1e-9);
  EXPECT_EQ(r.stepping.periods, 0);
}

/// Balls that are fed at 1 m fall past each other, `present` of them: the k-th since k/feed. The
/// switches of the run.
long expectFed(int count, int present, int feed, double until, double rounding) {
  LocatedRun run(R"xml(<dynamy version="1">
    <parameter name="n" value="1"/><parameter name="rate" value="1"/><systems>
    <Grains name="balls" count="{n}" present="0" within="0 0 0 1 1 1" feed="{rate}" seed="1"
      feedWithin="0 0 1 10 10 1"><Sphere radius="1mm" mass="1" material="a"/></Grains>
    <Ground name="floor"><HalfSpace position="0 0 -2000" material="a"/></Ground></systems>
    <forces><Gravity/></forces><elements><Contact between="a a"><Unilateral/></Contact></elements>
    <simulation until="1" step="1"/></dynamy>)xml",
                 kLooseTolerance, until,
                 {{"n", std::to_string(count)}, {"rate", std::to_string(feed)}});
  EXPECT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  for (int k = 1; k <= present; ++k) {
    const double t = until - static_cast<double>(k) / feed;
    EXPECT_NEAR(run.state().q[7 * (k - 1) + 2], 1.0 - 0.5 * 9.81 * t * t, rounding) << k;
  }
  return run.report().contacts.switches;
}

TEST(LocatedInstants, OfAFeeder) { expectFed(5, 3, 3, 1.1, kInstantRounding); }

TEST(LocatedInstants, OfAFeederEndWithItsGrains) {
  // Two grains, 300 a second for 3 s: what is told later than the second may be one instant more.
  // They have fallen 44 m.
  EXPECT_LE(expectFed(2, 2, 300, 3.0, 10.0 * kInstantRounding), 3);
}

TEST(LocatedInstants, AtTheEndOfARunDoNotMoveItsEnd) {
  for (const double until : {1.0, 0.3}) {
    LocatedRun run(R"xml(<dynamy version="1"><parameter name="T" value="1"/><systems>
      <Coordinates name="body" q="x" units="m" q0="0" M="1" h="6*step(t-T) + 1"/></systems>
      <simulation until="1" step="1"/></dynamy>)xml",
                   kLooseTolerance, until, {{"T", std::to_string(until)}});
    ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    EXPECT_EQ(run.state().t, until);
    EXPECT_NEAR(run.state().q[0], 0.5 * until * until, kInstantRounding);
  }
}

TEST(LocatedInstants, AreRecordedByNameOnly) {
  LocatedRun run(line("6*step(t - 0.3)"), kLooseTolerance, 1.0);
  for (const NamedSignal* s : chooseSignals(run.model(), {}, {}))
    EXPECT_EQ(s->name.find("nextInstant"), std::string::npos) << s->name;
  EXPECT_EQ(chooseSignals(run.model(), {"body.nextInstant"}, {}).size(), 1u);
}

/// A brake that says when it switches, as contact elements do.
class Brake final : public ExternalForce {
 public:
  static void declare(Attributes&) {}
  explicit Brake(const Parameters& x) : ExternalForce(x) {}
  void connect(Topology&) override {}
  void addTo(const Kinematics&, ForceSink&) const override {}
  void describe(Description& d) const override {
    d.signal(kSwitching, Unit::none, "positive where it would act",
             [](const SignalView&) { return -1.0; });
  }
};

TEST(LocatedInstants, OfAForceThatSwitchesAreRefusedAsTheyWouldBeLate) {
  std::string text = line("1");
  text.replace(text.find("<elements>"), 0, "<forces>\n<Brake name=\"brake\"/></forces>");
  try {
    LocatedRun run(text, kLooseTolerance, 1.0, {}, [](Registry& r) { r.add<Brake>("Brake"); });
    FAIL() << "was taken";
  } catch (const ModelError& e) {
    const std::string said = e.what();
    EXPECT_NE(said.find("scene.xml:2:1"), std::string::npos) << said;
    EXPECT_NE(said.find("<Brake name=\"brake\">"), std::string::npos) << said;
    EXPECT_NE(said.find("is asked of contact elements only"), std::string::npos) << said;
  }
}

/// A body of 1 kg that 5 N of friction hold, under a load h(t): one LocatedRun of 40 s.
LocatedRun rubbed(const std::string& load, double tolerance) {
  return {R"xml(<dynamy version="1"><systems><Coordinates name="body" q="x" units="m"
      q0="0" M="1" h=")xml" +
              load + R"xml("/></systems><elements><CoordinateContact on="body"
      slipVelocity="x_dot"><GivenFriction force="5"/></CoordinateContact></elements>
      <simulation until="1" step="1"/></dynamy>)xml",
          tolerance, 40.0};
}

TEST(LocatedRest, ShortensStepsWhereForcesChangeUnseen) {
  // h = 4.9 sin² t + 0.3 sin 7t goes beyond 5 N now and then, for less than 0.1 s, while steps at
  // rest would grow to 26 s. Own sum of the slips: with V = ∫h dt − 5t, one begins where h rises
  // through 5 N and ends where V is back; all of them forwards.
  const auto h = [](double t) { return 4.9 * std::sin(t) * std::sin(t) + 0.3 * std::sin(7.0 * t); };
  const auto V = [](double t) {
    return 4.9 * (0.5 * t - 0.25 * std::sin(2.0 * t)) - 0.3 / 7.0 * std::cos(7.0 * t) - 5.0 * t;
  };
  const auto way = [](double t) {  // its integral
    return 4.9 * (0.25 * t * t + 0.125 * std::cos(2.0 * t)) - 0.3 / 49.0 * std::sin(7.0 * t) -
           2.5 * t * t;
  };
  const auto root = [](auto&& f, double a, double b) {  // f(a) ≤ 0 < f(b), or the other way round
    const bool rises = f(b) > 0.0;
    for (int i = 0; i < 60; ++i) ((f(0.5 * (a + b)) > 0.0) == rises ? b : a) = 0.5 * (a + b);
    return 0.5 * (a + b);
  };
  constexpr double kScan = 1e-3;
  double x = 0.0;
  int slips = 0;
  for (double t = 0.0; t < 40.0; t += kScan) {
    if (!(h(t) <= 5.0 && h(t + kScan) > 5.0)) continue;
    const double begin = root([&](double s) { return h(s) - 5.0; }, t, t + kScan);
    const auto speed = [&](double s) { return V(s) - V(begin); };
    double s = begin + kScan;
    while (speed(s) > 0.0) s += kScan;
    const double end = root(speed, s - kScan, s);
    x += way(end) - way(begin) - V(begin) * (end - begin);
    t = end, ++slips;
  }
  EXPECT_GT(slips, 5);
  LocatedRun run = rubbed("4.9*sin(t)^2 + 0.3*sin(7*t)", 1e-6);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_NEAR(run.state().q[0], x, 10.0 * 1e-6);  // L = 1 m, K = 1
  EXPECT_TRUE(run.report().warnings.empty());
}

TEST(LocatedRest, IsNotTheInstantAtWhichATumblingBodyTurnsBack) {
  // Corners of a die leave the table and hit it within 1 µs around 0.5014 s, while it accelerates at
  // 60 rad/s² from 1e-6 rad/s: forces change within steps of 2e-7 s, but it is not at rest.
  LocatedRun run("dice", 1e-4, 0.51);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_GT(run.report().contacts.impacts, 20);
  EXPECT_EQ(run.report().located.unseen.value, 0.0);
}

TEST(LocatedRest, ARatchetMissesNoPeriodOfItsRing) {
  // The model's closed form, b = 30/s², w = 10/s: (1 + b/(10 w)) + (100 − (b/w)²)/(2 b) rad a
  // period. Steps at rest grow to seven periods, and looks at 0.93 of one seem to tell that it
  // rests.
  const double gain = 1.3 + (100.0 - 9.0) / 60.0, until = 16.0 * std::acos(-1.0) / 10.0;
  for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
    LocatedRun run("ratchet", tolerance, until);
    ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    EXPECT_NEAR(run.state().q[2], 8.0 * gain, 10.0 * tolerance) << tolerance;  // K = 1
  }
}

TEST(LocatedRest, WarnsWhereForcesChangeFasterThanShortStepsLook) {
  // Steps at rest are not shortened below 0.02 T for a load that never ends to change. One that
  // grows in proportion to the time is seen, and no warning.
  const auto warnings = [](const std::string& load) {
    LocatedRun run = rubbed(load, 1e-6);
    EXPECT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    return std::count_if(run.report().warnings.begin(), run.report().warnings.end(),
                         [](const Warning& w) { return w.kind == "rest"; });
  };
  EXPECT_EQ(warnings("4*sin(1e5*t)"), 1);
  EXPECT_EQ(warnings("0.1*t"), 0);
}

}  // namespace
}  // namespace dynamy::reference
