// Runs to a tolerance across switches, against closed forms and event-driven solutions in extended
// precision. Costs are counted in evaluations of M, h and contacts, never in seconds.
#include <gtest/gtest.h>
#include <fstream>

#include <cmath>
#include <numbers>
#include <reference/located/located_run.hpp>
#include <reference/located/located_scenes.hpp>

namespace dynamy::reference {
namespace {

using namespace scenes;

// Event-driven, Taylor series of order 40 (models/woodpecker.xml).
constexpr double kPeriod = 0.145976065144;  // 12 digits
constexpr double kFall = 0.019445379285;    // 11 digits

struct Cycle {
  double period = 0.0, fall = 0.0, evaluations = 0.0;
};

/// Means of 40 cycles behind 120: the multiplier −0.84 leaves 1e-9 of the start there, and the sum
/// of what is left alternates, so 1e-9/40 of 3 % of a cycle, below 1e-12, is seen in the mean.
Cycle woodpecker(double tolerance) {
  class Falls final : public Observer {
   public:
    void step(const StepView& v) override {
      if (v.report.counts.impacts > 0) t.push_back(v.after.t), y.push_back(v.after.q[0]);
    }
    std::vector<double> t, y;
  } falls;
  LocatedRun toy("woodpecker", tolerance, 23.45);
  toy.simulation().observe(falls);
  const RunReport& r = toy.run();
  EXPECT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_EQ(r.located.undecided, 0);
  const std::vector<double> beak = toy.impacts("beak");
  EXPECT_GE(beak.size(), 160u);
  if (beak.size() < 160) return {};
  const auto height = [&](double t) {
    for (std::size_t i = 0; i < falls.t.size(); ++i)
      if (falls.t[i] == t) return falls.y[i];
    return std::nan("");
  };
  Cycle c;
  c.period = (beak[159] - beak[119]) / 40.0;
  c.fall = (height(beak[119]) - height(beak[159])) / 40.0;
  c.evaluations = static_cast<double>(r.cost.evaluations) * kPeriod / r.t;
  return c;
}

TEST(LocatedWoodpecker, ReachesOneInAMillionWithAtMost700EvaluationsACycle) {
  const Cycle c = woodpecker(1e-6);
  EXPECT_NEAR(c.period / kPeriod, 1.0, 1e-6);
  EXPECT_NEAR(c.fall / kFall, 1.0, 1e-6);
  EXPECT_LE(c.evaluations, 700.0);
}

TEST(LocatedWoodpecker, ReachesTenDigitsWithAtMost1300EvaluationsACycle) {
  const Cycle c = woodpecker(1e-10);
  EXPECT_NEAR(c.period / kPeriod, 1.0, 1e-10);
  EXPECT_NEAR(c.fall / kFall, 1.0, 1e-9);  // 10 tol: y is measured against the toy's length
  EXPECT_LE(c.evaluations, 1300.0);
}

TEST(LongLocatedWoodpecker, ReachesPeriodAndFallTo1e10) {
  const Cycle c = woodpecker(1e-12);
  EXPECT_NEAR(c.period / kPeriod, 1.0, 1e-10);
  EXPECT_NEAR(c.fall / kFall, 1.0, 1e-10);
}

// ---- accumulations of impacts
// --------------------------------------------------------------------

TEST(LocatedBall, RestsAtTheInstantOfTheClosedFormAndStays) {
  LocatedRun ball(kBall, 1e-10, 3.0);
  const RunReport& r = ball.run();
  EXPECT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  // √(2h/g)(1 + e)/(1 − e).
  EXPECT_NEAR(r.located.accumulationEnd, std::sqrt(2.0 / 9.81) * 3.0, 1e-10);
  EXPECT_EQ(r.located.accumulations, 1);
  EXPECT_LE(r.located.switches, 20);
  // A flight is a parabola: the method of order 5 will do for the step to the floor, two of 6
  // evaluations an impact, and what finds and decides it; with order 8 there were 584.
  EXPECT_LE(r.cost.evaluations, 360);
  EXPECT_EQ(ball.state().u[0], 0.0);
  EXPECT_NEAR(ball.state().q[0], 0.0, 1e-15);  // rounding of the projection
  EXPECT_NEAR(ball.impacts("floor").front(), std::sqrt(2.0 / 9.81), 1e-10);
}

TEST(LocatedBall, RestsAfterAThousandImpactsToo) {
  LocatedRun ball(kBall, 1e-8, 100.0, {{"e", "0.99"}});
  const RunReport& r = ball.run();
  EXPECT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  // 89.9 s. Parabolas are exact, so that rounding alone is passed on from rebound to rebound: 1e-14
  // of a second a thousand times.
  EXPECT_NEAR(r.located.accumulationEnd, std::sqrt(2.0 / 9.81) * 199.0, 1e-10);
  EXPECT_EQ(ball.state().u[0], 0.0);
  // e^2n h = 0.1 tol: 1030 impacts.
  EXPECT_LE(r.located.switches, 1100);
}

TEST(LocatedSlot, ChattersToSlidingAndSlidesOn) {
  LocatedRun slot(kSlot, 1e-11, 2.0);
  const RunReport& r = slot.run();
  EXPECT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  // Truth N19, event-driven.
  EXPECT_NEAR(r.located.accumulationEnd, 0.14555811843322627, 1e-10);
  EXPECT_NEAR(slot.state().q[0], 8.11185815777493, 1e-9);
  EXPECT_NEAR(slot.state().u[0], 8.110858157774931, 1e-10);
  EXPECT_EQ(slot.state().u[1], 0.0);
}

TEST(LocatedBlock, RocksAsLongAsTheClosedFormSays) {
  LocatedRun block("rocking_block", 1e-11, 2.2);
  const RunReport& r = block.run();
  EXPECT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  // Truth N08, 13 digits.
  const double truth[] = {0.4128261160473157, 1.10230523122, 1.702799677331815};
  std::vector<double> t;
  for (const ContactEvent& e : block.events)
    if (e.impact && (t.empty() || e.t > t.back())) t.push_back(e.t);
  ASSERT_GE(t.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(t[i], truth[i], 1e-10);
}

TEST(LocatedBlock, ComesToRestWithoutRestitution) {
  LocatedRun block("rocking_block", 1e-6, 12.0);
  EXPECT_EQ(block.run().ended, RunReport::Ended::finished) << block.report().reason;
  EXPECT_LT(block.state().u.lpNorm<Eigen::Infinity>(), 1e-9);
  // What is off by less than 1e-3 tol L is left: 1e-9 m over the width of 0.2 m.
  EXPECT_LT(std::abs(block.state().q[2]), 5e-9);
  // η = 0.942 a turn in angular rate, until its rise of 1e-7 L: some 110 turns.
  EXPECT_LT(block.report().located.switches, 200);
}

TEST(LocatedBlock, ABoxInSpaceFallsTumblesAndRests) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    LocatedRun box("falling_box", tolerance, 3.0);
    EXPECT_EQ(box.run().ended, RunReport::Ended::finished) << box.report().reason;
    EXPECT_LT(box.state().u.lpNorm<Eigen::Infinity>(), 1e-9) << tolerance;
    EXPECT_NEAR(box.state().q[2], 0.075, 1e-7) << tolerance;  // its half height
    EXPECT_LT(box.report().located.switches, 100) << tolerance;
  }
}

// ---- time scales -------------------------------------------------------------------------------

TEST(LocatedScales, OfAFastTopAreNotThoseOfThePendulumBesideIt) {
  // A double pendulum for 10 s, alone and beside a top that is braked from 1000 rad/s to rest
  // within 0.05 s. With one time for both the pendulum's velocities had a scale of 1000 rad/s for
  // 10 s, and its error grew 120 times.
  const std::string pendulum = R"xml(<Coordinates name="pendulum" q="a b" units="rad rad"
    q0="{pi/2} {pi/2}" kineticEnergy="a_dot^2 + b_dot^2/2 + a_dot*b_dot*cos(a - b)"
    potential="-9.81*(2*cos(a) + cos(b))"/>)xml";
  const std::string top = R"xml(<Coordinates name="top" q="s" units="rad" q0="0" u0="1000" M="1"/>
    </systems><elements><CoordinateContact on="top" slipVelocity="s_dot"><GivenFriction
    force="20000"/></CoordinateContact></elements>)xml";
  const auto error = [](const std::string& systems, double tolerance) {
    LocatedRun run("<dynamy version=\"1\"><systems>" + systems +
                       "<simulation until=\"1\" step=\"1\"/></dynamy>",
                   tolerance, 10.0);
    EXPECT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
    // Truth S09; in extended precision.
    return std::hypot(run.state().q[0] + 0.5684746640162, run.state().q[1] + 0.5263937279321);
  };
  for (const double tolerance : {1e-5, 1e-6, 1e-7, 1e-8}) {
    // Steps are others, and with them the errors, by a chance factor: here up to 3.
    EXPECT_LE(error(pendulum + top, tolerance), 10.0 * error(pendulum + "</systems>", tolerance))
        << tolerance;
  }
}

