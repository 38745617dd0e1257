// Where systems lie in q and u, names, and the evaluation of frames.
#include <gtest/gtest.h>

#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/system/description.hpp>
#include <dynamy/system/kinematics.hpp>

namespace dynamy {
namespace {

/// Points (x, y), `capacity` of them; frame i is point i, frame `capacity` stands still at −x.
class Points final : public PartialMechanicalSystem {
 public:
  explicit Points(const Parameters& x)
      : PartialMechanicalSystem(x), capacity_(x["capacity"].integer()) {}
  static void declare(Attributes& a) {
    a.add(AttributeType::integer, "capacity", "1", "number of points");
  }
  Blocks blocks() const override { return {.nq = 2, .nu = 2, .capacity = capacity_}; }
  void initialState(Vec q, Vec u) const override { q.setZero(), u.setZero(); }
  void M(double, ConstVec, MassBlocks M) const override {
    for (int b = 0; b < M.capacity(); ++b) M[b].setIdentity();
  }
  void h(double, ConstVec, ConstVec, Vec h) const override { h.setZero(); }
  int frames() const override { return capacity_ + 1; }
  void frame(double, ConstVec q, ConstVec u, int id, Frame& f) const override {
    ++calls;
    if (id == capacity_) {
      f.r_OS_I = -Vec3::UnitX();
      f.block = -1;
      return;
    }
    f.block = id;
    f.r_OS_I = {q[2 * id], q[2 * id + 1], 0.0};
    f.v_S_I = {u[2 * id], u[2 * id + 1], 0.0};
    f.J_S_I(0, 0) = f.J_S_I(1, 1) = 1.0;
  }
  void describe(Description& d) const override { d.frame("anchor", capacity_); }
  mutable int calls = 0;

 private:
  int capacity_;
};

Points make(const std::string& name, int capacity) {
  return Points(Parameters::of<Points>("Points", name, {{"capacity", double(capacity)}}));
}

class Asking final : public Element {
 public:
  explicit Asking(const Parameters& x) : Element(x) {}
  static void declare(Attributes&) {}
};

struct Scene {
  Points ball = make("ball", 1), sand = make("sand", 3);
  Topology topology{{&ball, &sand}};
  Asking asking{Parameters::of<Asking>("Spring", "s1", {})};
};

std::string messageOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const ModelError& error) {
    return error.diagnostics().front().format();
  }
  return "no error";
}

TEST(Topology, PlacesSystemsOneAfterTheOther) {
  Scene s;
  const SystemHandle sand = s.topology.system("sand", s.asking);
  EXPECT_EQ(sand.index, 1);
  EXPECT_EQ(sand.q0, 2);
  EXPECT_EQ(sand.nq, 6);
  EXPECT_EQ(sand.u0, 2);
  EXPECT_EQ(sand.nu, 6);
  EXPECT_EQ(sand.block0, 1);
  EXPECT_EQ(sand.blocks, 3);
  EXPECT_EQ(s.topology.nq(), 8);
  EXPECT_EQ(s.topology.nu(), 8);
  EXPECT_EQ(s.topology.blocks(), 4);
}

TEST(Topology, SuggestsTheNearestSystem) {
  Scene s;
  EXPECT_EQ(messageOf([&] { s.topology.system("sant", s.asking); }),
            "error: <Spring name=\"s1\">: no system named \"sant\" — did you mean \"sand\"?");
}

TEST(Topology, SuggestsTheNearestFrame) {
  Scene s;
  EXPECT_EQ(
      messageOf([&] { s.topology.frame("sand.ancor", s.asking); }),
      "error: <Spring name=\"s1\">: no frame named \"sand.ancor\" — did you mean \"sand.anchor\"?");
}

TEST(Topology, GivesTheSameHandleForTheSameFrame) {
  Scene s;
  const FrameHandle a = s.topology.frame("ball", s.asking),
                    b = s.topology.frame("sand.anchor", s.asking);
  EXPECT_EQ(s.topology.frame("ball", s.asking).index, a.index);
  EXPECT_NE(a.index, b.index);
  EXPECT_EQ(s.topology.requestedFrames().size(), 2u);
}

TEST(Kinematics, EvaluatesEachRequestedFrameOnce) {
  Scene s;
  s.topology.frame("ball", s.asking), s.topology.frame("ball", s.asking);
  Kinematics k;
  k.resize(s.topology);
  const Eigen::VectorXd q = Eigen::VectorXd::Zero(8);
  k.evaluate(s.topology, 0.5, {q.data(), 8}, {q.data(), 8});
  EXPECT_EQ(s.ball.calls, 1);
  EXPECT_EQ(s.sand.calls, 0);
  EXPECT_EQ(k.t(), 0.5);
}

TEST(Kinematics, IsMadeReadyForASecondTopology) {
  Scene s, another;
  s.topology.frame("ball", s.asking);
  const FrameHandle ball = another.topology.frame("ball", another.asking);
  Kinematics k;
  k.resize(s.topology);  // frames with Jacobians, which no longer exist after the next line
  k.resize(another.topology);
  const Eigen::VectorXd q = Eigen::VectorXd::Constant(8, 0.5);
  k.evaluate(another.topology, 0.0, {q.data(), 8}, {q.data(), 8});
  EXPECT_EQ(k.frame(ball).r_OS_I, Vec3(0.5, 0.5, 0.0));
}

TEST(Kinematics, PutsFramesOfAPopulationOnTheirBlocks) {
  Scene s;
  const SystemHandle sand = s.topology.system("sand", s.asking);
  const FrameHandle last = s.topology.frame(sand, 2);
  Kinematics k;
  k.resize(s.topology);
  const Eigen::VectorXd q{{0, 1, 2, 3, 4, 5, 6, 7}}, u = -q;
  k.evaluate(s.topology, 0.0, {q.data(), 8}, {u.data(), 8});
  const Frame& f = k.frame(last);
  EXPECT_EQ(f.r_OS_I, Vec3(6, 7, 0));
  EXPECT_EQ(f.v_S_I, Vec3(-6, -7, 0));
  EXPECT_EQ(f.block, 3);
  EXPECT_EQ(f.u0, 6);
  EXPECT_EQ(f.nu(), 2);
  EXPECT_EQ(k.q(sand)[0], 2.0);
}

TEST(Kinematics, KeepsAFrameThatStandsStillOffTheMassBlocks) {
  Scene s;
  const FrameHandle anchor = s.topology.frame("sand.anchor", s.asking);
  Kinematics k;
  k.resize(s.topology);
  const Eigen::VectorXd q = Eigen::VectorXd::Zero(8);
  k.evaluate(s.topology, 0.0, {q.data(), 8}, {q.data(), 8});
  EXPECT_EQ(k.frame(anchor).block, -1);
}

}  // namespace
}  // namespace dynamy
