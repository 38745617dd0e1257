// Runs to a tolerance with resistance to rolling and to spin, whose parts stick and slip for
// themselves, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <reference/located/located_run.hpp>
#include <support/gravity.hpp>

namespace dynamy::reference {
namespace {

constexpr double kRadius = 0.05, kMu = 0.3, kArm = 0.002;

/// A ball of 0.2 kg on a table; `gravity` in its plane besides 9.81 downwards.
std::string rollingBall(const std::string& motion, const std::string& law,
                        const std::string& gravity = "0 0") {
  return R"xml(<dynamy version="1"><systems>
  <RigidBody name="ball" position="0 0 0.05" )xml" +
         motion + R"xml(><Sphere radius="0.05" mass="0.2" material="ivory"/></RigidBody>
  <Ground name="table"><HalfSpace material="felt"/></Ground></systems>
  <forces><Gravity acceleration=")xml" +
         gravity + R"xml( -9.81"/></forces>
  <elements><Contact between="ivory felt">)xml" +
         law + R"xml(</Contact></elements><simulation until="1" step="1"/></dynamy>)xml";
}

const std::string kLaw = R"(<UnilateralRolling mu="0.3" rolling="2mm"/>)";

TEST(LocatedRolling, EndsWhereTheClosedFormSays) {
  // (5/7) g arm/r from v, v²/(2 …) of way: the stop is analytic, forces are constant.
  const double slow = 5.0 / 7.0 * kG * kArm / kRadius, rest = 0.5 / slow;
  for (const double tol : {1e-4, 1e-7, 1e-10}) {
    LocatedRun run(rollingBall(R"(velocity="0.5 0 0" angularVelocity="0 10 0")", kLaw), tol,
                   2.0 * rest);
    ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    EXPECT_NEAR(run.state().q[0], 0.25 / (2.0 * slow), 1e-12) << tol;
    EXPECT_LT(run.state().u.norm(), 1e-14) << tol;
    EXPECT_EQ(run.report().located.undecided, 0);
  }
}

TEST(LocatedRolling, SlidesThenRollsThenRests) {
  // Sliding takes μ g from v and gives (5/2)(μ r − arm) g/r² of spin, until r ω = v.
  const double v = 1.0, spin = 2.5 * (kMu * kRadius - kArm) * kG / (kRadius * kRadius);
  const double t1 = v / (kMu * kG + kRadius * spin), v1 = v - kMu * kG * t1;
  const double slow = 5.0 / 7.0 * kG * kArm / kRadius, rest = t1 + v1 / slow;
  const double way = v * t1 - 0.5 * kMu * kG * t1 * t1 + v1 * v1 / (2.0 * slow);
  LocatedRun early(rollingBall(R"(velocity="1 0 0")", kLaw), 1e-9, 0.9 * t1);
  ASSERT_EQ(early.run().ended, RunReport::Ended::finished) << early.report().reason;
  EXPECT_NEAR(early.state().u[4], spin * 0.9 * t1, 1e-9);
  for (const double tol : {1e-5, 1e-9}) {
    LocatedRun run(rollingBall(R"(velocity="1 0 0")", kLaw), tol, 1.5 * rest);
    ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    EXPECT_NEAR(run.state().q[0], way, 10.0 * tol);
    EXPECT_LT(run.state().u.norm(), 1e-14);
    EXPECT_EQ(run.report().located.undecided, 0);
    EXPECT_LE(run.report().cost.evaluations, 2000) << tol;
  }
}

TEST(LocatedRolling, ABallThatGrazesAnotherStopsSlidingAtOnce) {
  // Two balls side by side slide alike until they roll: of v_c = v + ω × (−r e_z), 2/7 is lost of v
  // after 2 |v_c|/(7 μ g). Their gap stays at −3e-17 m of rounding, which is no impact before that.
  const std::string motion = R"xml(velocity="1 0 0" angularVelocity="2 1 3">
      <Sphere radius="0.1" mass="1" material="ball"/></RigidBody>)xml";
  LocatedRun run(R"xml(<dynamy version="1"><systems>
      <RigidBody name="a" position="0 0.1 0.1" )xml" +
                     motion + R"xml(<RigidBody name="b" position="0 0.3 0.1" )xml" + motion +
                     R"xml(<Ground name="world"><HalfSpace material="floor"/></Ground></systems>
      <forces><Gravity/></forces><elements>
      <Contact between="ball floor"><UnilateralCoulomb mu="0.3"/></Contact>
      <Contact between="ball ball"><Unilateral/></Contact></elements>
      <simulation until="1" step="1"/></dynamy>)xml",
                 1e-6, 0.5);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  const Eigen::Vector2d v(1.0, 0.0), slip(0.9, 0.2);
  const double stop = 2.0 * slip.norm() / (7.0 * kMu * kG);
  const Eigen::Vector2d left = v - 2.0 / 7.0 * slip,
                        way = 0.5 * (v + left) * stop + left * (0.5 - stop);
  // Spins stand in axes that turn with the balls: within the tolerance.
  EXPECT_NEAR(run.state().q[0], way[0], 1e-6);
  EXPECT_NEAR(run.state().q[1], 0.1 + way[1], 1e-6);
  EXPECT_NEAR(run.state().q[7] - run.state().q[0], 0.0, 1e-12);
  EXPECT_EQ(run.report().located.undecided, 0);
  EXPECT_LE(run.report().cost.evaluations, 500);  // 168; 2233 with steps towards an impact
}

