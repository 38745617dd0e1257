#include <gtest/gtest.h>

#include "unit/simulation/scenes.hpp"

namespace dynamy {
namespace {

using namespace scenes;

TEST(Simulation, EndsExactlyAtTheEndTimeWithAShortenedStep) {
  Model m = ballOnFloor(1.0, 0.0, 0.0, 0.0, 0.25, 0.1);
  m.build();
  Simulation s(m);
  const RunReport& r = s.run();
  EXPECT_EQ(r.ended, RunReport::Ended::finished);
  EXPECT_EQ(r.steps, 3);
  EXPECT_EQ(s.state().t, 0.25);
  // Moreau's midpoint rule is exact for a parabola; three steps round a few times.
  EXPECT_NEAR(s.state().q[1], 1.0 - 0.5 * kGravity * 0.0625, 1e-15);
}

TEST(Simulation, GoesOnAtItsStepsWhenTheEndIsMovedAhead) {
  Model m = ballOnFloor(1.0, 0.0, 0.0, 0.0, 0.25, 0.1);
  m.build();
  Simulation s(m);
  std::vector<double> ends;
  while (s.state().t < 0.25) ASSERT_TRUE(s.step());
  m.simulation.until = 0.4;
  while (s.state().t < 0.4) {
    ASSERT_TRUE(s.step());
    ends.push_back(s.state().t);
  }
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[0], 0.3);  // the remainder of the step that 0.25 has shortened
  EXPECT_EQ(ends[1], 0.4);
  EXPECT_NEAR(s.state().q[1], 1.0 - 0.5 * kGravity * 0.16, 1e-15);  // rounding, as above
}

TEST(Simulation, AnArchivedStateContinuesWithTheSameBits) {
  Model m = ballOnFloor(1.0, 0.0, 0.5, 0.0, 1.0, 1e-2);
  m.build();
  Simulation straight(m);
  ASSERT_TRUE(straight.start());
  EXPECT_EQ(straight.state().t, 0.0);
  for (int i = 0; i < 50; ++i) ASSERT_TRUE(straight.step());
  const std::string state = straight.archived();
  straight.run();
  Simulation again(m);
  again.resume(state);
  EXPECT_EQ(again.state().t, 0.5);
  again.run();
  EXPECT_EQ(again.state().q, straight.state().q);
  EXPECT_EQ(again.state().u, straight.state().u);
}

TEST(Simulation, TimeIsCountedAndDoesNotDrift) {
  Model m = ballOnFloor(1.0, 0.0, 0.5, 0.0, 30.0, 1e-3);
  m.build();
  Simulation s(m);
  EXPECT_EQ(s.run().steps, 30000);
  EXPECT_EQ(s.state().t, 30.0);  // summing 1e-3 misses it by some 1e-11
}

TEST(Simulation, CountsImpactsOfABallThatBouncesTwiceBeforeTheEnd) {
  // Fall 1 m: t1 = sqrt(2/g) = 0.4472, then 2 ε t1 each: impacts at 0.4472 and 0.8944 for ε = 0.5.
  Model m = ballOnFloor(1.0, 0.0, 0.5, 0.0, 1.0, 1e-3);
  m.build();
  Simulation s(m);
  const RunReport& r = s.run();
  EXPECT_EQ(r.contacts.impacts, 2);
  EXPECT_GE(r.solver.solves, 2);  // the midpoint may still lie below the floor in the step after
  EXPECT_GE(r.contacts.switches, 4);  // closed and opened, twice
  EXPECT_EQ(r.gaps.penetration.name, "floor");
  // At most half a step of the impact speed sqrt(2 g) and the midpoint's own half step.
  EXPECT_LE(r.gaps.penetration.value, std::sqrt(20.0) * 1e-3);
  EXPECT_GT(r.gaps.penetration.value, 0.0);
}

TEST(Simulation, ARestingContactIsNoImpact) {
  Model m = ballOnFloor(0.0, 0.0, 0.5, 0.3, 1.0, 1e-3);
  m.build();
  Simulation s(m);
  const RunReport& r = s.run();
  EXPECT_EQ(r.contacts.impacts, 0);
  EXPECT_EQ(r.solver.solves, 1000);
  EXPECT_LE(s.state().q[1], 1e-12);
}

TEST(Simulation, StopsAtTheFirstNumberThatIsNotFiniteAndNamesTheSystem) {
  Model m;
  addBall(m, "ball", 1.0);
  m.add<Broken>("motor", {});
  m.simulation.until = 1.0, m.simulation.step = 0.1;
  m.build();
  Table table;
  Simulation s(m);
  s.record(table);
  const RunReport& r = s.run();
  EXPECT_EQ(r.ended, RunReport::Ended::failed);
  EXPECT_EQ(r.reason, "t = 0.6 s: u[0] of \"motor\" is not finite");
  EXPECT_EQ(r.steps, 5);
  EXPECT_EQ(s.state().t, 0.5);  // the last state that was sound
  EXPECT_TRUE(s.state().u.allFinite());
  EXPECT_EQ(table.t.back(), 0.5);  // nothing recorded is lost
}

/// Why a run ends whose motor is broken from 0.5 s on.
std::string reasonOfBroken(const char* what) {
  Model m;
  m.add<Broken>("motor", {{"what", what}});
  m.simulation.until = 1.0, m.simulation.step = 0.1;
  m.build();
  Simulation s(m);
  EXPECT_EQ(s.run().ended, RunReport::Ended::failed);
  return s.report().reason;
}

TEST(Simulation, StopsAtAnIndefiniteMassMatrixAndNamesTheSystem) {
  EXPECT_EQ(reasonOfBroken("mass"),
            "t = 0.6 s: the mass matrix of \"motor\" is not positive definite");
}

TEST(Simulation, AnElementThatThrowsIsNamed) {
  const std::string reason = reasonOfBroken("throws");
  EXPECT_TRUE(reason.starts_with("t = 0.5")) << reason;
  EXPECT_TRUE(reason.ends_with(" s: <element name=\"motor\"> failed: beyond the table")) << reason;
}

TEST(Simulation, ALawThatThrowsIsNamed) {
  Model m;
  addBall(m, "ball", 0.0);
  Parameters p = Parameters::of<Floor>({}, "floor", {{"on", "ball"}, {"belt", 0.0}});
  p.children.push_back(
      {Kind::law, std::make_unique<ThrowingLaw>(Parameters::of<ThrowingLaw>("Sticky", "", {}))});
  m.add(std::make_unique<Floor>(p));
  m.simulation.until = 1.0, m.simulation.step = 0.1;
  m.build();
  Simulation s(m);
  EXPECT_EQ(s.run().ended, RunReport::Ended::failed);
  const std::string& reason = s.report().reason;
  EXPECT_TRUE(reason.ends_with(" s: <Sticky> threw something that is no std::exception")) << reason;
}

TEST(Simulation, AMissingStepIsAModelError) {
  Model m = ballOnFloor(1.0, 0.0, 0.5, 0.0, 1.0, 0.0);
  m.build();
  EXPECT_THROW(Simulation{m}, ModelError);
}

TEST(Simulation, AFlagEndsTheRunAtTheNextStep) {
  class Flagger final : public Observer {
   public:
    explicit Flagger(std::atomic<bool>& flag) : flag_(flag) {}
    void step(const StepView& v) override { flag_ = v.index >= 7; }

   private:
    std::atomic<bool>& flag_;
  };
  Model m = ballOnFloor(1.0, 0.0, 0.5, 0.0, 1.0, 1e-2);
  m.build();
  std::atomic<bool> flag{false};
  Flagger flagger(flag);
  Table table;
  Simulation s(m);
  s.record(table);
  s.observe(flagger);
  s.stopWhen(flag);
  const RunReport& r = s.run();
  EXPECT_EQ(r.ended, RunReport::Ended::stopped);
  EXPECT_EQ(r.steps, 7);
  EXPECT_EQ(table.t.back(), 0.07);
  EXPECT_FALSE(s.checkpoint().empty());
}

TEST(Simulation, AnObserverThatThrowsEndsTheRunWithItsMessage) {
  class Thrower final : public Observer {
   public:
    void step(const StepView&) override { throw std::runtime_error("disk full"); }
  };
  Model m = ballOnFloor(1.0, 0.0, 0.5, 0.0, 1.0, 1e-2);
  m.build();
  Thrower thrower;
  Simulation s(m);
  s.observe(thrower);
  EXPECT_EQ(s.run().ended, RunReport::Ended::failed);
  EXPECT_EQ(s.report().reason, "disk full");
  // The figures so far stand all the same: a ball of 1 kg at 1 m.
  EXPECT_GT(s.report().t, 0.0);
  EXPECT_NE(s.report().energy.potentialStart, 0.0);
  EXPECT_NE(s.report().hash, 0U);
}

/// Solves steps of at most `longest` only.
class ShortSteps final : public InclusionSolver {
 public:
  explicit ShortSteps(double longest) : longest_(longest) {}
  SolveReport solve(const InclusionProblem& p, Vec Lambda) override {
    SolveReport r = inner_.solve(p, Lambda);
    if (p.dt > longest_ && p.size() > 0) {
      r.status = SolveStatus::maxIterations;
      r.residuals.worst = 0, r.residuals.Eu = 0.5;
    }
    return r;
  }

