/// What a run reports as its worst overlap covers every row that it records: gaps of balls in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/simulation/run/simulation.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

/// Three balls begin inside each other; a box and a capsule between them make the run step in time for a
/// while, which pushes ball b out of a and into c. From there on steps are located again.
constexpr const char* kPushed = R"xml(<dynamy version="1"><systems>
<RigidBody name="capsule" position="-0.0135602 0.184835 0.226978" euler="-0.545823 1.12309 2.0863" velocity="0.28425 0.195427 0.158146"><Capsule radius="0.0471702" length="0.141511" mass="14.5521" material="b"/></RigidBody>
<RigidBody name="box" position="0.170701 0.168731 0.226978" euler="-1.93577 -0.759931 -2.55139" velocity="-0.0368411 -0.0502386 0.140391"><Box size="0.137191 0.121604 0.163907" mass="0.0403047" material="a"/></RigidBody>
<RigidBody name="a" position="0.0165416 0.363833 0.401576" euler="1.33893 1.54456 -2.97323" velocity="-0.0952365 -0.127622 -0.105111"><Sphere radius="0.121093" mass="10.3752" material="a"/></RigidBody>
<RigidBody name="b" position="0.181754 0.332662 0.401576" euler="-0.791692 2.74908 -1.48376" velocity="0.304843 -0.0842054 -0.161003"><Sphere radius="0.106319" mass="0.0831296" material="b"/></RigidBody>
<RigidBody name="c" position="0.337957 0.352482 0.401576" euler="-2.22714 0.795187 2.04027" velocity="0.0407488 0.154909 0.211609"><Sphere radius="0.0972316" mass="2.39948" material="a"/></RigidBody>
<Ground name="world"><HalfSpace normal="0 0 1" material="c"/><HalfSpace position="-0.523795 0 0" normal="1 0 0" material="c"/><HalfSpace position="1.04759 0 0" normal="-1 0 0" material="c"/><HalfSpace position="0 -0.523795 0" normal="0 1 0" material="c"/><HalfSpace position="0 1.04759 0" normal="0 -1 0" material="c"/></Ground>
</systems><forces><Gravity/></forces><elements>
<Contact between="a a"><UnilateralCoulomb mu="0.5" epsilonN="0.819285"/></Contact>
<Contact between="a b"><UnilateralCoulomb mu="0.5" epsilonN="0.819285"/></Contact>
<Contact between="b b"><UnilateralCoulomb mu="0.5" epsilonN="0.819285"/></Contact>
<Contact between="a c"><UnilateralCoulomb mu="0.5" epsilonN="0.819285"/></Contact>
<Contact between="b c"><UnilateralCoulomb mu="0.5" epsilonN="0.819285"/></Contact>
</elements><simulation until="0.400227" tolerance="1e-4"/><record every="0.00400227"/></dynamy>)xml";
constexpr double kRow = 0.00400227;  ///< time between two rows [s]

/// Deepest overlap of balls b and c at the rows [m].
class OverlapAtRows final : public Observer {
 public:
  void step(const StepView& v) override {
    const double from = v.before.t, to = v.after.t;
    for (double t = kRow * (std::floor(from / kRow) + 1.0); t <= to; t += kRow) {
      v.scheme.interpolate(v.system, v.before, v.after, (t - from) / (to - from), at_);
      const double apart = (at_.q.segment<3>(kB) - at_.q.segment<3>(kC)).norm();
      deepest = std::max(deepest, 0.106319 + 0.0972316 - apart);
    }
  }
  double deepest = 0.0;

 private:
  static constexpr int kB = 3 * 7, kC = 4 * 7;  // positions: seven coordinates of each body
  State at_;
};

TEST(ReportedOverlap, CoversTheRowsOfLocatedStepsAfterBodiesWerePushedIntoEachOther) {
  Scene scene("pushed", {.text = kPushed});
  OverlapAtRows seen;
  Simulation s(scene.model());
  s.observe(seen);
  const RunReport& r = s.run();
  EXPECT_GT(r.stepping.periods, 0);
  EXPECT_GT(seen.deepest, 0.06);  // at the start 0.046 m
  // 0.0632 m, at the ends of steps alone, before. Both evaluate the same places: rounding of a length.
  EXPECT_GE(r.gaps.penetration.value, seen.deepest - 1e-12);
}

}  // namespace
}  // namespace dynamy::reference
