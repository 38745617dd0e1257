/// Staggered Moreau midpoint: what rests stays, what lands does not sink, joints keep length and
/// energy.
#include <gtest/gtest.h>

#include <dynamy/integrator/staggered_moreau.hpp>
#include <dynamy/simulation/simulation.hpp>
#include <dynamy/solver/prox_solvers.hpp>
#include <reference/order.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

std::string withScheme(const std::string& body, const std::string& scheme) {
  return "<dynamy version=\"1\">" + body + "<simulation until=\"1\" step=\"1e-3\">" + scheme +
         "</simulation></dynamy>";
}
std::string rod(const std::string& scheme) {
  return withScheme(
      "<systems><PointMass name=\"bob\" plane=\"xz\" position=\"-1 0 0\" mass=\"1\"/>"
      "<Ground name=\"world\"/></systems><forces><Gravity/></forces>"
      "<elements><Distance name=\"rod\" between=\"world bob\"/></elements>",
      scheme);
}
double length(const Scene& scene) { return scene.q("bob").norm(); }
/// S01 at 5 s.
double angleError(const Scene& scene) {
  const Eigen::VectorXd q = scene.q("bob");
  return std::remainder(std::atan2(q[0], -q[1]) - std::atan2(-0.942305435043757, 0.334754338414001),
                        2.0 * M_PI);
}

TEST(StaggeredMoreau, KeepsARodToRoundingAndConvergesWithOrderTwo) {
  std::vector<double> dt = halvings(4e-3, 4), error;
  for (const double h : dt) {
    Scene scene("rod", {.text = rod("<StaggeredMoreau/>")});
    scene.run(5.0, h, [&] { EXPECT_NEAR(length(scene), 1.0, 1e-12); });
    EXPECT_TRUE(scene.solved());
    error.push_back(std::abs(angleError(scene)));
  }
  const Fit fit = fitOrder(dt, error);
  EXPECT_NEAR(fit.order, 2.0, 0.2) << fit;
  EXPECT_LT(error.back(), 2e-4);
}

TEST(StaggeredMoreau, WithoutProjectionTheMeanVelocityKeepsTheEnergyExactly) {
  // W_Mᵀ(u^A + u^E) = 0 and gravity is linear: ½|u|² − g·q of the end of each step is constant to
  // rounding, 5000 steps of some 1e-15 · 10 J.
  Scene scene("rod", {.text = rod("<StaggeredMoreau project=\"none\"/>")});
  const double start = scene.energy();
  scene.run(5.0, 1e-3, [&] { EXPECT_NEAR(scene.energy(), start, 1e-10); });
  // The gap error does not accumulate: (Δt ω)²/8 at ω² = 2g/l.
  EXPECT_NEAR(length(scene), 1.0, 1e-5);
}

TEST(StaggeredMoreau, StabilisedJointsLoseEnergyAndNeverGainIt) {
  Scene scene("rod", {.text = rod("<StaggeredMoreau joints=\"stabilised\" project=\"none\"/>")});
  const double start = scene.energy();
  scene.run(5.0, 1e-3, [&] { EXPECT_LT(scene.energy(), start + 1e-9); });
  EXPECT_NEAR(scene.energy(), start, 1e-3);  // measured 8e-5 J over 10 s, order 2
  EXPECT_NEAR(length(scene), 1.0, 2e-5);
}

TEST(StaggeredMoreau, AskedBackSpeedHasItsCap) {
  // The rod starts 1 mm too long: with a cap of 0.1 m/s it comes back in 10 steps of 1 ms, not one.
  Scene scene(
      "rod",
      {.text = rod("<StaggeredMoreau joints=\"stabilised\" cap=\"0.1\" project=\"none\"/>")});
  const double l = 1.001;
  scene.state().q[0] = -l;
  scene.step(1e-3);
  EXPECT_NEAR(scene.u("bob")[0], 0.1, 1e-4);
  scene.run(0.02, 1e-3);
  EXPECT_NEAR(length(scene), 1.0, 1e-6);
}

const char* const kBall =
    "<systems><RigidBody name=\"ball\" position=\"0 0 0.35\"><Sphere radius=\"0.1\" mass=\"1\" "
    "material=\"m\"/></RigidBody><Ground name=\"world\"><HalfSpace material=\"m\"/></Ground>"
    "</systems><forces><Gravity/></forces><elements><Contact between=\"m m\">"
    "<UnilateralCoulomb mu=\"0.3\"/></Contact></elements>";

TEST(StaggeredMoreau, ABallLandsWithoutSinkingAndStays) {
  for (const double dt : {1e-2, 1e-3, 1.7e-4}) {
    Scene scene("ball", {.text = withScheme(kBall, "<StaggeredMoreau/>")});
    scene.run(2.0, dt, [&] {
      // Midpoints do not overlap; ends do not either, they lie on a line between two of them.
      EXPECT_GT(scene.q("ball")[2], 0.1 - 1e-12) << dt;
    });
    EXPECT_NEAR(scene.q("ball")[2], 0.1, 1e-12) << dt;
    EXPECT_LT(scene.u("ball").norm(), 1e-12) << dt;
  }
}

