/// What a run's report says against itself.
#include <gtest/gtest.h>

#include <dynamy/schemes/staggered_moreau.hpp>

#include "unit/simulation/scenes.hpp"

namespace dynamy {
namespace {

using scenes::ballOnFloor;

bool warns(const std::vector<Warning>& all, const std::string& kind) {
  for (const Warning& w : all)
    if (w.kind == kind) return true;
  return false;
}

/// A pendulum of small amplitude and omega = 1 for 20 s.
RunReport pendulumRun(double dt) {
  Model m;
  m.add<scenes::Pendulum>("pendulum", {});
  m.simulation.until = 20.0, m.simulation.step = dt;
  m.build();
  return Simulation(m).run();
}

TEST(RunWatch, HasNothingAgainstAResolvedMotion) {
  const RunReport r = pendulumRun(1e-2);
  EXPECT_TRUE(r.warnings.empty()) << r.warnings.front().text;
  // The amplitude of 1 rad lowers omega to 0.938 (quarter period K(sin 1/2)); higher harmonics
  // and the falling speed at the turns change the mean by a few per cent.
  EXPECT_NEAR(r.trust.omegaDt, 0.938e-2, 0.05e-2);
  // Leapfrog: the energy swings by O(dt^2), below omega^2 dt^2.
  EXPECT_LT(r.trust.energyError, 1e-4);
}

TEST(RunWatch, TellsThatAStepDoesNotResolveTheMotion) {
  EXPECT_TRUE(warns(pendulumRun(1.6).warnings, "resolution"));
}

TEST(RunWatch, TellsARiseOfEnergyThatNothingBroughtIn) {
  RunReport r;
  r.trust.kineticMax = 2.0, r.trust.energyRise = 0.1, r.trust.energyRiseTime = 3.0;
  EXPECT_TRUE(warns(warningsOf(r, 1.0), "energy gain"));
  r.trust.energyRise = 0.01;  // 0.5 %
  EXPECT_TRUE(warningsOf(r, 1.0).empty());
  // At rest, the energy that the forces give in one step is the measure.
  r.trust.kineticMax = 1e-20, r.trust.stepEnergy = 1e-4, r.trust.energyRise = 1e-18;
  EXPECT_TRUE(warningsOf(r, 1.0).empty());
}

TEST(RunWatch, TellsEnergyThatNoForceAccountsFor) {
  RunReport r;
  r.trust.kineticMax = 2.0, r.trust.energyError = 0.1;
  EXPECT_TRUE(warns(warningsOf(r, 1.0), "energy"));
}

TEST(RunWatch, TellsOverlapsByTheSizeOfTheSceneAndByTheStep) {
  RunReport r;
  r.gaps.penetration.value = 0.02, r.gaps.penetration.t = 1.0, r.trust.way = 1.0;
  EXPECT_TRUE(warns(warningsOf(r, 1.0), "overlap"));
  EXPECT_FALSE(warns(warningsOf(r, 10.0), "overlap"));
  r.gaps.penetration.value = 1e-4, r.trust.way = 1e-5;  // ten times what a step can overlap
  EXPECT_TRUE(warns(warningsOf(r, 1.0), "overlap"));
  r.gaps.penetration.value = 1e-12, r.trust.way = 0.0;  // rounding
  EXPECT_TRUE(warningsOf(r, 1.0).empty());
}

TEST(RunWatch, TellsThatTheModelPutsBodiesIntoEachOther) {
  RunReport r;
  r.gaps.penetration.value = r.gaps.atStart.value = 1e-3, r.trust.way = 1.0;
  EXPECT_TRUE(warns(warningsOf(r, 1.0), "start overlap"));
  EXPECT_FALSE(warns(warningsOf(r, 1.0), "overlap"));
  r.trust.kineticMax = 2.0, r.trust.regain = 0.1;  // 5 %: bodies pushed apart stretched springs
  EXPECT_TRUE(warns(warningsOf(r, 1.0), "start"));
  r.trust.regain = 0.0;
  r.gaps.penetration.value = 0.05;  // far more than the model gives
  EXPECT_TRUE(warns(warningsOf(r, 1.0), "overlap"));
  r.gaps.atStart.value = 0.045;  // 0.5 % of the length more than the model gives
  EXPECT_FALSE(warns(warningsOf(r, 1.0), "overlap"));
  r.gaps.penetration.value = r.gaps.atStart.value = 1e-7;  // numbers of a file are rounded
  EXPECT_TRUE(warningsOf(r, 1.0).empty());
}

TEST(RunWatch, TellsJointsThatDriftAndUnsolvedSteps) {
  RunReport r;
  r.gaps.jointError.value = 0.01, r.solver.unconverged = 2, r.solver.solves = 5;
  const std::vector<Warning> all = warningsOf(r, 1.0);
  for (const char* kind : {"joints", "unsolved"}) EXPECT_TRUE(warns(all, kind)) << kind;
}

TEST(RunWatch, ABallThatFallsAndRestsIsFine) {
  Model m = ballOnFloor(1.0, 0.0, 0.5, 0.3, 3.0, 1e-3);
  m.build();
  const RunReport r = Simulation(m).run();
  EXPECT_TRUE(r.warnings.empty()) << r.warnings.front().text;
  // Largest T seen is that of the first landing, g h = 10 J, sampled every 12 ms: T falls by at
  // most v g 12 ms = 0.54 J before it.
  EXPECT_GT(r.trust.kineticMax, 9.4);
  EXPECT_LE(r.trust.kineticMax, 10.0 + 0.05);
}

TEST(RunWatch, SpeaksOfNoAmountBelowRounding) {
  RunReport r;
  // A scene at rest: T is rounding over rounding, and so would every ratio to it be.
  r.trust.kineticMax = 1e-50, r.trust.rounding = 1e-16;
  r.trust.energyRise = 1e-27, r.trust.energyError = 3e-29, r.contacts.energyGain.value = 1e-30;
  r.contacts.repairedImpacts = 1;
  EXPECT_TRUE(warningsOf(r, 1.0).empty()) << warningsOf(r, 1.0).front().text;
  EXPECT_LE(runFigure("run.energyRise")->value(r), RunTrust::kWarned);
  EXPECT_LE(runFigure("run.energyError")->value(r), RunTrust::kWarned);
  // A step that missed something else does not blame the forces of its inclusion.
  r.solver.unconverged = 1, r.solver.solves = 10, r.solver.residual.value = 1.3e-15;
  EXPECT_EQ(warningsOf(r, 1.0).front().text.find("not to be trusted"), std::string::npos);
}

TEST(RunWatch, KnowsWhatRoundingLeavesOfEnergies) {
  Model m = ballOnFloor(1.0, 0.0, 0.5, 0.3, 1.0, 1e-3);
  m.build();
  const RunReport r = Simulation(m).run();
  // V = 10 J at the start, T + V + works at most twice that; positions to 1e-11 of it. The part of
  // the inertia, ε ½ m L²/t², is 1e-16 J.
  EXPECT_GT(r.trust.rounding, 0.9e-10);
  EXPECT_LT(r.trust.rounding, 4e-10);
}

TEST(RunWatch, AWarningSaysHowOftenWhenAndWhere) {
  RunReport r;
  r.solver.unconverged = 3, r.solver.solves = 5, r.solver.residual.value = 0.1,
  r.solver.unsolved.t = 0.7;
  r.solver.unsolved.contact = "floor (a.xml:3)";
  r.gaps.penetration.value = 0.5, r.gaps.penetration.t = 0.2, r.gaps.penetration.name = "wall";
  const std::vector<Warning> all = warningsOf(r, 1.0);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].count, 3);
  EXPECT_EQ(all[0].t, 0.7);
  EXPECT_EQ(all[0].place, "floor (a.xml:3)");
  EXPECT_EQ(all[1].place, "wall");
  EXPECT_EQ(all[1].t, 0.2);
}