 private:
  double longest_;
  ProxGaussSeidel inner_;
};

Model hardModel(NonConvergence policy) {
  Model m = ballOnFloor(0.0, 0.0, 0.0, 0.3, 1.0, 0.1);
  m.solver(std::make_unique<ShortSteps>(0.03));
  m.simulation.onNonConvergence = policy;
  m.build();
  return m;
}

TEST(Simulation, WarnCountsAndGoesOn) {
  Model m = hardModel(NonConvergence::warn);
  Simulation s(m);
  const RunReport& r = s.run();
  EXPECT_EQ(r.ended, RunReport::Ended::finished);
  EXPECT_EQ(r.solver.unconverged, 10);
  EXPECT_EQ(r.solver.residual.value, 0.5);
  EXPECT_EQ(r.solver.residual.name, "floor");
}

TEST(Simulation, StopNamesTheWorstContact) {
  Model m = hardModel(NonConvergence::stop);
  Simulation s(m);
  const RunReport& r = s.run();
  EXPECT_EQ(r.ended, RunReport::Ended::failed);
  EXPECT_NE(r.reason.find("worst at floor"), std::string::npos) << r.reason;
  EXPECT_EQ(r.steps, 0);
}

TEST(Simulation, RetryHalvesUntilTheStepIsSolved) {
  // 0.1 and 0.05 fail, 0.025 is solved: 4 accepted and 3 rejected steps for each of the ten.
  Model m = hardModel(NonConvergence::retry);
  Simulation s(m);
  const RunReport& r = s.run();
  EXPECT_EQ(r.steps, 40);
  EXPECT_EQ(r.rejected, 30);
  EXPECT_EQ(r.solver.unconverged, 0);
  EXPECT_EQ(s.state().t, 1.0);
}

TEST(Simulation, SameModelSameHashAndAnotherModelAnother) {
  const auto hashOf = [](double z) {
    Model m = ballOnFloor(z, 1.0, 0.5, 0.3, 2.0, 1e-3);
    m.build();
    Table table;
    Simulation s(m);
    s.record(table);
    return s.run().hash;
  };
  EXPECT_EQ(hashOf(1.0), hashOf(1.0));
  EXPECT_NE(hashOf(1.0), hashOf(std::nextafter(1.0, 2.0)));
}

TEST(Simulation, TheHashCoversTheStepsAndNotWhatIsRecorded) {
  const auto hashOf = [](double step, double every, bool recorded) {
    Model m = ballOnFloor(1.0, 1.0, 0.5, 0.3, 2.0, step);
    m.record.every = every;
    m.build();
    Table table;
    Simulation s(m);
    if (recorded) s.record(table);
    return s.run().hash;
  };
  const std::uint64_t alone = hashOf(1e-3, 0.0, false);
  EXPECT_EQ(hashOf(1e-3, 0.0, true), alone);
  EXPECT_EQ(hashOf(1e-3, 0.37, true), alone);
  EXPECT_EQ(hashOf(1e-3, 1e-4, true), alone);
  EXPECT_NE(hashOf(5e-4, 0.0, false), alone);
  // At rest every state is the same, but not the steps to it.
  const auto restingFor = [](double until, double step) {
    Model m = ballOnFloor(0.0, 0.0, 0.0, 0.0, until, step);
    m.build();
    return Simulation(m).run().hash;
  };
  EXPECT_NE(restingFor(1.0, 0.1), restingFor(1.0, 0.05));
}

TEST(Simulation, ACheckpointOfAnotherModelIsRefused) {
  Model m = ballOnFloor(1.0, 0.0, 0.5, 0.0, 0.1, 1e-2);
  m.build();
  Simulation s(m);
  s.run();
  Model other;
  other.add<Pendulum>("p", {});
  other.simulation.step = 0.1;
  other.build();
  Simulation t(other);
  EXPECT_THROW(t.resume(s.checkpoint()), ModelError);
  EXPECT_THROW(t.resume("rubbish"), ModelError);
}

TEST(Simulation, RefusesACheckpointOfAnotherLayoutByItsNumber) {
  Model m = ballOnFloor(1.0, 0.0, 0.5, 0.0, 0.1, 1e-2);
  m.build();
  Simulation s(m);
  s.run();
  std::string old = s.checkpoint();
  const std::size_t number =
      old.find("dynamy checkpoint ") + std::string("dynamy checkpoint ").size();
  ASSERT_LT(number, old.size());
  old[number] = '2';
  const std::string named = old.substr(number, 2);
  Simulation t(m);
  try {
    t.resume(old);
    FAIL() << "was taken";
  } catch (const ModelError& e) {
    EXPECT_NE(std::string(e.what()).find("\"dynamy checkpoint " + named + "\""), std::string::npos)
        << e.what();
  }
}

}  // namespace
}  // namespace dynamy
