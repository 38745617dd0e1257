// Ropes over sheaves, reservoirs that switch, adhesion: rows against differences, motions against
// closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/simulation/run/simulation.hpp>
#include <dynamy/testing/check_element.hpp>
#include <numbers>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

/// A model of the elements `inside`; systems first.
std::unique_ptr<Scene> scene(const std::string& systems, const std::string& elements,
                             const std::string& forces = {}) {
  return std::make_unique<Scene>(
      "", SceneSetup{.text = "<dynamy version=\"1\"><systems><Ground name=\"world\"/>" + systems +
                             "</systems><forces>" + forces + "</forces><elements>" + elements +
                             "</elements><simulation until=\"1\" step=\"1e-3\"/></dynamy>"});
}

const char* const kPlanar =
    R"(<PlanarBody name="a" position="0.7 0 1" mass="2" inertia="0.1"/>
       <PlanarBody name="b" position="-0.9 0 0.4" mass="1" inertia="0.2" angle="0.4"/>
       <PlanarBody name="wheel" position="0.1 0 2" mass="1" inertia="0.2"/>)";

TEST(SheaveRope, HasRowsThatFitItsGapAndVelocities) {
  const auto s =
      scene(kPlanar,
            R"(<SheaveRope between="a b" pointA="0.1 0 0.1" sheave="wheel" radius="0.2" length="9">
           <BeltFriction mu="0.2" wrap="180deg"/></SheaveRope>
         <SheaveRope between="b a" sheave="wheel" radius="0.1" side="0 0 -1" turns="2"/>
         <SheaveRope between="b world" pointB="2 0 0" sheave="wheel" radius="0.1"/>)");
  const Verdict fits = checkContacts(s->model());
  EXPECT_TRUE(fits) << fits.message();
}

TEST(SheaveRope, HasRowsThatFitWhereItsEndsLieBesideIt) {
  const auto s = scene(
      R"(<RigidBody name="a" position="0.7 0.5 1" mass="2" inertia="0.1 0.2 0.3"/>
         <RigidBody name="b" position="-0.9 -0.3 0.4" mass="1" inertia="0.2 0.1 0.3" euler="0.4 0.1 0"/>
         <RigidBody name="wheel" position="0.1 0 2" mass="1" inertia="0.2 0.3 0.1"/>)",
      R"(<SheaveRope between="a b" pointA="0.1 0.2 0.1" sheave="wheel" radius="0.2" axis="0.1 1 0"
           length="9"><BeltFriction mu="0.2" wrap="180deg"/></SheaveRope>
         <SheaveRope between="b world" pointB="2 0.7 0" sheave="wheel" radius="0.1" axis="0 1 0.2"/>)");
  const Verdict fits = checkContacts(s->model());
  EXPECT_TRUE(fits) << fits.message();
}

TEST(SheaveRope, RunsStraightWhereItHasLeftTheSheave) {
  // Both ends have been lifted above the sheave: no arc is left, and the distance of the ends, 1 m of a
  // rope of 1.2 m, is all that counts.
  const auto s = scene(
      R"(<RigidBody name="a" position="0.5 0 0.5" mass="2" inertia="0.1 0.2 0.3"/>
         <RigidBody name="b" position="-0.5 0 0.5" mass="1" inertia="0.2 0.1 0.3"/>
         <RigidBody name="wheel" position="0 0 1" mass="1" inertia="0.2 0.3 0.1"/>)",
      R"(<SheaveRope name="rope" between="a b" sheave="wheel" radius="0.2" axis="0 1 0" length="1.2"/>)");
  State x = s->state();
  x.q[2] = x.q[9] = 1.3;  // 0.1 m above the top of the sheave
  const Evaluation& e = s->system().evaluate(x);
  ASSERT_EQ(e.contacts.g.size(), 1U);
  EXPECT_NEAR(e.contacts.g[0], 0.2, 1e-12);
}

TEST(SheaveRope, LaysTheRopeOverTheWantedSide) {
  // Both ends hang at ±r below the centre: l = 2·1 + π r over the top, no more at the start.
  const auto s = scene(
      R"(<PlanarBody name="a" position="-0.25 0 0" mass="1" inertia="1"/>
         <PlanarBody name="b" position="0.25 0 0" mass="1" inertia="1"/>
         <PlanarBody name="wheel" position="0 0 1" mass="1" inertia="1"/>)",
      R"(<SheaveRope name="rope" between="a b" sheave="wheel" radius="0.25"
           length="{2 + 0.25*pi}"/>)");
  const Evaluation& e = s->system().evaluate(s->state());
  ASSERT_EQ(e.contacts.g.size(), 1U);
  EXPECT_NEAR(e.contacts.g[0], 0.0, 1e-15);
}

const char* const kHeld =
    R"(<CoordinateContact on="wheel" slipVelocity="omega"><Bilateral/></CoordinateContact>)";

/// Cabin and counterweight on a sheave; J/r² = 40 kg.
std::unique_ptr<Scene> lift(double cabin, double counterweight, const char* axle, double mu = 0.2) {
  const auto number = [](double x) { return std::to_string(x); };
  return scene("<PlanarBody name=\"a\" position=\"-0.25 0 -3\" mass=\"" + number(cabin) +
                   "\" inertia=\"100\"/><PlanarBody name=\"b\" position=\"0.25 0 -3\" mass=\"" +
                   number(counterweight) +
                   "\" inertia=\"100\"/><PlanarBody name=\"wheel\" mass=\"80\" inertia=\"2.5\"/>",
               "<Revolute between=\"world wheel\"/>" + std::string(axle) +
                   "<SheaveRope name=\"rope\" between=\"a b\" sheave=\"wheel\" "
                   "radius=\"0.25\"><BeltFriction mu=\"" +
                   number(mu) + "\" wrap=\"180deg\"/></SheaveRope>",
               "<Gravity/>");
}