TEST(RunWatch, RepairedImpactsAreANoteUnlessTheEnergyRose) {
  RunReport r;
  r.contacts.repairedImpacts = 2, r.contacts.energyGain.value = 0.1, r.trust.kineticMax = 1.0;
  ASSERT_EQ(warningsOf(r, 1.0).size(), 1u);
  EXPECT_EQ(warningsOf(r, 1.0)[0].kind, "restitution");
  r.trust.regain = 2.0 * RunTrust::kWarned;
  EXPECT_EQ(warningsOf(r, 1.0)[0].kind, "impact law");
}

TEST(RunWatch, StepsInTimeAreANoteIfTheirErrorsAddUpToTenTolerances) {
  RunReport r;
  r.stepping.periods = 1, r.stepping.systems = 3, r.stepping.error = 0.5, r.stepping.total = 9.0;
  ASSERT_EQ(warningsOf(r, 1.0).size(), 1u);
  EXPECT_EQ(warningsOf(r, 1.0)[0].kind, "stepped");
  r.stepping.total = 11.0;
  EXPECT_EQ(warningsOf(r, 1.0)[0].kind, "time stepping");
}

TEST(RunWatch, NotesAFewStepsOfASimplerSchemeOrWithoutProjection) {
  RunReport r;
  r.steps = 1000, r.simpler.steps = 10;
  EXPECT_TRUE(warns(warningsOf(r, 1.0), "simpler step"));
  r.simpler.steps = 11;
  EXPECT_TRUE(warns(warningsOf(r, 1.0), "simpler"));
  r = {};
  r.steps = 1000, r.solver.solves = 1000, r.solver.unconverged = 10;
  r.solver.residual.value = 1e-10;  // solved; a projection did not end
  EXPECT_TRUE(warns(warningsOf(r, 1.0), "unprojected"));
  r.solver.unconverged = 11;
  EXPECT_TRUE(warns(warningsOf(r, 1.0), "unsolved"));
  r.solver.unconverged = 1, r.solver.residual.value = 1e-3;
  EXPECT_TRUE(warns(warningsOf(r, 1.0), "unsolved"));
}

