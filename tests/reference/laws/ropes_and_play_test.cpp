/// Strings that go taut and joints with play against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <reference/located/located_run.hpp>
#include <reference/scene.hpp>
#include <support/gravity.hpp>

namespace dynamy::reference {
namespace {

std::string scene(const std::string& systems, const std::string& elements) {
  return "<dynamy version=\"1\"><systems><Ground name=\"world\"/>" + systems +
         "</systems><forces><Gravity/></forces><elements>" + elements +
         "</elements><simulation until=\"1\" step=\"1e-3\"/></dynamy>";
}

// Runs to 1e-10 a step: phases of a second of parabolas, which the method integrates without error,
// or of smooth swings; 100 times the tolerance for what adds up over the steps.
constexpr double kRun = 1e-10, kClose = 1e-8;

TEST(Tether, CatchesABallThrownFromItsHook) {
  // Thrown so that it is at r* = l (0.6 cos a, 0.6 sin a, 0.8) at 0.2 s; |r| grows until then. The
  // rope takes (1 + ε) of the velocity along it and m v_r² (1 − ε²)/2 of the energy.
  constexpr double l = 2.0, t = 0.2, epsilon = 0.5, m = 0.3, later = 0.05;
  const Vec3 e(0.6 * std::cos(0.4), 0.6 * std::sin(0.4), 0.8), at = l * e, gravity(0.0, 0.0, -kG);
  const Vec3 v0 = at / t - 0.5 * t * gravity, vMinus = v0 + t * gravity;
  const Vec3 vPlus = vMinus - (1.0 + epsilon) * e.dot(vMinus) * e;
  const std::string rope =
      "<Rope name=\"rope\" through=\"world ball\" length=\"2\"><Unilateral "
      "epsilonN=\"0.5\"/></Rope>";
  LocatedRun run(
      scene("<PointMass name=\"ball\" mass=\"0.3\" velocity=\"" + std::to_string(v0.x()) + ' ' +
                std::to_string(v0.y()) + ' ' + std::to_string(v0.z()) + "\"/>",
            rope),
      kRun, t + later);
  // The six digits of the text: 5e-7 m/s of the throw.
  constexpr double kText = 2e-6;
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  ASSERT_EQ(run.impacts("rope").size(), 1U);
  EXPECT_NEAR(run.impacts("rope")[0], t, kText / 9.0);  // it moves along the rope with 9.2 m/s
  const Eigen::VectorXd &q = run.state().q, &u = run.state().u;
  const Vec3 r = at + later * vPlus + 0.5 * later * later * gravity, v = vPlus + later * gravity;
  EXPECT_LT((q.head<3>() - r).norm(), kText);
  EXPECT_LT((u.head<3>() - v).norm(), 2.0 * kText);
  const double loss = 0.5 * m * e.dot(vMinus) * e.dot(vMinus) * (1.0 - epsilon * epsilon);
  const double before = 0.5 * m * v0.squaredNorm(),
               after = 0.5 * m * u.squaredNorm() + m * kG * q[2];
  EXPECT_NEAR(before - after, loss, m * v0.norm() * 4.0 * kText);
}

TEST(Tether, JerksABodyOffItsCentre) {
  // B drives off at 2 m/s from A at rest, the rope tied to A at ρ = 0.3 above its centre goes taut
  // at 0.5 s along x: P = (1 + ε) v/(1/m_A + 1/m_B + ρ²/J_A). Without gravity.
  const std::string bodies =
      "<PlanarBody name=\"a\" mass=\"1\" inertia=\"0.05\"/>"
      "<PlanarBody name=\"b\" mass=\"2\" inertia=\"0.1\" position=\"1 0 0.3\" velocity=\"2 0 0\"/>";
  std::string text = scene(bodies,
                           "<Rope name=\"rope\" through=\"a b\" points=\"0 0 0.3  0 0 0\" "
                           "length=\"2\"><Unilateral epsilonN=\"0.5\"/></Rope>");
  text.replace(text.find("<Gravity/>"), 10, "");
  const double P = 1.5 * 2.0 / (1.0 + 0.5 + 0.09 / 0.05);
  LocatedRun run(text, kRun, 0.6);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  ASSERT_EQ(run.impacts("rope").size(), 1U);
  EXPECT_NEAR(run.impacts("rope")[0], 0.5, kClose);
  const Eigen::VectorXd& u = run.state().u;
  EXPECT_NEAR(u[0], P, kClose);
  EXPECT_NEAR(std::abs(u[2]), 0.3 * P / 0.05, kClose);
  EXPECT_NEAR(u[3], 2.0 - 0.5 * P, kClose);
  EXPECT_NEAR(u[1], 0.0, kClose);
  EXPECT_NEAR(u[5], 0.0, kClose);
}

TEST(Tether, IsAConicalPendulumWhileTaut) {
  // Half angle 60°, ω² = g/(l cos θ): tension m g/cos θ, back after a turn.
  const double theta = std::numbers::pi / 3.0, omega = std::sqrt(kG / std::cos(theta)),
               r = std::sin(theta), turn = 2.0 * std::numbers::pi / omega;
  char ball[160];
  std::snprintf(ball, sizeof ball,
                "<PointMass name=\"ball\" mass=\"1.5\" position=\"%.17g 0 %.17g\" velocity=\"0 "
                "%.17g 0\"/>",
                r, -std::cos(theta), r * omega);
  const std::string text =
      scene(ball, "<Rope name=\"rope\" through=\"world ball\" length=\"1\"><Unilateral/></Rope>");
  LocatedRun located(text, kRun, turn);
  ASSERT_EQ(located.run().ended, RunReport::Ended::finished) << located.report().reason;
  EXPECT_TRUE(located.impacts("rope").empty());
  EXPECT_LT((located.state().q.head<3>() - Vec3(r, 0.0, -std::cos(theta))).norm(), kClose);
  // Steps in time: the first one throws the ball off the circle by (ω Δt)²/2 before the rope takes
  // its velocity along itself, ω Δt/2 of the whole; first order.
  const auto tensionError = [&](double dt) {
    Scene steps("cone", {.text = text});
    steps.run(0.5, dt);
    EXPECT_TRUE(steps.solved());
    return steps.Lambda()[0] / dt / (1.5 * kG / std::cos(theta)) - 1.0;
  };
  const double coarse = tensionError(1e-3), fine = tensionError(5e-4);
  EXPECT_LT(std::abs(coarse), omega * 1e-3);
  EXPECT_NEAR(coarse / fine, 2.0, 0.1);  // second order of what is left: ω Δt, with room
}

TEST(Tether, GoesSlackInALoopAndTautAfterTheParabola) {
  // From the lowest point with v² = 3.5 g l: slack where the rope has risen α = 30° above the
  // horizontal, v² = g l sin α (energy, no tension), taut again on the parabola 4 v cos α/g later
  // at 3 α below it.
  const double l = 1.0, alpha = std::numbers::pi / 6.0, v = std::sqrt(kG * l * std::sin(alpha));
  char ball[120];
  std::snprintf(ball, sizeof ball,
                "<PlanarBody name=\"ball\" mass=\"1\" inertia=\"0.1\" position=\"0 0 -1\" "
                "velocity=\"%.17g 0 0\"/>",
                std::sqrt(3.5 * kG * l));
  LocatedRun run(scene(ball, "<Rope name=\"rope\" through=\"world ball\"><Unilateral/></Rope>"),
                 kRun, 2.0);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  const std::vector<double> slack = run.changes("rope", Status::open), taut = run.impacts("rope");
  ASSERT_FALSE(slack.empty());
  ASSERT_FALSE(taut.empty());
  // Both instants are located to the tolerance of the run.
  EXPECT_NEAR(taut[0] - slack[0], 4.0 * v * std::cos(alpha) / kG, 10.0 * kClose);
}

TEST(Play, OfASliderChattersToRest) {
  // N19: released at the upper end of a slot that is 10 mm wide across an incline of 30°; ε = 0.5:
  // t = √(2 c/(g cos 30°)) (1 + 2 ε/(1 − ε)) = 0.14555811843323 s.
  const std::string bead = "<PointMass name=\"bead\" mass=\"0.1\" position=\"0 0 0.005\"/>";
  std::string text = scene(
      bead,
      "<JointStop name=\"slot\" between=\"world bead\" coordinate=\"displacement\" axis=\"0 0 "
      "1\" start=\"0.005\" lower=\"-0.005\" upper=\"0.005\"><Unilateral "
      "epsilonN=\"0.5\"/></JointStop>");
  text.replace(text.find("<Gravity/>"), 10,
               "<Gravity acceleration=\"4.905 0 -8.4957092111253443\"/>");
  LocatedRun run(text, kRun, 0.2);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  const std::vector<double> hits = run.impacts("slot.lower");
  ASSERT_GE(hits.size(), 3U);
  const double first = std::sqrt(0.02 / 8.4957092111253443);
  EXPECT_NEAR(hits[0], first, kClose);
  EXPECT_NEAR(hits[1] - hits[0], first, kClose);        // 2 ε
  EXPECT_NEAR(hits[2] - hits[1], 0.5 * first, kClose);  // 2 ε²
  EXPECT_TRUE(run.impacts("slot.upper").empty());
  // The end of the series, 2^-n of it from the last impact that is told as one.
  EXPECT_NEAR(hits.back(), 0.14555811843323, 1e-5);
  EXPECT_NEAR(run.state().q[2], -0.005, kClose);
  EXPECT_NEAR(run.state().u[2], 0.0, kClose);
  // Free along the slot.
  EXPECT_NEAR(run.state().u[0], 4.905 * 0.2, kClose);
}

TEST(Play, OfAHingeIsCrossedInEqualTimes) {
  // A wheel with 0.2 rad of play at 5 rad/s, ε = 0.8: each way takes 1/ε of the one before.
  std::string text =
      scene("<PlanarBody name=\"wheel\" mass=\"1\" inertia=\"0.5\" angularVelocity=\"5\"/>",
            "<Revolute between=\"world wheel\"/>"
            "<JointStop name=\"play\" between=\"world wheel\" lower=\"-0.1\" upper=\"0.1\">"
            "<Unilateral epsilonN=\"0.8\"/></JointStop>");
  text.replace(text.find("<Gravity/>"), 10, "");
  LocatedRun run(text, kRun, 0.2);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  std::vector<double> hits = run.impacts("play.upper");
  const std::vector<double> lower = run.impacts("play.lower");
  hits.insert(hits.end(), lower.begin(), lower.end());
  std::sort(hits.begin(), hits.end());
  ASSERT_GE(hits.size(), 3U);
  EXPECT_NEAR(hits[0], 0.02, kClose);
  EXPECT_NEAR(hits[1], 0.02 + 0.05, kClose);
  EXPECT_NEAR(hits[2], 0.02 + 0.05 + 0.0625, kClose);
}

}  // namespace
}  // namespace dynamy::reference
