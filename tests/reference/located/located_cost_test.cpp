// What located switches cost, counted in evaluations of M, h and contacts, at an error that truth
// from outside of the program measures.
#include <gtest/gtest.h>

#include <cmath>
#include <reference/located/located_run.hpp>
#include <reference/located/located_scenes.hpp>

namespace dynamy::reference {
namespace {

using namespace scenes;

// Woodpecker, event-driven with Taylor series of order 40 (truth N10): the limit cycle from the
// instant at which the stuck sleeve begins to slip.
constexpr double kCyclePeriod = 0.14597606514375183, kCycleFall = 0.019445379284716527;
constexpr double kPhiS = -0.20513534924352575, kOmegaS = 17.57466620557608;
constexpr double kLift = 0.00582075723481;  // the sleeve leaves the pole, 11 digits
const std::string kCycle = R"xml(<dynamy version="1"><plugin library="woodpecker"/>
  <systems><Woodpecker name="toy" q0="0 {-0.6/5.8} -0.20513534924352575" u0="0 0 17.57466620557608"/>
  </systems><elements>
    <WoodpeckerContact name="beak" on="toy" place="beak">
      <UnilateralCoulomb epsilonN="0.5" mu="0.3"/></WoodpeckerContact>
    <WoodpeckerContact name="sleeve2" on="toy" place="sleeve2">
      <UnilateralCoulomb epsilonN="0" mu="0.3"/></WoodpeckerContact>
    <WoodpeckerContact name="sleeve3" on="toy" place="sleeve3">
      <UnilateralCoulomb epsilonN="0" mu="0.3"/></WoodpeckerContact>
  </elements><simulation until="1" step="1"/></dynamy>)xml";

TEST(LocatedCost, TenSwitchesTo1e10TakeAtMost2000Evaluations) {
  constexpr double kTolerance = 2e-11;
  LocatedRun cycle(kCycle, kTolerance, kCyclePeriod);
  ASSERT_EQ(cycle.run().ended, RunReport::Ended::finished) << cycle.report().reason;
  EXPECT_NEAR(cycle.state().q[0] / kCycleFall, -1.0, 1e-10);
  EXPECT_NEAR(cycle.state().q[2] / kPhiS, 1.0, 1e-10);
  EXPECT_NEAR(cycle.state().u[2] / kOmegaS, 1.0, 1e-10);

  LocatedRun ten(kCycle, kTolerance, kCyclePeriod + 1.02 * kLift);
  const RunReport& r = ten.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_EQ(r.located.switches, 10);
  EXPECT_LE(r.cost.evaluations, 2000);
  const std::vector<double> lifts = ten.changes("sleeve2", Status::open);
  ASSERT_FALSE(lifts.empty());
  EXPECT_NEAR(lifts.back(), kCyclePeriod + kLift, 1e-10 * kCyclePeriod);
  RecordProperty("evaluations", static_cast<int>(r.cost.evaluations));
}

TEST(LocatedCost, ASwitchTakesAtMost35EvaluationsBesideTheSmoothSteps) {
  constexpr double kMost = 35.0;
  struct Row {
    const char* name;
    std::string scene;
    double until;
  };
  const Row rows[] = {
      {"woodpecker", "woodpecker", 1.46},          {"impact oscillator", kImpactOscillator, 30.0},
      {"belt, two levels", kBelt, 45.0},           {"belt, weakening", kWeakeningBelt, 60.0},
      {"dry friction", "coulomb_oscillator", 5.0}, {"rocking block", "rocking_block", 2.2}};
  for (const Row& row : rows)
    for (const double tolerance : {1e-3, 1e-4, 1e-6, 1e-8, 1e-10}) {
      LocatedRun run(row.scene, tolerance, row.until);
      const RunReport& r = run.run();
      ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
      ASSERT_GE(r.located.switches, 3);
      // The step that the switch spoils, the step to it, the search, the decision; the first
      // decision of a run is no switch.
      const double each = static_cast<double>(r.cost.effort.switches + r.cost.effort.events) /
                          static_cast<double>(r.located.switches);
      EXPECT_LE(each, kMost) << row.name << " at " << tolerance;
    }
}

TEST(LocatedCost, AContactThatIsAloneLiftsOffForTheCostOfAnyOtherSwitch) {
  // 1 kg on a floor that is pulled up with 3 N/s t: lifts off where 3 t = 9.81. The force is
  // linear in t, so that its root on any path is exact: the step that is spoiled and the one to
  // the root are 12 evaluations each at most, the look in the middle and three of the root's
  // search, the decision four.
  LocatedRun run(R"xml(<dynamy version="1">
    <systems><Coordinates name="block" q="y" units="m" q0="0" u0="0" M="1" h="3*t - 9.81"/></systems>
    <elements><CoordinateContact name="floor" on="block" gap="y"><Unilateral/></CoordinateContact>
    </elements><simulation until="1" step="1"/></dynamy>)xml",
                 1e-8, 4.0);
  const RunReport& r = run.run();
  ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  const std::vector<double> lifts = run.changes("floor", Status::open);
  ASSERT_EQ(lifts.size(), 1u);
  // As near as the force's bound is found, 1e-8 of a step of at most 4 s.
  EXPECT_NEAR(lifts.front(), 3.27, 4e-8);
  EXPECT_LE(r.cost.effort.switches, 28);
}

