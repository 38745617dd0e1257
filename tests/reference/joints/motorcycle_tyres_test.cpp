// The motorcycle of bodies and tyres against the linear equations that Sharp has published.
#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <dynamy/simulation/linear/linearisation.hpp>
#include <support/load_model.hpp>
#include <vector>

namespace dynamy {
namespace {

/// The eigenvalue of the motorcycle at 30 m/s that is nearest to `z`, for a carcass of stiffness Cz
/// [N/m].
std::complex<double> nearest(const std::vector<std::complex<double>>& all, std::complex<double> z) {
  return *std::min_element(all.begin(), all.end(), [&](const auto& a, const auto& b) {
    return std::abs(a - z) < std::abs(b - z);
  });
}

std::vector<std::complex<double>> eigenvalues(const char* Cz) {
  LoadedModel m("models/motorbike_tyres.xml", {{"disturbance", "0"}, {"Cz", Cz}});
  const Linearisation l = linearise(m.model(), m.model().initialState());
  return {l.eigenvalues.begin(), l.eigenvalues.end()};
}

TEST(MotorcycleOnTyres, HasTheEigenvaluesOfSharpsEquations) {
  // Sharp 1971, with the data of the paper and the front load that follows from them, 1012.53 N; the
  // eigenvalues of these 8 × 8 equations by LAPACK. They know no carcass: what is off by 1/Cz is
  // extrapolated from two stiffnesses, and 1/Cz² is left: 5e-6 of capsize, the largest.
  // A wheel of the second pair leaves the road 0.01 mm higher.
  for (const auto& [one, other] : {std::pair{"2.5e5", "1e6"}, {"2.5e7", "1e8"}}) {
    const auto soft = eigenvalues(one), stiff = eigenvalues(other);
    for (const std::complex<double> z : {std::complex<double>(-4.05582639, 54.20488995),  // wobble
                                         {-1.96542967, 19.10057338},                      // weave
                                         {0.06137729, 0.0},                               // capsize
                                         {-18.8500197, 0.0},
                                         {-109.73880336, 0.0},
                                         {-121.12345281, 0.0}}) {
      const std::complex<double> found = (4.0 * nearest(stiff, z) - nearest(soft, z)) / 3.0;
      EXPECT_NEAR(found.real(), z.real(), 1e-5) << z;
      EXPECT_NEAR(found.imag(), z.imag(), 1e-5) << z;
    }
  }
}

}  // namespace
}  // namespace dynamy