// ---- friction ----------------------------------------------------------------------------------

TEST(LocatedOscillator, StopsWhereTheClosedFormSays) {
  LocatedRun block("coulomb_oscillator", 1e-10, 6.0);
  const RunReport& r = block.run();
  EXPECT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_EQ(r.located.switches, 13);
  // Truth N05c: 13 half cycles.
  const std::vector<double> stops = block.changes("sole-table", Status::stick);
  ASSERT_FALSE(stops.empty());
  EXPECT_NEAR(stops.back(), 13.0 * std::numbers::pi / 10.0, 1e-9);
  EXPECT_NEAR(block.state().q[0], 0.01012, 1e-9);
  EXPECT_EQ(block.state().u[0], 0.0);
}

TEST(LocatedBelt, HasThePeriodOfTheClosedForm) {
  LocatedRun belt(kBelt, 1e-11, 45.0);
  const RunReport& r = belt.run();
  EXPECT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  const std::vector<double> slips = belt.changes("friction", Status::slip);
  ASSERT_GE(slips.size(), 4u);
  EXPECT_NEAR(slips[3] - slips[2], 8.90260540781452, 1e-10);  // truth N05
}

TEST(LocatedBelt, HasThePeriodOfWeakeningFriction) {
  LocatedRun belt(kWeakeningBelt, 1e-12, 45.0);
  const RunReport& r = belt.run();
  EXPECT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  const std::vector<double> slips = belt.changes("friction", Status::slip);
  ASSERT_GE(slips.size(), 3u);
  EXPECT_NEAR(slips[2] - slips[1], 12.001031294830579, 1e-10);  // truth N05e, 12 digits
}

