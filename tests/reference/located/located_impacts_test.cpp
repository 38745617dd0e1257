// Every impact of a run to a tolerance is told, at its instant, wherever in a step it lies.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/solver/proximal_newton.hpp>
#include <memory>
#include <reference/located/located_run.hpp>
#include <utility>
#include <vector>

namespace dynamy::reference {
namespace {

/// A body that turns to and fro between two stops of its joint, free between them.
const std::string kTwoStops = R"xml(<dynamy version="1">
  <systems><Ground name="world"/>
    <PlanarBody name="a" plane="xy" mass="1" inertia="0.5" angularVelocity="5"/></systems>
  <elements><Revolute between="world a"/>
    <JointStop name="stop" between="world a" start="1" lower="-3" upper="9">
      <Unilateral epsilonN="0.6"/></JointStop></elements>
  <simulation until="1" step="1"/></dynamy>)xml";

TEST(LocatedImpacts, OfAJointBetweenTwoStopsAreAllTold) {
  // ω_k = 5·0.6^k; 8 rad to the first impact, 12 rad from each to the next. Some of these instants
  // are ends of steps: free motion doubles the step up to a contact's reach.
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-11}) {
    LocatedRun run(kTwoStops, tolerance, 200.0);
    ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    const std::vector<double> upper = run.impacts("stop.upper"), lower = run.impacts("stop.lower");
    double t = 8.0 / 5.0, omega = 5.0;
    std::size_t n = 0;
    for (; t < 200.0; ++n, omega *= 0.6, t += 12.0 / omega) {
      const std::vector<double>& told = n % 2 == 0 ? upper : lower;
      ASSERT_LT(n / 2, told.size()) << "tolerance " << tolerance << ", impact at " << t << " s";
      // The motion between impacts is linear: rounding of ε per step, times (1/0.6)^n of the speed.
      EXPECT_NEAR(told[n / 2], t, 1e-11 * t);
    }
    EXPECT_EQ(upper.size() + lower.size(), n);
    EXPECT_EQ(run.report().contacts.impacts, static_cast<long>(n));
    for (const ContactEvent& e : run.events) EXPECT_TRUE(!e.impact || e.impulse > 0.0);
  }
}

/// A ball on the floor that falls at once, or from a height.
std::string fallingBall(double height, double velocity) {
  return R"xml(<dynamy version="1"><systems>
    <RigidBody name="ball" position="0 0 )xml" +
         std::to_string(0.1 + height) + R"xml(" velocity="0 0 )xml" + std::to_string(velocity) +
         R"xml("><Sphere radius="0.1" mass="1" material="stone"/></RigidBody>
    <Ground name="world"><HalfSpace material="floor"/></Ground></systems>
  <forces><Gravity/></forces>
  <elements><Contact name="floor" between="stone floor"><Unilateral epsilonN="0.5"/></Contact>
  </elements><simulation until="1" step="1"/></dynamy>)xml";
}

TEST(LocatedImpacts, AtTheStartOfARunAreTold) {
  LocatedRun run(fallingBall(0.0, -2.0), 1e-8, 0.1);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  ASSERT_EQ(run.events.size(), 1u);
  EXPECT_TRUE(run.events[0].impact);
  EXPECT_EQ(run.events[0].t, 0.0);
  EXPECT_DOUBLE_EQ(run.events[0].speed, 2.0);
  EXPECT_NEAR(run.events[0].impulse, 3.0, 1e-12);  // m (1 + ε) v, rounding of the solver
  EXPECT_NEAR(run.state().u[2], 1.0 - 0.1 * 9.81, 1e-9);
}

TEST(LocatedImpacts, OfABallThatComesToRestAreThoseOfTheSeries) {
  // Heights below z tol L = 1e-10 m (L: below 1 m) are none: v_k = ε^k v, v²/(2g) = ε^{2k} h.
  const double h = 0.5;
  LocatedRun run(fallingBall(h, 0.0), 1e-9, 2.0);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  const double length = run.model().length();
  std::vector<double> told;
  double t = std::sqrt(2.0 * h / 9.81), v = 9.81 * t;
  for (const ContactEvent& e : run.events)
    if (e.impact) told.push_back(e.t);
  // The last is the first whose rebound is lower than the threshold.
  for (std::size_t n = 0;; ++n) {
    ASSERT_LT(n, told.size());
    EXPECT_NEAR(told[n], t, 1e-8);  // ten times the tolerance, in seconds
    v *= 0.5;
    if (v * v / (2.0 * 9.81) <= 0.1 * 1e-9 * length) {
      EXPECT_EQ(told.size(), n + 1);
      break;
    }
    t += 2.0 * v / 9.81;
  }
  EXPECT_EQ(run.report().contacts.impacts, static_cast<long>(told.size()));
}

