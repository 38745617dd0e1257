// What a run to a tolerance records of contacts: their forces and gaps at the instant of the row,
// however long the steps are.
#include <gtest/gtest.h>

#include <cmath>
#include <reference/located/located_run.hpp>
#include <reference/located/located_scenes.hpp>
#include <support/bounded_run.hpp>
#include <support/table.hpp>

namespace dynamy::reference {
namespace {

Table record(LocatedRun& run, const std::vector<std::string>& signals, double every) {
  run.model().record.signals = signals;
  run.model().record.places.assign(signals.size(), Place());
  run.model().record.every = every;
  Table table;
  run.simulation().record(table);
  EXPECT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  return table;
}

TEST(LocatedSignals, OfContactsAreThoseOfTheInstant) {
  // 1 kg, pressed by 20 N − 4 N/s t, pulled by 3 N/s t, mu = 0.5: sticks until 3 t = 0.5 (20 − 4
  // t), t = 2 s; slides with u = 2.5 m/s³ (t − 2 s)²; lifts off at 5 s, y = 2/3 m/s³ (t − 5 s)³.
  LocatedRun run(R"xml(<dynamy version="1">
    <systems><Coordinates name="block" q="x y" units="m m" q0="0 0" u0="0 0" M="1 ; 0 ; 1"
      h="3*t ; 4*t - 20"/></systems>
    <elements><CoordinateContact name="floor" on="block" gap="y" slip="1 ; 0">
      <UnilateralCoulomb mu="0.5"/></CoordinateContact></elements>
    <simulation until="1" step="1"/></dynamy>)xml",
                 1e-8, 6.0);
  const Table r = record(
      run, {"floor.lambda_N", "floor.lambda_T", "floor.gamma_T", "floor.g", "floor.status"}, 0.13);
  // Forces are formulas of t alone. The rest is met to the tolerance, here of lengths of 1 m and
  // speeds of up to 20 m/s.
  constexpr double kForce = 1e-12, kMotion = 2e-7;
  ASSERT_GT(r.t.size(), 40u);
  for (std::size_t i = 1; i < r.t.size(); ++i) {
    const double t = r.t[i], N = t < 5.0 ? 20.0 - 4.0 * t : 0.0;
    EXPECT_NEAR(r.rows[i][0], N, kForce) << t;
    EXPECT_NEAR(r.rows[i][1], t < 2.0 ? -3.0 * t : -0.5 * N, kForce) << t;
    if (t < 5.0) {
      EXPECT_NEAR(r.rows[i][2], t < 2.0 ? 0.0 : 2.5 * (t - 2.0) * (t - 2.0), kMotion) << t;
    }
    EXPECT_NEAR(r.rows[i][3], t < 5.0 ? 0.0 : 2.0 / 3.0 * std::pow(t - 5.0, 3.0), kMotion) << t;
    const Status status = t < 2.0 ? Status::stick : t < 5.0 ? Status::slip : Status::open;
    EXPECT_EQ(r.rows[i][4], static_cast<double>(status)) << t;
  }
  EXPECT_LT(run.report().steps, 30);  // a row is not a step
}

TEST(LocatedSignals, OfTheMotionAreWithinTheToleranceInStepsThatEndAtASwitch) {
  // x'' + x = cos(2.2 t + p) with an impact each 2 π/2.2 s: closed form of its orbit (truth N07).
  constexpr double kOmega = 2.2, kPhase = 2.803786574972142, kSpeed = 1.8987487383113029;
  constexpr double kPeriod = 2.0 * 3.14159265358979323846 / kOmega, G = 1.0 / (1.0 - 2.2 * 2.2);
  const double c1 = -G * std::cos(kPhase), c2 = -0.8 * kSpeed + G * kOmega * std::sin(kPhase);
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    LocatedRun run(scenes::kImpactOscillator, tolerance, 10.0);
    const Table r = record(run, {"mass.x"}, 0.013);
    ASSERT_GT(r.t.size(), 700u);
    double worst = 0.0;
    for (std::size_t i = 0; i < r.t.size(); ++i) {
      const double t = std::fmod(r.t[i], kPeriod);
      const double x = c1 * std::cos(t) + c2 * std::sin(t) + G * std::cos(kOmega * r.t[i] + kPhase);
      worst = std::max(worst, std::abs(r.rows[i][0] - x));
    }
    // Within the promise of ten tolerances of 1 m, as at the end of the run.
    EXPECT_LE(worst, 10.0 * tolerance) << tolerance;
  }
}

TEST(LocatedSignals, PercussionsAreNoForces) {
  // 2 kg fall from 1.225 m, e = 0.5: m (1 + e) v with v = sqrt(2 g h), at sqrt(2 h/g) = 0.5 s.
  LocatedRun run(R"xml(<dynamy version="1">
    <systems><Coordinates name="ball" q="y" units="m" q0="1.225" u0="0" M="2" h="-19.6"/></systems>
    <elements><CoordinateContact name="floor" on="ball" gap="y"><Unilateral epsilonN="0.5"/>
      </CoordinateContact></elements>
    <simulation until="1" step="1"/></dynamy>)xml",
                 1e-8, 0.9);
  const Table r = record(run, {"floor.Lambda_N", "floor.lambda_N"}, 0.09);
  double largest = 0.0;
  for (std::size_t i = 0; i < r.t.size(); ++i) {
    EXPECT_EQ(r.rows[i][1], 0.0) << r.t[i];  // closed for an instant
    if (r.t[i] > 0.5 + 1e-8) {
      EXPECT_EQ(r.rows[i][0], 0.0) << r.t[i];  // rows of one step share its percussion
    }
    largest = std::max(largest, r.rows[i][0]);
  }
  EXPECT_NEAR(largest, 2.0 * 1.5 * 4.9, 1e-7);
}

