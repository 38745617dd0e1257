/// Energy of fast springs in runs to a tolerance (theory 50.2).
#include <gtest/gtest.h>

#include <reference/located/located_run.hpp>

namespace dynamy::reference {
namespace {

/// Two balls on a stiff spring, high above a floor on which a third one slides to rest.
std::string springBesideASlide(const std::string& stiffness) {
  return R"(<dynamy version="1"><systems>
    <RigidBody name="a" position="0 0 50" velocity="0 0.3 0"><Sphere radius="0.1" mass="1"/></RigidBody>
    <RigidBody name="b" position="1.3 0 50"><Sphere radius="0.1" mass="1"/></RigidBody>
    <RigidBody name="slider" position="0 5 0.1" velocity="1 0.4 0"><Box size="0.2 0.2 0.2" mass="1"
      material="m"/></RigidBody>
    <Ground name="floor"><HalfSpace material="m"/></Ground></systems>
    <forces><Gravity/><SpringDamper between="a b" stiffness=")" +
         stiffness + R"(" length="1"/></forces>
    <elements><Contact between="m m"><UnilateralCoulomb mu="0.3"/></Contact></elements>
    <simulation until="1" step="1"/></dynamy>)";
}

// ω = √(2k/m) = 1414 /s and 4472 /s: 225 and 712 periods, with an amplitude of 0.3 m. κ ln(1 + t/T₀)
// with T₀ of 1e-4 s bounds the error by 5e-4 · 9.2 of T_A + T_E + |ΔV|,
// 1.3 times the energy in the mean, if all errors have one sign.
TEST(LocatedEnergy, OfAStiffSpringRemainsAtALooseTolerance) {
  for (const char* stiffness : {"1e6", "1e7"})
    for (const double tolerance : {1e-3, 1e-4}) {
      LocatedRun run(springBesideASlide(stiffness), tolerance, 1.0);
      const RunReport& r = run.run();
      ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
      EXPECT_LT(r.trust.energyError, 0.01 * r.trust.energyScale()) << stiffness << ' ' << tolerance;
      EXPECT_TRUE(r.warnings.empty()) << r.warnings.front().text;
    }
}

// A ball passes the fixed end of its spring at some millimetres, where the spring turns by half a
// turn: no step there keeps the bound, which pauses. The 270 passages of 60 s may cost a hundredth of
// the energy (theory 50.2); with pauses of a thousand steps at once they cost 1.6 hundredths.
TEST(LocatedEnergy, OfASpringThatSwingsThroughZeroLengthRemains) {
  LocatedRun run(R"(<dynamy version="1"><systems><RigidBody name="m" position="1 0.01 0"><Sphere
    radius="0.05" mass="1"/></RigidBody><Ground name="world"/></systems><forces>
    <SpringDamper between="world m" stiffness="1000" length="0.3"/></forces>
    <simulation until="1" step="1"/></dynamy>)",
                 1e-3, 60.0);
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_LT(r.trust.energyError, 0.01 * r.trust.energyScale());
}

/// A spring whose element reports a wrong energy.
class BoastfulSpring final : public ExternalForce {
 public:
  static void declare(Attributes& a) { a.about("For tests."); }
  explicit BoastfulSpring(const Parameters& x) : ExternalForce(x) {}
  void connect(Topology& topology) override { frame_ = topology.frame("a", *this); }
  void addTo(const Kinematics& k, ForceSink& sink) const override {
    sink.force(k.frame(frame_), Vec3::Zero(), -100.0 * k.frame(frame_).r_OS_I);
  }
  bool hasPotential() const override { return true; }
  double potentialEnergy(const Kinematics& k) const override {
    return 70.0 * k.frame(frame_).r_OS_I.squaredNorm();
  }

 private:
  FrameHandle frame_;
};

// Steps do not become shorter for ever where energy and force contradict each other: six trials,
// then a pause.
TEST(LocatedEnergy, ThatAnElementMisstatesDoesNotStopARun) {
  LocatedRun run(R"(<dynamy version="1"><systems><RigidBody name="a" position="1 0 0"><Sphere
    radius="0.1" mass="1"/></RigidBody></systems><forces><Boastful/></forces>
    <simulation until="1" step="1"/></dynamy>)",
                 1e-6, 6.0, {}, [](Registry& r) { r.add<BoastfulSpring>("Boastful"); });
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_NEAR(run.state().q[0], std::cos(60.0), 1e-4);
  EXPECT_LT(r.cost.evaluations, 6000);
}

}  // namespace
}  // namespace dynamy::reference