TEST(LocatedBelt, SlipsBackIntoStickWithoutAFloorOfTheError) {
  // Friction 1/(1 + 3 v): its slope at rest turns an error of the slip, even the least that is
  // taken for one, into an error of the force. At 20 s the belt slips for the third time. Truth:
  // Taylor series of 40 terms with 40 digits.
  const std::string block = R"(<dynamy version="1"><systems><Coordinates name="block" q="x"
      q0="0" u0="0.2" M="1" potential="x^2/2"/></systems><elements><CoordinateContact name="friction"
      on="block" slipVelocity="x_dot - 0.2"><StribeckFriction force="1" kineticForce="0"
      speed="{1/3}" decay="rational"/></CoordinateContact></elements>
      <simulation until="20" step="1"/></dynamy>)";
  for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12}) {
    LocatedRun belt(block, tolerance, 20.0);
    EXPECT_EQ(belt.run().ended, RunReport::Ended::finished) << belt.report().reason;
    // K of the calibration's belt with weakening friction is 1 at its worst 2 K tol; the place is
    // of 1 m, rounding of its 1200 evaluations 1e-12.
    EXPECT_NEAR(belt.state().q[0], 0.00256236528282473, 10.0 * tolerance + 1e-12) << tolerance;
    // With a kink of the friction at the end of a slip every other step was rejected.
    const StepEffort& effort = belt.report().cost.effort;
    EXPECT_LT(effort.rejected, effort.smooth) << tolerance;
  }
}

