// Tyres against closed forms: slips that build up, the magic formula, camber, a wheel at rest.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <unit/elements/blocks/block_scene.hpp>

namespace dynamy {
namespace {

/// A wheel so heavy that no force moves it, 0.3 m of radius at 0.29 m above the road: its load is
/// 1 cm of the carcass, 1500 N.
std::string heavyWheel(const std::string& motion, const std::string& tyre,
                       const std::string& until) {
  return R"(<dynamy version="1"><systems><Ground name="road"/>
    <RigidBody name="wheel" position="0 0 0.29" mass="1e13" inertia="1e13 1e13 1e13" )" +
         motion +
         R"(/></systems><forces><Tyre name="tyre" between="wheel road" radius="0.3" stiffness="1.5e5" )" +
         tyre + R"(/></forces><simulation until=")" + until + R"(" tolerance="1e-10"/></dynamy>)";
}

/// The magic formula with E = 0, of p = c s/mu.
double curve(double C, double p) { return std::sin(C * std::atan(p / C)); }

TEST(Tyre, BuildsUpItsSideForceOverTheRelaxationLength) {
  // A wheel that rolls at V with its plane turned by ψ: σ s' = −V sin ψ − V s.
  const double psi = 0.05, V = 20.0, sigma = 0.25, s = -std::sin(psi);
  const std::string motion = R"(euler="-90deg 0 0" velocity=")" +
                             std::to_string(V * std::cos(psi)) + " " +
                             std::to_string(V * std::sin(psi)) + R"( 0" angularVelocity="0 0 )" +
                             std::to_string(V * std::cos(psi) / 0.29) + R"(")";
  for (const double t : {0.01, 0.1}) {
    BlockScene scene(
        heavyWheel(motion, R"(relaxation="0.12 0.25" curve="1.3 0" mu="1.1")", std::to_string(t)));
    const State x = scene.run();
    const double now = s * (1.0 - std::exp(-V * t / sigma));
    // Six decimals of the speeds above, 1e-7 of the slip; of 1500 N.
    EXPECT_NEAR(scene.signal(x, "tyre.lateralSlip"), now, 1e-7) << t;
    EXPECT_NEAR(scene.signal(x, "tyre.lateralForce"), 1500.0 * 1.1 * curve(1.3, 12.0 * now / 1.1),
                2e-3)
        << t;
    EXPECT_NEAR(scene.signal(x, "tyre.load"), 1500.0, 1e-6) << t;
    EXPECT_NEAR(scene.signal(x, "tyre.sideslip"), psi, 1e-6) << t;
    EXPECT_NEAR(scene.signal(x, "tyre.longitudinalForce"), 0.0, 2e-3) << t;
  }
}

TEST(Tyre, SharesItsFrictionBetweenBothDirections) {
  // A wheel that is locked and slides at 45 degrees: V = |v|, s = −(1, 1)/√2 after some lengths, and
  // both normalised slips, 15/√2 and 12/√2, give one force of mu N g(|p|) along p.
  BlockScene scene(heavyWheel(R"(euler="-90deg 0 0" velocity="7 7 0")", R"(mu="0.9")", "0.8"));
  const State x = scene.run();
  const double px = 15.0 / std::sqrt(2.0) / 0.9, py = 12.0 / std::sqrt(2.0) / 0.9,
               p = std::hypot(px, py), F = 0.9 * 1500.0 * curve(1.5, p);
  EXPECT_NEAR(scene.signal(x, "tyre.longitudinalForce"), -F * px / p, 1e-5);
  EXPECT_NEAR(scene.signal(x, "tyre.lateralForce"), -F * py / p, 1e-5);
  EXPECT_NEAR(scene.signal(x, "tyre.slip"), -1.0 / std::sqrt(2.0), 1e-11);  // F t/(m v)
}

