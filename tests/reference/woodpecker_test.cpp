// The woodpecker toy against its limit cycle from an event-driven solution (Taylor series of order
// 40 between the events, impacts by enumeration).
#include <gtest/gtest.h>

#include <cmath>
#include <reference/woodpecker_cycle.hpp>
#include <support/load_model.hpp>

namespace dynamy {
namespace {

using reference::Cycle, reference::kPeriod;

constexpr double kFall = 0.0194453792847;  // per cycle [m]

/// Means over `cycles` cycles from beak impact to beak impact, after `transient` cycles. The cycle
/// attracts with the multiplier −0.84: 60 cycles leave 3e-5 of the start. Single cycles scatter, so
/// `cycles` is even and large; an impact is seen one step late at most, dt/cycles of the mean.
Cycle meanCycle(double dt, int cycles, int transient = 60) {
  LoadedModel toy("models/woodpecker_expressions.xml");
  HandStepper s(toy.model());
  constexpr int kBeak = 0;  // the first contact of the file
  int count = 0;
  double last = 0.0, t0 = 0.0, y0 = 0.0;
  while (s.x.t < 0.2 * (cycles + transient)) {
    s.step(dt);
    const ContactSet& contacts = s.system().slot(0).contacts;
    const bool impact = contacts.find(kBeak, 0) >= 0 && s.x.t - last > 0.5 * kPeriod;
    if (!impact) continue;
    last = s.x.t;
    if (count == transient) t0 = s.x.t, y0 = s.x.q[0];
    if (count == transient + cycles) return {(s.x.t - t0) / cycles, (y0 - s.x.q[0]) / cycles};
    ++count;
  }
  ADD_FAILURE() << "only " << count << " beak impacts";
  return {};
}

TEST(Woodpecker, StickTurningPointsComeAtTheirTimes) {
  // From the published start; order 1: 1e-5 s steps, impacts a step late at 17 rad/s move the next
  // turning point by some 1e-4 rad and 1e-4 s.
  const double time[] = {0.032805571232, 0.178588177089, 0.324727480140};
  const double phiS[] = {-0.53006127852090, -0.52897921513051, -0.52988676621187};
  LoadedModel toy("models/woodpecker_expressions.xml");
  HandStepper s(toy.model());
  int found = 0;
  double before = s.x.u[2];
  while (found < 3 && s.x.t < 0.4) {
    s.step(1e-5);
    const bool turns = before < 0.0 && s.x.u[2] >= 0.0 && s.x.q[2] < -0.4;
    before = s.x.u[2];
    if (!turns) continue;
    EXPECT_NEAR(s.x.t, time[found], 3e-4) << found;
    EXPECT_NEAR(s.x.q[2], phiS[found], 3e-4) << found;
    ++found;
  }
  EXPECT_EQ(found, 3);
}

TEST(Woodpecker, SleeveSticksWhereTheSmoothSlidingEnds) {
  // Until it sticks the sleeve slides on one edge: a linear equation of two coordinates, solved
  // apart to 1e-12. Explicit Euler in the force: 1e-5 s of 0.34 m/s.
  LoadedModel toy("models/woodpecker_expressions.xml");
  HandStepper s(toy.model());
  while (s.x.t < 0.03) s.step(1e-5);
  EXPECT_NEAR(s.x.q[0], -0.004403947088, 5e-6);
  EXPECT_NEAR(s.x.u[0], 0.0, 1e-9);
}

TEST(Woodpecker, MeanCycleIsThatOfMoreausRule) {
  // A second program (plain Moreau, prox SOR) falls 19.465 mm with 1e-5 s; 5 µm hold its scatter.
  const Cycle c = meanCycle(1e-5, 200);
  EXPECT_NEAR(c.fall, 19.465e-3, 5e-6);
  EXPECT_NEAR(c.period, 0.1460097, 2e-5);
}

TEST(LongWoodpecker, MeanCycleConvergesToTheEventDrivenOneWithOrderOne) {
  const double dt[] = {1e-4, 1e-5, 1e-6};
  double sumX = 0, sumY = 0, sumXX = 0, sumXY = 0;
  Cycle finest;
  for (const double h : dt) {
    finest = meanCycle(h, 200);
    const double x = std::log(h), y = std::log(std::abs(finest.fall - kFall));
    sumX += x, sumY += y, sumXX += x * x, sumXY += x * y;
    RecordProperty("fall_at_" + std::to_string(h), std::to_string(finest.fall));
  }
  const double order = (3 * sumXY - sumX * sumY) / (3 * sumXX - sumX * sumX);
  EXPECT_GE(order, 0.85);
  EXPECT_LE(order, 1.15);
  // Ten times nearer than with 1e-5 s.
  EXPECT_NEAR(finest.fall, kFall, 4e-6);
  EXPECT_NEAR(finest.period, kPeriod, 8e-6);
}

}  // namespace
}  // namespace dynamy