TEST(RunWatch, KindsThatQualifyARunAreThoseOfWhatTheModelAsks) {
  for (const char* kind : {"unsolved", "energy gain", "overlap", "joints", "time stepping"})
    EXPECT_EQ(warningKind(kind)->says, Says::qualifies) << kind;
  for (const char* kind : {"energy", "impact law", "resolution", "rest", "start"})
    EXPECT_EQ(warningKind(kind)->says, Says::warning) << kind;
  for (const char* kind :
       {"start overlap", "start velocities", "start positions", "restitution", "stepped"})
    EXPECT_EQ(warningKind(kind)->says, Says::note) << kind;
  RunReport r;
  r.warnings.push_back({"resolution", "", 1, 0.0, ""});
  EXPECT_FALSE(r.qualified());
  r.warnings.push_back({"overlap", "", 1, 0.0, ""});
  EXPECT_TRUE(r.qualified());
}

/// Depth of the ball under the floor at the ends of steps [m].
class Deepest final : public Observer {
 public:
  void step(const StepView& view) override { value = std::max(value, -view.after.q[1]); }
  double value = 0.0;
};

TEST(RunWatch, PenetrationCoversTheEndsOfSteps) {
  for (const double e : {0.0, 0.5})
    for (const bool staggered : {false, true}) {
      Model m = ballOnFloor(1.0, 0.0, e, 0.3, 2.0, 1e-2);
      if (staggered)
        m.scheme(std::make_unique<StaggeredMoreau>());
      else
        m.scheme(std::make_unique<MoreauMidpoint>());
      m.build();
      Simulation simulation(m);
      Deepest deepest;
      simulation.observe(deepest);
      const RunReport& r = simulation.run();
      EXPECT_GE(r.gaps.penetration.value, deepest.value / 1.01)
          << e << ' ' << staggered;  // kDeeper
    }
}

TEST(RunWatch, FiguresOfTheReportCanBeChecked) {
  Model m = ballOnFloor(1.0, 0.0, 0.0, 0.3, 1.0, 1e-2);
  for (const auto& [signal, low, high] :
       {std::tuple{"run.steps", 100.0, 100.0}, std::tuple{"run.penetration", 0.0, 0.1},
        std::tuple{"ball.z", 5.0, 6.0}, std::tuple{"run.impacts", 1.0, 1.0}}) {
    CheckSettings c;
    c.signal = signal, c.low = low, c.high = high;
    m.checks.push_back(c);
  }
  m.build();
  Simulation simulation(m);
  simulation.run();
  const std::vector<CheckResult> all = simulation.checks();
  ASSERT_EQ(all.size(), 4u);
  EXPECT_TRUE(all[0].pass) << all[0].got;
  EXPECT_TRUE(all[1].pass) << all[1].got;
  EXPECT_FALSE(all[2].pass) << all[2].got;
  EXPECT_TRUE(all[3].pass) << all[3].got;
  EXPECT_EQ(runFigure("run.step"), nullptr);
  EXPECT_EQ(runFigure("ball.z"), nullptr);
}

TEST(RunWatch, AResumedRunKnowsWhatWasBefore) {
  const auto model = [](double until) {
    Model m = ballOnFloor(1.0, 2.0, 0.5, 0.3, until, 1e-3);
    m.build();
    return m;
  };
  Model whole = model(2.0), first = model(1.0), second = model(2.0);
  Simulation straight(whole), begin(first), end(second);
  straight.run(), begin.run();
  end.resume(begin.checkpoint());
  end.run();
  EXPECT_EQ(end.report().trust.way, straight.report().trust.way);
  EXPECT_EQ(end.report().trust.omegaDt, straight.report().trust.omegaDt);
}

}  // namespace
}  // namespace dynamy