/// Solves, and says that it has searched for long in vain.
class SearchesInVain final : public InclusionSolver {
 public:
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) override {
    efforts.push_back(problem.effort);
    SolveReport report = solver_.solve(problem, Lambda);
    report.inVain = true;
    return report;
  }
  std::vector<Effort> efforts;

 private:
  ProximalNewton solver_;
};

// A ball that bounces: one inclusion an impact. After a long search in vain the next 1, 3, 7, … search
// briefly (theory 4.13, 50.7).
TEST(LocatedImpacts, SearchBrieflyAfterALongSearchInVain) {
  LocatedRun run(
      R"xml(<dynamy version="1"><systems><PointMass name="ball" plane="xz" position="0 0 1"
    mass="1"/><Ground name="world"/></systems><forces><Gravity/></forces><elements>
    <CoordinateContact on="ball" gap="z"><Unilateral epsilonN="1"/></CoordinateContact></elements>
    <simulation until="1" step="1"/></dynamy>)xml",
      1e-8, 13.5);
  auto owned = std::make_unique<SearchesInVain>();
  SearchesInVain& solver = *owned;
  run.model().solver(std::move(owned));
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  ASSERT_EQ(r.contacts.impacts, 15);  // the first after √(2/g) = 0.452 s, one each 0.903 s
  ASSERT_EQ(solver.efforts.size(), 15u);
  for (std::size_t i = 0; i < solver.efforts.size(); ++i)
    EXPECT_EQ(solver.efforts[i],
              i == 0 || i == 2 || i == 6 || i == 14 ? Effort::full : Effort::retried)
        << i;
}

TEST(LocatedImpacts, FindsADipThatBeginsWhereTheGapIsZero) {
  // A light ball between the floor and a heavy one that falls beside its top: ever faster impacts, until
  // both gaps are zero to rounding. The heavy ball then glides past: the gap falls below zero at
  // once, and is above it again at the next sample. 0.3 s at 1 ms: no picture shows an overlap of more
  // than the height of a slip that the tolerance passes, 1e-6 of 6 m.
  LocatedRun run(R"(<dynamy version="1"><systems>
    <RigidBody name="light" position="-0.1985 0.136582 2.82314" mass="0.0325188" inertia="0.0126 0.0126 0.0126"
      angularVelocity="-3.2227 -5.11335 -6.91395"><Sphere radius="0.985375" material="a"/></RigidBody>
    <RigidBody name="heavy" position="-0.174351 -0.0861254 8.46942" mass="0.540301" inertia="0.37 0.37 0.37"
      angularVelocity="-1.46195 1.72858 -2.51949"><Sphere radius="1.30911" material="a"/></RigidBody>
    <Ground><HalfSpace material="c"/></Ground></systems><forces><Gravity/></forces>
    <elements><Contact between="a a"><UnilateralCoulomb mu="1.48518" epsilonN="0.557124"/></Contact>
    <Contact between="a c"><UnilateralCoulomb mu="1.48518" epsilonN="0.557124"/></Contact></elements>
    <simulation until="1.3" tolerance="1e-6"/></dynamy>)",
                 1e-6, 1.3);
  run.record(1.3, 1000.0);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  double least = 1.0;
  for (const LocatedRun::Picture& p : run.film)
    least = std::min(least, (p.poses[0].r_OS_I - p.poses[1].r_OS_I).norm() - 0.985375 - 1.30911);
  EXPECT_GT(least, -6e-6);
}

