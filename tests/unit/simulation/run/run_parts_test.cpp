/// The parts of a Simulation, each alone: calls by wall time, checkpoints, attempted steps, faults,
/// unsolved steps and observers.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <dynamy/simulation/run/run_faults.hpp>
#include <optional>

#include "unit/simulation/scenes.hpp"

namespace dynamy {
namespace {

using scenes::ballOnFloor;
using std::chrono::milliseconds;

TEST(IdleCalls, ComeATenthOfASecondApart) {
  const IdleCalls::Clock::time_point t0{};
  int calls = 0;
  IdleCalls idle;
  idle.begin(t0);
  idle.at(t0 + milliseconds(200));  // there is no function yet
  idle.call([&] { ++calls; });
  idle.begin(t0);
  idle.at(t0 + milliseconds(50));
  EXPECT_EQ(calls, 0);
  idle.at(t0 + milliseconds(100)), idle.at(t0 + milliseconds(150));
  EXPECT_EQ(calls, 1);
  idle.at(t0 + milliseconds(201));
  EXPECT_EQ(calls, 2);
}

TEST(Checkpoints, AreDueAfterTheGivenTimeAndHandOnWhatWasKept) {
  Checkpoints c;
  const auto now = Checkpoints::Clock::now();
  EXPECT_FALSE(c.hasReceiver());
  EXPECT_FALSE(c.due(now + std::chrono::hours(1)));
  std::string received;
  c.receiver(10.0, 1.0, [&](const std::string& bytes) { received = bytes; });
  EXPECT_TRUE(c.hasReceiver());
  c.begin(now);
  EXPECT_FALSE(c.due(now + std::chrono::seconds(9)));
  EXPECT_TRUE(c.due(now + std::chrono::seconds(11)));
  c.handOn([&] { c.keep("state"); });
  EXPECT_EQ(received, "state");
  EXPECT_EQ(c.bytes(), "state");
  EXPECT_FALSE(c.due(Checkpoints::Clock::now()));
}

TEST(Checkpoints, StatesThatNoRunProducesAreRefused) {
  State x;
  x.q.setZero(1), x.u.setZero(1);
  EXPECT_EQ(stateFault(x, 0), "");
  x.impulses.key.resize(1), x.impulses.first = {0, 1}, x.impulses.Lambda = {0.5};
  EXPECT_EQ(stateFault(x, 1), "");
  EXPECT_EQ(stateFault(x, 0), "a contact is of an element that is not");
  x.impulses.first = {0, 2};
  EXPECT_EQ(stateFault(x, 1), "its percussions are not those of its contacts");
  x.u[0] = std::nan("");
  EXPECT_EQ(stateFault(x, 1), "a position or a velocity is not finite");
  x.t = -1.0;
  EXPECT_EQ(stateFault(x, 1), "its time is -1 s");
}

/// A ball over a floor and its system, ready for steps.
struct Scene {
  Scene() : model(ballOnFloor(1.0, 0.0, 0.5, 0.3, 1.0, 1e-3)) {
    model.build();
    model.readyScheme();
    system.emplace(model.mechanicalSystem());
  }
  Model model;
  std::optional<MechanicalSystem> system;
};

TEST(StepAttempt, CanBeUndone) {
  Scene s;
  StepAttempt step(s.model, *s.system);
  step.start();
  EXPECT_FALSE(step.attempted());
  EXPECT_EQ(step.report().dt, 0.0);
  ASSERT_TRUE(step.take(1e-3, 1e-3, nullptr));
  EXPECT_TRUE(step.attempted());
  EXPECT_TRUE(step.sound()) << step.fault();
  EXPECT_EQ(step.x().t, 1e-3);
  EXPECT_EQ(step.before().t, 0.0);
  EXPECT_NEAR(step.x().u[1], -scenes::kGravity * 1e-3, 1e-15);
  step.undo();
  EXPECT_EQ(step.x().t, 0.0);
  EXPECT_EQ(step.x().u[1], 0.0);
  step.clear(), step.settle();
  EXPECT_EQ(step.report().dt, 0.0);
  EXPECT_FALSE(step.attempted());
}

TEST(StepAttempt, IgnoresAFlagThatWasSetBefore) {
  Scene s;
  StepAttempt step(s.model, *s.system);
  step.start();
  const std::atomic<bool> stop{true};
  EXPECT_TRUE(step.take(1e-3, 1e-3, &stop));
}

TEST(StepAttempt, ContinuesFromItsArchive) {
  Scene s, other;
  StepAttempt step(s.model, *s.system), copy(other.model, *other.system);
  step.start(), step.take(1e-3, 1e-3, nullptr);
  Archive out;
  step.archive(out);
  Archive in(out.bytes());
  copy.archive(in), copy.resumed();
  EXPECT_TRUE(in.atEnd());
  EXPECT_EQ(copy.x().q, step.x().q);
  EXPECT_EQ(copy.before().t, 1e-3);
}

TEST(RunFaults, NameTheSystemThatIsNotFinite) {
  Scene s;
  State x = s.model.initialState();
  s.system->evaluate(x);
  EXPECT_TRUE(isSound(*s.system, x, {}));
  EXPECT_EQ(faultOf(s.model, *s.system, x, {}), "");
  StepReport refused;
  refused.refused = "knows no impact";
  EXPECT_FALSE(isSound(*s.system, x, refused));
  EXPECT_NE(faultOf(s.model, *s.system, x, refused).find("knows no impact"), std::string::npos);
  x.u[1] = std::nan("");
  EXPECT_FALSE(isSound(*s.system, x, {}));
  EXPECT_NE(faultOf(s.model, *s.system, x, {}).find("u[1] of"), std::string::npos);
}

TEST(UnsolvedSteps, KeepTheLargestResidual) {
  Scene s;
  StepAttempt step(s.model, *s.system);
  step.start(), step.take(1e-3, 1e-3, nullptr);
  Unsolved worst;
  UnsolvedSteps unsolved(s.model, *s.system, worst);
  StepReport report;
  report.solved.status = SolveStatus::stalled;
  report.solved.residuals.Ef = 1e-3;
  unsolved.note(5, 0.005, report, true);
  EXPECT_EQ(worst.step, 5);
  EXPECT_EQ(worst.t, 0.005);
  EXPECT_EQ(worst.residual, 1e-3);
  EXPECT_EQ(worst.status, "stalled");
  report.solved.residuals.Ef = 5e-3;  // not ten times as large
  unsolved.note(6, 0.006, report, true);
  EXPECT_EQ(worst.step, 5);
  report.solved.residuals.Ef = 0.5;
  unsolved.note(7, 0.007, report, true);
  EXPECT_EQ(worst.step, 7);
}

/// A solver that notes how long searches may take.
class EffortNoted final : public InclusionSolver {
 public:
  explicit EffortNoted(std::vector<Effort>& asked) : asked_(asked) {}
  SolveReport solve(const InclusionProblem& p, Vec) override {
    asked_.push_back(p.effort);
    SolveReport out;
    out.status = SolveStatus::stalled;
    return out;
  }

