/// Steps that are too long for the motion are divided by the run, if no scheme is named (theory
/// 37.6): closed forms of an oscillator and of bodies that turn.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/simulation/run/energy_gain.hpp>
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
  // Parts take the spring by the implicit midpoint rule, which keeps quadratic energies: rounding of
  // 1600 parts, ε · 1600, and of the length, 1e4 N/m · 1 m · ε in a force of 100 N, stay below 1e-9.
  EXPECT_LT(largest, 1.0 + 1e-9);
  EXPECT_GT(least, 1.0 - 1e-9);
  EXPECT_EQ(s.report().passing.divided, 50);
  EXPECT_EQ(s.report().passing.finest, 32);  // 2 √(2 · 4)/0.35 = 16.2
  EXPECT_EQ(s.report().trust.damped, 0);
  EXPECT_TRUE(s.report().warnings.empty());
}

TEST(DividedSteps, KeepTheEnergyOfASpringBesideOneThatIsDamped) {
  // ωΔt = 1 beside ωΔt = 1e5, for which there are no parts. The explicit midpoint rule would let T + V of the
  // first mass swing by (ωΔt)²/4; the implicit one keeps its quadratic energy to rounding, as above.
  std::string text = oscillator("");
  text.replace(text.find("0.04"), 4, "0.01");
  text.insert(text.find("<Ground"),
              "<PointMass name=\"fast\" plane=\"xz\" position=\"5 0 2\" mass=\"1\"/>");
  text.insert(text.find("</forces>"),
              "<SpringDamper between=\"world fast\" pointA=\"5 0 0\" stiffness=\"1e14\" "
              "length=\"1.999\"/>");
  Scene loaded("oscillator", {.text = text});
  Simulation s(loaded.model());
  while (s.step()) {
    const double x = s.state().q[1] - 1.0, u = s.state().u[1];
    EXPECT_NEAR(0.5 * u * u + 0.5e4 * x * x, 0.5, 1e-9 * 0.5) << s.state().t;
  }
  EXPECT_EQ(s.report().trust.damped, 1);
  EXPECT_EQ(s.report().passing.divided, 0);
}