TEST(SheaveRope, MovesCabinAndCounterweightOnAFreeSheave) {
  const auto s = lift(1600.0, 1300.0, "");
  s->run(0.5, 1e-2);
  // (m_c − m_w) g/(m_c + m_w + J/r²) = 1.0010204 m/s² down: constant forces, exact steps.
  EXPECT_NEAR(s->state().u[1], -0.5 * 300.0 * 9.81 / 2940.0, 1e-12);
  EXPECT_NEAR(s->state().u[4], 0.5 * 1.0010204, 5e-8);  // digits of the value
  // The sheave goes with the rope: |ω| r is the speed of the cabin.
  EXPECT_NEAR(std::abs(s->state().u[8]) * 0.25, 0.5 * 300.0 * 9.81 / 2940.0, 1e-12);
}

TEST(SheaveRope, HoldsOnABlockedSheaveBelowTheRatioOfTheForces) {
  const auto s = lift(1600.0, 1300.0, kHeld);  // 1.2308 < 1.874456
  s->run(1.0, 1e-2);
  EXPECT_NEAR(s->state().q[1], -3.0, 1e-13);
  // Solved to 1e-8 of the speed that weight gives in a step, 0.1 m/s; rad/s: divided by 0.25 m.
  EXPECT_NEAR(s->state().u.norm(), 0.0, 1e-8);
}

TEST(SheaveRope, SlipsOnABlockedSheaveAboveTheRatioOfTheForces) {
  const auto s = lift(2600.0, 1300.0, kHeld);  // 2 > 1.874456
  s->run(0.5, 1e-2);
  // S₁ = k S₂: m₁(g − a) = k m₂(g + a).
  const double k = std::exp(0.2 * std::numbers::pi);
  const double a = 9.81 * (2600.0 - k * 1300.0) / (2600.0 + k * 1300.0);
  EXPECT_NEAR(s->state().u[1], -0.5 * a, 1e-11);
  EXPECT_NEAR(s->state().u[4], 0.5 * a, 1e-11);
}

TEST(SheaveRope, GoesSlackWhenItsEndRests) {
  // The counterweight flies on when the cabin is stopped at once: a stop 1 mm below its start.
  const auto s = scene(
      R"(<PlanarBody name="a" position="-0.25 0 -3" velocity="0 0 -1" mass="2" inertia="1"/>
         <PlanarBody name="b" position="0.25 0 -3" velocity="0 0 1" mass="1" inertia="1"/>)",
      R"(<CoordinateContact on="a" gap="z + 3.001"/>
         <SheaveRope name="rope" between="a b" sheave="world" radius="0.25"/>)",
      "<Gravity/>");
  s->run(0.1, 1e-4);
  // From some 1 ms on: free flight of the counterweight, v = 1 − g t within the fall before.
  EXPECT_NEAR(s->state().u[4], 1.0 - 9.81 * 0.1, 2e-2);
  EXPECT_NEAR(s->state().u[1], 0.0, 1e-12);
}

TEST(ReservoirSwitch, ServesFormulasOfASystem) {
  // Friction 6 t N against 1 kg at 3 m/s, from 0.1 s to 0.2 s: v = 3 − 3 (0.2² − 0.1²).
  Scene s("", {.text = R"(<dynamy version="1"><systems>
    <Coordinates name="m" q="x" units="m" q0="0" u0="3" M="1"/></systems><elements>
    <CoordinateContact on="m" slip="1" scale="t" engage="t - 0.1" release="t - 0.2">
    <GivenFriction force="6"/></CoordinateContact></elements>
    <simulation until="0.5" step="1e-3"/></dynamy>)"});
  Simulation simulation(s.model());
  ASSERT_EQ(simulation.run().ended, RunReport::Ended::finished);
  // Each switch is read at the end of a step, up to one later: 1.2 m/s² · 1 ms.
  EXPECT_NEAR(simulation.state().u[0], 3.0 - 3.0 * 0.03, 1.2e-3);
  EXPECT_EQ(simulation.state().memory[0], 0.0);
}

TEST(SheaveRope, BreaksForGood) {
  const auto s = scene(
      R"(<PlanarBody name="a" position="-0.25 0 -3" mass="2" inertia="1"/>
         <PlanarBody name="b" position="0.25 0 -3" mass="2" inertia="1"/>)",
      R"(<SheaveRope between="a b" sheave="world" radius="0.25" breaksAt="0.1"/>)", "<Gravity/>");
  s->run(0.5, 1e-3);
  // Balanced until it breaks, then both fall.
  EXPECT_NEAR(s->state().u[1], -9.81 * 0.4, 9.81e-3);
  EXPECT_NEAR(s->state().u[4], -9.81 * 0.4, 9.81e-3);
}

TEST(UnilateralAdhesion, HoldsABlockUnderACeiling) {
  for (const double force : {9.9, 5.0}) {  // its weight: 9.81 N
    const auto s = scene(R"(<PlanarBody name="block" mass="1" inertia="1"/>)",
                         "<CoordinateContact on=\"block\" gap=\"-z\"><UnilateralAdhesion force=\"" +
                             std::to_string(force) + "\"/></CoordinateContact>",
                         "<Gravity/>");
    s->run(0.1, 1e-3);
    // Held: rest. Not held: free fall once the gap is out of a step's reach, within 10 steps.
    if (force > 9.81)
      EXPECT_NEAR(s->state().q[1], 0.0, 1e-15);
    else
      EXPECT_NEAR(s->state().u[1], -9.81 * 0.1, 10.0 * 5.0e-3);
  }
}

}  // namespace
}  // namespace dynamy::reference
