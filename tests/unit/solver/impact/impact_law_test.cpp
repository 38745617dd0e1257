// Impact laws and the energy guard, against enumeration of all contact states (cradle) and a
// published paradox (Kane's rod).
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/solver/impact/poisson_impact.hpp>
#include <dynamy/solver/impact/sequential_impact.hpp>
#include <dynamy/solver/prox_solvers.hpp>

#include "unit/solver/inclusion_fixture.hpp"

namespace dynamy {
namespace {

ProxGaussSeidel solver() { return ProxGaussSeidel(ProxOptions{.tolerance = 1e-13}); }

/// Balls in a row, in contact; velocities after one impact.
struct Row {
  Row(int balls, double e, const std::vector<double>& masses = {})
      : law(e), inclusion(blocks(balls, masses)), balls_(balls) {
    for (int i = 0; i + 1 < balls; ++i) {
      Eigen::MatrixXd w = Eigen::MatrixXd::Zero(1, balls);
      w(0, i) = -1.0, w(0, i + 1) = 1.0;
      inclusion.contact(law, w);
    }
  }
  static std::vector<Eigen::MatrixXd> blocks(int balls, const std::vector<double>& masses) {
    std::vector<Eigen::MatrixXd> out;
    for (int i = 0; i < balls; ++i)
      out.push_back(Eigen::MatrixXd::Constant(
          1, 1, masses.empty() ? 1.0 : masses[static_cast<std::size_t>(i)]));
    return out;
  }
  Eigen::VectorXd after(const ImpactLaw& impact, const Eigen::VectorXd& u) {
    Delassus G;
    G.assemble(inclusion.contacts, inclusion.mass);
    InclusionProblem p;
    p.G = &G, p.contacts = &inclusion.contacts;
    const auto n = static_cast<std::size_t>(p.rows());
    p.gammaA.resize(n), p.c.resize(n);
    inclusion.contacts.gamma(view(u), {p.gammaA.data(), p.rows()});
    p.gammaFree = p.gammaA;
    p.uRef = 1.0;
    std::vector<double> Lambda(n, 0.0);
    ProxGaussSeidel s = solver();
    report = impact.solve(p, s, {Lambda.data(), p.rows()});
    Eigen::VectorXd out = u;
    G.addVelocity(Lambda.data(), view(out));
    return out;
  }
  Unilateral law;
  fixture::Inclusion inclusion;
  int balls_;
  SolveReport report;
};

struct Cradle {
  int balls;
  double e;
  std::vector<double> simultaneous, sequential;
};
const Cradle kCradles[] = {
    {3, 0.0, {1.0 / 3, 1.0 / 3, 1.0 / 3}, {1.0 / 3, 1.0 / 3, 1.0 / 3}},
    {3, 0.5, {0, 0.5, 0.5}, {0.203125, 0.234375, 0.5625}},
    {3, 1.0, {-1.0 / 3, 2.0 / 3, 2.0 / 3}, {0, 0, 1}},
    {5, 0.0, {0.4, 0.4, 0.4, 0.4, 0.4}, {0.4, 0.4, 0.4, 0.4, 0.4}},
    {5,
     0.5,
     {0.1, 0.1, 0.6, 0.6, 0.6},
     {0.321044921875, 0.351806640625, 0.3779296875, 0.4482421875, 0.5009765625}},
    {5, 1.0, {-0.2, -0.2, 0.8, 0.8, 0.8}, {0, 0, 0, 1, 1}}};

/// The first ball of three moves, the first two of five (N03).
Eigen::VectorXd start(int balls) {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(balls);
  u[0] = 1.0;
  if (balls == 5) u[1] = 1.0;
  return u;
}

void expectCradle(const ImpactLaw& law, const Cradle& c, const std::vector<double>& expected) {
  SCOPED_TRACE(std::to_string(c.balls) + " balls, e = " + std::to_string(c.e));
  Row row(c.balls, c.e);
  const Eigen::VectorXd u = row.after(law, start(c.balls));
  EXPECT_TRUE(row.report.ok());
  EXPECT_EQ(row.report.repaired, 0);
  // Tolerance of the solver 1e-13 of the velocities, condition of G about 10.
  for (int i = 0; i < c.balls; ++i) EXPECT_NEAR(u[i], expected[static_cast<std::size_t>(i)], 1e-11);
}

TEST(NewtonImpact, SharesTheImpactInTheCradle) {
  for (const Cradle& c : kCradles) expectCradle(NewtonImpact(), c, c.simultaneous);
}
TEST(PoissonImpact, SharesTheImpactInTheCradle) {
  for (const Cradle& c : kCradles) expectCradle(PoissonImpact(), c, c.simultaneous);
}
TEST(EnergeticImpact, SharesTheImpactInTheCradle) {
  // Without friction and with one ε the energetic coefficient is Newton's.
  for (const Cradle& c : kCradles) expectCradle(EnergeticImpact(), c, c.simultaneous);
}
TEST(SequentialImpact, PassesTheImpactOnInTheCradle) {
  for (const Cradle& c : kCradles) expectCradle(SequentialImpact(), c, c.sequential);
}

TEST(SequentialImpact, IsNewtonsImpactForOneContact) {
  for (const double e : {0.0, 0.3, 1.0}) {
    Row row(2, e, {1.0, 3.0});
    const Eigen::VectorXd u = row.after(SequentialImpact(), Eigen::Vector2d(1.0, -0.5));
    EXPECT_NEAR(u[1] - u[0], e * 1.5, 1e-14);
    EXPECT_NEAR(u[0] + 3.0 * u[1], -0.5, 1e-14);
  }
}

/// Kane's rod (F05): ε_N = 1, ε_T = 0 and friction, Newton's law gains energy.
struct KaneRod {
  explicit KaneRod(double e = 1.0)
      : law(e, 0.0, 0.3),
        G((Eigen::Matrix2d() << kNN, kNT, kNT, kTT).finished()),
        inclusion(Eigen::MatrixXd(G.llt().matrixL()), law, 0) {}
  static constexpr double kNN = 1.9869697850114967, kNT = 1.4095389311788624,
                          kTT = 3.013030214988503;
  struct Contact : fixture::Inclusion {
    Contact(const Eigen::MatrixXd& S, const SetValuedForceLaw& law, int)
        : Inclusion(std::vector<Eigen::MatrixXd>{Eigen::Matrix2d::Identity()}) {
      contact(law, S);
    }
  };
  /// Change of the kinetic energy, Λᵀγ⁻ + ½ΛᵀGΛ.
  double change(const ImpactLaw& impact) {
    Delassus d;
    d.assemble(inclusion.contacts, inclusion.mass);
    InclusionProblem p;
    p.G = &d, p.contacts = &inclusion.contacts;
    p.gammaA = p.gammaFree = {gamma[0], gamma[1]};
    p.c.resize(2);
    Lambda.setZero();
    ProxGaussSeidel s = solver();
    report = impact.solve(p, s, {Lambda.data(), 2});
    return Lambda.dot(gamma) + 0.5 * Lambda.dot(G * Lambda);
  }
  UnilateralCoulomb law;
  Eigen::Matrix2d G;
  Contact inclusion;
  Eigen::Vector2d gamma{-1.0, -0.7}, Lambda;
  SolveReport report;
};

TEST(EnergyGuard, ReportsAndRepairsKanesParadox) {
  KaneRod rod;
  const double change = rod.change(NewtonImpact());
  EXPECT_TRUE(rod.report.ok());
  EXPECT_EQ(rod.report.repaired, 1);
  // F05, less what counts as rounding: 1e-8 of the energy turned over (about 2 J).
  EXPECT_NEAR(rod.report.energyGain, 0.124967413624, 1e-7);
  EXPECT_LE(change, 1e-7);
  // The repair takes no more of the rebound than it must: some of it is left.
  EXPECT_GT(rod.gamma[0] + rod.G.row(0).dot(rod.Lambda), 0.1);
  EXPECT_GT(change, -0.02);
}

TEST(EnergyGuard, LeavesImpactsWithoutGainAlone) {
  KaneRod rod(0.2);
  const double change = rod.change(NewtonImpact());
  EXPECT_LT(change, 0.0);
  EXPECT_EQ(rod.report.repaired, 0);
  EXPECT_EQ(rod.report.energyGain, 0.0);
  EXPECT_NEAR(rod.gamma[0] + rod.G.row(0).dot(rod.Lambda), 0.2, 1e-12);
}

TEST(EnergyGuard, RepairsOnlyTheGroupThatGains) {
  // Kane's rod beside a ball with ε = 1 that touches nothing of it.
  const UnilateralCoulomb friction(1.0, 0.0, 0.3);
  const Unilateral elastic(1.0);
  KaneRod rod;
  fixture::Inclusion both({Eigen::Matrix2d::Identity(), Eigen::MatrixXd::Identity(1, 1)});
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(2, 3), v = Eigen::MatrixXd::Zero(1, 3);
  w.leftCols(2) = Eigen::MatrixXd(rod.G.llt().matrixL()), v(0, 2) = 1.0;
  both.contact(friction, w), both.contact(elastic, v);
  Delassus d;
  d.assemble(both.contacts, both.mass);
  InclusionProblem p;
  p.G = &d, p.contacts = &both.contacts;
  p.gammaA = p.gammaFree = {-1.0, -0.7, -2.0};
  p.c.resize(3);
  Eigen::Vector3d Lambda = Eigen::Vector3d::Zero();
  ProxGaussSeidel s = solver();
  const SolveReport report = NewtonImpact().solve(p, s, {Lambda.data(), 3});
  EXPECT_EQ(report.repaired, 1);
  EXPECT_NEAR(Lambda[2], 4.0, 1e-12);  // the ball keeps its ε = 1: Λ = 2 m v
  const Eigen::Vector2d percussion = Lambda.head<2>();
  EXPECT_LE(percussion.dot(rod.gamma) + 0.5 * percussion.dot(rod.G * percussion), 1e-7);
}

TEST(PoissonImpact, LosesEnergyInKanesParadox) {
  KaneRod rod;
  EXPECT_NEAR(rod.change(PoissonImpact()), -0.0704256383603, 1e-10);  // F05
  EXPECT_EQ(rod.report.repaired, 0);
}

TEST(EnergeticImpact, ReturnsTheWorkOfCompressionAndNoMore) {
  for (const double e : {0.2, 0.5, 1.0}) {
    KaneRod rod(e);
    const double change = rod.change(EnergeticImpact());
    EXPECT_EQ(rod.report.repaired, 0) << e;
    EXPECT_LE(change, 1e-12) << e;
    // Compression alone: ε = 0, straight from the plastic impact.
    KaneRod plastic(0.0);
    plastic.change(EnergeticImpact());
    const double compression = plastic.Lambda[0];
    const double gammaC = plastic.gamma[0] + plastic.G.row(0).dot(plastic.Lambda);
    const double taken = -0.5 * compression * (plastic.gamma[0] + gammaC);
    const double end = rod.gamma[0] + rod.G.row(0).dot(rod.Lambda);
    const double returned = 0.5 * (rod.Lambda[0] - compression) * (gammaC + end);
    EXPECT_NEAR(returned, e * e * taken, 1e-9) << e;
  }
}

/// Solves nothing: returns 1000 N s at each contact, after a long search if it is asked for one.
class Absurd final : public InclusionSolver {
 public:
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) override {
    efforts.push_back(problem.effort);
    Lambda.setConstant(1000.0);
    SolveReport report;
    report.status = SolveStatus::stalled;
    report.inVain = problem.effort == Effort::full;
    return report;
  }
  std::vector<Effort> efforts;
};

/// A mass of 1 kg that hits the ground at 1 m/s.
struct Hit {
  explicit Hit(double e) : law(e), inclusion(Eigen::MatrixXd::Ones(1, 1), law) {}
  double percussion(const ImpactLaw& impact, InclusionSolver& solver, Effort effort) {
    InclusionProblem& p = inclusion.pose(-Eigen::VectorXd::Ones(1));
    p.gammaA = p.gammaFree;
    p.effort = effort;
    double Lambda = 0.0;
    report = impact.solve(p, solver, {&Lambda, 1});
    return Lambda;
  }
  Unilateral law;
  fixture::Inclusion inclusion;
  SolveReport report;
};

TEST(ImpactLaw, PercussionsThatSolveNothingAddNoEnergy) {
  for (const double e : {0.0, 1.0}) {
    Hit hit(e);
    Absurd solver;
    // ΔT(s) = −1000 s + ½ 10⁶ s² = 0 at s = 1/500, as in an elastic impact.
    EXPECT_NEAR(hit.percussion(NewtonImpact(), solver, Effort::full), 2.0, 1e-12);
    EXPECT_FALSE(hit.report.ok());
    // The last try poses the impact without rebound, whose percussion is 1 N s.
    EXPECT_NEAR(hit.report.residuals.largest(), 1.0, 1e-12);
  }
}

TEST(ImpactLaw, IsNotSolvedAgainWhereTheFirstSolveFails) {
  Hit hit(1.0);
  Absurd full, retried;
  hit.percussion(NewtonImpact(), full, Effort::full);
  hit.percussion(NewtonImpact(), retried, Effort::retried);
  EXPECT_EQ(full.efforts.size(), 2U);
  EXPECT_EQ(retried.efforts.size(), 1U);
}

TEST(ImpactLaw, SearchesForLongOnceInAnImpact) {
  Hit hit(1.0);
  Absurd solver;
  hit.percussion(NewtonImpact(), solver, Effort::full);
  EXPECT_EQ(solver.efforts, (std::vector{Effort::full, Effort::retried}));
  EXPECT_TRUE(hit.report.inVain);
}

}  // namespace
}  // namespace dynamy