TEST(StaggeredMoreau, OverlapsAreRepairedWithoutSpeed) {
  Scene scene("ball", {.text = withScheme(kBall, "<StaggeredMoreau/>")});
  scene.state().q[2] = 0.08;  // 2 cm too deep
  scene.step(1e-3);
  EXPECT_NEAR(scene.q("ball")[2], 0.1, 1e-11);
  EXPECT_LT(scene.u("ball").norm(), 1e-8);
}

TEST(StaggeredMoreau, RestitutionIsThatOfNewton) {
  // Dropped by 0.25 m, e = 0.5: rises to h e² = 0.0625 m. The impact is late by up to Δt and the
  // ball sinks by up to |v| Δt before it: both change the height by 2 |v| Δt at most, v = 2.2 m/s.
  std::string text = withScheme(kBall, "<StaggeredMoreau/>");
  text.replace(text.find("mu=\"0.3\""), 0, "epsilonN=\"0.5\" ");
  Scene scene("ball", {.text = text});
  double highest = 0.0;
  scene.run(0.3, 1e-4);
  scene.run(0.5, 1e-4, [&] { highest = std::max(highest, scene.q("ball")[2] - 0.1); });
  EXPECT_NEAR(highest, 0.0625, 2.0 * 2.2 * 1e-4);
}

TEST(StaggeredMoreau, ABoxAtRestCostsNoNewtonStepAndDoesNotMove) {
  // The box on its floor: after the first steps the start is accepted, nothing changes any more.
  Scene scene(
      "box",
      {.text = withScheme(
           "<systems><RigidBody name=\"box\" position=\"0 0 0.5\"><Box size=\"1 1 1\" mass=\"1\" "
           "material=\"m\"/></RigidBody><Ground name=\"world\"><HalfSpace material=\"m\"/></Ground>"
           "</systems><forces><Gravity/></forces><elements><Contact between=\"m m\">"
           "<UnilateralCoulomb mu=\"0.5\"/></Contact></elements>",
           "<StaggeredMoreau/>")});
  int accepted = 0, steps = 0;
  scene.run(1.0, 1e-3, [&] {
    ++steps;
    accepted += scene.report().solved.warmAccepted;
  });
  EXPECT_TRUE(scene.solved());
  EXPECT_GT(accepted, 9 * steps / 10);
  EXPECT_LT((scene.q("box").head<3>() - Vec3(0, 0, 0.5)).norm(), 1e-12);
}

TEST(Projection, MovesByTheInverseOfTheMass) {
  // Two masses 1 kg and 3 kg on a rod of 1 m, 8 cm too long: the centre of mass stays, the light
  // one moves 6 cm, the heavy one 2 cm. Momentum stays as well, kinetic energy falls.
  Scene scene("pair",
              {.text = withScheme(
                   "<systems><PointMass name=\"a\" plane=\"xz\" position=\"0 0 0\" mass=\"1\"/>"
                   "<PointMass name=\"b\" plane=\"xz\" position=\"1 0 0\" mass=\"3\"/></systems>"
                   "<elements><Distance between=\"a b\"/></elements>",
                   "<StaggeredMoreau/>")});
  State& x = scene.state();
  x.q << -0.05, 0.0, 1.03, 0.0;
  x.u << 1.0, 2.0, -0.5, 0.0;
  Projection projection;
  ProxGaussSeidel solver;
  ASSERT_TRUE(projection.positions(scene.system(), solver, x, 1e-13));
  EXPECT_NEAR(x.q[0], 0.01, 1e-13);
  EXPECT_NEAR(x.q[2], 1.01, 1e-13);
  const double before = scene.kineticEnergy();
  ASSERT_TRUE(projection.velocities(scene.system(), solver, x));
  EXPECT_NEAR(x.u[0], -0.125, 1e-13);  // both go with (1·1 − 3·0.5)/4 along the rod
  EXPECT_NEAR(x.u[2], -0.125, 1e-13);
  EXPECT_NEAR(x.u[1], 2.0, 1e-13);
  EXPECT_LT(scene.kineticEnergy(), before);
}

TEST(Projection, KeepsTheJointsOfAnyScheme) {
  // <simulation project="positions"> beside the book's midpoint rule, which drifts by 3e-2 m here.
  Registry registry;
  registerFramework(registry);
  PluginLoader plugins({DYNAMY_BINARY_DIR "/lib/dynamy"});
  plugins.load(kStandardElements, {}, registry);
  std::string text = rod("<MoreauMidpoint/>");
  text.replace(text.find("step="), 0, "project=\"positions\" ");
  Model model = loadModelText(text, "rod.xml", registry, plugins, {});
  Simulation simulation(model);
  EXPECT_EQ(simulation.run().ended, RunReport::Ended::finished);
  EXPECT_NEAR(simulation.state().q.norm(), 1.0, 1e-12);
}

}  // namespace
}  // namespace dynamy::reference