TEST(Tyre, PushesTowardsTheSideToWhichItLeans) {
  // The top leans to +y by 0.1 rad; the disc rolls straight on, without sideslip. Its edge is at
  // h − R cos γ, which is 1 cm below the road.
  const double gamma = 0.1, V = 15.0, height = 0.3 * std::cos(gamma) - 0.01;
  // The axle, y at first, sinks on the left: R_x(−γ).
  const std::string motion = R"(euler=")" + std::to_string(-0.5 * M_PI - gamma) +
                             R"( 0 0" velocity="15 0 0" )" + R"(angularVelocity="0 0 )" +
                             std::to_string(V / (height / std::cos(gamma))) + R"(")";
  std::string text = heavyWheel(motion, R"(trail="0.02" trailCurve="1 1.2")", "0.5");
  text.replace(text.find("0 0 0.29"), 8, "0 0 " + std::to_string(height));
  BlockScene scene(text);
  const State x = scene.run();
  const double p = 0.9 * gamma, F = 1500.0 * curve(1.5, p);
  // Six decimals of the height, 5e-7 m, are 0.08 N of load.
  EXPECT_NEAR(scene.signal(x, "tyre.camber"), -gamma, 1e-6);
  EXPECT_NEAR(scene.signal(x, "tyre.load"), 1500.0, 0.1);
  EXPECT_NEAR(scene.signal(x, "tyre.lateralForce"), F, 1e-4 * F);
  EXPECT_NEAR(scene.signal(x, "tyre.aligningMoment"), -F * 0.02 * std::cos(1.2 * std::atan(p)),
              1e-4 * F * 0.02);
}

TEST(Tyre, HoldsAWheelAtRestOnASlope) {
  // A locked wheel on a slope of 0.3: the carcass stretches by σ s, where μ N g(c s/μ) = m g sin α, and
  // swings out to e⁻¹⁰ of it.
  const double slope = std::atan(0.3), N = 100.0 * 9.81 * std::cos(slope);
  const std::string scene = R"(<dynamy version="1"><systems><Ground name="road"/>
    <RigidBody name="wheel" position="0 0 )" +
                            std::to_string(0.3 - N / 1.5e5) +
                            R"(" euler="-90deg 0 0" mass="100" inertia="1e9 1e9 1e9"/></systems>
    <forces><Gravity acceleration=")" +
                            std::to_string(-9.81 * std::sin(slope)) + " 0 " +
                            std::to_string(-9.81 * std::cos(slope)) + R"("/>
    <Tyre name="tyre" between="wheel road" radius="0.3" stiffness="1.5e5" damping="2e3" slipDamping="10ms"/>
    </forces><simulation until="3" )";
  for (const char* simulation : {R"(tolerance="1e-8"/></dynamy>)", R"(step="1ms"/></dynamy>)"}) {
    BlockScene still(scene + simulation);
    const State x = still.run();
    const double p = 1.5 * std::tan(std::asin(0.3) / 1.5), s = p / 15.0;
    EXPECT_NEAR(still.signal(x, "tyre.longitudinalSlip"), s, 1e-5) << simulation;
    // The carcass gives by σ s; while it swings the wheel rolls on the way by V s, a little.
    EXPECT_LT(x.q[0], -0.12 * s) << simulation;
    EXPECT_GT(x.q[0], -1.15 * 0.12 * s) << simulation;
    EXPECT_NEAR(still.signal(x, "tyre.longitudinalForce"), N * 0.3, 0.05) << simulation;
    EXPECT_LT(std::abs(x.u[0]), 1e-4) << simulation;
  }
}

TEST(Tyre, LeavesTheRoadWithoutForce) {
  // A ball of a wheel (tube = radius) dropped from 0.1 m bounces on its carcass, without damping
  // back to where it was: half a period on the road is a spring's, with the weight.
  const std::string scene = R"(<dynamy version="1"><systems><Ground name="road"/>
    <RigidBody name="wheel" position="0 0 0.4" mass="10" inertia="1 1 1"/></systems>
    <forces><Gravity/><Tyre name="tyre" between="wheel road" radius="0.3" tube="0.3"
      axis="0 1 0" stiffness="1e4"/></forces><simulation until=")";
  const double w = std::sqrt(1e4 / 10.0), v = std::sqrt(2.0 * 9.81 * 0.1), fall = v / 9.81,
               sag = 9.81 / (w * w);
  // z'' = −w² (z + sag): on the road for 2 (π − atan(v/(w sag)))/w.
  const double on = 2.0 * (M_PI - std::atan(v / (w * sag))) / w;
  BlockScene bounce(scene + std::to_string(2.0 * fall + on) + R"(" tolerance="1e-9"/></dynamy>)");
  const State x = bounce.run();
  EXPECT_NEAR(x.q[2], 0.4, 1e-6);
  EXPECT_EQ(bounce.signal(x, "tyre.load"), 0.0);
}

