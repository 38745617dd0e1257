// Runs to a tolerance with laws whose set becomes another one at some γ^A.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <reference/located/located_run.hpp>

namespace dynamy::reference {
namespace {

/// Two rotors on one axis, J = 1 and 2 kg m²; the first turns with 10 rad/s at the start.
class Rotors final : public PartialMechanicalSystem {
 public:
  static void declare(Attributes&) {}
  explicit Rotors(const Parameters& x) : PartialMechanicalSystem(x) {}
  Blocks blocks() const override { return {2, 2, 1, true}; }
  void initialState(Vec q, Vec u) const override { q.setZero(), u[0] = 10.0, u[1] = 0.0; }
  void M(double, ConstVec, MassBlocks M) const override { M[0].diagonal() << 1.0, 2.0; }
  void h(double, ConstVec, ConstVec, Vec h) const override { h.setZero(); }
  void describe(Description& d) const override {
    d.coordinate("phi1", Unit::angle, 0);
    d.coordinate("phi2", Unit::angle, 1);
    d.velocity("w1", Unit::angularVelocity, 0);
    d.velocity("w2", Unit::angularVelocity, 1);
  }
};

/// Slips with a given moment while |γ^A| > lockSpeed; below it dogs engage, C = ℝ.
class Synchro final : public SetValuedForceLaw {
 public:
  static void declare(Attributes& a) {
    a.required("moment", Unit::force, "friction while slipping").nonNegative();
    a.required("lockSpeed", Unit::velocity, "slip below which the dogs engage").positive();
  }
  explicit Synchro(const Parameters& x)
      : SetValuedForceLaw(x), moment_(x["moment"]), lockSpeed_(x["lockSpeed"]) {}
  int dim(int) const override { return 1; }
  bool unilateral() const override { return false; }
  RowKind rowKind(int) const override { return RowKind::friction; }
  void prox(const LawInput& in, const double* r, const double* xi, double* L) const override {
    const double z = L[0] - r[0] * xi[0], b = moment_ * in.dt;
    L[0] = locked(in) ? z : std::clamp(z, -b, b);
  }
  Status status(const LawInput& in, const double* z) const override {
    const double b = moment_ * in.dt;
    if (locked(in)) return Status::locked;
    return z[0] < -b ? Status::lower : z[0] > b ? Status::upper : Status::stick;
  }
  SimpleSet simpleSet(const LawInput& in) const override {
    if (locked(in)) return {SimpleSet::Shape::all};
    return {SimpleSet::Shape::interval, -moment_ * in.dt, moment_ * in.dt};
  }

 private:
  bool locked(const LawInput& in) const {
    return in.gammaA != nullptr && std::abs(in.gammaA[0]) <= lockSpeed_;
  }
  double moment_, lockSpeed_;
};

void synchroTypes(Registry& r) {
  r.add<Rotors>("Rotors");
  r.add<Synchro>("Synchro");
}

std::string synchro(const std::string& lockSpeed) {
  return R"(<dynamy version="1"><systems><Rotors name="rotors"/></systems><elements>
    <CoordinateContact name="clutch" on="rotors" slipVelocity="w1 - w2">
      <Synchro moment="2" lockSpeed=")" +
         lockSpeed +
         R"("/></CoordinateContact></elements><simulation until="1" step="1"/></dynamy>)";
}

// γ falls from 10 by 2 (1/1 + 1/2) = 3 rad/s², is 1 at 3 s, and the dogs engage at once; the
// angular momentum of 10 N m s turns both by 10/3 rad/s from then on:
//   φ₁(4) = 10·3 − ½·2·3² + 10/3
TEST(LocatedSetChanges, DogsThatEngageBelowASpeedLockBothRotors) {
  constexpr double kTolerance = 1e-4;
  LocatedRun run(synchro("1"), kTolerance, 4.0, {}, synchroTypes);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  // The instant of the switch is met to a step in time, whose error the tolerance bounds: Δt²·3/2
  // of angle 1. Velocities are exact: one percussion on two rotors.
  EXPECT_NEAR(run.state().u[0], 10.0 / 3.0, 1e-9);
  EXPECT_NEAR(run.state().u[1], 10.0 / 3.0, 1e-9);
  EXPECT_NEAR(run.state().q[0], 30.0 - 9.0 + 10.0 / 3.0, 10.0 * kTolerance * 24.0);
  // It is reported where: no tolerance is promised for a switch that was stepped over.
  const std::vector<Warning>& all = run.report().warnings;
  const auto told = std::find_if(all.begin(), all.end(), [](const Warning& w) {
    return w.kind == "time stepping" || w.kind == "stepped";
  });
  ASSERT_NE(told, all.end());
  EXPECT_EQ(told->place, "clutch");
  EXPECT_NEAR(told->t, 3.0, 1e-3);
}

TEST(LocatedSetChanges, DogsThatAreEngagedAtTheStartLockAtOnce) {
  LocatedRun run(synchro("20"), 1e-4, 1.0, {}, synchroTypes);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_NEAR(run.state().u[0], 10.0 / 3.0, 1e-9);
  EXPECT_NEAR(run.state().u[1], 10.0 / 3.0, 1e-9);
}

// Without the dogs the slip ends at 10/3 s, which is located: no steps in time.
TEST(LocatedSetChanges, WithoutDogsTheEndOfTheSlipIsLocated) {
  LocatedRun run(synchro("1e-12"), 1e-8, 4.0, {}, synchroTypes);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished) << run.report().reason;
  EXPECT_NEAR(run.state().u[0], 10.0 / 3.0, 1e-7);
  EXPECT_EQ(run.report().stepping.periods, 0);
}

}  // namespace
}  // namespace dynamy::reference
