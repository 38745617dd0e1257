/// Bearings with play: a journal in a bore is a pendulum of the length R − r, in a plane and as a
/// cylinder in space, and friction holds a spinning one at the angle of friction.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/testing/check_element.hpp>
#include <reference/located/located_run.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

constexpr double kPlay = 0.15, kAngle = 1.0;  // R − r [m], angle at the start [rad]

/// A journal of radius 0.1 m at rest in a bore of 0.25 m, `kAngle` from its lowest place.
std::string journal(bool space, const std::string& law, const std::string& more = "") {
  const std::string place = R"(position="{0.15*sin(1)} 0 {-0.15*cos(1)}" )" + more;
  const std::string body =
      space ? R"(<RigidBody name="journal" )" + place + R"( euler="{pi/2} 0 0">
                 <Cylinder radius="0.1" length="0.5" mass="2" material="s"/></RigidBody>)"
            : R"(<PlanarBody name="journal" )" + place + R"( mass="2" inertia="0.01">
                 <Circle radius="0.1" euler="{pi/2} 0 0" material="s"/></PlanarBody>)";
  return R"(<dynamy version="1"><systems>)" + body + R"(<Ground name="world">
    <Bore name="bush" radius="0.25" length="0.3" euler="{pi/2} 0 0" material="s"/></Ground></systems>
    <forces><Gravity/></forces><elements><Contact between="s s">)" +
         law + R"(</Contact></elements><simulation until="1" tolerance="1e-8"/></dynamy>)";
}

/// Half a period of a pendulum of length l: it stands on the other side.
double halfPeriod(double l) {
  return 2.0 * std::comp_ellint_1(std::sin(0.5 * kAngle)) * std::sqrt(l / 9.81);
}

TEST(Bore, MakesAPendulumOfAJournal) {
  // A rolling disc or cylinder has 3/2 of the inertia.
  for (const bool space : {false, true})
    for (const bool rolls : {false, true}) {
      const double until = halfPeriod(rolls ? 1.5 * kPlay : kPlay);
      LocatedRun run(journal(space, rolls ? R"(<UnilateralCoulomb mu="5"/>)" : "<Unilateral/>"),
                     1e-8, until);
      ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
      // Some fifty steps of the tolerance each, of the size of the scene.
      EXPECT_NEAR(run.state().q[0], -kPlay * std::sin(kAngle), 5e-7) << space << rolls;
      EXPECT_NEAR(run.state().q[space ? 2 : 1], -kPlay * std::cos(kAngle), 5e-7) << space << rolls;
      EXPECT_LT(run.state().u.cwiseAbs().maxCoeff(), 1e-5) << space << rolls;
    }
}

TEST(Bore, HoldsASpinningJournalAtTheAngleOfFriction) {
  // Where tan φ = μ the contact carries the weight; the spin is lost at M = μ N r = m g r sin φ.
  for (const bool space : {false, true}) {
    const std::string spin =
        space ? R"(angularVelocity="0 0 -100")" : R"(angularVelocity="-100")";  // about the axis
    LocatedRun run(journal(space, R"(<UnilateralCoulomb mu="{tan(1)}"/>)", spin), 1e-8, 0.1);
    ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    EXPECT_NEAR(run.state().q[0], kPlay * std::sin(kAngle), 1e-7) << space;
    const double rate = 9.81 * 0.1 * std::sin(kAngle) / (0.5 * 0.1 * 0.1);
    EXPECT_NEAR(std::abs(run.state().u[space ? 5 : 2]), 100.0 - 0.1 * rate, 1e-5) << space;
  }
}

TEST(Bore, KeepsMomentumOfTwoBodiesThatTumbleInEachOther) {
  const std::string tumbling = R"(<dynamy version="1"><systems>
    <RigidBody name="bush" euler="{pi/2} 0 0" angularVelocity="0.3 0.2 1">
      <Cylinder radius="0.4" length="0.3" mass="5"/>
      <Bore name="bore" radius="0.25" length="0.3" material="s"/></RigidBody>
    <RigidBody name="journal" position="0.02 0.05 -0.01" euler="{pi/2 + 0.1} 0.05 0"
       velocity="0.2 0 0.3" angularVelocity="0.5 1 3">
      <Cylinder radius="0.2" length="0.5" mass="2" material="s"/></RigidBody></systems>
    <elements><Contact between="s s"><UnilateralCoulomb mu="0.3" epsilonN="0.5"/></Contact></elements>
    <simulation until="0.8" tolerance="1e-6"/></dynamy>)";
  LocatedRun run(tumbling, 1e-6, 0.8);
  EXPECT_TRUE(checkModel(run.model())) << checkModel(run.model());
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_GT(run.events.size(), 2u);
  // The percussions on both bodies are opposite to the last bit but for sums of a few of them.
  const Vec3 p = 5.0 * run.state().u.segment<3>(0) + 2.0 * run.state().u.segment<3>(6);
  EXPECT_LT((p - 2.0 * Vec3(0.2, 0.0, 0.3)).norm(), 1e-12);
}

TEST(Bore, RefusesWhatItCannotTouch) {
  const auto refused = [](const std::string& shapes) {
    SceneSetup setup;
    setup.text = R"(<dynamy version="1"><systems><RigidBody name="b" mass="1" inertia="1 1 1">)" +
                 shapes + R"(</Ground></systems><elements><Contact between="s s"><Unilateral/>
      </Contact></elements><simulation until="1" step="1ms"/></dynamy>)";
    try {
      Scene scene("refused", std::move(setup));
    } catch (const ModelError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  const std::string ball = R"(<Sphere radius="0.1" material="s"/></RigidBody><Ground name="w">)";
  EXPECT_NE(refused(ball + R"(<Bore radius="0.2" material="s"/>)")
                .find("a bore in space needs a length — add length=\"…\" to <Bore>"),
            std::string::npos);
  EXPECT_EQ(refused(ball + R"(<Bore radius="0.2" length="1" material="s"/>)"), "");
  const std::string ring =
      R"(<Torus radius="0.1" tube="0" material="s"/></RigidBody><Ground name="w">)";
  EXPECT_EQ(refused(ring + R"(<HalfSpace material="s"/>)"), "");
  EXPECT_NE(refused(ring + R"(<Box size="1 1 1" material="s"/>)").find("circles have no thickness"),
            std::string::npos);
}

TEST(Bore, ACircleRollsAsAThinDiscDoes) {
  // A hoop of given inertia rolls down a slope of 0.1 rad: a = g sin α/(1 + J/(m r²)).
  const auto rolled = [](const std::string& shape) {
    LocatedRun run(
        R"(<dynamy version="1"><systems><RigidBody name="w" position="0 0 0.3" euler="{pi/2} 0 0"
      mass="2" inertia="0.09 0.09 0.18">)" +
            shape + R"(</RigidBody><Ground name="g">
      <HalfSpace material="s"/></Ground></systems><forces><Gravity acceleration="{9.81*sin(0.1)} 0
      {-9.81*cos(0.1)}"/></forces><elements><Contact between="s s"><UnilateralCoulomb mu="1"/></Contact>
      </elements><simulation until="1" tolerance="1e-8"/></dynamy>)",
        1e-8, 1.0);
    EXPECT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    return run.state().q[0];
  };
  // The tolerance, over a second.
  EXPECT_NEAR(rolled(R"(<Torus radius="0.3" tube="0" material="s"/>)"),
              0.5 * 9.81 * std::sin(0.1) / 2.0, 1e-7);
}

}  // namespace
}  // namespace dynamy::reference