/// n balls that bounce on a floor 1 m apart from each other. Any two of them could touch.
std::string bouncingBalls(int n) {
  std::string text = R"xml(<dynamy version="1"><systems>)xml";
  for (int i = 0; i < n; ++i)
    text += "<RigidBody name=\"b" + std::to_string(i) + "\" position=\"" + std::to_string(i % 8) +
            " " + std::to_string(i / 8) + " " + std::to_string(0.5 + 0.3 * (i * 37 % 101) / 101.0) +
            "\"><Sphere radius=\"0.1\" mass=\"1\" material=\"a\"/></RigidBody>";
  return text + R"xml(<Ground name="floor"><HalfSpace material="a"/></Ground></systems>
    <forces><Gravity acceleration="0 0 -9.81"/></forces>
    <elements><Contact between="a a"><Unilateral epsilonN="0.9"/></Contact></elements>
    <simulation until="1" step="1"/></dynamy>)xml";
}

TEST(LocatedCost, LooksASwitchDoNotGrowWithTheNumberOfBodies) {
  // Pairs that fly apart take no look, and of the gaps above the floor, which all fall, only the
  // first one is refined: each other one takes a look at its gap alone in each of the eight
  // intervals of a search at most.
  double alone = 0.0;
  for (const int n : {8, 64}) {
    LocatedRun run(bouncingBalls(n), 1e-8, 0.6);
    const RunReport& r = run.run();
    ASSERT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
    ASSERT_GE(r.located.switches, n);
    const auto switches = static_cast<double>(r.located.switches);
    EXPECT_LT(static_cast<double>(r.cost.effort.looks) / switches, 40.0) << n;
    const double gaps = static_cast<double>(r.cost.effort.gaps) / (switches * n);
    if (n == 8) alone = gaps;
    EXPECT_LT(gaps, 1.2 * alone) << n;
    RecordProperty("gapsOf" + std::to_string(n), std::to_string(gaps));
  }
}

/// Two rods of 1 m and 1 kg with hinges, let go from the horizontal, in the coordinates of the
/// hinges.
const std::string kRods = R"xml(<dynamy version="1"><systems>
    <PlanarBody name="upper" position="0.5 0 0" mass="1" inertia="{1/12}"/>
    <PlanarBody name="lower" position="1.5 0 0" mass="1" inertia="{1/12}"/><Ground name="world"/>
  </systems><forces><Gravity acceleration="0 0 -9.81"/></forces><elements>
    <Revolute between="world upper" at="0 0 0"/><Revolute between="upper lower" at="1 0 0"/>
  </elements><simulation coordinates="minimal" until="10" step="1ms"/></dynamy>)xml";

/// Angles from straight down, Lagrange's equations of the rods by Runge and Kutta's method.
class Rods {
 public:
  Rods() : y_{0.5L * kPi, 0.5L * kPi, 0.0L, 0.0L} {}
  /// Place of the tip at t [m], later than the last.
  Eigen::Vector2d tip(double t) {
    // 20 µs: h⁴ and a length of the motion of 0.1 s leave 1e-15.
    const int n = std::max(1, static_cast<int>(std::ceil((t - t_) / 2e-5)));
    const long double h = (static_cast<long double>(t) - t_) / n;
    for (int i = 0; i < n; ++i) step(h);
    t_ = t;
    return {static_cast<double>(std::sin(y_[0]) + std::sin(y_[1])),
            static_cast<double>(-std::cos(y_[0]) - std::cos(y_[1]))};
  }

 private:
  using Y = std::array<long double, 4>;
  static constexpr long double kPi = 3.14159265358979323846264338L;
  static Y rates(const Y& y) {
    // 4/3 a'' + 1/2 c b'' = −1/2 s b'² − 3/2 g sin a,  1/2 c a'' + 1/3 b'' = 1/2 s a'² − 1/2 g sin
    // b
    const long double g = 9.81L, c = std::cos(y[0] - y[1]), s = std::sin(y[0] - y[1]);
    const long double A = 4.0L / 3, B = 0.5L * c, C = 1.0L / 3;
    const long double f = -0.5L * s * y[3] * y[3] - 1.5L * g * std::sin(y[0]);
    const long double k = 0.5L * s * y[2] * y[2] - 0.5L * g * std::sin(y[1]);
    const long double D = A * C - B * B;
    return {y[2], y[3], (C * f - B * k) / D, (A * k - B * f) / D};
  }
  void step(long double h) {
    const auto along = [this](const Y& k, long double by) {
      Y out = y_;
      for (std::size_t i = 0; i < 4; ++i) out[i] += by * k[i];
      return out;
    };
    const Y k1 = rates(y_), k2 = rates(along(k1, h / 2)), k3 = rates(along(k2, h / 2)),
            k4 = rates(along(k3, h));
    for (std::size_t i = 0; i < 4; ++i) y_[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  Y y_;
  double t_ = 0.0;
};

TEST(LocatedCost, APendulumOfTwoRodsHas1e10OverTwoSecondsInFewEvaluations) {
  class Tips final : public Observer {
   public:
    void step(const StepView& v) override {
      if (v.after.t > 2.0) return;
      const double a = v.after.q[0], b = v.after.q[0] + v.after.q[1];
      const Eigen::Vector2d tip(std::cos(a) + std::cos(b), std::sin(a) + std::sin(b));
      worst = std::max(worst, (tip - rods.tip(v.after.t)).norm());
    }
    Rods rods;
    double worst = 0.0;
  } tips;
  LocatedRun run(kRods, 1e-9, 10.0);
  run.simulation().observe(tips);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_LT(tips.worst, 3.4e-10);
  // 0.7 µs each on the machine where MuJoCo's and Bullet's Runge–Kutta methods take 34 and 35 ms
  // for that error: a seventh of their time.
  EXPECT_LE(run.report().cost.evaluations, 7000);
}

}  // namespace
}  // namespace dynamy::reference
