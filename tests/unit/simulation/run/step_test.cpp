// Simulation::step: a run that is taken step by step is the same run, to the last bit.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <string>

#include "unit/simulation/scenes.hpp"

namespace dynamy {
namespace {

using namespace scenes;

/// 50 ms steps to 0.93 s: 18 of them and a shortened one, with an impact on the way.
Model bouncing() {
  Model m = ballOnFloor(1.0, 0.5, 0.5, 0.3, 0.93, 0.05);
  m.build();
  return m;
}

/// What is to be equal: rows, motion, figures.
struct Outcome {
  Table table;
  RunReport report;
  State end;
};

Outcome outcome(Model m, const std::function<void(Simulation&)>& drive) {
  Outcome out;
  Simulation s(m);
  s.record(out.table);
  drive(s);
  out.report = s.report(), out.end = s.state();
  return out;
}

void expectEqual(const Outcome& a, const Outcome& b) {
  EXPECT_EQ(a.table.t, b.table.t);
  EXPECT_EQ(a.table.rows, b.table.rows);
  EXPECT_EQ(a.report.hash, b.report.hash);
  EXPECT_EQ(a.report.ended, b.report.ended);
  EXPECT_EQ(a.report.steps, b.report.steps);
  EXPECT_EQ(a.report.contacts.impacts, b.report.contacts.impacts);
  EXPECT_EQ(a.report.energy.end(), b.report.energy.end());
  EXPECT_EQ(a.end.t, b.end.t);
  EXPECT_EQ(a.end.q, b.end.q);
}

TEST(Steps, AreThoseOfARun) {
  int taken = 0;
  const Outcome straight = outcome(bouncing(), [](Simulation& s) { s.run(); });
  const Outcome stepped = outcome(bouncing(), [&](Simulation& s) {
    for (; s.step(); ++taken) {
      // Instants are counted, not summed; the last step ends at `until`.
      EXPECT_EQ(s.state().t, taken < 18 ? 5 * (taken + 1) / 100.0 : 0.93) << taken;
    }
  });
  EXPECT_EQ(taken, 19);
  EXPECT_EQ(straight.report.cost.evaluations, stepped.report.cost.evaluations);
  EXPECT_GT(straight.report.contacts.impacts, 0);
  expectEqual(straight, stepped);
}

TEST(Steps, OfATolerance) {
  // No contact: a pendulum, by the steps that its scheme chooses.
  const auto pendulum = [] {
    Model m;
    m.add<Pendulum>("p", {});
    m.simulation.until = 3.0, m.simulation.tolerance = 1e-8;
    m.build();
    return m;
  };
  const Outcome straight = outcome(pendulum(), [](Simulation& s) { s.run(); });
  double before = 0.0;
  const Outcome stepped = outcome(pendulum(), [&](Simulation& s) {
    while (s.step()) {
      EXPECT_GT(s.state().t, before);
      before = s.state().t;
    }
  });
  EXPECT_EQ(before, 3.0);
  expectEqual(straight, stepped);
}

TEST(Steps, MayBeFollowedByTheRestOfTheRun) {
  const Outcome straight = outcome(bouncing(), [](Simulation& s) { s.run(); });
  expectEqual(straight, outcome(bouncing(), [](Simulation& s) {
                for (int i = 0; i < 7; ++i) EXPECT_TRUE(s.step());
                s.run();
              }));
}

TEST(Steps, GoOnFromACheckpointOfOthers) {
  const Outcome straight = outcome(bouncing(), [](Simulation& s) { s.run(); });
  Table table;
  std::string bytes;
  {
    Model m = bouncing();
    Simulation first(m);
    first.record(table);
    first.onCheckpoint(1e-12, 1e12, [&](const std::string& b) { bytes = b; });
    for (int i = 0; i < 7; ++i) EXPECT_TRUE(first.step());
  }
  Outcome resumed;
  Model m = bouncing();
  Simulation second(m);
  second.record(resumed.table);
  second.resume(bytes);
  EXPECT_EQ(second.state().t, 0.35);
  while (second.step()) {
  }
  resumed.report = second.report(), resumed.end = second.state();
  expectEqual(straight, resumed);
}

/// A pendulum of length 1 m and mass 1 kg in the gravity g.
class HeavyPendulum final : public PartialMechanicalSystem {
 public:
  static void declare(Attributes& a) { a.required("g", Unit::acceleration, "gravity"); }
  explicit HeavyPendulum(const Parameters& x) : PartialMechanicalSystem(x), g_(x["g"]) {}
  Blocks blocks() const override { return {1, 1, 1, true}; }
  void initialState(Vec q, Vec u) const override { q[0] = 1.0, u[0] = 0.0; }
  void M(double, ConstVec, MassBlocks M) const override { M[0].setIdentity(); }
  void h(double, ConstVec q, ConstVec, Vec h) const override { h[0] = -g_ * std::sin(q[0]); }
  double potentialEnergy(double, ConstVec q) const override { return g_ * (1.0 - std::cos(q[0])); }

