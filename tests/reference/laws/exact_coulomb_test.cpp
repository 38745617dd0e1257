/// Coulomb's law is exact at every step: what slides does not float, a ball thrown with slip does
/// not hop, friction points against the velocity, and impacts with e = 1 keep the energy. The
/// convexified law −(γ_N, γ_T) ∈ N_K of a cone K lifts a sliding body by Δt μ v in each step.
#include <gtest/gtest.h>

#include <dynamy/core/rotation.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <iomanip>
#include <limits>
#include <numbers>
#include <reference/scene.hpp>
#include <sstream>

namespace dynamy::reference {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();
/// Every scheme that knows friction.
const char* const kSchemes[] = {"MoreauMidpoint",
                                "StaggeredMoreau",
                                "EnergyMomentum",
                                "HalfExplicitEuler",
                                "HalfExplicitHeun",
                                "StewartTrinkle",
                                "AnitescuPotra",
                                "ThetaMethod",
                                "NonsmoothRattle",
                                "GeneralizedAlpha",
                                "Ggl",
                                "PaoliSchatzman"};
constexpr double kSteps[] = {1e-1, 1e-2, 1e-3, 1e-4};

std::string model(const std::string& inside, const std::string& scheme) {
  return "<dynamy version=\"1\">" + inside + "<simulation until=\"1\" step=\"1e-3\"><" + scheme +
         "/></simulation></dynamy>";
}
std::string exactly(double x) {
  std::ostringstream out;
  out << std::setprecision(17) << x;
  return out.str();
}
const std::string kFloor =
    "<Ground name=\"world\"><HalfSpace material=\"floor\"/></Ground></systems><forces><Gravity/>"
    "</forces><elements><Contact between=\"body floor\"><UnilateralCoulomb mu=\"0.3\"/></Contact>"
    "</elements>";

class ExactCoulomb : public testing::TestWithParam<const char*> {};

TEST_P(ExactCoulomb, ASlidingBoxDoesNotFloat) {
  for (const double dt : kSteps) {
    Scene scene("box", {.text = model("<systems><RigidBody name=\"box\" position=\"0 0 0.05\" "
                                      "velocity=\"2 1 0\"><Box size=\"0.4 0.2 0.1\" mass=\"1\" "
                                      "material=\"body\"/></RigidBody>" +
                                          kFloor,
                                      GetParam())});
    double highest = 0.0;
    scene.run(0.3, dt, [&] { highest = std::max(highest, std::abs(scene.q("box")[2] - 0.05)); });
    // g_tol = 1e-12 of the scene's length; convexified: Δt μ v = 7e-5 … 7e-2 m in the first step.
    EXPECT_LT(highest, 1e-11) << dt;
    EXPECT_TRUE(scene.solved()) << dt;
  }
}

TEST_P(ExactCoulomb, ABallThrownWithSlipDoesNotHop) {
  // 3 m/s and back spin of 100 rad/s: 13 m/s of slip, all the time of the run.
  for (const double dt : kSteps) {
    Scene scene("ball", {.text = model("<systems><RigidBody name=\"ball\" position=\"0 0 0.1\" "
                                       "velocity=\"3 1 0\" angularVelocity=\"20 -100 30\"><Sphere "
                                       "radius=\"0.1\" mass=\"1\" material=\"body\"/></RigidBody>" +
                                           kFloor,
                                       GetParam())});
    double highest = 0.0;
    scene.run(0.3, dt, [&] { highest = std::max(highest, std::abs(scene.q("ball")[2] - 0.1)); });
    EXPECT_LT(highest, 1e-11) << dt;
    EXPECT_TRUE(scene.solved()) << dt;
  }
}

TEST_P(ExactCoulomb, APuckKeepsAnyHeading) {
  // Friction is a multiple of the velocity: place and velocity stay on one ray. Each of the 500
  // steps rounds both by a few eps; 1e-12 leaves three digits. The sliding ends at 0.68 s.
  for (int i = 0; i < 25; ++i) {
    const double heading = 0.2513274 * i - std::numbers::pi;
    const std::string velocity =
        exactly(2.0 * std::cos(heading)) + " " + exactly(2.0 * std::sin(heading)) + " 0";
    Scene scene("puck", {.text = model(
                             "<systems><PointMass name=\"puck\" velocity=\"" + velocity +
                                 "\" mass=\"0.17\"><Point material=\"body\"/></PointMass>" + kFloor,
                             GetParam())});
    double off = 0.0, highest = 0.0;
    scene.run(0.5, 1e-3, [&] {
      const Eigen::VectorXd q = scene.q("puck"), u = scene.u("puck");
      for (const double angle : {std::atan2(q[1], q[0]), std::atan2(u[1], u[0])})
        off = std::max(off, std::abs(std::remainder(angle - heading, 2.0 * std::numbers::pi)));
      highest = std::max(highest, std::abs(q[2]));
    });
    EXPECT_LT(off, 1e-12) << heading;
    EXPECT_LT(highest, 1e-12) << heading;
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, ExactCoulomb, testing::ValuesIn(kSchemes));

// ---- e = 1
// ---------------------------------------------------------------------------------------

class ElasticImpacts : public testing::TestWithParam<const char*> {};

TEST_P(ElasticImpacts, KeepTheEnergyOverHundredThousand) {
  // A ball that bounces under gravity, ten steps a flight: at most 4 eps of the energy an impact.
  Scene scene("ball",
              {.text = model("<systems><PointMass name=\"ball\" plane=\"xz\" position=\"0 0 1\" "
                             "mass=\"1\"><Point material=\"body\"/></PointMass><Ground "
                             "name=\"world\"><HalfSpace material=\"floor\"/></Ground></systems>"
                             "<forces><Gravity/></forces><elements><Contact between=\"body "
                             "floor\"><Unilateral epsilonN=\"1\"/></Contact></elements>",
                             GetParam())});
  const double E0 = 9.81, dt = 0.2 * std::sqrt(2.0 / 9.81);
  long impacts = 0;
  double worst = 0.0;
  while (impacts < 100000) {
    const double before = scene.state().u[1];
    scene.step(dt);
    const double u = scene.state().u[1], z = scene.state().q[1];
    if (before < 0.0 && u > 0.0) ++impacts;
    worst = std::max(worst, std::abs(0.5 * u * u + 9.81 * z - E0) -
                                4.0 * kEps * E0 * static_cast<double>(impacts));
  }
  EXPECT_LE(worst, 4.0 * kEps * E0);
}

TEST_P(ElasticImpacts, OfFastBallsKeepTheEnergyToo) {
  // Two balls between two plates at up to 300 m/s, with the time loop that takes steps in parts.
  Scene scene(
      "balls",
      {.text = "<dynamy version=\"1\"><systems><RigidBody name=\"a\" position=\"-0.005 0 0\" "
               "velocity=\"300 0 0\"><Sphere radius=\"1mm\" mass=\"0.05\" material=\"body\"/>"
               "</RigidBody><RigidBody name=\"b\" position=\"0.005 0 0\" velocity=\"-100 0 0\">"
               "<Sphere radius=\"1mm\" mass=\"0.05\" material=\"body\"/></RigidBody><Ground "
               "name=\"plates\"><Box position=\"0.011 0 0\" size=\"2mm 1 1\" "
               "material=\"floor\"/><Box position=\"-0.011 0 0\" size=\"2mm 1 1\" "
               "material=\"floor\"/></Ground></systems><elements><Contact between=\"body floor\">"
               "<Unilateral epsilonN=\"1\"/></Contact><Contact between=\"body body\"><Unilateral "
               "epsilonN=\"1\"/></Contact></elements><simulation until=\"0.2\" step=\"1e-3\"><" +
               std::string(GetParam()) + "/></simulation></dynamy>"});
  Simulation simulation(scene.model());
  const RunReport& r = simulation.run();
  EXPECT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_GT(r.contacts.impacts, 3000);
  EXPECT_LE(std::abs(r.energy.end() - r.energy.start()),
            4.0 * kEps * r.energy.start() * static_cast<double>(r.contacts.impacts));
}

INSTANTIATE_TEST_SUITE_P(Schemes, ElasticImpacts,
                         testing::Values("MoreauMidpoint", "StaggeredMoreau", "EnergyMomentum"));

}  // namespace
}  // namespace dynamy::reference