/// A wheel that rolls over a slope, of 3/10 along x and 1/10 along y, given by `road`.
std::string onSlope(const std::string& road) {
  return R"(<dynamy version="1"><systems><Ground name="road"/>
    <RigidBody name="wheel" position="1 0.5 0.66" euler="-80deg 5deg 10deg" velocity="3 0.2 0.8"
      angularVelocity="0 0 9" mass="20" inertia="0.6 0.6 1"/></systems>
    <forces><Gravity/><Tyre name="tyre" between="wheel road" radius="0.3" tube="0.05" stiffness="1.5e5"
      damping="300" trail="0.02" )" +
         road + R"(/></forces><simulation until="0.5" tolerance="1e-11"/></dynamy>)";
}

TEST(Tyre, RollsOnASlopeGivenAsHeightAsOnOneThatLeans) {
  BlockScene leans(onSlope(R"(normal="-0.3 -0.1 1")")),
      height(onSlope(R"(height="0.3*x + 0.1*y")"));
  const State a = leans.run(), b = height.run();
  ASSERT_GT(leans.signal(a, "tyre.load"), 1.0);
  // Both runs have the error of the tolerance, in some hundred steps.
  EXPECT_LE((a.q - b.q).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LE((a.u - b.u).cwiseAbs().maxCoeff(), 1e-8);
}

/// What the tyre of a heavy wheel says at the start of a run on a road of this height.
double deflectionOn(const std::string& height, const std::string& wheel,
                    const std::string& tube = "0") {
  BlockScene scene(R"(<dynamy version="1"><systems><Ground name="road"/>
    <RigidBody name="wheel" )" +
                   wheel + R"( mass="1e13" inertia="1e13 1e13 1e13"/></systems><forces>
    <Tyre name="tyre" between="wheel road" radius="0.3" stiffness="1.5e5" tube=")" +
                   tube + "\" height=\"" + height +
                   R"("/></forces><simulation until="1e-9" tolerance="1e-8"/></dynamy>)");
  return scene.signal(scene.run(), "tyre.deflection");
}

TEST(Tyre, FindsTheNearestPointOfARoundRoad) {
  // In a valley of radius 2 m, and on a ridge of the same, the wheel's edge is 1 cm below the road.
  const std::string valley = "2 - sqrt(4 - x^2)", ridge = "sqrt(4 - x^2) - 2";
  for (const double angle : {-0.5, 0.0, 0.02, 0.9}) {
    const auto wheel = [&](double distance, double centre) {
      return R"(euler="-90deg 0 0" position=")" + numberText(distance * std::sin(angle)) + " 0 " +
             numberText(centre - distance * std::cos(angle)) + "\"";
    };
    // Rounding of a few lengths of 2 m.
    EXPECT_NEAR(deflectionOn(valley, wheel(2.0 - 0.29, 2.0)), 0.01, 1e-13) << angle;
    EXPECT_NEAR(deflectionOn(ridge, wheel(-2.0 - 0.29, -2.0)), 0.01, 1e-13) << angle;
  }
  // In a bowl of radius 3 m round C, with a tube of 0.1 m on a wheel that leans: of the circle of
  // radius r = 0.2 m about c the point c + r w⊥/|w⊥|, w = c − C, is the farthest from C.
  const Vec3 c(0.9, -0.4, 0.47), w = c - Vec3(0.0, 0.0, 3.0);
  const double lean = 0.3;
  // The axle, z at first, turned about x by lean − π/2.
  const Vec3 axle(0.0, std::cos(lean), std::sin(lean));
  const double across = (w - w.dot(axle) * axle).norm(),
               farthest = std::sqrt(w.squaredNorm() + 0.04 + 0.4 * across);
  const std::string wheel =
      R"(position="0.9 -0.4 0.47" euler=")" + numberText(lean - 0.5 * M_PI) + " 0 0\"";
  EXPECT_NEAR(deflectionOn("3 - sqrt(9 - x^2 - y^2)", wheel, "0.1"), 0.1 - (3.0 - farthest), 1e-12);
}