 private:
  double g_;
};

TEST(Steps, GoOnWithOtherParametersAndBookTheChangeOfEnergy) {
  const auto model = [](double g) {
    Model m;
    m.add<HeavyPendulum>("p", {{"g", g}});
    m.simulation.until = 2.0, m.simulation.tolerance = 1e-9;
    m.build();
    return m;
  };
  Model weak = model(1.0), strong = model(4.0);
  Simulation first(weak);
  while (first.state().t < 1.0) ASSERT_TRUE(first.step());
  const State at = first.state();
  const double before = 0.5 * at.u[0] * at.u[0] + 1.0 - std::cos(at.q[0]);
  Simulation second(strong);
  second.resume(first.archived(), before);
  EXPECT_EQ(second.state().q, at.q);
  EXPECT_EQ(second.state().u, at.u);
  const RunReport& report = second.run();
  ASSERT_EQ(report.ended, RunReport::Ended::finished) << report.reason;
  const State& end = second.state();
  // T + V of the strong pendulum is that at the change, to the tolerance; V jumps by 3 (1 − cos φ).
  EXPECT_NEAR(0.5 * end.u[0] * end.u[0] + 4.0 * (1.0 - std::cos(end.q[0])),
              0.5 * at.u[0] * at.u[0] + 4.0 * (1.0 - std::cos(at.q[0])), 1e-7);
  EXPECT_NEAR(report.energy.boundaries, 3.0 * (1.0 - std::cos(at.q[0])), 1e-12);
  EXPECT_NEAR(report.energy.discretisation, 0.0, 1e-7);
  EXPECT_TRUE(report.warnings.empty());
}

TEST(Steps, EndOnceAndForAll) {
  Model m = bouncing();
  Table table;
  Simulation s(m);
  s.record(table);
  while (s.step()) {
  }
  const std::size_t rows = table.rows.size();
  const long steps = s.report().steps;
  EXPECT_GE(steps, 19);  // steps that are too long have parts
  EXPECT_FALSE(s.step());
  EXPECT_EQ(s.run().steps, steps);
  EXPECT_EQ(table.rows.size(), rows);
}

TEST(Steps, EndWhereTheRunFailsAndTheReportTellsWhy) {
  Model m;
  addBall(m, "ball", 1.0);
  m.add<Broken>("motor", {{"what", "throws"}});
  m.simulation.until = 1.0, m.simulation.step = 0.1;
  m.build();
  Simulation s(m);
  int taken = 0;
  while (s.step()) ++taken;
  EXPECT_GE(taken, 4);  // it breaks at 0.5 s
  EXPECT_LE(taken, 5);
  EXPECT_EQ(s.report().ended, RunReport::Ended::failed);
  EXPECT_FALSE(s.report().reason.empty());
}

TEST(Steps, EndWhenTheRunIsStopped) {
  Model m = bouncing();
  std::atomic<bool> stop{false};
  Simulation s(m);
  s.stopWhen(stop);
  EXPECT_TRUE(s.step());
  stop = true;
  EXPECT_FALSE(s.step());  // the second step is taken, and is the last
  EXPECT_EQ(s.report().ended, RunReport::Ended::stopped);
  EXPECT_TRUE(s.report().reason.empty());
  EXPECT_EQ(s.state().t, 0.1);
}

/// Is asked to stop by a signal within its fourth step.
class Interrupted final : public OneStep {
 public:
  explicit Interrupted(std::atomic<bool>& stop) : stop_(stop) {}
  int order() const override { return 2; }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override {
    EXPECT_FALSE(s.problem().enough());
    stop_ = ++steps_ == 4;
    EXPECT_EQ(s.problem().enough(), steps_ == 4);  // solvers leave off
    return inner_.step(s, solver, x, dt);
  }