TEST(DividedSteps, BeginWithTheFirstStep) {
  // ωΔt = 20 beside a hundred masses at rest: 2 √(2 · 100)/0.35 = 81 parts of one evaluation, of
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
  EXPECT_EQ(s.report().passing.finest, 128);
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

TEST(DividedSteps, KeepTheOverlapOfBodiesThatReboundBelowWhatIsWarnedOf) {
  // A ball of 0.1 m that falls without gravity on a floor 1 m below; 0.2 m in a step.
  for (int k = 0; k < 20; ++k) {
    const std::string at = std::to_string(0.6 + 0.01 * k);
    Scene loaded("ball", {.text = "<dynamy version=\"1\"><systems><RigidBody name=\"b\" "
                                  "position=\"0 0 " +
                                  at +
                                  "\" velocity=\"0 0 -10\"><Sphere radius=\"0.1\" mass=\"1\" "
                                  "material=\"a\"/></RigidBody><Ground name=\"world\"><HalfSpace "
                                  "material=\"a\"/></Ground></systems><elements><Contact "
                                  "between=\"a a\"><Unilateral epsilonN=\"1\"/></Contact>"
                                  "</elements><simulation until=\"0.2\" step=\"0.02\"/></dynamy>"});
    Simulation s(loaded.model());
    EXPECT_TRUE(s.run().warnings.empty()) << at << " " << s.report().warnings.front().text;
    EXPECT_LT(s.report().gaps.penetration.value, 0.01 * loaded.model().length()) << at;
  }
}

TEST(DividedSteps, AreNotWarnedOfWhereASmallBodyTumbles) {
  // Ω × JΩ turns it by 0.1 rad in a step, which is more than 0.05 only as a number of metres.
  Scene box("box", {.text = "<dynamy version=\"1\"><systems><RigidBody name=\"b\" "
                            "angularVelocity=\"60 60 60\"><Box size=\"0.01 0.02 0.03\" mass=\"1\""
                            "/></RigidBody><Ground name=\"world\"/></systems><simulation "
                            "until=\"0.1\" step=\"0.008\"/></dynamy>"});
  Simulation s(box.model());
  EXPECT_TRUE(s.run().warnings.empty()) << s.report().warnings.front().text;
}

TEST(DividedSteps, HaveNoResolutionWhereAllMotionIsRounding) {
  // ωΔt = 1.5, released at 1 cm and at 1e-13 m: T of the latter is below that of rounding.
  for (const char* at : {"0 0 1.01", "0 0 1.0000000000001"}) {
    std::string text = oscillator("<MoreauMidpoint/>");
    text.replace(text.find("0 0 1.01"), 8, at);
    text.replace(text.find("0.04"), 4, "0.015");
    Scene loaded("oscillator", {.text = text});
    Simulation s(loaded.model());
    EXPECT_EQ(s.run().trust.omegaDt > 1.0, at[7] == '1') << at;
  }
}

/// Two masses of 1 kg on a spring of 1e10 N/m, 0.2 m from its length, that turn about each other:
/// ωΔt = 3000, and in a step the line between them turns by 2 rad.
std::string turningSpring(const std::string& step) {
  return "<dynamy version=\"1\"><systems><PointMass name=\"a\" mass=\"1\"/><PointMass "
         "name=\"b\" position=\"1 0 0\" velocity=\"0 100 0\" mass=\"1\"/></systems><forces>"
         "<SpringDamper between=\"a b\" stiffness=\"1e10\" length=\"0.8\"/></forces><simulation "
         "until=\"0.6\" step=\"" +
         step + "\"/></dynamy>";
}

TEST(DividedSteps, LetASpringThatTheyDampGainNothing) {
  // The tangent of the spring at the start of a step does not hold at its end: undivided, T + V rose
  // from 2.0e8 to 4.7e8 J in the first step. A part may gain 0.2 % of its T.
  Scene loaded("spring", {.text = turningSpring("0.02")});
  Simulation s(loaded.model());
  while (s.step()) {
  }
  EXPECT_EQ(s.report().trust.damped, 1);
  EXPECT_LE(s.report().trust.energyRise, 0.01 * s.report().trust.kineticMax);
  EXPECT_EQ(s.report().passing.finest, 8);
  EXPECT_EQ(s.report().trust.slowed.steps, 0);
  // The common velocity of 50 m/s is not touched; forces of 2e9 N leave 1e-16 of their impulse of 4e7 N s.
  EXPECT_NEAR(s.state().u[1] + s.state().u[4], 100.0, 1e-7);
}

/// A mass of 2 kg that flies in a plane, and one on a spring whose other end moves: V = 50 (y − sin t)² J.
const char* const kFlying =
    "<dynamy version=\"1\"><systems><PointMass name=\"m\" plane=\"xz\" mass=\"2\"/><Coordinates "
    "name=\"c\" q=\"y\" M=\"1\" potential=\"50*(y - sin(t))^2\"/></systems><simulation until=\"1\" "
    "step=\"0.1\"/></dynamy>";

struct Gained {
  explicit Gained(const Eigen::Vector3d& u) : scene("flying", {.text = kFlying}) {
    before = after = scene.state();
    after.t = before.t + 0.1;
    before.u << 3.0, 4.0, 0.0;
    after.u = u;
    scene.system().evaluate(before);
    scene.system().impactProblem(before, 0.1);
    report.dt = 0.1;
  }
  double taken(SolveStatus status) {
    report.solved.status = status;
    EnergyGain gain(scene.model());
    return gain.takeBack(scene.system(), report, before, after);
  }
  Scene scene;
  State before, after;
  StepReport report;
};

TEST(EnergyGain, IsTakenFromVelocitiesAfterAStepThatIsNotSolved) {
  // T = 25 J before and 100 J after: velocities are halved, to rounding.
  Gained twice({6.0, 8.0, 0.0});
  EXPECT_NEAR(twice.taken(SolveStatus::stalled), 75.0, 1e-12);
  EXPECT_NEAR((twice.after.u - twice.before.u).norm(), 0.0, 1e-12);
  Gained solved({6.0, 8.0, 0.0});
  EXPECT_EQ(solved.taken(SolveStatus::solved), 0.0);
  EXPECT_EQ(solved.after.u, Eigen::Vector3d(6.0, 8.0, 0.0));
}

TEST(EnergyGain, IsGivenBackByTheSystemsThatTookTheStep) {
  // The coordinate moves by 2 m/s, T = 2 J, on a clock of its own: the mass alone gives 75 J back.
  Gained beside({6.0, 8.0, 2.0});
  beside.before.u[2] = 2.0;
  const std::vector<char> apart{0, 1};
  beside.report.apart = apart;
  EXPECT_NEAR(beside.taken(SolveStatus::stalled), 75.0, 1e-12);
  EXPECT_NEAR((beside.after.u - beside.before.u).norm(), 0.0, 1e-12);
}

TEST(EnergyGain, IsNoneWhereThePotentialChangesWithTime) {
  // V rises from 0 to 50 sin² 0.1 = 0.498 J, 2 % of T, and no body gains.
  Gained still({3.0, 4.0, 0.0});
  EXPECT_EQ(still.taken(SolveStatus::stalled), 0.0);
}

}  // namespace
}  // namespace dynamy::reference
