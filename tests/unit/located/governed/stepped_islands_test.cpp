// Steps in time beside located ones, on a sledge of 1 kg with closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <dynamy/located/governed/stepped_islands.hpp>

#include "unit/located/sledge.hpp"

namespace dynamy {
namespace {

using fixture::SledgeScene;

/// T + V [J] at fractions of a step of 0.1 s, the second one of a sledge that starts at (0, z) with
/// velocity w upwards.
std::vector<double> energiesWithin(double z, double w, double epsilonN = 0.9,
                                   std::vector<double>* heights = nullptr) {
  constexpr double kStep = 0.1;
  SledgeScene scene({0, z}, {0, w}, SledgeScene::pull(0.0), 0.5, epsilonN);
  MechanicalSystem& s = *scene.system;
  s.evaluate(scene.x);
  ErrorNorm norm;
  const double time = 1.0;
  norm.resume(s, 1e-3, 1.0, time, {&time, 1});
  Islands islands;
  islands.start(s.parts());
  SteppedIslands steps;
  State from = scene.x, to;
  for (int k = 0; k < 2; ++k) {
    if (k > 0) from = to;
    steps.attempt(s, scene.solver, norm, islands, {1}, Effort::full, from, to, kStep);
    to.t = from.t + kStep;
    steps.take(s, from, to, kStep);
  }
  std::vector<double> out;
  State at;
  for (int k = 0; k <= 10; ++k) {
    steps.between(s, from, to, 0.1 * k, at);
    out.push_back(0.5 * at.u.squaredNorm() + SledgeScene::kG * at.q[1]);
  }
  for (int k = 0; k <= 100 && heights != nullptr; ++k) {
    steps.between(s, from, to, 0.01 * k, at);
    heights->push_back(at.q[1]);
  }
  return out;
}

TEST(SteppedIslands, RowsWithinAFreeFlightKeepTheEnergy) {
  // 1 m above the floor at 0.2 s: T + V = 10 J + 2 J.
  for (const double e : energiesWithin(1.0, 2.0)) EXPECT_NEAR(e, 12.0, 1e-12);
}

TEST(SteppedIslands, RowsWithinAnImpactLoseNoMoreThanItTakes) {
  // The second step begins with −3 m/s, 5 cm above the floor, and ends with 0.9 of that upwards:
  // half way between the two velocities there is no kinetic energy at all.
  const std::vector<double> energies = energiesWithin(0.3, -2.0);
  const auto [least, most] = std::minmax_element(energies.begin(), energies.end());
  const double start = energies.front(), end = energies.back();
  ASSERT_LT(end, 0.9 * start);
  // Positions go on with the velocity of the nearer end, through the floor for half a step: not more
  // than 3 m/s · 0.05 s away from a path above it, 1.5 J.
  EXPECT_GE(*least, end - 1.5);
  EXPECT_LE(*most, start + 1.5);
}

TEST(SteppedIslands, RowsWithinAnImpactDoNotJump) {
  // The second step begins with −3 m/s, a hundredth of the way of a step above the floor, where it
  // stops.
  std::vector<double> heights;
  energiesWithin(0.253, -2.0, 0.0, &heights);
  for (std::size_t k = 1; k < heights.size(); ++k)
    EXPECT_LE(std::abs(heights[k] - heights[k - 1]), 3.0 * 0.1 * 0.01 + 1e-12) << k;
}

}  // namespace
}  // namespace dynamy