TEST(LocatedImpacts, KeepTheOrbitOfTheImpactOscillator) {
  LocatedRun mass(kImpactOscillator, 1e-12, 20.0);
  const RunReport& r = mass.run();
  EXPECT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  const std::vector<double> t = mass.impacts("wall");
  ASSERT_GE(t.size(), 5u);
  double speed = 0.0;
  for (const ContactEvent& e : mass.events)
    if (e.impact) speed = e.speed;
  EXPECT_NEAR(speed, 1.8987487383113029, 1e-10);  // truth N07
  EXPECT_NEAR(t[4] - t[3], 2.0 * std::numbers::pi / 2.2, 1e-10);
}

TEST(LocatedLadder, LeavesTheWallWhereTheForceEnds) {
  LocatedRun ladder(kLadder, 1e-11, 0.68);
  const RunReport& r = ladder.run();
  EXPECT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  // Truth N22.
  const std::vector<double> leaves = ladder.changes("wall", Status::open);
  ASSERT_EQ(leaves.size(), 1u);
  EXPECT_NEAR(leaves[0], 0.459662826377381, 1e-9);
  EXPECT_NEAR(ladder.state().u[0], 1.1899376181916248, 1e-9);
}

// ---- smooth motion -----------------------------------------------------------------------------

TEST(LocatedSmooth, FollowsADoublePendulumForTenSeconds) {
  const double truth[4] = {-0.5684746640161875, -0.5263937279321457, 6.078384885761731,
                           -9.681360681708352};  // truth S09, 13 digits
  LocatedRun pendulum(kDoublePendulum, 1e-13, 10.0);
  EXPECT_EQ(pendulum.run().ended, RunReport::Ended::finished);
  // The rates at 10 s turn an error of angles into ten times as much.
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(pendulum.state().q[i], truth[i], 1e-10);
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(pendulum.state().u[i], truth[2 + i], 1e-9);

  LocatedRun rods(kRodPendulum, 1e-13, 10.0);
  EXPECT_EQ(rods.run().ended, RunReport::Ended::finished);
  EXPECT_NEAR(rods.state().q[0], std::sin(truth[0]), 1e-9);
  EXPECT_NEAR(rods.state().q[1], -std::cos(truth[0]), 1e-9);
}

TEST(LocatedSmooth, FollowsAFreeTop) {
  // Taylor series of order 40 in 45 digits, checked with truth S06 at 10 s.
  const double truth[4] = {-0.70956269522612847, -0.00067118913482409111, -0.7046373743077522,
                           -0.0025498582812157004};
  LocatedRun top(kTop, 1e-11, 20.0);
  EXPECT_EQ(top.run().ended, RunReport::Ended::finished);
  const auto p = top.state().q.tail<4>();
  double dot = 0.0;
  for (int i = 0; i < 4; ++i) dot += p[i] * truth[i];
  // Angle between the attitudes: 2|p − (p·p*)p*|.
  double square = 0.0;
  for (int i = 0; i < 4; ++i) square += (p[i] - dot * truth[i]) * (p[i] - dot * truth[i]);
  EXPECT_LT(2.0 * std::sqrt(square), 1e-9);
  EXPECT_NEAR(p.norm(), 1.0, 1e-15);
}

TEST(LocatedRest, ABoxOnFourCornersStaysForOneEvaluationAndAFew) {
  LocatedRun box(kRestingBox, 1e-8, 100.0);
  const RunReport& r = box.run();
  EXPECT_EQ(r.ended, RunReport::Ended::finished) << r.reason;
  EXPECT_LT(box.state().u.lpNorm<Eigen::Infinity>(), 1e-13);
  EXPECT_NEAR(box.state().q[2], 0.1, 1e-13);
  // Rounding of the accelerations, 1e-15 g, over 100 s: 5e-11.
  EXPECT_NEAR(box.state().q[0], 0.0, 1e-10);
  EXPECT_LT(r.cost.evaluations, 400);
}

