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

}  // namespace
}  // namespace dynamy::reference
