// Friction that is pressed, and friction with an internal state: closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <unit/elements/blocks/block_scene.hpp>

namespace dynamy {
namespace {

/// A cart of 1 kg on a rail with a law in its displacement.
std::string onRail(const std::string& law, const std::string& elements,
                   const std::string& simulation) {
  return R"(<dynamy version="1"><systems><Ground name="world"/>
    <PlanarBody name="cart" mass="1" inertia="1"/></systems><forces>)" +
         law + R"(</forces><elements><Prismatic name="rail" between="world cart" axis="1 0 0"/>)" +
         elements + "</elements><simulation until=\"1\" " + simulation + "</simulation></dynamy>";
}

const std::string kCoordinate =
    R"( name="f" between="world cart" coordinate="displacement" axis="1 0 0" )";

TEST(DahlFriction, HasTheHysteresisOfItsClosedForm) {
  // s' = κ (1 − s sgn v) along the way: from 0 up by A, down by 2 A, up by A, with κ A = 1.
  const double e = std::exp(-1.0), s1 = 1.0 - e, s2 = -1.0 + (s1 + 1.0) * e * e,
               s3 = 1.0 + (s2 - 1.0) * e;
  const std::string law = "<DahlFriction" + kCoordinate + R"(stiffness="2000" force="20"/>)";
  const std::string drive = R"~(<JointDrive name="d" between="world cart"
    coordinate="displacement" axis="1 0 0" motion="0.01*sin(2*pi*t)"/>)~";
  for (const auto& [simulation, tolerance] :
       {std::pair{R"(tolerance="1e-8">)", 1e-5},  // 20 N times a thousand tolerances
        // Order 1 beside reversals: A ω h, in units of 1/κ, times the force.
        std::pair{R"(step="0.5ms">)", 0.1}}) {
    BlockScene scene(onRail(law, drive, simulation));
    const State x = scene.run();
    EXPECT_NEAR(scene.signal(x, "f.force"), -20.0 * s3, tolerance) << simulation;
  }
}

TEST(DahlFriction, WithAnExponentIsThatOfItsClosedForm) {
  // s' = κ (1 − s)²: s = κ x/(1 + κ x).
  BlockScene scene(
      onRail("<DahlFriction" + kCoordinate + R"(stiffness="2000" force="20" exponent="2"/>)",
             R"(<JointDrive name="d" between="world cart" coordinate="displacement"
    axis="1 0 0" motion="0.03*t"/>)",
             R"(tolerance="1e-8">)"));
  const State x = scene.run();
  EXPECT_NEAR(scene.signal(x, "f.deflection"), 3.0 / 4.0, 1e-6);  // a hundred tolerances
}

TEST(LuGreFriction, SlipsSteadilyWithStribecksCurve) {
  const double v = 0.002, g = 1.0 + 0.5 * std::exp(-4.0);
  BlockScene scene(
      onRail("<LuGreFriction" + kCoordinate +
                 R"(stiffness="1e5" force="1" staticForce="1.5" speed="1mm/s" damping="300"
    viscous="0.4"/>)",
             R"(<JointDrive name="d" between="world cart" coordinate="displacement"
    axis="1 0 0" motion="0.002*t"/>)",
             R"(tolerance="1e-7">)"));
  const State x = scene.run();
  // Bristles are bent after 1e-5 m, and follow from there on.
  EXPECT_NEAR(scene.signal(x, "f.force"), -(g + 0.4 * v), 1e-5);
}

TEST(LuGreFriction, IsASpringBelowItsForceAndFadesWithItsLoad) {
  const std::string law = "<LuGreFriction" + kCoordinate +
                          R"(stiffness="1e4" force="2" damping="200" load="2"/>
    <JointForce name="pull" between="world cart" coordinate="displacement" axis="1 0 0" force="1"/>)";
  for (const char* simulation : {R"(tolerance="1e-8">)", R"(step="5ms">)"}) {
    BlockScene scene(onRail(law, "", simulation));
    const State x = scene.run();
    // F_c s load = 1; before it yields, s is κ x up to the bristles' slip on the way.
    EXPECT_NEAR(scene.signal(x, "f.deflection"), 0.25, 2e-3) << simulation;
    EXPECT_NEAR(x.q[0], 0.25 * 2.0 / 1e4, 0.5 * 0.25 * 2.0 / 1e4) << simulation;
    EXPECT_LT(std::abs(x.u[0]), 1e-4) << simulation;
  }
}

TEST(Clutch, PressedByAFormulaTakesTheTimeOfTwoDiscs) {
  // J = 2 and 1 kg m², 10 rad/s apart; M rises to 5 N m in 0.2 s. M (1/2 + 1) (t − 0.1) = 10.
  const double slip = 10.0 / 7.5 + 0.1, together = 20.0 / 3.0;
  BlockScene scene(R"~(<dynamy version="1"><systems><Ground name="world"/>
    <PlanarBody name="a" mass="1" inertia="2" angularVelocity="10"/>
    <PlanarBody name="b" mass="1" inertia="1"/></systems>
    <elements><Revolute between="world a"/><Revolute between="world b"/>
    <JointFriction name="clutch" between="a b" scale="min(t/0.2, 1)"><GivenFriction force="5"/>
    </JointFriction></elements><simulation until="1.5" tolerance="1e-9"/></dynamy>)~");
  const State x = scene.run();
  EXPECT_NEAR(scene.signal(x, "a.omega"), together, 1e-8);  // ten tolerances
  EXPECT_NEAR(scene.signal(x, "b.omega"), together, 1e-8);
  // Angle of the first disc: ω = 10 − ∫M/2, then together. ∫∫M/2 = 2.5 (T²/2 − T 0.1 + 0.2²/6).
  const double lost = 2.5 * (0.5 * slip * slip - 0.1 * slip + 0.04 / 6.0);
  EXPECT_NEAR(scene.signal(x, "a.phi"), 10.0 * slip - lost + together * (1.5 - slip), 1e-7);
}

}  // namespace
}  // namespace dynamy