TEST(Tyre, MeetsAnEdgeThatIsSharperThanTheWheelWhereItIsNearest) {
  // The rounded edge of a kerb of 5 cm, of radius of curvature 2 e/s down to 0.3 mm, and a hump of 0.1 m
  // width: without camber the deflection is R less the least distance of the axle from the road, found
  // here among 4e5 places: off by (spacing of 5 µm)² over twice the radius of curvature, 4e-8 m.
  const double R = 0.3;
  struct Road {
    std::string formula;
    double (*z)(double);
  };
  const Road roads[] = {
      {"0.05 + 3*(x - sqrt(x^2 + 1e-4))",
       [](double x) { return 0.05 + 3.0 * (x - std::sqrt(x * x + 1e-4)); }},
      {"0.05 + 3*(x - sqrt(x^2 + 1e-6))",
       [](double x) { return 0.05 + 3.0 * (x - std::sqrt(x * x + 1e-6)); }},
      {"0.05*exp(-(x/0.05)^2)", [](double x) { return 0.05 * std::exp(-400.0 * x * x); }}};
  for (const auto& [formula, z] : roads)
    for (const double x : {-0.45, -0.36, -0.3, -0.2, -0.1, -0.03, 0.0, 0.02, 0.2}) {
      const double height = 0.31 + (x > -0.25 ? 0.03 : 0.0);
      double least = 10.0;
      for (int i = -200000; i <= 200000; ++i)
        least = std::min(least, std::hypot(5e-6 * i - x, z(5e-6 * i) - height));
      const std::string wheel =
          R"(euler="-90deg 0 0" position=")" + numberText(x) + " 0 " + numberText(height) + "\"";
      const double deflection = deflectionOn(formula, wheel, "0.1");
      if (least < R)
        EXPECT_NEAR(deflection, R - least, 4e-8) << formula << " at " << x;
      else
        EXPECT_LE(deflection, 0.0) << formula << " at " << x;  // in the air, as far as is known
    }
}

TEST(Tyre, RollsOutAgainstAResistanceThatFollowsItsLoad) {
  // (m + J/h²) a = −T/h with T = f R N and h the height of the axle; slips of f/15 are left out.
  // Its large inertias about the other axes keep it from falling over.
  const double m = 20.0, J = 1.0, h = 0.3 - m * 9.81 / 1.5e5, T = 0.02 * 0.3 * m * 9.81,
               a = T / h / (m + J / (h * h));
  const std::string scene = R"(<dynamy version="1"><systems><Ground name="road"/>
    <RigidBody name="wheel" mass="20" inertia="1e4 1e4 1" euler="-90deg 0 0" velocity="1 0 0" position="0 0 )" +
                            numberText(h) + R"(" angularVelocity="0 0 )" + numberText(1.0 / h) +
                            R"("/></systems>
    <forces><Gravity/><Tyre name="tyre" between="wheel road" radius="0.3" stiffness="1.5e5" damping="300"
      slipDamping="10ms"/></forces>
    <elements><JointFriction between="road wheel" axis="0 1 0" scale="0.02*0.3*tyre.load">
      <GivenFriction force="1"/></JointFriction></elements><simulation tolerance="1e-9" until=")";
  BlockScene rolls(scene + "2\"/></dynamy>"), stands(scene + "12\"/></dynamy>");
  EXPECT_NEAR(rolls.run().u[0], 1.0 - 2.0 * a, 1e-3 * 2.0 * a);
  EXPECT_NEAR(stands.run().u[0], 0.0, 1e-6);
}

}  // namespace
}  // namespace dynamy
