/// Staggered Moreau midpoint: what rests stays, what lands does not sink, joints keep length and
/// energy.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <dynamy/schemes/staggered_moreau.hpp>
#include <dynamy/simulation/run/simulation.hpp>
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

/// Moreau's impact of a planar body of mass 1 and inertia J with ε = 0, at its corner r from the
/// centre, in one piece: stick, or slip against its direction. u = (vx, vz, ω from x to z).
Eigen::Vector3d cornerImpact(const Eigen::Vector3d& u, const Eigen::Vector2d& r, double J,
                             double mu) {
  Eigen::Matrix<double, 3, 2> W;  // γ_N = vz + ω rx, γ_T = vx − ω rz
  W << 0.0, 1.0, 1.0, 0.0, r[0], -r[1];
  const Eigen::Vector3d mInv(1.0, 1.0, 1.0 / J);
  const Eigen::Matrix2d G = W.transpose() * mInv.asDiagonal() * W;
  const Eigen::Vector2d gamma = W.transpose() * u;
  Eigen::Vector2d Lambda = -G.ldlt().solve(gamma);
  for (const double side : {-1.0, 1.0}) {
    if (std::abs(Lambda[1]) <= mu * Lambda[0]) break;
    Lambda[0] = -gamma[0] / (G(0, 0) + side * mu * G(0, 1));
    Lambda[1] = side * mu * Lambda[0];
    if (side * (gamma[1] + G.row(1) * Lambda) < 0.0) break;
  }
  return u + mInv.asDiagonal() * (W * Lambda);
}

TEST(StaggeredMoreau, AnImpactWithFrictionIsTheSameWhereverInTheStepItFalls) {
  // A tilted board hits with one corner, which then slips back: done in two parts, up to the gap
  // and the rest, its slip would turn round in between, and ω end up to 0.5 rad/s elsewhere.
  const double dt = 1e-5, a = 0.05, b = 0.5, tilt = 0.5, g = 9.81, J = (a * a + b * b) / 3.0;
  const Eigen::Vector3d before(-1.0, -2.0, 0.0);
  const auto turned = [&](double x, double z) {
    return Eigen::Vector2d(x * std::cos(tilt) - z * std::sin(tilt),
                           x * std::sin(tilt) + z * std::cos(tilt));
  };
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector2d r = turned(-a, -b);
    const double height = -r[1] + 2.0 * dt * (20.0 + k / 8.0);
    Scene scene(
        "board",
        {.text = withScheme("<parameter name=\"z\" value=\"" + std::to_string(height * 1e6) +
                                "e-6\"/><systems><PlanarBody name=\"board\" position=\"0 0 {z}\" "
                                "angle=\"0.5\" velocity=\"-1 0 -2\"><Box size=\"0.1 0.1 1\" "
                                "mass=\"1\" material=\"wood\"/></PlanarBody><Ground "
                                "name=\"world\"><HalfSpace material=\"floor\"/></Ground></systems>"
                                "<forces><Gravity/></forces><elements><Contact between=\"wood "
                                "floor\"><UnilateralCoulomb mu=\"0.1\"/></Contact></elements>",
                            "<StaggeredMoreau/>")});
    scene.run(25 * dt, dt);
    const Eigen::Vector3d after = cornerImpact(before, r, J, 0.1);
    // 25 steps of gravity, and what the contact hands on of it: a few times g t.
    EXPECT_LT((scene.u("board") - after).norm(), 10.0 * 25.0 * dt * g)
        << k << ": " << scene.u("board").transpose() << ", expected " << after.transpose();
    EXPECT_GT((after - before).norm(), 1.0);
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

// ---- contacts within reach that nothing closes --------------------------------------------------

/// Balls of 0.1 m and 1 kg without weight: one that flies along x at 1000 m/s, two in a row before
/// it, 10 and 5 mm apart, and 60 at rest elsewhere, 15 mm apart: within its reach in 18 µs.
std::string fastBall(const std::string& systems = "", const std::string& elements = "") {
  std::string out = "<systems>" + systems;
  const auto ball = [&](const std::string& name, double x, double y, const char* velocity) {
    out += "<RigidBody name=\"" + name + "\" position=\"" + std::to_string(x) + ' ' +
           std::to_string(y) + " 0\" velocity=\"" + velocity +
           "\"><Sphere radius=\"0.1\" mass=\"1\" material=\"steel\"/></RigidBody>";
  };
  ball("a", 0.0, 0.0, "1000 0 0"), ball("b", 0.21, 0.0, "0 0 0"), ball("c", 0.415, 0.0, "0 0 0");
  for (int i = 0; i < 60; ++i)
    ball("rest" + std::to_string(i), 0.215 * (i % 10), 1.0 + 0.215 * (i / 10), "0 0 0");
  return out +
         "<Ground name=\"world\"/></systems><elements><Contact between=\"steel steel\">"
         "<Unilateral/></Contact>" +
         elements + "</elements>";
}

TEST(StaggeredMoreau, AsksOnlyContactsThatSomethingCloses) {
  Scene scene("fast", {.text = withScheme(fastBall(), "<StaggeredMoreau/>")});
  const StepReport& report = scene.step(1.8e-5);
  EXPECT_TRUE(report.solved.ok());
  // a–b closes with the free motion, b–c by what a does to b; the 104 gaps of the others do not.
  EXPECT_EQ(report.contacts, 2);
  const double a = scene.q("a")[0], b = scene.q("b")[0], c = scene.q("c")[0];
  EXPECT_GE(b - a, 0.2 - 1e-12);  // rounding of positions of 1 m, some times over
  EXPECT_GE(c - b, 0.2 - 1e-12);
  EXPECT_GT(scene.u("c")[0], 1.0);
  EXPECT_NEAR(scene.u("a")[0] + scene.u("b")[0] + scene.u("c")[0], 1000.0, 1e-9);
  EXPECT_EQ(scene.u("rest7").norm(), 0.0);
}

TEST(EnergyMomentum, LeavesNoContactOutThatCloses) {
  // The same beside a pendulum: contacts are condensed onto the equations of joints.
  Scene scene("fast",
              {.text = withScheme(
                   fastBall("<RigidBody name=\"bob\" position=\"0 0 5\"><Sphere radius=\"0.1\" "
                            "mass=\"1\"/></RigidBody>",
                            "<Spherical between=\"world bob\" at=\"0 0 6\"/>"),
                   "<EnergyMomentum/>")});
  EXPECT_TRUE(scene.step(1.8e-5).solved.ok());
  EXPECT_GE(scene.q("b")[0] - scene.q("a")[0], 0.2 - 1e-12);  // rounding, as above
  EXPECT_GE(scene.q("c")[0] - scene.q("b")[0], 0.2 - 1e-12);
  EXPECT_GT(scene.u("c")[0], 1.0);
  EXPECT_NEAR(scene.u("a")[0] + scene.u("b")[0] + scene.u("c")[0], 1000.0, 1e-9);
  EXPECT_EQ(scene.u("rest7").norm(), 0.0);
}

}  // namespace
}  // namespace dynamy::reference
