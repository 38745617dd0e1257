// A view on some systems of a model: it evaluates these alone, in arrays of its own.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "unit/stages/stage_fixture.hpp"

namespace dynamy {
namespace {

using Eigen::VectorXd;

/// One mass, which counts how often its forces are evaluated.
class Mass final : public PartialMechanicalSystem {
 public:
  explicit Mass(const std::string& name)
      : PartialMechanicalSystem(Parameters::of<Mass>("Mass", name, {})) {}
  static void declare(Attributes&) {}
  Blocks blocks() const override { return {.nq = 1, .nu = 1, .constantMass = true}; }
  void initialState(Vec q, Vec u) const override { q.setZero(), u.setZero(); }
  void M(double, ConstVec, MassBlocks M) const override { M[0](0, 0) = 2.0; }
  void h(double, ConstVec, ConstVec, Vec h) const override { ++calls, h[0] = -20.0; }
  int frames() const override { return 1; }
  void frame(double, ConstVec q, ConstVec, int, Frame& f) const override { f.r_OS_I.x() = q[0]; }
  mutable int calls = 0;
};

/// A force of 3 N on one mass and −3 N on another.
class Between final : public ExternalForce {
 public:
  Between(std::string a, std::string b) : names_{std::move(a), std::move(b)} {}
  void connect(Topology& topology) override {
    topology.noting().begin(this);
    for (int i = 0; i < 2; ++i) ends_[i] = topology.system(names_[i], *this);
    topology.noting().begin(nullptr);
  }
  void addTo(const Kinematics&, ForceSink& sink) const override {
    ++calls;
    sink.generalised(ends_[0], 0, 3.0), sink.generalised(ends_[1], 0, -3.0);
  }
  mutable int calls = 0;

 private:
  std::string names_[2];
  SystemHandle ends_[2];
};

/// −1 N on every mass. It requests no system by name.
class Wind final : public ExternalForce {
 public:
  void connect(Topology& topology) override { topology_ = &topology; }
  void addTo(const Kinematics&, ForceSink& sink) const override {
    for (int i = 0; i < 3; ++i) sink.generalised(topology_->system(i), 0, -1.0);
  }

