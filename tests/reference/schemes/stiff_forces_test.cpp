/// Stiff smooth forces, taken implicitly from the elements that declare them: stable beyond their
/// period in every scheme that takes them; the two explicit ones refuse.
#include <gtest/gtest.h>

#include <reference/schemes/scheme_table.hpp>

namespace dynamy::reference {
namespace {

bool takesStiffForces(const std::string& scheme) {
  Scene scene("spring", {.text = modelWith(scheme, kRodPendulum)});
  return scene.model().scheme().lacks(Asked::stiffForces).empty();
}
/// Runs `each` after every step; returns the refusal, if there was one.
template <class Each>
std::string_view runOf(Scene& scene, double t, double dt, Each&& each) {
  std::string_view refused;
  scene.run(t, dt, [&] {
    if (!scene.report().refused.empty()) refused = scene.report().refused;
    each();
  });
  EXPECT_TRUE(scene.solved());
  return refused;
}

class StiffSpring : public testing::TestWithParam<SchemeOrders> {};

TEST_P(StiffSpring, NeverSwingsFartherThanItWasReleased) {
  // F01: 1 kg on 1e6 N/m, period 6.3 ms, released at x0 = 1 mm; explicit rules blow up beyond
  // 2 ms. Rounding of 1 m in 20 s / 2.1 ms = 1e4 steps: 1e-12 m of 1e-3 m.
  const std::string sections =
      "<systems><PointMass name=\"m\" plane=\"xz\" position=\"0 0 1.001\" mass=\"1\"/><Ground "
      "name=\"world\"/></systems><forces><SpringDamper between=\"world m\" stiffness=\"1e6\" "
      "length=\"1\" stiff=\"true\"/></forces>";
  for (const double dt : {1e-2, 3e-3, 2.1e-3}) {
    Scene scene("spring", {.text = modelWith(GetParam().xml, sections)});
    double farthest = 0.0;
    const auto refused = runOf(
        scene, 20.0, dt, [&] { farthest = std::max(farthest, std::abs(scene.q("m")[1] - 1.0)); });
    EXPECT_EQ(std::string(refused), std::string(scene.model().scheme().lacks(Asked::stiffForces)));
    EXPECT_LE(farthest, 1e-3 * (1.0 + 1e-9)) << dt;
  }
}

TEST_P(StiffSpring, BetweenTwoBodiesKeepsTheirMomentumAndTheContact) {
  if (!takesStiffForces(GetParam().xml)) GTEST_SKIP() << "takes forces explicitly";
  const char* const sections =
      "<systems><PointMass name=\"a\" plane=\"xz\" position=\"0 0 0.1\" mass=\"1\"><Sphere "
      "radius=\"0.1\" material=\"steel\"/></PointMass><PointMass name=\"b\" plane=\"xz\" "
      "position=\"0 0 0.6\" velocity=\"1 0 0\" mass=\"2\"/><Ground name=\"world\"><HalfSpace "
      "material=\"steel\"/></Ground></systems><forces><Gravity/><SpringDamper between=\"a b\" "
      "stiffness=\"1e6\" damping=\"100\" length=\"0.5\" "
      "stiff=\"true\"/></forces><elements><Contact "
      "between=\"steel steel\"><Unilateral/></Contact></elements>";
  Scene scene("pair", {.text = modelWith(GetParam().xml, sections)});
  double stretch = 0.0;
  const auto refused = runOf(scene, 0.2, 1e-2, [&] {
    stretch = std::max(stretch, std::abs((scene.q("b") - scene.q("a")).norm() - 0.5));
  });
  EXPECT_EQ(std::string(refused), std::string(scene.model().scheme().lacks(Asked::contact)));
  if (!refused.empty()) return;
  // No horizontal force from outside: 20 steps of rounding of momenta of 2 kg m/s.
  EXPECT_NEAR(scene.u("a")[0] + 2.0 * scene.u("b")[0], 2.0, 1e-12);
  // The lower body stays on the floor: the generalised-α rule keeps it on velocity level.
  EXPECT_NEAR(scene.q("a")[1], 0.1, 1e-7);
  // Static and centrifugal force, 24 N, stretch by 2.4e-5 m; the turning of the spring within a
  // step, (u Δt)²/2l = 1e-4 m, adds to that in the linearised rules.
  EXPECT_LT(stretch, 5e-4);
}

TEST_P(StiffSpring, OnAJointedBodyStaysShort) {
  if (!takesStiffForces(GetParam().xml)) GTEST_SKIP() << "takes forces explicitly";
  // A pendulum on a rod, a second body on it by a spring: they swing as one from the horizontal.
  const char* const sections =
      "<systems><PointMass name=\"a\" plane=\"xz\" position=\"1 0 0\" mass=\"1\"/><PointMass "
      "name=\"b\" plane=\"xz\" position=\"1.5 0 0\" mass=\"2\"/><Ground name=\"world\"/></systems>"
      "<forces><Gravity/><SpringDamper between=\"a b\" stiffness=\"1e6\" length=\"0.5\" "
      "stiff=\"true\"/></forces><elements><Distance between=\"world a\"/></elements>";
  Scene scene("pendulum", {.text = modelWith(GetParam().xml, sections)});
  double stretch = 0.0;
  runOf(scene, 2.0, 1e-2,
        [&] { stretch = std::max(stretch, std::abs((scene.q("b") - scene.q("a")).norm() - 0.5)); });
  // Up to 9 m/s on the turning spring of 0.5 m: the turning within a step, (ω Δt)² l/2 at 10 rad/s
  // relative to the rod, is 2.5e-3 m.
  EXPECT_LT(stretch, 5e-3);
}

INSTANTIATE_TEST_SUITE_P(AllSchemes, StiffSpring, testing::ValuesIn(kAllSchemes),
                         [](const auto& p) { return std::string(p.param.name); });

TEST(StiffSpring, IsTakenByTheExplicitSchemesBelowTheirLimit) {
  // ω = 1e3 rad/s: leapfrog up to 2 ms, Heun's rule up to 0.2 ms.
  const std::string sections =
      "<systems><PointMass name=\"m\" plane=\"xz\" position=\"0 0 1.001\" mass=\"1\"/><Ground "
      "name=\"world\"/></systems><forces><SpringDamper between=\"world m\" stiffness=\"1e6\" "
      "length=\"1\" stiff=\"true\"/></forces>";
  for (const auto& [scheme, dt, ok] :
       {std::tuple{"NonsmoothRattle", 1.99e-3, true}, std::tuple{"NonsmoothRattle", 2.01e-3, false},
        std::tuple{"HalfExplicitHeun", 1.99e-4, true},
        std::tuple{"HalfExplicitHeun", 2.01e-4, false}}) {
    Scene scene("spring", {.text = modelWith(scheme, sections)});
    EXPECT_EQ(scene.step(dt).refused.empty(), ok) << scheme << ' ' << dt;
  }
}

TEST(StiffFormulas, AreTakenWithExactDerivatives) {
  // x'' = −1e6 x − 1e8 x³ by formula, Δt = 1e-2.
  for (const char* scheme : {"MoreauMidpoint", "StaggeredMoreau", "EnergyMomentum"}) {
    Scene scene("formula", {.text = modelWith(
                                scheme,
                                "<systems><Coordinates name=\"x\" q=\"x\" q0=\"0.01\" M=\"1\" "
                                "potential=\"5e5*x^2 + 2.5e7*x^4\" stiff=\"true\"/></systems>")});
    const double start = scene.energy();
    double worst = 0.0;
    scene.run(5.0, 1e-2, [&] { worst = std::max(worst, scene.energy()); });
    EXPECT_LT(worst, 2.0 * start) << scheme;
  }
}

// ---- forces that nobody declares, beyond what the step resolves ----------------------------------

/// Two masses of 2 kg on a spring of 1e8 N/m, stretched by 1 cm of 1 m; a pendulum beside them, so
/// that EnergyMomentum takes its own way.
std::string pair(const char* stiffness) {
  return std::string(
             "<systems><PointMass name=\"a\" plane=\"xz\" position=\"0 0 0\" mass=\"2\"/>"
             "<PointMass name=\"b\" plane=\"xz\" position=\"0 0 1.01\" mass=\"2\"/>"
             "<PointMass name=\"c\" plane=\"xz\" position=\"5 0 0\" mass=\"1\"/><Ground "
             "name=\"world\"/></systems><forces><SpringDamper between=\"a b\" length=\"1\" "
             "stiffness=\"") +
         stiffness +
         "\"/></forces><elements><Distance name=\"rod\" between=\"world c\"/></elements>";
}

class UnresolvedSpring : public testing::TestWithParam<const char*> {};

TEST_P(UnresolvedSpring, ComesToRestAsTheEndOfItsStepsSays) {
  // x: stretch, y = Δt u, z = ωΔt = 10:  y' (1 + z²) = y − z² (x + y/2),  x' = x + (y + y')/2.
  Scene scene("pair", {.text = modelWith(GetParam(), pair("1e8"))});
  double x = 0.01, y = 0.0;
  const double start = scene.energy();
  const double dt = 1e-3, zz = 100.0;
  for (int step = 0; step < 8; ++step) {
    const double before = y;
    y = (before - zz * (x + 0.5 * before)) / (1.0 + zz);
    x += 0.5 * (before + y);
    EXPECT_TRUE(scene.step(dt).solved.ok());
    // Rounding of positions of 1 m: 1e-16 m, of which a spring of 1e8 N/m makes velocities of
    // 1e-16 z²/Δt; some of them in eight steps.
    EXPECT_NEAR(scene.q("b")[1] - scene.q("a")[1] - 1.0, x, 1e-14) << step;
    EXPECT_NEAR(scene.u("b")[1] - scene.u("a")[1], y / dt, 1e-10) << step;
    EXPECT_NEAR(scene.u("b")[1] + scene.u("a")[1], 0.0, 1e-12) << step;
    EXPECT_LT(scene.energy(), start) << step;
  }
  EXPECT_LT(std::abs(x), 1e-6);  // of 1 cm
}

TEST_P(UnresolvedSpring, IsExplicitWhereTheStepResolvesIt) {
  // ωΔt = 0.1: the explicit rule, whose energy swings by (ωΔt)²/8 and does not fall.
  Scene scene("pair", {.text = modelWith(GetParam(), pair("1e4"))});
  const double start = scene.energy();
  double least = start, most = start;
  scene.run(1.0, 1e-3, [&] {
    least = std::min(least, scene.energy()), most = std::max(most, scene.energy());
  });
  EXPECT_GT(least, start * (1.0 - 0.005));
  EXPECT_LT(most, start * (1.0 + 0.005));
}

TEST_P(UnresolvedSpring, CarriesWhatLiesOnIt) {
  // 1 kg on 1e7 N/m (ωΔt = 32), 3 kg on top of it by a contact: 4 kg g/c deep at rest.
  const std::string sections =
      "<systems><PointMass name=\"a\" plane=\"xz\" position=\"0 0 0\" mass=\"1\"><Sphere "
      "radius=\"0.1\" material=\"steel\"/></PointMass><PointMass name=\"b\" plane=\"xz\" "
      "position=\"0 0 0.2\" mass=\"3\"><Sphere radius=\"0.1\" material=\"steel\"/></PointMass>"
      "<PointMass name=\"c\" plane=\"xz\" position=\"5 0 0\" mass=\"1\"/><Ground "
      "name=\"world\"/></systems><forces><Gravity/><SpringDamper between=\"world a\" "
      "pointA=\"0 0 -1\" stiffness=\"1e7\" length=\"1\"/></forces><elements><Contact "
      "between=\"steel steel\"><Unilateral/></Contact><Distance name=\"rod\" between=\"world "
      "c\"/></elements>";
  Scene scene("plate", {.text = modelWith(GetParam(), sections)});
  for (int step = 0; step < 60; ++step) EXPECT_TRUE(scene.step(1e-2).solved.ok()) << step;
  // The contact's share goes through a quarter of the way in each step at most: 2^-60 of it is left.
  const double deep = 4.0 * 9.81 / 1e7;
  EXPECT_NEAR(scene.q("a")[1], -deep, 1e-4 * deep);
  EXPECT_NEAR(scene.q("b")[1] - scene.q("a")[1], 0.2, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Default, UnresolvedSpring,
                         testing::Values("StaggeredMoreau", "EnergyMomentum"),
                         [](const auto& p) { return std::string(p.param); });

TEST_P(UnresolvedSpring, SpinsNoBodyUpThatItPullsBesideItsCentre) {
  // A stretched spring, ωΔt = 25, whose end is 2 cm beside the centre of mass of a small body that
  // turns: implicit Euler's rule can only lose of its 49 kJ. With the gyroscopic term at the mean
  // velocity that the spring's whole moment gives in the step, 1e5 rad/s, it gained 300 MJ.
  const std::string sections =
      "<systems><RigidBody name=\"a\" position=\"0 0 0\" angularVelocity=\"1.3 -2.3 5.6\"><Box "
      "size=\"0.08 0.1 0.12\" position=\"0.01 0.015 -0.01\" mass=\"1.9\"/></RigidBody><RigidBody "
      "name=\"b\" position=\"1.08 0 0\"><Sphere radius=\"0.1\" mass=\"1.2\"/></RigidBody>"
      "<PointMass name=\"c\" plane=\"xz\" position=\"5 0 0\" mass=\"1\"/><Ground "
      "name=\"world\"/></systems><forces><SpringDamper between=\"a b\" stiffness=\"5e6\" "
      "length=\"0.94\"/></forces><elements><Distance between=\"world c\"/></elements>";
  Scene scene("beside", {.text = modelWith(GetParam(), sections)});
  const double stored = 0.5 * 5e6 * 0.14 * 0.14;
  for (int step = 0; step < 60; ++step) {
    EXPECT_TRUE(scene.step(1.6e-2).solved.ok()) << step;
    EXPECT_LT(scene.energy(), stored) << step;
  }
}

TEST(UnresolvedDamper, StopsInsteadOfGrowing) {
  // 1 kg, 1e4 Ns/m, Δt = 1e-2: Δt d/m = 100; explicit rules grow by 99 in every step.
  const std::string sections =
      "<systems><PointMass name=\"a\" plane=\"xz\" position=\"0 0 0\" velocity=\"0 0 1\" "
      "mass=\"1\"/><Ground name=\"world\"/></systems><forces><SpringDamper between=\"world a\" "
      "pointA=\"0 0 -1\" stiffness=\"0\" damping=\"1e4\" length=\"1\"/></forces>";
  Scene scene("damper", {.text = modelWith("EnergyMomentum", sections)});
  scene.step(1e-2);
  EXPECT_NEAR(scene.u("a")[1], 1.0 / 101.0, 1e-12);  // u' = u/(1 + Δt d/m)
}

}  // namespace
}  // namespace dynamy::reference
