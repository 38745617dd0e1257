/// Fast bodies (F12 and its relatives): what goes further in a step than it is thick hits where the
/// closed form says, on the side from which it came, under every scheme that knows impacts.
#include <gtest/gtest.h>

#include <dynamy/simulation/run/simulation.hpp>
#include <functional>
#include <iomanip>
#include <numbers>
#include <reference/scene.hpp>
#include <sstream>

namespace dynamy::reference {
namespace {

constexpr double kFastStep = 1e-3;
/// A hit is mistimed by at most 1e-7 of the thickness of 1 mm, times factors of a few
/// (theory 37.2); behind it the body is off by as much.
constexpr double kHit = 1e-9;

class Watch final : public Observer {
 public:
  explicit Watch(std::function<void(const StepView&)> see) : see_(std::move(see)) {}
  void step(const StepView& view) override { see_(view); }

 private:
  std::function<void(const StepView&)> see_;
};

struct Ran {
  RunReport report;
  State x;
};

std::string scheme(const std::string& name, double until = 0.01) {
  return "<simulation until=\"" + std::to_string(until) + "\" step=\"1e-3\"><" + name +
         "/></simulation>";
}

/// Runs `inside` with the time loop of the program; `see` gets every accepted step.
Ran run(
    const std::string& inside, const Overrides& set = {},
    std::function<void(const StepView&)> see = [](const StepView&) {}) {
  Scene scene("fast", {.set = set, .text = "<dynamy version=\"1\">" + inside + "</dynamy>"});
  Simulation simulation(scene.model());
  Watch watch(std::move(see));
  simulation.observe(watch);
  simulation.run();
  return {simulation.report(), simulation.state()};
}

std::string ball(const std::string& name, const std::string& position, const std::string& velocity,
                 const std::string& more = "") {
  return "<RigidBody name=\"" + name + "\" position=\"" + position + "\" velocity=\"" + velocity +
         "\" " + more + "><Sphere radius=\"1mm\" mass=\"0.05\" material=\"lead\"/></RigidBody>";
}
const std::string kLaw =
    "<elements><Contact between=\"lead steel\"><Unilateral epsilonN=\"{e}\"/></Contact>"
    "<Contact between=\"lead lead\"><Unilateral epsilonN=\"{e}\"/></Contact>"
    "<NoContact between=\"steel steel\"/></elements>";
std::string withE(double e) {
  return "<parameter name=\"e\" value=\"" + std::to_string(e) + "\"/>";
}

/// All digits of a number.
std::string exactly(double x) {
  std::ostringstream out;
  out << std::setprecision(17) << x;
  return out.str();
}

// ---- F12 ---------------------------------------------------------------------------------------

/// 0.3 m per step against 2 mm of steel whose face is at x = 0.099.
std::string bullet(const std::string& name, double e, const std::string& wall) {
  return withE(e) + "<systems>" + ball("ball", "-0.5 0.1 0.2", "300 0 0") +
         "<Ground name=\"plate\">" + wall + "</Ground></systems>" + kLaw + scheme(name);
}
const char* const kPlate = "<Box position=\"0.1 0 0\" size=\"2mm 1 1\" material=\"steel\"/>";
const char* const kHalf =
    "<HalfSpace position=\"0.099 0 0\" normal=\"-1 0 0\" material=\"steel\"/>";
const char* const kBall = "<Sphere position=\"0.104 0.1 0.2\" radius=\"5mm\" material=\"steel\"/>";

class Bullet : public testing::TestWithParam<const char*> {};

TEST_P(Bullet, HitsThePlateInTimeAndStaysOnItsSide) {
  const std::string name = GetParam();
  for (const char* wall : {kPlate, kHalf, kBall})
    for (const double e : {0.0, 0.5, 1.0}) {
      SCOPED_TRACE(std::string(wall) + ", e = " + std::to_string(e));
      // One knows no rebound, the other none in steps of different length.
      if (e > 0.0 && (name == "StewartTrinkle" || name == "PaoliSchatzman")) continue;
      double furthest = -1.0, hit = -1.0;
      const Ran r = run(bullet(name, e, wall), {}, [&](const StepView& v) {
        furthest = std::max(furthest, v.after.q[0]);
        if (hit < 0.0 && v.after.u[0] < 299.0) hit = v.after.t;
      });
      EXPECT_EQ(r.report.ended, RunReport::Ended::finished) << r.report.reason;
      // t = gap/v within h
      const double truth = (0.098 + 0.5) / 300.0;
      EXPECT_NEAR(hit, truth, kFastStep);
      EXPECT_LT(furthest, 0.098 + kHit);
      EXPECT_LT(r.report.gaps.penetration.value, kHit);
      EXPECT_NEAR(r.x.u[0], -300.0 * e, 1e-9);
      // Schemes whose law looks ahead stop the ball gently, in the step before it would arrive.
      EXPECT_NEAR(r.x.q[0], 0.098 - 300.0 * e * (0.01 - truth), kHit);
      EXPECT_LE(r.report.energy.end(), r.report.energy.start() * (1.0 + 1e-12));
    }
}

INSTANTIATE_TEST_SUITE_P(Schemes, Bullet,
                         testing::Values("MoreauMidpoint", "StaggeredMoreau", "EnergyMomentum",
                                         "HalfExplicitEuler", "HalfExplicitHeun", "StewartTrinkle",
                                         "AnitescuPotra", "PaoliSchatzman", "ThetaMethod",
                                         "NonsmoothRattle", "GeneralizedAlpha", "Ggl"));

// ---- relatives ---------------------------------------------------------------------------------

class FastBodies : public testing::TestWithParam<const char*> {};

TEST_P(FastBodies, TwoBallsHeadOnExchangeTheirVelocities) {
  // 600 m/s of approach, 0.6 m per step, radii of 1 mm.
  const Ran r = run(withE(1.0) + "<systems>" + ball("a", "-0.5 0 0", "300 0 0") +
                    ball("b", "0.4123 0 0", "-200 0 0") + "</systems>" + kLaw + scheme(GetParam()));
  const double t = (0.9123 - 0.002) / 500.0;
  EXPECT_NEAR(r.x.u[0], -200.0, 1e-9);
  EXPECT_NEAR(r.x.u[6], 300.0, 1e-9);
  EXPECT_NEAR(r.x.q[0], -0.5 + 300.0 * t - 200.0 * (0.01 - t), 2.0 * kHit);
  EXPECT_NEAR(r.x.q[7], 0.4123 - 200.0 * t + 300.0 * (0.01 - t), 2.0 * kHit);
}

TEST_P(FastBodies, ABallThatIsGrazedIsTurnedByTheClosedForm) {
  // Impact parameter b = 2R sin(θ): smooth, elastic, equal masses: the hit one leaves along the
  // line of centres with v cos θ, the other at a right angle with v sin θ.
  for (const double theta : {0.1, 0.7, 1.3, 1.5}) {
    const double b = 0.002 * std::sin(theta), v = 300.0;
    const Ran r =
        run(withE(1.0) + "<systems>" + ball("a", "-0.5 {b} 0", "300 0 0") +
                ball("b", "0.1 0 0", "0 0 0") + "</systems><parameter name=\"b\" value=\"0\"/>" +
                kLaw + scheme(GetParam()),
            {{"b", exactly(b)}});
    // The contact is taken 1e-9 m beside its place: the normal turns by 1e-9/(0.002 cos θ).
    const double turned = 300.0 * kHit / (0.002 * std::cos(theta));
    EXPECT_NEAR(r.x.u[6], v * std::cos(theta) * std::cos(theta), turned) << theta;
    EXPECT_NEAR(r.x.u[7], -v * std::cos(theta) * std::sin(theta), turned) << theta;
    EXPECT_NEAR(r.x.u[0], v * std::sin(theta) * std::sin(theta), turned) << theta;
  }
}

TEST_P(FastBodies, ABallThatPassesByIsLeftAlone) {
  // 1 µm of air beside the edge of the plate: no ghost of its plane may stop the ball.
  for (const char* at : {"-0.5 0 0.501001", "-0.5 0.501001 0.3", "-0.5 0.7 0.7"}) {
    const Ran r =
        run(withE(0.0) + "<systems>" + ball("ball", at, "300 0 0") + "<Ground name=\"plate\">" +
            kPlate + "</Ground></systems>" + kLaw + scheme(GetParam()));
    EXPECT_EQ(r.x.u[0], 300.0) << at;
    EXPECT_EQ(r.x.u[1], 0.0) << at;
    EXPECT_EQ(r.x.u[2], 0.0) << at;
    EXPECT_EQ(r.report.passing.parted, 0) << at;
  }
}

TEST_P(FastBodies, AMovingPlateThrowsTheBallBackByTwiceItsSpeed) {
  // Face at 0.099 − 40 t, e = 1: v' = 2 (−40) − 300.
  const Ran r = run(withE(1.0) + "<systems>" + ball("ball", "-0.5 0.1 0.2", "300 0 0") +
                    "<Ground name=\"plate\" motion=\"-40*t; 0; 0\">" + kPlate +
                    "</Ground></systems>" + kLaw + scheme(GetParam()));
  const double t = 0.598 / 340.0;
  EXPECT_NEAR(r.x.u[0], -380.0, 1e-9);
  EXPECT_NEAR(r.x.q[0], -0.5 + 300.0 * t - 380.0 * (0.01 - t), 3.0 * kHit);
}

TEST_P(FastBodies, ABarThatTurnsARadianPerStepHitsTheBallInItsWay) {
  // Bar along x, half height h = 5 mm, Ω = 1000 rad/s; ball of R = 1 mm at radius 0.4 and angle
  // φ = 2.5: the face is there when 0.4 sin(φ − Ωt) = h + R; e = 1 adds 2 Ω 0.4 cos(φ − Ωt) along
  // the face's normal.
  double t = -1.0;
  Vec3 v = Vec3::Zero();
  const Ran r =
      run(withE(1.0) + "<systems>" + ball("ball", "{0.4*cos(2.5)} {0.4*sin(2.5)} 0", "0 0 0") +
              "<Ground name=\"bar\" rotation=\"1000*t\" axis=\"0 0 1\"><Box size=\"1 1cm 1cm\" "
              "material=\"steel\"/></Ground></systems>" +
              kLaw + scheme(GetParam(), 0.003),
          {}, [&](const StepView& view) {
            if (t < 0.0 && view.after.u.norm() > 1.0) t = view.after.t, v = view.after.u.head<3>();
          });
  EXPECT_EQ(r.report.ended, RunReport::Ended::finished) << r.report.reason;
  const double beta = std::asin(0.006 / 0.4), angle = 2.5 - beta;
  // The other end comes first: at φ − π its face meets the ball from the same side.
  const double first = angle - std::numbers::pi < 0.0 ? angle : angle - std::numbers::pi;
  EXPECT_NEAR(t, first / 1000.0, 1e-8);
  const double speed = 2.0 * 1000.0 * 0.4 * std::cos(beta);
  // The piece of the path is straight to 1e-5 rad at worst: theory 37.2.
  EXPECT_NEAR(v.x(), -speed * std::sin(first), 1e-4 * speed);
  EXPECT_NEAR(v.y(), speed * std::cos(first), 1e-4 * speed);
}

TEST_P(FastBodies, ACubeThatSpinsDoesNotPassThePlate) {
  // Box against box, both convex, 0.3 m and 2 rad per step: on its side, momentum only lost.
  double furthest = -1.0;
  const Ran r =
      run(withE(0.5) +
              "<systems><RigidBody name=\"cube\" position=\"-0.5 0.1 0.2\" velocity=\"300 "
              "0 0\" angularVelocity=\"900 1500 -1000\"><Box size=\"2mm 2mm 2mm\" "
              "mass=\"0.05\" material=\"lead\"/></RigidBody><Ground name=\"plate\">" +
              kPlate + "</Ground></systems>" + kLaw + scheme(GetParam()),
          {}, [&](const StepView& v) { furthest = std::max(furthest, v.after.q[0]); });
  EXPECT_EQ(r.report.ended, RunReport::Ended::finished) << r.report.reason;
  EXPECT_LT(furthest, 0.099 - 0.001 + 1e-6);  // the middle is a half edge away at least
  EXPECT_LT(r.x.u[0], 0.0);
  EXPECT_LT(r.report.gaps.penetration.value, 1e-6);
  EXPECT_LE(r.report.energy.end(), r.report.energy.start() * (1.0 + 1e-12));
}

TEST_P(FastBodies, AStackOfThinPlatesStaysInOrder) {
  std::string plates;
  for (int i = 0; i < 3; ++i)
    plates += "<RigidBody name=\"p" + std::to_string(i) + "\" position=\"" +
              std::to_string(0.1 + 0.003 * i) +
              " 0 0\"><Box size=\"2mm 0.1 0.1\" mass=\"0.2\" material=\"steel\"/></RigidBody>";
  double order = 1.0;
  const Ran r = run(withE(0.5) + "<systems>" + ball("ball", "-0.5 0 0", "300 0 0") + plates +
                        "</systems><elements><Contact between=\"lead steel\"><Unilateral "
                        "epsilonN=\"{e}\"/></Contact><Contact between=\"steel steel\"><Unilateral "
                        "epsilonN=\"{e}\"/></Contact></elements>" +
                        scheme(GetParam()),
                    {}, [&](const StepView& v) {
                      order = std::min(order, v.after.q[7] - v.after.q[0] - 0.002);
                      for (int i = 0; i < 2; ++i)
                        order =
                            std::min(order, v.after.q[14 + 7 * i] - v.after.q[7 + 7 * i] - 0.002);
                    });
  EXPECT_GT(order, -kHit);
  const double momentum = 0.05 * r.x.u[0] + 0.2 * (r.x.u[6] + r.x.u[12] + r.x.u[18]);
  EXPECT_NEAR(momentum, 15.0, 1e-10);
  EXPECT_LE(r.report.energy.end(), r.report.energy.start());
}

TEST_P(FastBodies, ManyHitsInOneStepFollowTheClosedForm) {
  // Between two plates 20 mm apart, 300 m/s: 16 hits per step.
  const Ran r = run(withE(1.0) + "<systems>" + ball("ball", "0.004 0 0", "300 0 0") +
                    "<Ground name=\"plates\"><Box position=\"0.011 0 0\" size=\"2mm 1 1\" "
                    "material=\"steel\"/><Box position=\"-0.011 0 0\" size=\"2mm 1 1\" "
                    "material=\"steel\"/></Ground></systems>" +
                    kLaw + scheme(GetParam(), 0.02));
  // Triangle wave of the centre between ±9 mm.
  const double way = std::fmod(0.004 + 0.009 + 300.0 * 0.02, 0.036);
  const double x = way < 0.018 ? way - 0.009 : 0.027 - way;
  EXPECT_NEAR(r.x.q[0], x, 340.0 * kHit);
  EXPECT_NEAR(std::abs(r.x.u[0]), 300.0, 340.0 * 300.0 * 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Schemes, FastBodies,
                         testing::Values("MoreauMidpoint", "StaggeredMoreau", "EnergyMomentum"));

// ---- limits and costs --------------------------------------------------------------------------

TEST(FastBodiesLimits, AContactThatLastsIsNotPassedAgainAndAgain) {
  // A box at 300 rad/s pushes a cube along its face, at 0.15 m from its axis at most: the face gains on
  // the cube's straight path by ½ ω² r t² ≤ 6750 m/s² t². It takes 1.7e-4 s to 1e-2 of the cube's
  // half edge of 2 cm, so that a step has up to six cuts; 1e-6 of it would make 580.
  const Ran r =
      run("<systems><RigidBody name=\"box\" euler=\"0 -0.3 0\" angularVelocity=\"0 -300 0\"><Box "
          "size=\"0.3 0.3 0.04\" mass=\"300\" material=\"a\"/></RigidBody><RigidBody name=\"cube\" "
          "position=\"0.1 0 0.08\"><Box size=\"0.04 0.04 0.04\" mass=\"0.1\" "
          "material=\"a\"/></RigidBody></systems><elements><Contact between=\"a "
          "a\"><Unilateral/></Contact></elements>" +
          scheme("MoreauMidpoint", 0.02));
  EXPECT_GT(r.report.passing.parted, 0);
  EXPECT_LE(r.report.passing.parted, 20 * 6);
  EXPECT_EQ(r.report.passing.left, 0);
  EXPECT_LT(r.report.gaps.penetration.value, 0.02);  // it does not get through
}

TEST(FastBodiesLimits, AStepOfTooManyHitsHasAnEndAndIsReported) {
  // 1 µm of play at 300 m/s: 3e5 hits per step.
  const Ran r = run(withE(1.0) + "<systems>" + ball("ball", "0 0 0", "300 0 0") +
                    "<Ground name=\"plates\"><Box position=\"2.0005mm 0 0\" size=\"2mm 1 1\" "
                    "material=\"steel\"/><Box position=\"-2.0005mm 0 0\" size=\"2mm 1 1\" "
                    "material=\"steel\"/></Ground></systems>" +
                    kLaw + scheme("MoreauMidpoint"));
  // The first step: 2000 passings, of two parts more each, and the rest, which leads out.
  EXPECT_EQ(r.report.ended, RunReport::Ended::finished) << r.report.reason;
  EXPECT_EQ(r.report.passing.left, 1);
  EXPECT_LE(r.report.steps, 2 * 2000 + 1 + 9);
  EXPECT_TRUE(r.report.qualified());
  const auto told = std::find_if(r.report.warnings.begin(), r.report.warnings.end(),
                                 [](const Warning& w) { return w.kind == "passed"; });
  ASSERT_NE(told, r.report.warnings.end());
  EXPECT_NE(told->text.find("hit so often in 1 step (first at t = "), std::string::npos)
      << told->text;
  EXPECT_NE(told->text.find(" s, ball-plates"), std::string::npos) << told->text;
}

TEST(FastBodiesLimits, AReboundThatComparesEqualStepsIsRefused) {
  const Ran r = run(bullet("PaoliSchatzman", 0.5, kPlate));
  EXPECT_EQ(r.report.ended, RunReport::Ended::failed);
  EXPECT_NE(r.report.reason.find("a rebound compares two steps of equal length"), std::string::npos)
      << r.report.reason;
  EXPECT_LT(r.x.q[0], 0.098 + kHit);
}

TEST(FastBodiesCost, NothingIsEvaluatedWhereNothingIsFast) {
  for (const char* file : {"falling_box", "tower", "newtons_cradle", "slide_to_roll"}) {
    Scene scene(file);
    scene.model().simulation.until = 0.2;
    scene.model().scheme(std::make_unique<MoreauMidpoint>());
    Simulation simulation(scene.model());
    const RunReport& r = simulation.run();
    EXPECT_EQ(r.passing.parted, 0) << file;
    EXPECT_EQ(r.passing.swept, 0) << file;
    EXPECT_EQ(r.cost.evaluations, r.steps) << file;
  }
}

TEST(FastBodiesCost, AFastBodyFarFromOthersCostsNoPath) {
  const Ran r = run(withE(0.0) + "<systems>" + ball("ball", "0 0 100", "300 0 0") +
                    "<Ground name=\"plate\">" + kPlate + "</Ground></systems>" + kLaw +
                    scheme("MoreauMidpoint", 0.1));
  EXPECT_EQ(r.report.passing.swept, 0);
}

}  // namespace
}  // namespace dynamy::reference
