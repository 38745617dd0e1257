// The loop of schemes that choose their steps, with a scheme whose steps are not even.
#include <gtest/gtest.h>

#include <algorithm>
#include <dynamy/schemes/moreau_midpoint.hpp>

#include "unit/simulation/scenes.hpp"

namespace dynamy {
namespace {

using namespace scenes;

/// Moreau's rule with steps that grow by a tenth from 1 ms to 10 ms and begin anew.
class Growing final : public OneStep {
 public:
  int order() const override { return 2; }
  bool choosesSteps() const override { return true; }
  void aim(const Accuracy& a) override { accuracy = a; }
  double nextStep(const State& x) const override { return x.scheme.size() ? x.scheme[0] : 1e-3; }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override {
    const double h = std::min(nextStep(x), dt), t = x.t;
    StepReport r = inner_.step(s, solver, x, h);
    x.t = h == dt ? t + dt : t + h;
    x.scheme.resize(1);
    x.scheme[0] = h >= 1e-2 ? 1e-3 : 1.1 * h;
    r.counts.rejected = 2;
    return r;
  }
  Accuracy accuracy;

 private:
  MoreauMidpoint inner_;
};

Model model(double until) {
  Model m = ballOnFloor(1.0, 0.0, 0.5, 0.0, until, 0.0);
  m.simulation.tolerance = 1e-4;
  m.scheme(std::make_unique<Growing>());
  m.build();
  return m;
}

TEST(OwnSteps, EndExactlyAtTheEndAndCountWhatTheSchemeDid) {
  Model m = model(1.0);
  Simulation s(m);
  const RunReport& r = s.run();
  EXPECT_EQ(r.ended, RunReport::Ended::finished);
  EXPECT_EQ(s.state().t, 1.0);
  EXPECT_EQ(r.rejected, 2 * r.steps);
  EXPECT_GT(r.steps, 100);  // the largest step is 10 ms
  EXPECT_EQ(static_cast<Growing&>(m.scheme()).accuracy.tolerance, 1e-4);
  EXPECT_EQ(static_cast<Growing&>(m.scheme()).accuracy.length, m.length());
}

TEST(OwnSteps, AreNoLongerThanTheModelAllows) {
  Model m = model(1.0);
  m.simulation.step = 1e-3;
  Simulation s(m);
  EXPECT_EQ(s.run().steps, 1000);
}

TEST(OwnSteps, GoOnFromACheckpointAsInALongerRun) {
  Model shortRun = model(0.6), longRun = model(1.0), resumed = model(1.0);
  Simulation a(shortRun), b(longRun), c(resumed);
  a.run(), b.run();
  c.resume(a.checkpoint());
  c.run();
  EXPECT_EQ(c.state().q, b.state().q);
  EXPECT_EQ(c.state().u, b.state().u);
  EXPECT_EQ(c.report().steps, b.report().steps);
}

TEST(OwnSteps, AToleranceForASchemeOfGivenStepsIsAModelError) {
  Model m = ballOnFloor(1.0, 0.0, 0.5, 0.0, 1.0, 0.0);
  m.simulation.tolerance = 1e-4;
  m.scheme(std::make_unique<MoreauMidpoint>());
  m.build();
  EXPECT_THROW(Simulation{m}, ModelError);
}

}  // namespace
}  // namespace dynamy
