// States of islands where one divides and two become one again.
#include <gtest/gtest.h>

#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/located/islands/divided_state.hpp>
#include <string>

namespace dynamy {
namespace {

using Eigen::VectorXd;

/// A system of n positions and velocities; 0: it stands still.
class Free final : public PartialMechanicalSystem {
 public:
  Free(const std::string& name, int n)
      : PartialMechanicalSystem(Parameters::of<Free>("Free", name, {})), n_(n) {}
  static void declare(Attributes&) {}
  Blocks blocks() const override { return {.nq = n_, .nu = n_, .constantMass = true}; }
  void initialState(Vec, Vec) const override {}
  void M(double, ConstVec, MassBlocks M) const override { M[0].setIdentity(); }
  void h(double, ConstVec, ConstVec, Vec) const override {}

 private:
  int n_;
};

constexpr ContactKey kOfA{7}, kOfC{9};

/// An island of a, b and c; the wall, which stands still, is in the view of every island.
struct Divided {
  Divided() {
    GovernedState state;
    state.governor.mode(SwitchGovernor::Mode::locate);
    state.time = 0.5, state.next = state.held.pace.next = 0.1;
    state.times = Eigen::Vector4d(1.0, 2.0, 3.0, 4.0);
    state.charged = VectorXd::LinSpaced(8, 10.0, 17.0);
    state.held.held.resize(2);
    state.held.held[0].key = kOfA, state.held.held[1].key = kOfC;
    NumberArchive numbers;
    numbers(state);
    all.systems = {0, 2, 3}, all.t = all.end = 0.25;
    all.q = VectorXd::LinSpaced(6, 1.0, 6.0), all.u = -all.q;
    numbers.copyTo(all.scheme);
    all.statuses = {{kOfA, Status::stick}, {kOfC, Status::slip}};
  }
  ClockState part(std::vector<int> systems, ContactKey key) const {
    return partOf(all, topology, std::move(systems), {&key, 1});
  }
  Free a{"a", 1}, wall{"wall", 0}, b{"b", 2}, c{"c", 3};
  Topology topology{{&a, &wall, &b, &c}};
  ClockState all;
};

GovernedState stateOf(const ClockState& x) {
  GovernedState out;
  EXPECT_TRUE(out.read(x.scheme));
  return out;
}

TEST(DividedState, PartsHaveTheirOwnNumbersAlone) {
  const Divided d;
  const ClockState part = d.part({2, 3}, kOfC);
  EXPECT_EQ(part.q, (VectorXd(5) << 2.0, 3.0, 4.0, 5.0, 6.0).finished());
  EXPECT_EQ(part.u, -part.q);
  ASSERT_EQ(part.statuses.size(), 1u);
  EXPECT_EQ(part.statuses[0].status, Status::slip);
  const GovernedState state = stateOf(part);
  EXPECT_EQ(state.times, Eigen::Vector3d(2.0, 3.0, 4.0));
  EXPECT_EQ(state.charged, (VectorXd(6) << 11.0, 12.0, 13.0, 15.0, 16.0, 17.0).finished());
  ASSERT_EQ(state.held.held.size(), 1u);
  EXPECT_EQ(state.held.held[0].key, kOfC);
}

TEST(DividedState, BecomesWholeAgain) {
  const Divided d;
  const ClockState whole =
      unionOf(d.part({3}, kOfC), unionOf(d.part({0}, kOfA), d.part({2}, ContactKey{1}), d.topology),
              d.topology);
  EXPECT_EQ(whole.systems, d.all.systems);
  EXPECT_EQ(whole.q, d.all.q);
  EXPECT_EQ(whole.u, d.all.u);
  EXPECT_EQ(whole.statuses.size(), 2u);
  const GovernedState state = stateOf(whole), before = stateOf(d.all);
  EXPECT_EQ(state.times, before.times);
  EXPECT_EQ(state.charged, before.charged);
  const ContactKey keys[] = {kOfA, kOfC};
  EXPECT_EQ(inOrder(whole.scheme, keys), d.all.scheme);
}

TEST(DividedState, KeepsTheLongerPauseOfTheEnergyBound) {
  const Divided d;
  const auto pausing = [&](ClockState x, double from, double pause) {
    GovernedState state = stateOf(x);
    state.held.pace.energyFrom = from, state.held.pace.energyPause = pause;
    NumberArchive numbers;
    numbers(state);
    numbers.copyTo(x.scheme);
    return x;
  };
  const ClockState a = pausing(d.part({0}, kOfA), 0.1, 10.0),
                   b = pausing(d.part({2, 3}, kOfC), 0.3, 100.0);
  for (const ClockState& both : {unionOf(a, b, d.topology), unionOf(b, a, d.topology)}) {
    EXPECT_EQ(stateOf(both).held.pace.energyFrom, 0.3);
    EXPECT_EQ(stateOf(both).held.pace.energyPause, 100.0);
  }
}

TEST(DividedState, IsDecidedAnewWhereOnePartIs) {
  const Divided d;
  ClockState other = d.part({3}, kOfC);
  GovernedState anew = stateOf(other);
  anew.governor.mode(SwitchGovernor::Mode::decideAnew);
  NumberArchive numbers;
  numbers(anew);
  numbers.copyTo(other.scheme);
  for (const ClockState& both : {unionOf(other, d.part({0, 2}, kOfA), d.topology),
                                 unionOf(d.part({0, 2}, kOfA), other, d.topology)}) {
    const GovernedState state = stateOf(both);
    EXPECT_EQ(state.governor.mode(), SwitchGovernor::Mode::decideAnew);
    EXPECT_EQ(state.times, stateOf(d.all).times);
  }
}

}  // namespace
}  // namespace dynamy
