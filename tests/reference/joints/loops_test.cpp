/// Loops of joints through the position in which they lose a rank: bars that lie flat.
#include <gtest/gtest.h>

#include <dynamy/simulation/run/simulation.hpp>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

/// Three cranks and two couplers, uniform rods of 1 m and 1 kg, cranks upright, their ends at 1
/// m/s; 35 rows of which 29 are independent, 28 where all bars lie flat, twice a turn of 1.94 s.
std::string fourBars(const std::string& scheme) {
  std::string systems, joints;
  const auto revolute = [&](const std::string& between, int x, int z) {
    joints += "<Revolute between=\"" + between + "\" at=\"" + std::to_string(x) + " 0 " +
              std::to_string(z) + "\" axis=\"0 1 0\"/>";
  };
  for (int k = 0; k < 3; ++k) {
    const std::string name = "crank" + std::to_string(k);
    systems += "<RigidBody name=\"" + name + "\" position=\"" + std::to_string(k) +
               " 0 0.5\" mass=\"1\" inertia=\"{1/12} {1/12} 1e-3\" velocity=\"0.5 0 0\" "
               "angularVelocity=\"0 1 0\"/>";
    revolute("world " + name, k, 0);
  }
  for (int k = 0; k < 2; ++k) {
    const std::string name = "coupler" + std::to_string(k);
    systems += "<RigidBody name=\"" + name + "\" position=\"" + std::to_string(k) +
               ".5 0 1\" mass=\"1\" inertia=\"1e-3 {1/12} {1/12}\" velocity=\"1 0 0\"/>";
    for (const int end : {k, k + 1}) revolute("crank" + std::to_string(end) + " " + name, end, 1);
  }
  return "<dynamy version=\"1\"><systems>" + systems +
         "<Ground name=\"world\"/></systems><forces><Gravity/></forces><elements>" + joints +
         "</elements><simulation until=\"10\" step=\"1e-2\">" + scheme + "</simulation></dynamy>";
}

/// Angle of crank k from upright [rad].
double angle(const Scene& scene, int k) {
  const Eigen::VectorXd q = scene.q("crank" + std::to_string(k));
  return std::atan2(q[0] - k, q[2]);
}

struct Passage {
  double spread = 0.0;  ///< largest angle between two cranks [rad]
  double energy = 0.0;  ///< largest change of T + V [J]
};
Passage pass(Scene& scene, double t, double dt) {
  const double start = scene.energy();
  Passage out;
  scene.run(t, dt, [&] {
    out.energy = std::max(out.energy, std::abs(scene.energy() - start));
    for (int k = 1; k < 3; ++k)
      out.spread = std::max(out.spread, std::abs(std::remainder(angle(scene, k) - angle(scene, 0),
                                                                2.0 * std::acos(-1.0))));
  });
  EXPECT_TRUE(scene.solved());
  return out;
}

TEST(Loops, CranksStayParallelThroughTheirFlatPosition) {
  // Place of the first crank's end after 1 s: extrapolated in extended precision, the period
  // checked by a quadrature. Errors measured at 1e-2: 5.6e-4 m and 9.6e-4 m, times 2. Marks of this
  // scene: cranks apart by less than 1e-6 rad, energy by less than 1e-4 of the 35.8 J, which the
  // staggered rule holds to its order only.
  for (const auto& [scheme, energy] :
       {std::pair{"<EnergyMomentum/>", 1e-4 * 35.8}, std::pair{"<StaggeredMoreau/>", 0.15}}) {
    Scene scene("bars", {.text = fourBars(scheme)});
    EXPECT_LT(pass(scene, 1.0, 1e-2).energy, energy) << scheme;
    EXPECT_NEAR(2.0 * scene.q("crank0")[0], -0.19502030194944, 2e-3) << scheme;
    EXPECT_NEAR(2.0 * scene.q("crank0")[2], -0.98079920566217, 2e-3) << scheme;
    const Passage rest = pass(scene, 10.0, 1e-2);  // ten passages
    EXPECT_LT(rest.spread, 1e-6) << scheme;
    EXPECT_LT(rest.energy, energy) << scheme;
  }
}

TEST(Loops, ABodyThatTheyLockIsHeldFromTheFirstStepOn) {
  // A hinge and a bar leave nothing free. Its bearings carry the weight: no step moves the body, and
  // each is found in a few turns, the first one as well.
  Scene scene(
      "triangle",
      {.text = "<dynamy version=\"1\"><systems><Ground name=\"world\"/><PlanarBody name=\"b\" "
               "mass=\"2\" inertia=\"0.1\" position=\"0.3 0 -0.2\"/></systems><forces>"
               "<Gravity/></forces><elements><Revolute between=\"world b\" at=\"0 0 0\"/>"
               "<Distance between=\"world b\" pointA=\"0.34 0 0.7\" pointB=\"0.1 0 0.06\"/>"
               "</elements><simulation until=\"0.01\" step=\"1e-3\" "
               "coordinates=\"minimal\"><EnergyMomentum/></simulation></dynamy>"});
  Simulation simulation(scene.model());
  const RunReport& r = simulation.run();
  EXPECT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_FALSE(r.qualified());
  EXPECT_LE(r.solver.iterationsMax, 8);
  EXPECT_LT(std::abs(r.energy.kineticEnd), 1e-20);
}

}  // namespace
}  // namespace dynamy::reference
