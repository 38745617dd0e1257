/// The parts of RunWatch, each alone: energy, gaps, resolution and travel.
#include <gtest/gtest.h>

#include "unit/simulation/scenes.hpp"

namespace dynamy {
namespace {

using scenes::ballOnFloor;

/// Shows each step of a run to the parts, in the order of RunWatch, and keeps a report of its own.
class Parts final : public Observer {
 public:
  explicit Parts(Model& model)
      : ledger(model),
        energy(ledger, report),
        gaps(model, report),
        resolution(model, report),
        travel(model, report) {}
  void start(const StepView& initial) override {
    ledger.start(initial);
    energy.start(initial), energy.sample(initial);
    gaps.start(initial);
  }
  void step(const StepView& view) override {
    ledger.step(view), ++report.steps;
    travel.step(view), travel.contacts(view);
    given = resolution.step(view);
    energy.forcesGive(given);
    gaps.step(view);
    energy.sample(view), gaps.sample(view);
  }
  RunReport report;
  EnergyLedger ledger;
  EnergyWatch energy;
  GapWatch gaps;
  ResolutionWatch resolution;
  TravelWatch travel;
  double given = 0.0;
};

Model pendulum(double until, double dt) {
  Model m;
  m.add<scenes::Pendulum>("pendulum", {});
  m.simulation.until = until, m.simulation.step = dt;
  m.scheme(std::make_unique<MoreauMidpoint>());
  m.build();
  return m;
}

RunReport watched(Model& m) {
  Simulation s(m);
  Parts parts(m);
  s.observe(parts);
  s.run();
  parts.resolution.finish();
  return parts.report;
}

TEST(EnergyWatch, FindsTheLargestKineticEnergyAndNoErrorOfAnAccurateScheme) {
  Model m = pendulum(10.0, 1e-3);
  const RunTrust t = watched(m).trust;
  // T is largest at the bottom, 1 − cos 1. The energy of the midpoint rule swings by O(Δt²).
  EXPECT_NEAR(t.kineticMax, 1.0 - std::cos(1.0), 1e-5);
  EXPECT_LT(t.energyError, 1e-6);
  EXPECT_GT(t.rounding, 0.0);
  EXPECT_LT(t.rounding, 1e-10);
}

TEST(EnergyWatch, FindsARiseThatNothingBroughtIn) {
  Model m = pendulum(10.0, 1e-1);
  m.scheme(std::make_unique<HalfExplicitEuler>());
  EXPECT_GT(watched(m).trust.energyRise, 1e-3);
}

/// MoreauMidpoint, but a ball leaves an impact 1.2 times as fast as it should.
class Pushing final : public OneStep {
 public:
  explicit Pushing(bool inTime) : inTime_(inTime) {}
  int order() const override { return 1; }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override {
    StepReport out = inner_.step(s, solver, x, dt);
    if (s.problem().size() > 0 && s.problem().Lambda(0) > 0.0) x.u *= 1.2;
    out.counts.stepped = inTime_;
    return out;
  }

 private:
  MoreauMidpoint inner_;
  bool inTime_;
};

TEST(EnergyWatch, CountsWhatNormalForcesBringIntoStepsInTimeAsAGain) {
  const auto gain = [](bool inTime) {
    Model m = ballOnFloor(1.0, 0.0, 1.0, 0.0, 1.0, 1e-3);  // one impact, at 0.45 s
    m.scheme(std::make_unique<Pushing>(inTime));
    m.build();
    return watched(m).trust.energyGain;
  };
  // Λ = 2v does the work Λ (1.2v − v)/2 = 0.2 v², ΔT = 0.22 v², v² = 20; v is off by g Δt.
  EXPECT_NEAR(gain(true), 4.4, 0.05);
  EXPECT_NEAR(gain(false), 0.4, 0.05);  // a law may store energy: only what no work explains
}

TEST(ResolutionWatch, MeasuresTheTurnOfAnOscillationInAStep) {
  Model m = pendulum(20.0, 1e-2);
  // The amplitude of 1 rad lowers ω to 0.938; see the test of RunWatch.
  EXPECT_NEAR(watched(m).trust.omegaDt, 0.938e-2, 0.05e-2);
}

TEST(ResolutionWatch, ReturnsTheEnergyThatForcesGiveInAStep) {
  Model m = pendulum(1e-2, 1e-2);
  Simulation s(m);
  Parts parts(m);
  s.observe(parts);
  s.run();
  const double h = std::sin(1.0);  // at the start, where the pendulum is at rest
  EXPECT_NEAR(parts.given, 0.5 * 1e-4 * h * h, 1e-9);
  EXPECT_EQ(parts.report.trust.stepEnergy, parts.given);
  EXPECT_NEAR(parts.report.trust.fall, 0.5 * 1e-4 * h, 1e-8);
}

TEST(GapWatch, SeesAnOverlapOfTheInitialState) {
  Model m = ballOnFloor(-0.01, 0.0, 0.0, 0.0, 1e-3, 1e-3);
  m.build();
  Simulation s(m);
  Parts parts(m);
  s.observe(parts);
  s.run();
  EXPECT_GE(parts.report.gaps.penetration.value, 0.01);
  EXPECT_EQ(parts.report.gaps.jointError.value, 0.0);
}

/// Shows the watch each step of a ball in flight as if it had ended 0.05 m in the floor.
class Deep final : public Observer {
 public:
  explicit Deep(Model& model) : gaps(model, report) {}
  void step(const StepView& view) override {
    State deep = view.after;
    deep.q[1] = -0.05;
    gaps.step({view.model, view.system, view.scheme, view.before, deep, view.Lambda, view.gammaE,
               view.report, view.index, view.whole});
  }
  RunReport report;
  GapWatch gaps;
};

TEST(GapWatch, MeasuresOverlapsThatStepsDoNotSeeWhereBodiesPassedUnseen) {
  for (const long left : {0L, 1L}) {
    Model m = ballOnFloor(1.0, 0.0, 0.0, 0.0, 1e-3, 1e-3);
    m.build();
    Simulation s(m);
    Deep deep(m);
    deep.report.passing.left = left;
    s.observe(deep);
    s.run();
    EXPECT_EQ(deep.report.gaps.penetration.value, left > 0 ? 0.05 : 0.0);
  }
}

TEST(TravelWatch, TakesTheSpeedOfSystemsWithoutFramesFromTheirContacts) {
  Model m = ballOnFloor(1.0, 0.0, 0.0, 0.0, 1.0, 1e-3);
  m.build();
  // The ball arrives with √20 m/s, up to the gravity of a step.
  EXPECT_NEAR(watched(m).trust.way, std::sqrt(20.0) * 1e-3, 2e-5);
}

}  // namespace
}  // namespace dynamy
