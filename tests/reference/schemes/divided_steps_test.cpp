/// Steps that are too long for the motion are divided by the run, if no scheme is named (theory
/// 37.6): closed forms of an oscillator and of bodies that turn.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/simulation/run/simulation.hpp>
#include <reference/scene.hpp>
#include <tuple>

namespace dynamy::reference {
namespace {

/// 1 kg on 1e4 N/m, ω = 100 rad/s, released at 1 cm; ωΔt = 4.
std::string oscillator(const std::string& scheme) {
  return "<dynamy version=\"1\"><systems><PointMass name=\"m\" plane=\"xz\" position=\"0 0 1.01\" "
         "mass=\"1\"/><Ground name=\"world\"/></systems><forces><SpringDamper between=\"world m\" "
         "stiffness=\"1e4\" length=\"1\"/></forces><simulation until=\"2\" step=\"0.04\">" +
         scheme + "</simulation></dynamy>";
}

/// 250 rad/s about z, far above a floor.
std::string spinning(const std::string& shape) {
  return "<dynamy version=\"1\"><systems><RigidBody name=\"b\" angularVelocity=\"0 0 250\"><" +
         shape +
         " mass=\"1\" material=\"a\"/></RigidBody><Ground name=\"world\"><HalfSpace position=\"0 0 "
         "-9\" material=\"a\"/></Ground></systems><elements><Contact between=\"a "
         "a\"><Unilateral/></Contact></elements><simulation until=\"0.1\" "
         "step=\"0.01\"/></dynamy>";
}

TEST(DividedSteps, FollowASpringThatTheStepDoesNot) {
  Scene loaded("oscillator", {.text = oscillator("")});
  Simulation s(loaded.model());
  double largest = 0.0, least = 1.0;
  while (s.step()) {
    const double x = s.state().q[1] - 1.0, u = s.state().u[1];
    const double E = 0.5 * u * u + 0.5e4 * x * x;
    largest = std::max(largest, E / 0.5), least = std::min(least, E / 0.5);
  }
  // With ωh = 4/32 the energy of the midpoint rule swings by less than (ωh)²/4 = 0.4 %, without drift.
  EXPECT_LT(largest, 1.004);
  EXPECT_GT(least, 0.996);
  EXPECT_EQ(s.report().passing.divided, 50);
  EXPECT_EQ(s.report().passing.finest, 32);  // 2 √(2 · 4)/0.18 = 31.4
  EXPECT_EQ(s.report().trust.damped, 0);
  EXPECT_TRUE(s.report().warnings.empty());
}

TEST(DividedSteps, BeginWithTheFirstStep) {
  // ωΔt = 20 beside a hundred masses at rest: 2 √(2 · 100)/0.18 = 157 parts of one evaluation, of
  // the 237 that 202 velocities may have. The first attempt of a run takes three evaluations, with
  // which only 79 would be allowed, and the spring would be damped.
  std::string text = oscillator(""), masses;
  for (int i = 0; i < 100; ++i)
    masses += "<PointMass name=\"m" + std::to_string(i) + "\" plane=\"xz\" mass=\"1\"/>";
  text.insert(text.find("<Ground"), masses);
  text.replace(text.find("0.04"), 4, "0.20");
  Scene loaded("oscillator", {.text = text});
  Simulation s(loaded.model());
  while (s.step()) {
    const double x = s.state().q[1] - 1.0, u = s.state().u[1];
    EXPECT_NEAR(0.5 * u * u + 0.5e4 * x * x, 0.5, 0.004 * 0.5) << s.state().t;  // as above
  }
  EXPECT_EQ(s.report().passing.divided, 10);
  EXPECT_EQ(s.report().passing.finest, 256);
}

TEST(DividedSteps, GoOnAfterAStopAsIfThereWereNone) {
  const auto run = [](double until, const std::string& checkpoint) {
    Scene scene("oscillator", {.text = oscillator("")});
    scene.model().simulation.until = until;
    Simulation s(scene.model());
    if (!checkpoint.empty()) s.resume(checkpoint);
    s.run();
    return std::tuple(s.checkpoint(), s.state().q, s.state().u, s.report().passing.divided);
  };
  const auto straight = run(2.0, ""), stopped = run(2.0, std::get<0>(run(1.0, "")));
  EXPECT_EQ(std::get<1>(straight), std::get<1>(stopped));
  EXPECT_EQ(std::get<2>(straight), std::get<2>(stopped));
  EXPECT_EQ(std::get<3>(straight), std::get<3>(stopped));
}

TEST(DividedSteps, AreNotThoseOfANamedScheme) {
  Scene loaded("oscillator", {.text = oscillator("<StaggeredMoreau/>")});
  Simulation s(loaded.model());
  const RunReport& r = s.run();
  EXPECT_EQ(r.steps, 50);
  EXPECT_EQ(r.passing.divided, 0);
  EXPECT_EQ(r.trust.damped, 1);
}

TEST(DividedSteps, ResolveTheTurnOfBodiesThatAreNoBalls) {
  Scene box("box", {.text = spinning("Box size=\"0.1 0.2 0.3\"")});
  Simulation s(box.model());
  // 2.5 rad in a step: four parts, from the second step on without a try.
  EXPECT_EQ(s.run().steps, 40);
  EXPECT_EQ(s.report().rejected, 1);
  EXPECT_TRUE(s.report().warnings.empty());
  Scene ball("ball", {.text = spinning("Sphere radius=\"0.1\"")});
  Simulation b(ball.model());
  EXPECT_EQ(b.run().steps, 10);
  EXPECT_TRUE(b.report().warnings.empty());
}

}  // namespace
}  // namespace dynamy::reference
