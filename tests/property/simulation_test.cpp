/// Properties of whole runs: resumed ≡ straight, order of elements, the order of the energy's
/// discretisation entry, no allocation in a step.
#include <gtest/gtest.h>

#include <dynamy/testing/counting_allocation.hpp>

#include "unit/simulation/scenes.hpp"

namespace dynamy {
namespace {

using namespace scenes;

Model bouncing(double until) {
  Model m = ballOnFloor(1.0, 2.0, 0.7, 0.2, until, 1e-3);
  m.record.signals = {"*"};
  m.record.every = 0.0137;
  CheckSettings c;
  c.signal = "ball.z", c.measure = CheckSettings::Measure::mean;
  m.checks = {c};
  m.build();
  return m;
}

struct RunOf {
  Table table;
  State end;
  double mean = 0.0;
  RunReport report;
  std::string checkpoint;
};

RunOf run(Model m, const std::string& from = {}) {
  RunOf out;
  Simulation s(m);
  s.record(out.table);
  if (!from.empty()) s.resume(from);
  s.run();
  out.end = s.state(), out.mean = s.checks()[0].got;
  out.report = s.report(), out.checkpoint = s.checkpoint();
  return out;
}

void expectSame(const RunOf& a, const RunOf& b) {
  EXPECT_EQ(a.table.t, b.table.t);
  EXPECT_EQ(a.table.rows, b.table.rows);
  EXPECT_EQ(a.end.q, b.end.q);
  EXPECT_EQ(a.end.u, b.end.u);
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_EQ(a.report.hash, b.report.hash);
  EXPECT_EQ(a.report.contacts.impacts, b.report.contacts.impacts);
  EXPECT_EQ(a.report.contacts.switches, b.report.contacts.switches);
  EXPECT_EQ(a.report.energy.normal, b.report.energy.normal);
  EXPECT_EQ(a.report.energy.discretisation, b.report.energy.discretisation);
}

TEST(Resume, GivesTheBitsOfTheStraightRun) {
  // The first ends between two steps and at one, in free flight and on the floor.
  const RunOf straight = run(bouncing(5.0));
  for (const double until : {0.0005, 0.25, 0.4473, 2.71828, 4.9999}) {
    const RunOf first = run(bouncing(until));
    expectSame(run(bouncing(5.0), first.checkpoint), straight);
  }
}

TEST(Resume, OfAResumedRunGivesTheSameBitsToo) {
  std::string checkpoint;
  for (const double until : {0.3, 1.00037, 3.3})
    checkpoint = run(bouncing(until), checkpoint).checkpoint;
  expectSame(run(bouncing(5.0), checkpoint), run(bouncing(5.0)));
}

TEST(ElementOrder, DoesNotChangeTheMotion) {
  const auto zs = [](bool swapped) {
    Model m;
    const std::vector<std::string> names =
        swapped ? std::vector<std::string>{"b", "a"} : std::vector<std::string>{"a", "b"};
    for (const std::string& n : names) addBall(m, n, n == "a" ? 1.0 : 0.5, n == "a" ? 1.0 : 3.0);
    for (const std::string& n : names) addFloor(m, "floor_" + n, n, 0.6, 0.3);
    m.record.signals = {"a.x", "a.z", "b.x", "b.z"};
    m.simulation.until = 2.0, m.simulation.step = 1e-3;
    m.build();
    Table table;
    Simulation s(m);
    s.record(table);
    s.run();
    return table.rows;
  };
  // The two balls do not touch; their blocks are solved to 1e-10 together, so that the number of
  // sweeps of one may depend on the other only.
  const auto straight = zs(false), swapped = zs(true);
  ASSERT_EQ(straight.size(), swapped.size());
  for (std::size_t i = 0; i < straight.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(straight[i][k], swapped[i][k], 1e-9);
}

template <class Scheme>
double orderOfDiscretisation() {
  // Slope of log|entry| over log Δt by least squares over four halvings.
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  int n = 0;
  for (double dt = 0.02; dt > 0.001; dt /= 2, ++n) {
    Model m;
    m.add<Pendulum>("p", {});
    m.scheme(std::make_unique<Scheme>());
    m.simulation.until = 2.5, m.simulation.step = dt;
    m.build();
    Simulation s(m);
    const double x = std::log(dt), y = std::log(std::abs(s.run().energy.discretisation));
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

TEST(EnergyLedger, DiscretisationFallsWithTheOrderOfTheScheme) {
  // Without contact Moreau's rule is drift–kick–drift, of order 2; half-explicit Euler has order 1.
  // The fit's bias is the next term of the expansion: about Δt of the coarsest run.
  EXPECT_NEAR(orderOfDiscretisation<MoreauMidpoint>(), 2.0, 0.1);
  EXPECT_NEAR(orderOfDiscretisation<HalfExplicitEuler>(), 1.0, 0.1);
}

/// Counts allocations from step 100 to step 1100.
class CountSteps final : public Observer {
 public:
  void step(const StepView& v) override {
    if (v.index == 100) counter_ = std::make_unique<AllocationCounter>();
    if (v.index == 1100) allocations = counter_->count();
  }
  long allocations = -1;

 private:
  std::unique_ptr<AllocationCounter> counter_;
};

class Nowhere final : public RecordSink {
 public:
  void row(double, std::span<const double>) override {}
  void frame(FilmInstant, std::span<const FramePose>, std::span<const ContactRecord>) override {}
};

TEST(Allocation, AThousandStepsAfterTheWarmUpTakeNoMemory) {
  ASSERT_TRUE(AllocationCounter::active());
  Model m = ballOnFloor(0.0, 2.0, 0.0, 0.3, 2.0, 1e-3);
  addBall(m, "other", 0.01, 0.0);  // bounces: contacts come and go
  addFloor(m, "under", "other", 0.9, 0.3);
  m.record.signals = {"*"};
  m.record.every = 2e-3;
  CheckSettings c;
  c.signal = "ball.x", c.measure = CheckSettings::Measure::period;
  m.checks = {c};
  m.build();
  Nowhere sink;
  CountSteps count;
  Simulation s(m);
  s.record(sink);
  s.observe(count);
  s.run();
  EXPECT_EQ(count.allocations, 0);
}

}  // namespace
}  // namespace dynamy
