#include <gtest/gtest.h>

#include <dynamy/law/rolling_friction.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/testing/check_element.hpp>

namespace dynamy {
namespace {

TEST(UnilateralRolling, FulfilsTheDefinitionsOfALaw) {
  for (const auto& [law, dim] : {std::pair{RollingCoefficients{0.6, 0.05, 0.0, 0.0}, 5},
                                 std::pair{RollingCoefficients{0.6, 0.05, 0.2, 0.0}, 6},
                                 std::pair{RollingCoefficients{0.6, 0.0, 0.2, 0.0}, 6},
                                 std::pair{RollingCoefficients{0.6, 0.05, 0.2, 0.3}, 8}}) {
    const Verdict result = checkLaw(UnilateralRolling(law), dim);
    EXPECT_TRUE(result) << dim << " rows: " << result.message();
  }
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

TEST(UnilateralRolling, IsCoulombFrictionInItsFirstRows) {
  const UnilateralRolling law(RollingCoefficients{0.4, 0.02, 0.01, 0.1});
  const UnilateralCoulomb coulomb(0.0, 0.0, 0.4);
  const double r[8] = {1.0, 2.0, 2.0, 1.0, 0.5, 0.5, 1.0, 1.0};
  const double xi[8] = {-1.0, 0.7, -0.9, 3.0, 1.0, 0.0, -0.2, 0.0};
  double all[8] = {}, three[3] = {};
  law.prox({.dim = 8}, r, xi, all);
  coulomb.prox({.dim = 3}, r, xi, three);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(all[i], three[i], 1e-15);
  EXPECT_NEAR(all[3], -0.01, 1e-15);  // every part at its own limit
  EXPECT_NEAR(all[4], -0.02, 1e-15);
  EXPECT_NEAR(all[6], 0.1, 1e-15);
}

}  // namespace
}  // namespace dynamy
