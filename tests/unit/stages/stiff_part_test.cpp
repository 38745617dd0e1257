// Derivatives of stiff elements: from those alone that declare themselves.
#include <gtest/gtest.h>

#include <unit/stages/stage_fixture.hpp>

namespace dynamy {
namespace {

/// A spring of 0 to mass 0 that counts who asks it for what.
class CountedSpring final : public ExternalForce {
 public:
  CountedSpring(double c, bool stiff) : c_(c), stiff_(stiff) {}
  void connect(Topology& topology) override { system_ = topology.system(0); }
  void addTo(const Kinematics& k, ForceSink& sink) const override {
    sink.generalised(system_, 0, -c_ * k.q(system_)[0]);
  }
  bool stiff() const override { return stiff_; }
  void addStiffness(const Kinematics&, StiffnessSink& sink) const override {
    ++derivatives;
    sink.entry(system_, 0, 0, -c_, 0.0);
  }
  mutable int derivatives = 0;

 private:
  double c_;
  bool stiff_;
  SystemHandle system_;
};

struct Springs {
  Springs()
      : scene(one(1.0), one(1e-3), one(0.0), {}, 0.0,
              [](double, ConstVec, ConstVec, Vec h) { h.setZero(); }) {
    soft.connect(scene.topology), stiff.connect(scene.topology);
    scene.parts.forces = {&soft, &stiff};
    scene.system = std::make_unique<MechanicalSystem>(scene.parts);
  }
  static Eigen::VectorXd one(double x) { return Eigen::VectorXd::Constant(1, x); }
  fixture::Scene scene;
  CountedSpring soft{1.0, false}, stiff{1e6, true};
};

TEST(StiffPart, AsksOnlyElementsThatDeclareThemselvesForDerivatives) {
  Springs springs;
  for (int i = 0; i < 100; ++i) springs.scene.step(1e-2);
  EXPECT_EQ(springs.soft.derivatives, 0);
  EXPECT_EQ(springs.stiff.derivatives, 100);  // once a step of the linearly implicit rule
  // F01: never farther than released.
  EXPECT_LE(std::abs(springs.scene.x.q[0]), 1e-3 * (1.0 + 1e-12));
}

TEST(StiffPart, KnowsTheLimitOfExplicitRules) {
  // ω = 1e3 rad/s: ωΔt = 2 at 2 ms. The soft spring does not count.
  Springs springs;
  MechanicalSystem& s = *springs.scene.system;
  s.evaluate(springs.scene.x);
  EXPECT_FALSE(explicitIsUnstable(s, 0, springs.scene.x, 1.999e-3, 2.0));
  EXPECT_TRUE(explicitIsUnstable(s, 0, springs.scene.x, 2.001e-3, 2.0));
}

}  // namespace
}  // namespace dynamy
