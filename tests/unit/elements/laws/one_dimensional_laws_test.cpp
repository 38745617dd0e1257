// One-way clutch, preloaded spring, Stribeck friction, adhesion, belt friction: the definitions of
// a law by checkLaw, and numbers from closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/testing/check_element.hpp>
#include <dynamy_elements/laws/adhesion.hpp>
#include <dynamy_elements/laws/belt_friction.hpp>
#include <dynamy_elements/laws/force_limit.hpp>
#include <dynamy_elements/laws/preloaded_spring.hpp>
#include <dynamy_elements/laws/stribeck_friction.hpp>
#include <numbers>

namespace dynamy {
namespace {

OneWayClutch clutch(const char* free, double limit = 0.0) {
  if (limit > 0.0)
    return OneWayClutch(
        Parameters::of<OneWayClutch>("OneWayClutch", "", {{"free", free}, {"limit", limit}}));
  return OneWayClutch(Parameters::of<OneWayClutch>("OneWayClutch", "", {{"free", free}}));
}

void expectLaw(const SetValuedForceLaw& law, int dim) {
  const Verdict result = checkLaw(law, dim);
  EXPECT_TRUE(result) << "dim " << dim << ": " << result.message();
}

double prox(const SetValuedForceLaw& law, const LawInput& in, double argument) {
  const double r = 1.0, zero = 0.0;
  law.prox(in, &r, &zero, &argument);
  return argument;
}

TEST(OneDimensionalLaws, FulfilTheDefinitionsOfALaw) {
  expectLaw(clutch("positive"), 1);
  expectLaw(clutch("negative", 0.4), 1);
  expectLaw(PreloadedSpring(50.0, 0.5, false), 1);
  expectLaw(PreloadedSpring(50.0, 0.5, true), 1);
  const StribeckCurve falling{.atRest = 0.8, .far = 0.2, .speed = 0.3, .exponent = 2.0};
  for (const int dim : {1, 2, 3}) {
    expectLaw(StribeckFriction(falling), dim);
    expectLaw(UnilateralStribeck(0.0, falling), dim);
    expectLaw(UnilateralAdhesion(0.7, 0.3, 0.0), dim);
  }
  expectLaw(
      BeltFriction(Parameters::of<BeltFriction>("BeltFriction", "", {{"mu", 0.2}, {"wrap", 3.0}})),
      2);
}

TEST(OneWayClutch, HoldsOneWayAndLetsTheOtherRun) {
  const LawInput in{.dim = 1, .dt = 0.1}, impact{.dim = 1, .dt = 0.0};
  EXPECT_EQ(prox(clutch("positive"), in, -3.0), 0.0);
  EXPECT_EQ(prox(clutch("positive"), in, 3.0), 3.0);
  EXPECT_EQ(prox(clutch("negative"), in, -3.0), -3.0);
  EXPECT_EQ(prox(clutch("negative"), in, 3.0), 0.0);
  EXPECT_EQ(prox(clutch("positive"), impact, 3.0), 3.0);  // a cone holds in an impact too
  EXPECT_DOUBLE_EQ(prox(clutch("positive", 5.0), in, 3.0), 0.5);
}

TEST(OneWayClutch, MakesCoulombFrictionOfTwo) {
  // λ_R = a + λ ≥ 0 and λ_L = a − λ ≥ 0: what two opposed clutches transmit beyond a preload is
  // friction of size a.
  const GivenFriction friction(2.0, 2.0);
  const LawInput in{.dim = 1, .dt = 0.1};
  const double a = 0.2;  // 2 N · 0.1 s
  for (const double z : {-1.0, -0.2, -0.1, 0.0, 0.15, 0.7}) {
    const double right = prox(clutch("positive"), in, z + a) - a;
    const double both = a - prox(clutch("positive"), in, a - right);
    EXPECT_NEAR(both, prox(friction, in, z), 1e-16);
  }
}

// Arguments of ±9 N s stand for motions that go through the notch in one step.
TEST(PreloadedSpring, HoldsUpToItsPreloadAndYieldsBeyond) {
  const PreloadedSpring law(100.0, 2.0, false);
  double at = 0.0;
  const LawInput in{.dim = 1, .dt = 0.1, .position = &at};
  EXPECT_DOUBLE_EQ(prox(law, in, 0.15), 0.15);
  EXPECT_DOUBLE_EQ(prox(law, in, 0.3), 0.2);
  at = 0.05;  // −c x − a
  EXPECT_DOUBLE_EQ(prox(law, in, -9.0), 0.1 * (-5.0 - 2.0));
  EXPECT_EQ(law.status(in, &at), Status::lower);
  at = -0.05;
  EXPECT_DOUBLE_EQ(prox(law, in, 9.0), 0.1 * (5.0 + 2.0));
}

TEST(PreloadedSpring, OfOneSideNeverPulls) {
  const PreloadedSpring law(100.0, 2.0, true);
  double at = 0.05;
  const LawInput in{.dim = 1, .dt = 0.1, .position = &at};
  EXPECT_EQ(prox(law, in, 0.0), 0.0);
  at = -0.05;
  EXPECT_DOUBLE_EQ(prox(law, in, 9.0), 0.1 * (5.0 + 2.0));
}

TEST(StribeckFriction, HasTheSizeOfTheSpeedAtTheBegin) {
  // The belt oscillator of Leine et al. 1998: F = 1/(1 + 3 v).
  const StribeckFriction law(
      StribeckCurve{.atRest = 1.0, .far = 0.0, .speed = 1.0 / 3.0, .rational = true});
  for (const double v : {0.0, 0.2, -1.5}) {
    const LawInput in{.dim = 1, .dt = 0.1, .gammaA = &v};
    EXPECT_NEAR(prox(law, in, 9.0), 0.1 / (1.0 + 3.0 * std::abs(v)), 1e-16);
  }
  const StribeckCurve both{
      .atRest = 2.0, .far = 1.0, .speed = 0.1, .exponent = 2.0, .viscous = 3.0};
  EXPECT_DOUBLE_EQ(both(0.1), 1.0 + std::exp(-1.0) + 0.3);
}

TEST(UnilateralAdhesion, PullsUpToItsForceAndHoldsSideways) {
  const UnilateralAdhesion law(20.0, 0.5, 0.0);
  const LawInput in{.dim = 2, .dt = 0.1};
  const double r[2] = {1.0, 1.0}, zero[2] = {0.0, 0.0};
  double pulled[2] = {-1.5, 3.0};  // held, −1.5 ≥ −2; friction 0.5 (−1.5 + 2)
  law.prox(in, r, zero, pulled);
  EXPECT_EQ(pulled[0], -1.5);
  EXPECT_DOUBLE_EQ(pulled[1], 0.25);
  double torn[2] = {-3.0, 1.0};
  EXPECT_EQ(law.status(in, torn), Status::lower);
  law.prox(in, r, zero, torn);
  EXPECT_DOUBLE_EQ(torn[0], -2.0);
  EXPECT_EQ(torn[1], 0.0);
}

TEST(BeltFriction, SlipsAtTheRatioOfEulerAndEytelwein) {
  // At the limit T = c S: S₁/S₂ = (1 + c/2)/(1 − c/2). One turn with mu 0.3: 6.58606196269472;
  // half a turn with 0.2: 1.874456 (both closed forms of the tables of reference values).
  const auto ratio = [](double mu, double wrap) {
    const double c = BeltFriction::coefficient(mu, wrap);
    return (1.0 + 0.5 * c) / (1.0 - 0.5 * c);
  };
  EXPECT_NEAR(ratio(0.3, 2.0 * std::numbers::pi), 6.58606196269472, 1e-13);
  EXPECT_NEAR(ratio(0.2, std::numbers::pi), 1.874456, 5e-7);  // digits of the table
}

TEST(Laws, ScaleTheirSets) {
  const LawInput in{.dim = 1, .dt = 0.1, .scale = 0.25};
  const StribeckCurve flat{.atRest = 4.0, .far = 4.0};
  EXPECT_DOUBLE_EQ(prox(GivenFriction(4.0, 4.0), in, 9.0), 0.1);
  EXPECT_DOUBLE_EQ(prox(StribeckFriction(flat), in, 9.0), 0.1);
  EXPECT_DOUBLE_EQ(prox(ForceLimit(-1.0, 4.0), in, 9.0), 0.1);
  EXPECT_DOUBLE_EQ(prox(PreloadedSpring(1.0, 4.0, false), in, 9.0), 0.1);
  EXPECT_DOUBLE_EQ(prox(UnilateralAdhesion(4.0, 0.0, 0.0), in, -9.0), -0.1);
  EXPECT_EQ(prox(clutch("positive"), in, 9.0), 9.0);  // no size of its own
}

}  // namespace
}  // namespace dynamy
