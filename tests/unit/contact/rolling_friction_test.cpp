#include <gtest/gtest.h>

#include <dynamy/contact/rolling_friction.hpp>
#include <dynamy/testing/check_element.hpp>

namespace dynamy {
namespace {

TEST(UnilateralRolling, FulfilsTheDefinitionsOfALaw) {
  const Verdict result = checkLaw(UnilateralRolling(0.6, 0.05), 5);
  EXPECT_TRUE(result) << result.message();
}

TEST(UnilateralRolling, RollsWhenTheMomentIsAtItsLimit) {
  // G = I, c = (−1, 0, 0, 2, 0), μ_r = 0.1: Λ_N = 1, Λ_M = −0.1, ξ_M = 1.9, in closed form.
  const UnilateralRolling law(0.5, 0.1);
  const double Lambda[5] = {1.0, 0.0, 0.0, -0.1, 0.0}, xi[5] = {0.0, 0.0, 0.0, 1.9, 0.0};
  double e[5];
  for (const double rho : {0.1, 1.0, 10.0}) {
    law.naturalMap({.dim = 5}, rho, xi, Lambda, e);
    // One projection: a few roundings of numbers of order ten.
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(e[i], 0.0, 1e-14) << "row " << i << ", rho " << rho;
  }
}

}  // namespace
}  // namespace dynamy