TEST(LocatedRolling, HoldsOnASlopeUpToItsArm) {
  // tan α = arm/r; beyond it a = (5/7)(g_x − g arm/r).
  const double limit = kG * kArm / kRadius;
  LocatedRun held(rollingBall("", kLaw, numberText(0.99 * limit) + " 0"), 1e-8, 1.0);
  ASSERT_EQ(held.run().ended, RunReport::Ended::finished) << held.report().reason;
  EXPECT_LT(held.state().u.norm(), 1e-14);
  LocatedRun rolls(rollingBall("", kLaw, numberText(1.25 * limit) + " 0"), 1e-10, 1.0);
  ASSERT_EQ(rolls.run().ended, RunReport::Ended::finished) << rolls.report().reason;
  EXPECT_NEAR(rolls.state().u[0], 5.0 / 7.0 * 0.25 * limit, 1e-9);
}

TEST(LocatedRolling, TurnsAsTheEquationOfItsMiddleSays) {
  // v̇ = (5/7)(g_T − g arm/r v/|v|), by Runge and Kutta's method with 1e5 steps: 1e-13.
  const double a = 5.0 / 7.0 * 0.6, d = 5.0 / 7.0 * kG * kArm / kRadius;
  double v[2] = {0.5, 0.0}, x[2] = {};
  const int n = 100000;
  const double h = 1.0 / n;
  const auto rate = [&](const double* w, double* out) {
    const double s = std::hypot(w[0], w[1]);
    out[0] = -d * w[0] / s, out[1] = a - d * w[1] / s;
  };
  for (int i = 0; i < n; ++i) {
    double k[4][2], w[2], vs[4][2];
    for (int s = 0; s < 4; ++s) {
      const double part = s == 0 ? 0.0 : s == 3 ? h : 0.5 * h;
      for (int j = 0; j < 2; ++j) vs[s][j] = w[j] = v[j] + (s > 0 ? part * k[s - 1][j] : 0.0);
      rate(w, k[s]);
    }
    for (int j = 0; j < 2; ++j) {
      x[j] += h / 6.0 * (vs[0][j] + 2.0 * vs[1][j] + 2.0 * vs[2][j] + vs[3][j]);
      v[j] += h / 6.0 * (k[0][j] + 2.0 * k[1][j] + 2.0 * k[2][j] + k[3][j]);
    }
  }
  LocatedRun run(rollingBall(R"(velocity="0.5 0 0" angularVelocity="0 10 0")", kLaw, "0 0.6"),
                 1e-11, 1.0);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  for (int j = 0; j < 2; ++j) {
    EXPECT_NEAR(run.state().q[j], x[j], 1e-10);
    EXPECT_NEAR(run.state().u[j], v[j], 1e-10);
  }
}

TEST(LocatedRolling, EndsASpinWithoutMovingTheBall) {
  // J Ω̇ = −arm m g, J = (2/5) m r².
  const double rest = 0.4 * kRadius * kRadius * 20.0 / (kG * 0.0004);
  const std::string law = R"(<UnilateralRolling mu="0.3" drilling="0.4mm"/>)";
  LocatedRun half(rollingBall(R"(angularVelocity="0 0 20")", law), 1e-9, 0.5 * rest);
  ASSERT_EQ(half.run().ended, RunReport::Ended::finished) << half.report().reason;
  EXPECT_NEAR(half.state().u[5], 10.0, 1e-8);
  LocatedRun run(rollingBall(R"(angularVelocity="0 0 20")", law), 1e-9, 1.2 * rest);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_LT(run.state().u.norm(), 1e-14);
  EXPECT_EQ(run.report().contacts.switches, 1);
}

TEST(LocatedRolling, KeepsTheToleranceFromAnyStart) {
  // Slides, rolls and spins at once on a table that leans, against own runs at 1e-12; a start
  // disturbed by 1e-7 is amplified by 1.4 at most.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const auto number = [&](double scale) { return numberText(scale * any(random)) + " "; };
  for (int i = 0; i < 12; ++i) {
    const std::string motion = "velocity=\"" + number(1.0) + number(1.0) +
                               "0\" angularVelocity=\"" + number(30.0) + number(30.0) +
                               number(30.0) + "\"";
    const std::string scene =
        rollingBall(motion, R"(<UnilateralRolling mu="0.2" rolling="1mm" drilling="0.3mm"/>)",
                    number(0.3) + number(0.3));
    LocatedRun truth(scene, 1e-12, 1.5);
    ASSERT_EQ(truth.run().ended, RunReport::Ended::finished) << truth.report().reason;
    for (const double tol : {1e-5, 1e-8}) {
      LocatedRun run(scene, tol, 1.5);
      ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
      EXPECT_LE((run.state().q - truth.state().q).lpNorm<Eigen::Infinity>(), 14.0 * tol) << i;
      EXPECT_EQ(run.report().located.undecided, 0);
      EXPECT_EQ(run.report().stepping.periods, 0);
    }
  }
}

TEST(LocatedRolling, FollowsEulersDiscAlongItsRim) {
  // models/eulers_disc.xml: Runge and Kutta's method on its own equations, 11 digits.
  LocatedRun disc("eulers_disc", 1e-11, 0.9);
  ASSERT_EQ(disc.run().ended, RunReport::Ended::finished) << disc.report().reason;
  EXPECT_NEAR(disc.state().q[2], 4.7700406737e-3, 1e-9);
}

}  // namespace
}  // namespace dynamy::reference