TEST(LocatedSwitching, RotorsThatNothingTurnsStickWhereTheyMeet) {
  // A clutch of 5 N m between rotors A and B in bearings: the slip ends at w A B/((A + B) 5), with
  // the velocity of their momentum. From there on nothing asks for a moment: what the rows ask is
  // rounding, which was taken for slip, of its sign; runs stalled, or one rotor went on past the other.
  for (const char* coordinates : {"absolute", "minimal"})
    for (const double A : {1.0, 2.0, 2.3, 0.017})
      for (const double B : {1.0, 1.1, 30.0})
        for (const double w : {10.0, -9.7}) {
          const double slip = std::abs(w) * A * B / ((A + B) * 5.0), together = w * A / (A + B);
          LocatedRun run(
              "<dynamy version=\"1\"><parameter name=\"A\" value=\"1\"/>"
              "<parameter name=\"B\" value=\"1\"/><parameter name=\"w\" value=\"1\"/>"
              "<systems><Ground name=\"world\"/>"
              "<PlanarBody name=\"a\" mass=\"1\" inertia=\"{A}\" angularVelocity=\"{w}\"/>"
              "<PlanarBody name=\"b\" mass=\"1\" inertia=\"{B}\"/></systems><elements>"
              "<Revolute between=\"world a\"/><Revolute between=\"world b\"/>"
              "<JointFriction name=\"clutch\" between=\"a b\"><GivenFriction force=\"5\"/>"
              "</JointFriction></elements><simulation until=\"1\" tolerance=\"1e-9\" "
              "coordinates=\"" +
                  std::string(coordinates) + "\"/></dynamy>",
              1e-9, 1.5 * slip,
              {{"A", std::to_string(A)}, {"B", std::to_string(B)}, {"w", std::to_string(w)}});
          ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
          EXPECT_EQ(run.report().stepping.periods, 0) << coordinates << ' ' << A << ' ' << B;
          const std::vector<double> sticks = run.changes("clutch", Status::stick);
          ASSERT_EQ(sticks.size(), 1U);
          // Constant moments: what remains is rounding, of some steps.
          EXPECT_NEAR(sticks[0], slip, 1e-12 * slip);
          EXPECT_NEAR(run.signal("a.omega"), together, 1e-12 * std::abs(w));
          EXPECT_NEAR(run.signal("b.omega"), together, 1e-12 * std::abs(w));
        }
}

TEST(LocatedSwitching, MechanismsComeToRestJointByJoint) {
  // Of three joints with dry friction, without weight, two are at rest but for 1e-28 m/s when the
  // third slides: what their rows ask for, 1e-31, was not found beside its friction, 1e-7.
  std::ifstream file(DYNAMY_SOURCE_DIR "/tests/data/defects/comes_to_rest.xml");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  LocatedRun run(text, 1e-9, 0.6);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_EQ(run.report().located.undecided, 0);
  EXPECT_EQ(run.report().solver.unconverged, 0);
  // All that was there is lost in friction, but for 1e-6 of it that sliders without friction keep.
  const EnergyReport& e = run.report().energy;
  EXPECT_NEAR(e.friction, -e.kineticStart, 1e-5 * e.kineticStart);
}

// ---- the run -----------------------------------------------------------------------------------

TEST(LocatedRunning, GoesOnFromACheckpointBitForBit) {
  LocatedRun shortRun("woodpecker", 1e-6, 0.3), longRun("woodpecker", 1e-6, 0.6),
      resumed("woodpecker", 1e-6, 0.6);
  shortRun.run(), longRun.run();
  resumed.simulation().resume(shortRun.simulation().checkpoint());
  resumed.run();
  EXPECT_EQ(resumed.state().q, longRun.state().q);
  EXPECT_EQ(resumed.state().u, longRun.state().u);
  EXPECT_EQ(resumed.report().located.switches, longRun.report().located.switches);
}

}  // namespace
}  // namespace dynamy::reference