 private:
  const Topology* topology_ = nullptr;
};

struct ThreeMasses {
  ThreeMasses() {
    first.connect(topology), second.connect(topology);
    parts.topology = &topology, parts.forces = {&first, &second}, parts.impactLaw = &law;
    x.q = VectorXd::Zero(3), x.u = VectorXd::Zero(3);
  }
  Mass masses[3]{Mass("a"), Mass("b"), Mass("c")};
  Topology topology{{&masses[0], &masses[1], &masses[2]}};
  Between first{"a", "b"}, second{"b", "c"};
  NewtonImpact law;
  SystemParts parts;
  State x;
};

TEST(SystemView, EvaluatesItsSystemsAloneInArraysOfItsOwn) {
  ThreeMasses all;
  MechanicalSystem whole(all.parts);
  EXPECT_EQ(whole.evaluate(all.x).h, Eigen::Vector3d(-17.0, -20.0, -23.0));
  SystemSubset subset;
  subset.assign(all.topology, {0, 1, 1}, all.parts.forces, all.parts.contacts);
  SystemParts parts = all.parts;
  parts.subset = &subset;
  MechanicalSystem view(parts);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(view.evaluate(all.x).h, Eigen::Vector3d(-17.0, 0.0, 0.0));
  EXPECT_EQ(all.masses[0].calls, 3);
  EXPECT_EQ(all.masses[2].calls, 1);
  EXPECT_EQ(all.second.calls, 1);  // it acts on no system of the view
  EXPECT_EQ(whole.slot(0).h, Eigen::Vector3d(-17.0, -20.0, -23.0));
  // Its owner may give it other systems.
  subset.assign(all.topology, {1, 0, 0}, all.parts.forces, all.parts.contacts);
  EXPECT_EQ(view.evaluate(all.x).h, Eigen::Vector3d(0.0, -20.0, -23.0));
  EXPECT_EQ(view.evaluations(), 3);
}

TEST(SystemView, ForcesOnAllSystemsLeaveNothingOutside) {
  ThreeMasses all;
  Wind wind;
  wind.connect(all.topology);
  all.parts.forces = {&wind};
  SystemSubset subset;
  subset.assign(all.topology, {0, 1, 0}, all.parts.forces, all.parts.contacts);
  SystemParts parts = all.parts;
  parts.subset = &subset;
  MechanicalSystem view(parts);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(view.evaluate(all.x).h, Eigen::Vector3d(-21.0, 0.0, -21.0));
}

TEST(SystemView, NumbersItsSystemsAnewWhereOthersAreOmitted) {
  ThreeMasses all;
  const FrameHandle a = all.topology.frame(all.topology.system(0), 0),
                    c = all.topology.frame(all.topology.system(2), 0);
  SystemSubset subset(SystemSubset::Outside::omitted);
  subset.assign(all.topology, {1, 0, 0}, all.parts.forces, all.parts.contacts);
  Topology own = topologyOf(subset, all.topology);
  EXPECT_EQ(own.nq(), 2);
  EXPECT_EQ(own.requestedFrames(), (std::vector<std::pair<int, int>>{{1, 0}}));
  SystemParts parts = all.parts;
  parts.topology = &own, parts.subset = &subset;
  EXPECT_EQ(parts.numberOf(a), -1);
  EXPECT_EQ(parts.numberOf(c), 0);
  MechanicalSystem view(parts);
  State x;
  x.q = Eigen::Vector2d(0.25, 0.5), x.u = Eigen::Vector2d(1.0, 2.0);
  const Evaluation& e = view.evaluate(x);
  // Forces on a, which has no place here, are left out; those on b and c keep their handles.
  EXPECT_EQ(e.h, Eigen::Vector2d(-20.0, -23.0));
  const Kinematics& k = e.kinematics;
  EXPECT_TRUE(k.leavesOut(0));
  EXPECT_TRUE(k.frame(a).absent);
  EXPECT_FALSE(k.frame(c).absent);
  EXPECT_EQ(k.frame(c).r_OS_I.x(), 0.5);
  EXPECT_EQ(k.q(all.topology.system(2))[0], 0.5);
  EXPECT_EQ(k.u(1)[0], 1.0);
  EXPECT_THROW(k.q(all.topology.system(0)), std::logic_error);
  view.move(x, 0.5);
  EXPECT_EQ(x.q, Eigen::Vector2d(0.75, 1.5));
}

TEST(SystemView, TakesNoForcesAtTheEndOfAStep) {
  ThreeMasses all;
  SystemSubset subset;
  subset.assign(all.topology, {0, 1, 1}, all.parts.forces, all.parts.contacts);
  all.parts.subset = &subset;
  MechanicalSystem view(all.parts);
  EXPECT_THROW(view.evaluate(all.x, {.ahead = 1e-3, .damped = &kImplicitMidpoint}),
               std::logic_error);
}

TEST(SystemView, FramesMadeAnewAreThoseOfItsSystems) {
  ThreeMasses all;
  all.topology.frame(all.topology.system(0), 0), all.topology.frame(all.topology.system(2), 0);
  SystemSubset subset;
  subset.assign(all.topology, {0, 1, 1}, all.parts.forces, all.parts.contacts);
  Kinematics k;
  const State& x = all.x;
  for (int i = 0; i < 2; ++i) {
    k.resize(all.topology);
    k.evaluate(all.topology, 0.0, view(x.q), view(x.u), {nullptr, 0}, &subset);
    EXPECT_FALSE(k.frame({0}).absent);
    EXPECT_TRUE(k.frame({1}).absent);
  }
}

TEST(SystemView, SubsetsKnowWhatActsOnThem) {
  ThreeMasses all;
  SystemSubset subset;
  subset.assign(all.topology, {0, 1, 1}, all.parts.forces, all.parts.contacts);
  EXPECT_EQ(subset.systems(), std::vector<int>{0});
  EXPECT_EQ(subset.forces(), std::vector<int>{0});
  EXPECT_EQ(subset.beside(), std::vector<int>{1});
  const std::uint64_t stamp = subset.stamp();
  subset.assign(all.topology, {0, 1, 1}, all.parts.forces, all.parts.contacts);
  EXPECT_EQ(subset.stamp(), stamp);
  EXPECT_THROW(subset.assign(all.topology, {0}, all.parts.forces, all.parts.contacts),
               std::logic_error);
}

}  // namespace
}  // namespace dynamy
