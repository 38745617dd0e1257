/// Disturbed stacks that land: every inclusion on the way is solved, and they stand afterwards.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <reference/schemes/landing.hpp>

namespace dynamy::reference {
namespace {

void print(const char* file, double k, double dt, unsigned seed, const Landing& l) {
  std::printf("| %s | %g | %g | %u | %ld, %.0e | %ld | %ld | %.1f | %.0f | %.0f |\n", file, k, dt,
              seed, l.unsolvedSteps, l.worst, l.newton[l.newton.size() / 2], l.newton.back(),
              l.cost[l.cost.size() / 2], l.cost[l.cost.size() * 99 / 100], l.cost.back());
}

/// Most Newton steps of a step: counts of this code, rounded up (theory 36.2), not laws of nature.
long mostNewton(double k, double dt) {
  if (k < 1e-7) return 15;
  if (k < 1e-4) return 100;
  return dt > 7e-3 ? 100 : (dt > 3e-3 ? 300 : 800);
}

/// Bodies stand when the one on top is at the height of the undisturbed stack.
void expectStands(const char* file, double height, double k, double dt, double until,
                  unsigned seed) {
  SCOPED_TRACE("k " + std::to_string(k) + ", step " + std::to_string(dt) + ", seed " +
               std::to_string(seed));
  const Landing l = land(file, k, dt, until, seed);
  print(file, k, dt, seed, l);
  EXPECT_EQ(l.unsolvedSteps, 0);
  EXPECT_EQ(l.silent, 0);
  EXPECT_LE(l.newton.back(), mostNewton(k, dt));
  // Midpoints do not overlap; an end between two of them lies lower by g Δt²/8 at most. An impact,
  // faster than 4 g Δt, may wait for a step (theory 34.1); the body on top falls by 10 · 4 k.
  const double fastest = std::sqrt(2.0 * 9.81 * 40.0 * k);
  const double waits = fastest > 4.0 * 9.81 * dt ? fastest * dt : 0.0;
  EXPECT_LT(l.overlap, 9.81 * dt * dt / 8.0 + waits);
  // All tilts are gone: what is left of them, 2 arcmin, would lower a corner by 1e-3 k.
  EXPECT_NEAR(l.lowest, height, 1e-3 * k + 1e-10);
}

void sweep(const std::vector<double>& steps, const std::vector<double>& sizes, double until,
           unsigned seeds) {
  std::printf(
      "| model | k | step | seed | unsolved, worst | Newton median | most | cost median | "
      "99 %% | most |\n");
  for (const double dt : steps)
    for (const double k : sizes)
      for (unsigned seed = 1; seed <= seeds; ++seed) {
        expectStands("tower", 9.5, k, dt, until, seed);
        expectStands("ratio_stack", 4.5, k, dt, until, seed);
      }
}

TEST(Landing, LeavesNoInclusionUnsolved) { sweep({1e-2}, {1e-8, 1e-5, 1e-3}, 1.0, 1); }
TEST(LongLanding, LeavesNoInclusionUnsolvedAtAnyStep) {
  sweep({1e-2, 5e-3, 1e-3}, {1e-8, 1e-5, 1e-3}, 5.0, 5);
}

}  // namespace
}  // namespace dynamy::reference