 private:
  std::vector<Effort>& asked_;
};

TEST(UnsolvedSteps, AreDiagnosedByShortSearches) {
  // A diagnosis tries several starts; searches for long took seconds each.
  std::vector<Effort> asked;
  Model model = ballOnFloor(0.0, 0.0, 0.5, 0.3, 1.0, 1e-3);
  model.solver(std::make_unique<EffortNoted>(asked));
  model.build(), model.readyScheme();
  MechanicalSystem system = model.mechanicalSystem();
  const State x = model.initialState();
  system.evaluate(x);
  system.impactProblem(x, 1e-3);
  ASSERT_EQ(system.problem().size(), 1);
  Unsolved worst;
  UnsolvedSteps unsolved(model, system, worst);
  StepReport report;
  report.contacts = 1, report.solved.status = SolveStatus::stalled;
  report.solved.residuals.Ef = 1e-3;
  unsolved.note(1, 0.001, report, true);
  ASSERT_GE(asked.size(), 2u);
  for (const Effort e : asked) EXPECT_EQ(e, Effort::retried);
  EXPECT_EQ(system.problem().effort, Effort::full);  // the step's own is as it was
}

class Counting final : public Observer {
 public:
  void start(const StepView&) override { ++starts; }
  void step(const StepView& view) override { steps += view.index; }
  void finish(const StepView&) override { ++ends; }
  int starts = 0, ends = 0;
  long steps = 0;
};

TEST(RunObservers, CallEachOneAndSumUp) {
  Scene s;
  StepAttempt step(s.model, *s.system);
  RunReport report;
  RunObservers all(s.model, report);
  Counting counting;
  all.add(counting);
  step.start();
  all.start(step.view(1, true));
  ASSERT_TRUE(step.take(1e-3, 1e-3, nullptr));
  all.step(step.view(report.steps + 1, true));
  all.finish(step.view(report.steps, true));
  EXPECT_EQ(report.steps, 1);
  EXPECT_EQ(counting.starts + counting.ends, 2);
  EXPECT_EQ(counting.steps, 1);
  EXPECT_EQ(report.hash, 0u);
  all.sumUp();
  EXPECT_NE(report.hash, 0u);
  EXPECT_NEAR(report.energy.start(), scenes::kGravity, 1e-12);
  EXPECT_TRUE(all.sinkFault().empty());
  EXPECT_TRUE(all.checks().empty());
}

}  // namespace
}  // namespace dynamy