 private:
  std::atomic<bool>& stop_;
  int steps_ = 0;
  MoreauMidpoint inner_;
};

TEST(Steps, AreTakenBackIfTheRunIsStoppedWithinThem) {
  Model m = ballOnFloor(1.0, 0.5, 0.5, 0.3, 0.93, 0.05);
  std::atomic<bool> stop{false};
  m.scheme(std::make_unique<Interrupted>(stop));
  m.build();
  Simulation s(m);
  s.stopWhen(stop);
  s.run();
  EXPECT_EQ(s.report().ended, RunReport::Ended::stopped);
  EXPECT_EQ(s.report().steps, 3);
  EXPECT_DOUBLE_EQ(s.state().t, 0.15);
}

/// Advances the time by a given share of each step.
class OffClock final : public OneStep {
 public:
  explicit OffClock(double share) : share_(share) {}
  int order() const override { return 2; }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override {
    const double end = x.t + share_ * dt;
    StepReport r = inner_.step(s, solver, x, dt);
    x.t = end;
    return r;
  }

 private:
  double share_;
  MoreauMidpoint inner_;
};

TEST(Steps, OfASchemeThatMovesTheTimeByAnotherLengthAreRefused) {
  for (const double share : {1.0, 0.5, 0.0, 1.5}) {
    Model m = ballOnFloor(1.0, 0.5, 0.5, 0.3, 0.93, 0.05);
    m.scheme(std::make_unique<OffClock>(share));
    m.build();
    Simulation s(m);
    const RunReport& report = s.run();
    EXPECT_EQ(report.ended == RunReport::Ended::finished, share == 1.0) << share;
    const bool named = report.reason.find("> moved the time by ") != std::string::npos;
    EXPECT_EQ(named, share != 1.0) << report.reason;
  }
}

/// Solves short steps alone.
class OnlyShort final : public OneStep {
 public:
  int order() const override { return 2; }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override {
    StepReport r = inner_.step(s, solver, x, dt);
    if (dt > 0.02) r.solved.status = SolveStatus::stalled;
    return r;
  }

 private:
  MoreauMidpoint inner_;
};

/// Asks for a stop after the first part of a step, or its first try.
class StopsAfter final : public Observer {
 public:
  enum class What { part, attempt };
  StopsAfter(What what, std::atomic<bool>& stop) : what_(what), stop_(stop) {}
  void step(const StepView& /*view*/) override { stop_ = stop_ || what_ == What::part; }
  void failed(const StepView& /*view*/) override { stop_ = stop_ || what_ == What::attempt; }

 private:
  What what_;
  std::atomic<bool>& stop_;
};

/// A run whose steps of 50 ms are taken in four parts, stopped in the first one.
struct Stopped {
  explicit Stopped(StopsAfter::What what) : observer(what, stop), model(parted()), run(model) {
    run.record(table);
    run.observe(observer);
    run.stopWhen(stop);
    EXPECT_FALSE(run.step());
    EXPECT_EQ(run.report().ended, RunReport::Ended::stopped);
  }
  static Model parted() {
    Model m = ballOnFloor(1.0, 0.5, 0.5, 0.3, 0.93, 0.05);
    m.scheme(std::make_unique<OnlyShort>());
    m.simulation.onNonConvergence = NonConvergence::retry;
    m.build();
    return m;
  }
  std::atomic<bool> stop{false};
  StopsAfter observer;
  Table table;
  Model model;
  Simulation run;
};

TEST(Steps, OfManyPartsAreStoppedWithin) {
  Stopped s(StopsAfter::What::part);
  EXPECT_NE(s.run.report().reason.find("stopped within a step"), std::string::npos);
  EXPECT_EQ(s.run.state().t, 0.0125);
  EXPECT_DOUBLE_EQ(s.table.t.back(), 13 * 0.93e-3);  // the last thousandth of the run in the part
  EXPECT_FALSE(s.run.step());
}

TEST(Steps, ThatWereOnlyTriedAreTakenBackByAStop) {
  Stopped s(StopsAfter::What::attempt);
  const std::string& reason = s.run.report().reason;
  EXPECT_NE(reason.find("taken back"), std::string::npos) << reason;
  EXPECT_EQ(s.run.state().t, 0.0);
  EXPECT_FALSE(s.run.checkpoint().empty());
}

}  // namespace
}  // namespace dynamy