TEST(LocatedImpacts, FollowEachOtherAtOneInstantUntilNoneIsLeft) {
  // A ball that touches the floor and a heavy one hits them in turn, all at t = 0: after one on the
  // floor v ← −e v, after one between both V ← V + P/M, v ← v − P/m. Of 900 impacts none is left, and
  // both rest.
  const double m = 1.0, M = 400.0, e = 0.9;
  double v = -1.0, V = -0.5;
  int impacts = 0;
  for (; impacts < 5000; ++impacts) {
    if (v < -1e-10) {
      v = -e * v;
    } else if (V - v < -1e-10) {
      const double P = -(1.0 + e) * (V - v) / (1.0 / m + 1.0 / M);
      V += P / M, v -= P / m;
    } else {
      break;
    }
  }
  LocatedRun run(R"(<dynamy version="1"><systems>
    <RigidBody name="light" position="0 0 0.1" velocity="0 0 -1"><Sphere radius="0.1" mass="1" material="a"/></RigidBody>
    <RigidBody name="heavy" position="0 0 0.5" velocity="0 0 -0.5"><Sphere radius="0.3" mass="400" material="a"/></RigidBody>
    <Ground><HalfSpace material="a"/></Ground></systems>
    <elements><Contact between="a a"><UnilateralCoulomb mu="0" epsilonN="0.9"/></Contact></elements>
    <simulation until="1" step="1"/></dynamy>)",
                 1e-6, 1.0);
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_EQ(r.stepping.periods, 0);
  // Contacts that approach with less than 1e-10 of the largest speed rest: some hundred roundings
  // of such speeds at most.
  EXPECT_NEAR(run.state().u[2], v, 1e-8);
  EXPECT_NEAR(run.state().u[8], V, 1e-8);
  EXPECT_GT(r.contacts.impacts, impacts / 2);  // the last ones, below 1e-10, are no impacts
}

TEST(LocatedImpacts, ABounceBelowRoundingOfItsGapComesToRest) {
  // It would rise by v²/2a = 2.6e-16 m from a gap of −1.5e-13 m: it never opens.
  LocatedRun run(R"(<dynamy version="1"><systems><RigidBody name="ball" velocity="0 0 2.3e-4"
    position="0 0 0.99999999999985"><Sphere radius="1" mass="1" material="a"/></RigidBody>
    <Ground><HalfSpace material="a"/></Ground></systems>
    <forces><Gravity acceleration="0 0 -1e8"/></forces>
    <elements><Contact between="a a"><UnilateralCoulomb mu="0" epsilonN="0.55"/></Contact></elements>
    <simulation until="1" step="1"/></dynamy>)",
                 1e-3, 1e-3);
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_EQ(r.stepping.periods, 0);
  EXPECT_NEAR(run.state().q[2], 1.0, 1e-12);
  EXPECT_EQ(run.state().u[2], 0.0);
}

TEST(LocatedImpacts, BodiesThatStartInsideEachOtherArePushedApartAtOnce) {
  // The second ball is inside the first one and separates from it; pushed away by half of the overlap, it
  // is inside the third one, from which it separates, too. Each is pushed by as much as the next:
  // centres 2 m apart, and the centre of mass where it was.
  LocatedRun run(R"(<dynamy version="1"><systems>
    <RigidBody name="a" position="0 0 0" velocity="-1 0 0"><Sphere radius="1" mass="1" material="a"/></RigidBody>
    <RigidBody name="b" position="1 0 0"><Sphere radius="1" mass="1" material="a"/></RigidBody>
    <RigidBody name="c" position="3.05 0 0" velocity="1 0 0"><Sphere radius="1" mass="1" material="a"/></RigidBody>
    </systems><elements><Contact between="a a"><UnilateralCoulomb mu="0" epsilonN="0"/></Contact></elements>
    <simulation until="1" step="1"/></dynamy>)",
                 1e-6, 1e-3);
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_EQ(r.stepping.periods, 0);
  const Eigen::VectorXd& q = run.state().q;
  const double a = q[0], b = q[7], c = q[14];
  // After 1 ms of separation at 1 m/s; positions are projected to 1e-10 L.
  EXPECT_NEAR(b - a, 2.001, 1e-9);
  EXPECT_NEAR(c - b, 2.001, 1e-9);
  EXPECT_NEAR(a + b + c, 4.05, 1e-9);
}

}  // namespace
}  // namespace dynamy::reference