TEST(LocatedSignals, OfPartsWithAStatusOfTheirOwnStandInTheirRows) {
  // A ball of 0.2 kg rolls against its resistance: λ_N = m g, a torque of λ_N times 2 mm, and
  // friction that slows it by (5/7) g arm/r.
  LocatedRun run(R"xml(<dynamy version="1"><systems>
    <RigidBody name="ball" position="0 0 0.05" velocity="0.5 0 0" angularVelocity="0 10 0">
      <Sphere radius="0.05" mass="0.2" material="ivory"/></RigidBody>
    <Ground name="table"><HalfSpace material="felt"/></Ground></systems>
    <forces><Gravity acceleration="0 0 -9.81"/></forces>
    <elements><Contact between="ivory felt"><UnilateralRolling mu="0.3" rolling="2mm"/></Contact>
    </elements><simulation until="1" step="1"/></dynamy>)xml",
                 1e-8, 0.5);
  const std::string contact = "ball-table.lambda_";
  const Table r = record(
      run, {contact + "N", contact + "T1", contact + "T2", contact + "roll1", contact + "roll2"},
      0.11);
  ASSERT_GT(r.rows.size(), 4u);
  for (std::size_t i = 1; i < r.rows.size(); ++i) {
    EXPECT_NEAR(r.rows[i][0], 0.2 * 9.81, 1e-12);  // rounding
    EXPECT_NEAR(std::hypot(r.rows[i][1], r.rows[i][2]), 0.2 * 5.0 / 7.0 * 9.81 * 0.04, 1e-12);
    EXPECT_NEAR(std::hypot(r.rows[i][3], r.rows[i][4]), 0.2 * 9.81 * 2e-3, 1e-14);
  }
}

TEST(LocatedSignals, CapstansForcesAtTheEndAreThoseOfItsFormula) {
  // models/capstan.xml says where the numbers come from; its own tolerance is that of steps of 1
  // ms.
  LocatedRun run("capstan", 1e-9, 2.6);
  const Table r = record(run, {"rope.forceA", "rope.forceB"}, 0.1);
  EXPECT_NEAR(r.rows.back()[0], 720.5888187993172, 1e-9);
  EXPECT_NEAR(r.rows.back()[1], 109.41118120068282, 1e-9);
}

TEST(LocatedSignals, ALatchIsRecordedAsSwitchedFromItsInstantOn) {
  // A mass in free fall; a brake engages at 20 m/s, after 20/9.81 s = 2.0387 s.
  BoundedRun fall(R"(<dynamy version="1"><systems>
<Coordinates name="m" q="z" units="m" q0="100" M="1" potential="9.81*z"/></systems><elements>
<CoordinateContact name="brake" on="m" slipVelocity="z_dot" engage="-z_dot - 20"><GivenFriction force="5"/></CoordinateContact>
</elements><simulation until="3" tolerance="1e-8"/><record signals="brake.engaged m.z_dot" every="10ms" frames="0"/></dynamy>)");
  fall.run();
  ASSERT_TRUE(fall.finished()) << fall.report().reason;
  constexpr double kInstant = 20.0 / 9.81;
  int wrong = 0;
  for (std::size_t i = 0; i < fall.times().size(); ++i)
    wrong += fall.value(i) != (fall.times()[i] < kInstant ? 0.0 : 1.0);
  EXPECT_EQ(wrong, 0) << "rows of " << fall.times().size();
}

TEST(LocatedSignals, AMaximumIsFoundBesideTheEndOfAStep) {
  // q'' = −q with q = sin(t + p): its maximum is 1, at another place of a step for every phase p.
  double worst = 0.0;
  for (int i = 0; i < 60; ++i) {
    const double p = -1.0 + i / 60.0;
    BoundedRun swing(
        R"(<dynamy version="1"><parameter name="p" value="0"/><systems>
<Coordinates name="m" q="x" units="m" q0="{sin(p)}" u0="{cos(p)}" M="1" potential="0.5*x^2"/></systems>
<simulation until="4" tolerance="1e-10"/><record signals="m.x" frames="0"/>
<check signal="m.x" measure="max" value="1" tolerance="1e-9"/></dynamy>)",
        {.set = {{"p", numberText(p)}}});
    swing.run();
    ASSERT_TRUE(swing.finished()) << swing.report().reason;
    const double got = swing.simulation().checks().at(0).got;
    if (std::abs(got - 1.0) > std::abs(worst)) worst = got - 1.0;
  }
  // Ten tolerances of a motion of some steps (theory 50.6).
  EXPECT_NEAR(worst, 0.0, 1e-9);
}

}  // namespace
}  // namespace dynamy::reference
