/// Memory of elements lives in State: it changes at the end of accepted steps only, and a
/// checkpoint holds it. The scene is an overspeed governor: once a falling ball is faster than the
/// limit, a safety gear acts and never lets go.
#include <gtest/gtest.h>

#include <dynamy/testing/check_element.hpp>

#include "unit/simulation/scenes.hpp"

namespace dynamy {
namespace {

constexpr double kLimit = 5.0;   // [m/s]
constexpr double kForce = 15.0;  // [N] upward, from then on

class SafetyGear final : public ExternalForce {
 public:
  static void declare(Attributes& a) { a.reference("on", "system", "what falls"); }
  explicit SafetyGear(const Parameters& x) : ExternalForce(x), on_(x["on"].text) {}
  void connect(Topology& topology) override {
    system_ = topology.system(on_, *this);
    latch_ = topology.memory(*this, {0.0});
  }
  void addTo(const Kinematics& k, ForceSink& sink) const override {
    if (k.memory(latch_)[0] > 0.0) sink.generalised(system_, 1, kForce);
  }
  void remember(const Kinematics& k, Vec memory) const override {
    if (-k.u(system_)[1] > kLimit) memory[0] = 1.0;
  }
  void describe(Description& d) const override {
    d.signal("latched", Unit::none, "1 once the limit was exceeded",
             [](const SignalView& v) { return v.memory[0]; });
  }

 private:
  std::string on_;
  SystemHandle system_;
  MemoryHandle latch_;
};

Model fallingBall(double until) {
  Model m;
  scenes::addBall(m, "ball", 10.0);
  m.add<SafetyGear>("gear", {{"on", "ball"}});
  m.simulation.until = until, m.simulation.step = 1e-3;
  m.build();
  return m;
}

TEST(Memory, ALatchStaysWhenItsCauseIsGone) {
  Model m = fallingBall(1.5);
  Simulation simulation(m);
  ASSERT_EQ(simulation.run().ended, RunReport::Ended::finished);
  EXPECT_EQ(simulation.state().memory[0], 1.0);
  // v(t) = −10 t up to the first step beyond −5 m/s, at 0.5 s + one step; +5 m/s² from then on. At
  // 1.5 s: −5.01 + 5·0.999, exact but for rounding.
  EXPECT_NEAR(simulation.state().u[1], -5.01 + 5.0 * 0.999, 1e-11);
}

TEST(Memory, IsASignalOfTheElement) {
  Model m = fallingBall(0.1);
  const NamedSignal* signal = m.signal("gear.latched");
  ASSERT_NE(signal, nullptr);
  EXPECT_EQ(signal->memory, 1);
}

TEST(Memory, ACheckpointHoldsIt) {
  Model straight = fallingBall(1.5), first = fallingBall(0.8), second = fallingBall(1.5);
  Simulation whole(straight), begin(first), rest(second);
  ASSERT_EQ(whole.run().ended, RunReport::Ended::finished);
  ASSERT_EQ(begin.run().ended, RunReport::Ended::finished);
  rest.resume(begin.checkpoint());
  ASSERT_EQ(rest.run().ended, RunReport::Ended::finished);
  EXPECT_EQ(whole.state().u, rest.state().u);
  EXPECT_EQ(whole.state().q, rest.state().q);
}

/// Against the contract: how often it is asked is no part of the state.
class Counter final : public ExternalForce {
 public:
  static void declare(Attributes&) {}
  explicit Counter(const Parameters& x) : ExternalForce(x) {}
  void connect(Topology& topology) override { topology.memory(*this, {0.0}); }
  void addTo(const Kinematics&, ForceSink&) const override {}
  void remember(const Kinematics&, Vec memory) const override { memory[0] += 1.0; }
};

TEST(Memory, IsTheSameAfterTwoCallsInOnePlaceOrTheCheckSaysSo) {
  Model latch = fallingBall(0.1), counting;
  EXPECT_TRUE(checkModel(latch)) << checkModel(latch);
  scenes::addBall(counting, "ball", 10.0);
  counting.add<Counter>("counter", {});
  counting.simulation.until = 1.0, counting.simulation.step = 1e-3;
  counting.build();
  EXPECT_NE(checkModel(counting).message().find(
                "counter: remember() gives memory[0] = 1, called again there 2"),
            std::string::npos)
      << checkModel(counting);
}

TEST(Memory, IsReservedOnce) {
  Topology topology({});
  Model m = fallingBall(0.1);
  const Element& owner = *m.forces().front();
  EXPECT_EQ(topology.memory(owner, {1.0, 2.0}).size, 2);
  EXPECT_THROW(topology.memory(owner, {3.0}), std::logic_error);
}

}  // namespace
}  // namespace dynamy
