/// Euler's disc with contour friction: its rows against differences, and the power of its
/// spin-down. Cylinders and tyres on boxes.
#include <gtest/gtest.h>

#include <dynamy/testing/check_element.hpp>
#include <reference/scene.hpp>
#include <support/load_model.hpp>

namespace dynamy::reference {
namespace {

TEST(EulersDisc, HasRowsAndBiasThatFitItsMotion) {
  LoadedModel loaded("models/eulers_disc.xml");
  const Verdict verdict = checkModel(loaded.model());
  EXPECT_TRUE(verdict) << verdict.message();
}

TEST(EulersDisc, LiesDownWithThePowerTwoThirds) {
  // A flat thin disc: (3/2) m g R α' = −μ_c m g R · 2 √(g/(R α)), so that α^(3/2) falls linearly.
  // At finite inclination the rate changes by terms of α² = 0.04 and, with the thickness, of l/(2 R
  // α) = 0.1, half of which differs between 12° and 6.5°.
  Scene scene("eulers_disc");
  std::vector<double> power{std::pow(M_PI / 15.0, 1.5)};
  for (const double t : {0.3, 0.6, 0.9}) {
    scene.run(t, 1e-4);
    double alpha = 0.2;  // z = R sin α + l/2 cos α
    for (int i = 0; i < 20; ++i)
      alpha = std::asin((scene.q("disc")[2] - 5e-4 * std::cos(alpha)) / 0.0375);
    power.push_back(std::pow(alpha, 1.5));
  }
  const double first = power[0] - power[1];
  EXPECT_NEAR((power[1] - power[2]) / first, 1.0, 0.06);
  EXPECT_NEAR((power[2] - power[3]) / first, 1.0, 0.06);
  // α itself does not: its rate grows by α^(−1/2).
  EXPECT_GT((std::pow(power[2], 2.0 / 3.0) - std::pow(power[3], 2.0 / 3.0)) /
                (std::pow(power[0], 2.0 / 3.0) - std::pow(power[1], 2.0 / 3.0)),
            1.1);
}

TEST(EulersDisc, RollsSteadilyWithoutFrictionAlongItsRim) {
  // The middle of the disc rests: one and a half turns of the precession; what moves it is the step
  // in which the contact closes at a gap of 1e-12, and the scheme's order 4 at 1e-4 s.
  SceneSetup setup;
  setup.set = {{"contour", "0"}, {"alpha", "0.2"}};
  Scene scene("eulers_disc", std::move(setup));
  const double z = scene.q("disc")[2];
  scene.run(0.1, 1e-4);
  EXPECT_NEAR(scene.q("disc")[2], z, 1e-9);
  EXPECT_NEAR(scene.q("disc").head<2>().norm(), 0.0, 1e-9);
}

std::string scene(const std::string& bodies, const std::string& laws) {
  return "<dynamy version=\"1\"><systems>" + bodies +
         "</systems><forces><Gravity/></forces><elements>" + laws +
         "</elements><simulation until=\"1\" step=\"1ms\"/></dynamy>";
}
const char* const kWoodOnStone =
    "<Contact between=\"wood stone\"><UnilateralCoulomb mu=\"0.6\"/></Contact>"
    "<NoContact between=\"wood wood\"/>";

TEST(RoundBodies, RollDownABoxWithTheirClosedForm) {
  // 0.3 rad; J/(m r²) is 1/2 of the cylinder and 0.8 of the tyre.
  const auto at = [](const char* y) {
    return std::string("position=\"{0.1*sin(0.3) - 0.5*cos(0.3)} ") + y +
           " {0.1*cos(0.3) + 0.5*sin(0.3)}\" euler=\"90deg 0 0\"";
  };
  SceneSetup setup;
  setup.text = scene("<RigidBody name=\"roll\" " + at("0") +
                         "><Cylinder radius=\"0.1\" length=\"0.2\" mass=\"1\" "
                         "material=\"wood\"/></RigidBody><RigidBody name=\"tyre\" " +
                         at("0.4") +
                         " mass=\"1\" inertia=\"0.005 0.005 0.008\"><Torus radius=\"0.08\" "
                         "tube=\"0.02\" material=\"wood\"/></RigidBody><Ground name=\"slope\">"
                         "<Box size=\"4 4 0.2\" euler=\"0 0.3 0\" material=\"stone\" "
                         "position=\"{-0.1*sin(0.3)} 0 {-0.1*cos(0.3)}\"/></Ground>",
                     kWoodOnStone);
  Scene both("slope", std::move(setup));
  both.run(0.5, 1e-3);
  // Constant accelerations, for which the scheme is exact: what the solver leaves in 500 steps.
  for (const auto& [name, share] : {std::pair{"roll", 1.0 / 1.5}, std::pair{"tyre", 1.0 / 1.8}}) {
    const Eigen::VectorXd u = both.u(name);
    EXPECT_NEAR(u[0] * std::cos(0.3) - u[2] * std::sin(0.3), share * 9.81 * std::sin(0.3) * 0.5,
                1e-10)
        << name;
    EXPECT_NEAR(u[0] * std::sin(0.3) + u[2] * std::cos(0.3), 0.0, 1e-10) << name;
    EXPECT_NEAR(u[1], 0.0, 1e-10) << name;
  }
}

TEST(RoundBodies, CanStandsOnATableSmallerThanItself) {
  // Only the corners and edges of the table bear it, two of them beyond the cap: rest, and the
  // forces have its weight and no moment about its middle.
  SceneSetup setup;
  setup.text = scene(
      "<RigidBody name=\"can\" position=\"0 0 0.1\"><Cylinder radius=\"0.1\" length=\"0.2\" "
      "mass=\"2\" material=\"wood\"/></RigidBody><Ground name=\"table\"><Box size=\"0.3 0.05 0.1\" "
      "position=\"0.02 0 -0.05\" euler=\"0 0 0.3\" material=\"stone\"/></Ground>",
      kWoodOnStone);
  Scene can("can", std::move(setup));
  const Eigen::VectorXd q = can.q("can");
  double least = 1e300, most = 0.0;
  can.run(1.0, 1e-3, [&] {
    double sum = 0.0;
    const ConstVec Lambda = can.Lambda();
    for (Eigen::Index i = 0; i < Lambda.size(); i += 3) sum += Lambda[i];
    least = std::min(least, sum), most = std::max(most, sum);
  });
  // What the solver leaves, 1e-10 of the percussion of a step.
  EXPECT_NEAR(least, 2.0 * 9.81 * 1e-3, 1e-11);
  EXPECT_NEAR(most, 2.0 * 9.81 * 1e-3, 1e-11);
  EXPECT_LT((can.q("can") - q).norm(), 1e-12);
}

/// Where a body ends that rolls for 0.5 s on each of three floors, z = 0.
struct Rolled {
  Eigen::VectorXd box, plane, field;
};

Rolled rolledOnThreeFloors(const std::string& body) {
  const auto rolled = [&](const std::string& table) {
    SceneSetup setup;
    setup.text = scene(body + "<Ground name=\"table\">" + table + "</Ground>", kWoodOnStone);
    Scene run("body", std::move(setup));
    run.run(0.5, 1e-3);
    return run.q("body");
  };
  // The field: eight triangles of one plane, whose edges the points of contact pass.
  return {rolled("<Box size=\"2 2 0.1\" position=\"0 0 -0.05\" material=\"stone\"/>"),
          rolled("<HalfSpace material=\"stone\"/>"),
          rolled("<HeightField columns=\"3\" spacing=\"1 1\" position=\"-1.03 -0.98 0\" "
                 "heights=\"0 0 0 0 0 0 0 0 0\" material=\"stone\"/>")};
}

TEST(RoundBodies, CoinRollsRoundOnABoxAndOnTrianglesAsOnAHalfSpace) {
  const Rolled on = rolledOnThreeFloors(
      "<RigidBody name=\"body\" position=\"0 0 0.06\" euler=\"0 -0.5 0\" "
      "angularVelocity=\"9 0 1\"><Cylinder radius=\"0.1\" length=\"0.02\" mass=\"1\" "
      "material=\"wood\"/></RigidBody>");
  // Roundings of the two ways to the same gap, over 500 steps.
  EXPECT_LT((on.box - on.plane).norm(), 1e-9);
  EXPECT_LT((on.field - on.plane).norm(), 1e-9);
}

TEST(RoundBodies, ConeRollsOnItsSideOnABoxAndOnTrianglesAsOnAHalfSpace) {
  // On its side, the tip at the origin; half the angle there is atan(1/3).
  const Rolled on = rolledOnThreeFloors(
      "<RigidBody name=\"body\" position=\"{-0.3*cos(atan(1/3))} 0 {0.3*sin(atan(1/3))}\" "
      "euler=\"0 {pi/2 + atan(1/3)} 0\" angularVelocity=\"3 0 1\"><Cone radius=\"0.1\" "
      "length=\"0.3\" mass=\"1\" material=\"wood\"/></RigidBody>");
  // Roundings of the two ways to the same gap, over 500 steps.
  EXPECT_LT((on.field - on.box).norm(), 1e-9);
  // Friction along the line of contact is not unique, and the solver ends elsewhere on the half
  // space: it leaves up to 5e-10 m/s there, of 500 steps, for up to half a second, and as much for
  // the angles of a body of this size.
  EXPECT_LT((on.box - on.plane).norm(), 2.5e-7);
}

}  // namespace
}  // namespace dynamy::reference
