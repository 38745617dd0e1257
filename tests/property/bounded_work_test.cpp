// Many contacts at a bounded cost: a wall hit by a ball with the default scheme and solver.
#include <gtest/gtest.h>

#include <algorithm>
#include <dynamy/simulation/run/simulation.hpp>
#include <dynamy/solver/automatic.hpp>
#include <dynamy/solver/problem/given_problem.hpp>
#include <reference/scene.hpp>
#include <support/bounded_run.hpp>

#include "unit/solver/inclusion_fixture.hpp"

namespace dynamy {
namespace {

using reference::Scene;

constexpr int kSide = 6;
constexpr double kStep = 2e-3, kMass = 100.0, kSpeed = 10.0;
/// Newton steps of a cold start, or 300 where sweeps do not suffice; sweeps: 100, and 1000 more
/// where these leave too much.
constexpr int kMostNewton = 500, kMostSweeps = 1100;
/// Residual up to which many contacts count as solved (theory 4.15).
constexpr double kAccepted = 3e-2;

/// kSide rows of as many bricks of 0.4 × 0.2 × 0.2 m and 16 kg in running bond, μ ½ (about 400
/// contacts), and a ball 5 cm from the wall.
std::string wall(const std::string& solver, double speed = kSpeed, int side = kSide) {
  std::string bricks;
  for (int i = 0; i < side * side; ++i)
    bricks += "<RigidBody name=\"b" + std::to_string(i) + "\" position=\"" +
              std::to_string(0.4 * (i % side) + 0.2 * (i / side % 2)) + " 0 " +
              std::to_string(0.1 + 0.2 * (i / side)) +
              "\"><Box size=\"0.4 0.2 0.2\" mass=\"16\" material=\"m\"/></RigidBody>";
  return "<dynamy version=\"1\"><systems>" + bricks +
         "<RigidBody name=\"ball\" position=\"1 -0.45 0.6\" velocity=\"0 " + std::to_string(speed) +
         " 0\"><Sphere radius=\"0.3\" mass=\"" + std::to_string(kMass) +
         "\" material=\"m\"/></RigidBody><Ground name=\"world\"><HalfSpace material=\"m\"/>"
         "</Ground></systems><forces><Gravity/></forces><elements><Contact between=\"m m\">"
         "<UnilateralCoulomb mu=\"0.5\"/></Contact></elements><simulation until=\"1\" "
         "step=\"2ms\">" +
         solver + "</simulation></dynamy>";
}

TEST(BoundedWork, AWallThatIsHitStaysApartAndGainsNothing) {
  Scene scene("wall", {.text = wall("")});
  const double ball = 0.5 * kMass * kSpeed * kSpeed;
  double least = scene.energy(), deepest = 0.0;
  int most = 0, loose = 0;
  for (int i = 0; i < 100; ++i) {
    const StepReport& report = scene.step(kStep);
    const double E = report.solved.residuals.largest();
    if (report.contacts >= 200) {
      most = std::max(most, report.solved.iterations);
      loose += E > 1e-10 ? 1 : 0;
      // The status is that of what is accepted.
      EXPECT_EQ(report.solved.ok(), E <= kAccepted) << i << ": " << E;
    }
    for (const double g : scene.system().slot(0).contacts.g) deepest = std::max(deepest, -g);
    const double now = scene.energy();
    // Nothing drives the scene. The mark of the project: a thousandth of the ball's energy.
    EXPECT_LT(now - least, 1e-3 * ball) << i;
    least = std::min(least, now);
  }
  EXPECT_LE(most, kMostNewton + kMostSweeps);
  EXPECT_GT(loose, 0);  // else nothing of it was tried
  // Bodies that turn may meet within a step where no contact was: less than the ball's way in it.
  EXPECT_LT(deepest, kSpeed * kStep);
}

TEST(BoundedWork, FewerContactsAreSettledWithoutLongSearches) {
  // Stages after the sweeps and 100 Newton steps used to take up to 6600 iterations, and ended
  // unsolved at 1.2 times the tolerance.
  int settled = 0, counted = 0;
  for (const double speed : {9.8, 9.9, 10.0, 10.1}) {
    Scene scene("wall", {.text = wall("", speed, 5)});
    for (int i = 0; i < 150; ++i) {
      const StepReport& report = scene.step(kStep);
      if (report.contacts < 24 || report.contacts >= 200) continue;
      ++counted;
      const double E = report.solved.residuals.largest();
      EXPECT_TRUE(report.solved.ok()) << speed << " m/s, step " << i << ": " << E;
      EXPECT_LE(E, 1e-4) << i;
      // At most about 350 sweeps, 100 Newton steps, 500 packed sweeps; at most twice where a
      // solution closes contacts left out before.
      EXPECT_LE(report.solved.iterations, 1900) << i;
      settled += E > 1e-10 ? 1 : 0;
    }
  }
  EXPECT_GT(counted, 100);
  EXPECT_GT(settled, 0);  // else nothing of it was tried
}

TEST(BoundedWork, BricksOverlapByHalfAPercentOfTheirThickness) {
  // With impacts that wait, and without steps that are divided where bodies would meet in them, the
  // ball was up to 8 mm deep, and bricks that fly up to 5 mm.
  std::vector<double> overlaps;
  for (const double speed : {9.8, 9.9, 10.0, 10.1, 10.2}) {
    Scene scene("wall", {.text = wall("", speed)});
    scene.model().simulation.until = 0.5;
    Simulation simulation(scene.model());
    const RunReport& report = simulation.run();
    ASSERT_EQ(report.ended, RunReport::Ended::finished) << report.reason;
    overlaps.push_back(report.gaps.penetration.value);
    // The mark of the project: a thousandth of the ball's energy.
    EXPECT_LT(report.trust.energyRise, 1e-3 * 0.5 * kMass * speed * speed) << speed;
  }
  // The mark of the project for a median: 1.5 mm of 0.2 m. A step that leads to more than 1 mm is
  // divided, up to eight times.
  std::nth_element(overlaps.begin(), overlaps.begin() + 2, overlaps.end());
  EXPECT_LE(overlaps[2], 1.5e-3);
}

TEST(BoundedWork, LeavesAWallAtRestExact) {
  Scene scene("wall", {.text = wall("", 0.0)});
  for (int i = 0; i < 50; ++i) {
    const StepReport& report = scene.step(kStep);
    EXPECT_LE(report.solved.residuals.largest(), 1e-10) << i;  // the default tolerance
  }
}

TEST(BoundedWork, IsForThoseWhoGiveNoTolerance) {
  // The ball hits in the third step; what a bounded solve leaves there is above 1e-6.
  const auto worst = [](const std::string& solver) {
    Scene scene("wall", {.text = wall(solver)});
    double E = 0.0;
    for (int i = 0; i < 4; ++i) E = std::max(E, scene.step(kStep).solved.residuals.largest());
    return E;
  };
  EXPECT_LE(worst("<Automatic tolerance=\"1e-8\"/>"), 1e-8);
  EXPECT_LE(worst("<Automatic work=\"unbounded\"/>"), 1e-10);
  EXPECT_GT(worst("<Automatic tolerance=\"1e-8\" work=\"bounded\"/>"), 1e-6);
  EXPECT_GT(worst(""), 1e-6);
}

/// A chain of `n` blocks of six velocities with a frictional contact each; its percussions from a
/// cold start.
Eigen::VectorXd chain(int n, bool bounded, Corrected corrected) {
  std::mt19937 random(3);
  const UnilateralCoulomb law(0.0, 0.0, 0.3);
  fixture::Inclusion x(
      std::vector<Eigen::MatrixXd>(static_cast<std::size_t>(n), Eigen::MatrixXd::Identity(6, 6)));
  Eigen::VectorXd c(3 * n), Lambda = Eigen::VectorXd::Zero(3 * n);
  for (int i = 0; i < n; ++i) {
    Eigen::MatrixXd Wt = Eigen::MatrixXd::Zero(3, 6 * n);
    Wt.middleCols(6 * i, 6) = fixture::randomMatrix(random, 3, 6);
    if (i > 0) Wt.middleCols(6 * (i - 1), 6) = fixture::randomMatrix(random, 3, 6);
    x.contact(law, Wt);
    c.segment(3 * i, 3) = Eigen::Vector3d(-1.0, 0.1, 0.0);
  }
  InclusionProblem& p = x.pose(c);
  p.corrected = corrected;
  Lambda[0] = 100.0;  // a start, but a bad one: sweeps only
  Automatic solver({.bounded = bounded});
  const SolveReport report = solver.solve(p, view(Lambda));
  EXPECT_TRUE(report.ok());
  const bool exact = report.residuals.largest() <= 1e-10;
  EXPECT_EQ(exact, !(bounded && corrected == Corrected::byGapsLoosely && n >= 200))
      << n << ": " << report.residuals.largest();
  return Lambda;
}

TEST(BoundedWork, LeavesFewContactsAndOtherSchemesExact) {
  // Newton's method begins elsewhere; residuals of 1e-10 leave some 1e-9 of the percussions.
  const Eigen::VectorXd few = chain(199, false, Corrected::byGapsLoosely);
  EXPECT_LE((few - chain(199, true, Corrected::byGapsLoosely)).norm(), 1e-8 * few.norm());
  EXPECT_EQ(chain(200, false, Corrected::never),
            chain(200, true, Corrected::never));  // nobody corrects what is left
  EXPECT_EQ(chain(200, false, Corrected::byGaps),
            chain(200, true, Corrected::byGaps));  // a few Newton steps
  EXPECT_NE(chain(200, false, Corrected::byGapsLoosely),
            chain(200, true, Corrected::byGapsLoosely));
}

/// `n` frictional contacts without bodies, each coupled with the one before: what is left of stiff
/// forces and joints.
std::unique_ptr<GivenProblem> givenChain(int n) {
  std::mt19937 random(3);
  Eigen::MatrixXd Wt = Eigen::MatrixXd::Zero(3 * n, 6 * n);
  Eigen::VectorXd c(3 * n);
  std::vector<GivenContact> contacts;
  for (int i = 0; i < n; ++i) {
    Wt.block(3 * i, 6 * i, 3, 6) = fixture::randomMatrix(random, 3, 6);
    if (i > 0) Wt.block(3 * i, 6 * (i - 1), 3, 6) = fixture::randomMatrix(random, 3, 6);
    c.segment(3 * i, 3) = Eigen::Vector3d(-1.0, 0.1, 0.0);
    contacts.push_back({std::make_unique<UnilateralCoulomb>(0.0, 0.0, 0.3), 3});
  }
  return std::make_unique<GivenProblem>(std::move(contacts), (Wt * Wt.transpose()).sparseView(), c);
}

TEST(BoundedWork, SweepsManyContactsWithoutBodies) {
  // An elimination of all rows costs more than all sweeps, so that Newton's method is not tried.
  for (const Corrected corrected : {Corrected::byGaps, Corrected::byGapsLoosely}) {
    const auto given = givenChain(200);
    InclusionProblem& p = given->problem();
    p.corrected = corrected;
    Eigen::VectorXd Lambda = Eigen::VectorXd::Zero(p.rows());
    const SolveReport report = Automatic({.bounded = true}).solve(p, view(Lambda));
    EXPECT_TRUE(report.ok());
    EXPECT_LE(report.residuals.largest(), kAccepted);
    EXPECT_LE(report.iterations, kMostSweeps);
    EXPECT_EQ(report.newton, 0);
  }
}

TEST(BoundedWork, IsExactWhereAStepIsTriedAgain) {
  const auto given = givenChain(200);
  InclusionProblem& p = given->problem();
  p.corrected = Corrected::inIteration, p.effort = Effort::retried;
  Eigen::VectorXd Lambda = Eigen::VectorXd::Zero(p.rows());
  const SolveReport report = Automatic({.bounded = true}).solve(p, view(Lambda));
  EXPECT_TRUE(report.ok());
  EXPECT_LE(report.residuals.largest(), 1e-10);  // the default tolerance
}

/// Pairs ξ = [1 −2; −2 1] Λ − (1, 1): neither both, nor one, nor none of the two can carry.
std::unique_ptr<GivenProblem> unsolvablePairs(int pairs) {
  Eigen::MatrixXd G = Eigen::MatrixXd::Identity(2 * pairs, 2 * pairs);
  std::vector<GivenContact> contacts;
  for (int i = 0; i < pairs; ++i) {
    G(2 * i, 2 * i + 1) = G(2 * i + 1, 2 * i) = -2.0;
    for (int k = 0; k < 2; ++k) contacts.push_back({std::make_unique<Unilateral>(0.0), 1});
  }
  return std::make_unique<GivenProblem>(std::move(contacts), G.sparseView(),
                                        Eigen::VectorXd::Constant(2 * pairs, -1));
}

TEST(BoundedWork, IsLittleWhereTheModelDoesNotHold) {
  const auto given = unsolvablePairs(40);  // more rows than the dense form takes
  InclusionProblem& p = given->problem();
  p.corrected = Corrected::inIteration, p.effort = Effort::little;
  Eigen::VectorXd Lambda = Eigen::VectorXd::Zero(p.rows());
  const SolveReport report = Automatic({.bounded = true}).solve(p, view(Lambda));
  EXPECT_FALSE(report.ok());
  EXPECT_LE(report.newton, 4);
}

TEST(BoundedWork, GivesUpEarlyWhereAStepIsTriedAgain) {
  const auto given = unsolvablePairs(20);
  InclusionProblem& p = given->problem();
  p.corrected = Corrected::inIteration, p.effort = Effort::retried;
  Eigen::VectorXd Lambda = Eigen::VectorXd::Zero(p.rows());
  const SolveReport early = Automatic({.bounded = true}).solve(p, view(Lambda));
  EXPECT_FALSE(early.ok());
  EXPECT_EQ(early.attempts, 3);  // sweeps, Newton's method with all of G, and by blocks
  Lambda.setZero();
  const SolveReport patient = Automatic().solve(p, view(Lambda));  // who gives a tolerance
  EXPECT_FALSE(patient.ok());
  EXPECT_LT(3 * early.iterations, patient.iterations);
}

TEST(BoundedWork, ARandomSceneOfFiveBodiesTakesItsFirstStep) {
  // Two pairs on cylindrical joints, springs of 44 to 6e6 N/m, velocities of 300 m/s, a step of
  // 0.13 s. Whatever is reached in a bounded number of iterations is to be taken and reported.
  BoundedRun scene("tests/data/defects/scene_3_54.xml", {.steps = 1, .iterations = 500});
  scene.run();
  EXPECT_NE(scene.report().reason, kUsedUp);
  EXPECT_GE(scene.report().steps, 1);
}

}  // namespace
}  // namespace dynamy
