// Moreau's midpoint rule: what it does exactly, and its order.
#include <gtest/gtest.h>

#include <dynamy/schemes/half_explicit_euler.hpp>

#include "unit/stages/stage_fixture.hpp"

namespace dynamy {
namespace {

using Eigen::VectorXd;
using fixture::Scene;

VectorXd one(double x) { return VectorXd::Constant(1, x); }

/// Error of q at t = 1 of m q̈ = force from q = 1, u = 0 with n steps.
template <class Scheme>
double error(const fixture::Masses::Force& force, double exact, int n) {
  Scene s(one(1.0), one(1.0), one(0.0), {}, 0.0, force);
  Scheme scheme;
  for (int k = 0; k < n; ++k) scheme.step(*s.system, s.solver, s.x, 1.0 / n);
  return std::abs(s.x.q[0] - exact);
}
template <class Scheme>
double order(const fixture::Masses::Force& force, double exact) {
  return std::log2(error<Scheme>(force, exact, 200) / error<Scheme>(force, exact, 400));
}

// The next term of the error changes the measured order by O(1/200).
constexpr double kOrder = 0.02;

TEST(MoreauMidpoint, IsExactInFreeFlight) {
  Scene s(one(2.0), one(5.0), one(3.0));
  for (int k = 0; k < 10; ++k) s.step(0.1);
  EXPECT_NEAR(s.x.t, 1.0, 1e-15);
  EXPECT_NEAR(s.x.u[0], 3.0 - 9.81, 1e-14);              // ten additions
  EXPECT_NEAR(s.x.q[0], 5.0 + 3.0 - 0.5 * 9.81, 1e-14);  // twenty additions of numbers of size 5
}

TEST(MoreauMidpoint, HasOrderTwoForForcesOfPositionAndTime) {
  // q̈ = −4q + 3cos t from q = 1, u = 0: q = cos t.
  const auto force = [](double t, ConstVec q, ConstVec, Vec h) {
    h[0] = -4.0 * q[0] + 3.0 * std::cos(t);
  };
  EXPECT_NEAR(order<MoreauMidpoint>(force, std::cos(1.0)), 2.0, kOrder);
}

TEST(MoreauMidpoint, HasOrderOneForForcesOfVelocity) {
  // q̈ = −u − 1: u = e^{−t} − 1, q = 2 − t − e^{−t}... from q = 1: q = 1 + 1 − e^{−t} − t.
  const auto force = [](double, ConstVec, ConstVec u, Vec h) { h[0] = -u[0] - 1.0; };
  EXPECT_NEAR(order<MoreauMidpoint>(force, 2.0 - std::exp(-1.0) - 1.0), 1.0, kOrder);
}

TEST(HalfExplicitEuler, HasOrderOne) {
  const auto force = [](double t, ConstVec q, ConstVec, Vec h) {
    h[0] = -4.0 * q[0] + 3.0 * std::cos(t);
  };
  EXPECT_NEAR(order<HalfExplicitEuler>(force, std::cos(1.0)), 1.0, kOrder);
}

TEST(MoreauMidpoint, StopsABallAtTheFloorAndKeepsItThere) {
  Scene s(one(1.0), one(0.0), one(-1.0), {{0, 0, -1}});
  for (int k = 0; k < 100; ++k) {
    const StepReport report = s.step(0.01);
    EXPECT_TRUE(report.solved.ok());
    // ξ = 0 to 1e-10 of u_ref ≤ 1.1 m/s, later of g Δt.
    EXPECT_NEAR(s.x.u[0], 0.0, k == 0 ? 2e-10 : 1e-11);
  }
  // One half step at −1 m/s into the floor, no more.
  EXPECT_NEAR(s.x.q[0], -0.005, 1e-10);
}

TEST(MoreauMidpoint, ReturnsABallWithTheRestitution) {
  Scene s(one(1.0), one(0.0), one(-2.0), {{0, 0, -1}}, 0.5);
  s.step(1e-3);
  EXPECT_NEAR(s.x.u[0], 1.0, 1e-9);  // ξ = u⁺ + ε u⁻ = 0 to 1e-10 of 2 m/s
}

TEST(MoreauMidpoint, InterpolatesItsOwnTwoStraightPieces) {
  Scene s(one(1.0), one(0.0), one(-2.0), {{0, 0, -1}}, 0.5);
  const State a = s.x;
  s.step(0.1);
  State out = a;
  s.scheme.interpolate(*s.system, a, s.x, 0.5, out);
  EXPECT_NEAR(out.q[0], -0.1, 1e-15);
  s.scheme.interpolate(*s.system, a, s.x, 0.75, out);
  EXPECT_NEAR(out.q[0], -0.1 + 0.025 * s.x.u[0], 1e-15);
  s.scheme.interpolate(*s.system, a, s.x, 1.0, out);
  EXPECT_NEAR(out.q[0], s.x.q[0], 1e-15);
}

}  // namespace
}  // namespace dynamy
