// Laws of users that read what LawInput holds, in a run to a tolerance: against a closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <dynamy/located/located_dormand_prince.hpp>

#include "unit/simulation/scenes.hpp"

namespace dynamy {
namespace {

using namespace scenes;

/// Friction of F/(1 + |γ^A|/(1 m/s)), F = 2 N. It reads γ^A and position wherever it is asked.
class FadingFriction final : public SetValuedForceLaw {
 public:
  int dim(int) const override { return 1; }
  bool unilateral() const override { return false; }
  RowKind rowKind(int) const override { return RowKind::friction; }
  void prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const override {
    Lambda[0] = std::clamp(Lambda[0] - r[0] * xi[0], -most(in), most(in));
  }
  SimpleSet simpleSet(const LawInput& in) const override {
    return {SimpleSet::Shape::interval, -most(in), most(in)};
  }
  Status status(const LawInput& in, const double* z) const override {
    return std::abs(z[0]) > most(in) ? Status::slip : Status::stick;
  }

 private:
  static double most(const LawInput& in) {
    return in.dt * 2.0 / (1.0 + std::abs(in.gammaA[0]) + 0.0 * in.position[0]);
  }
};

/// A brake on vx of a ball.
class Brake final : public SimpleContact {
 public:
  static void declare(Attributes&) {}
  explicit Brake(const Parameters& x) : SimpleContact(x) {}
  double g(double, ConstVec) const override { return 0.0; }
  int rows() const override { return 1; }
  void gamma(double, ConstVec, ConstVec u, Vec gamma) const override { gamma[0] = u[0]; }
};

TEST(LawsOfSlip, MayReadVelocitiesInRunsToATolerance) {
  // m v̇ = −F/(1 + v):  (1 + v)² = (1 + v0)² − 2 F t/m, at rest after ((1 + v0)² − 1) m/2F = 2 s.
  Model m;
  addBall(m, "ball", 1.0, 2.0);
  Parameters p = Parameters::of<Brake>({}, "brake", {{"on", "ball"}});
  p.children.push_back({Kind::law, std::make_unique<FadingFriction>()});
  m.add(std::make_unique<Brake>(p));
  m.simulation.until = 3.0, m.askTolerance(1e-9);
  m.scheme(
      std::make_unique<LocatedDormandPrince>(Parameters::of<LocatedDormandPrince>("", "", {})));
  CheckSettings slipping, atRest;
  slipping.signal = atRest.signal = "ball.vx";
  slipping.at = 1.0, slipping.low = std::sqrt(5.0) - 1.0 - 1e-8;  // ten tolerances
  slipping.high = slipping.low + 2e-8;
  atRest.at = 2.5, atRest.low = -1e-12, atRest.high = 1e-12;
  m.checks = {slipping, atRest};
  m.build();
  Simulation s(m);
  ASSERT_EQ(s.run().ended, RunReport::Ended::finished) << s.report().reason;
  for (const CheckResult& r : s.checks()) EXPECT_TRUE(r.pass) << r.over << ": " << r.got;
}

}  // namespace
}  // namespace dynamy
