/// Euler's disc with contour friction: its rows against differences, and the power of its
/// spin-down.
#include <gtest/gtest.h>

#include <dynamy/testing/check_element.hpp>
#include <reference/scene.hpp>
#include <support/load_model.hpp>

namespace dynamy::reference {
namespace {

TEST(EulersDisc, HasRowsAndBiasThatFitItsMotion) {
  LoadedModel loaded("models/eulers_disc.xml");
  const Verdict verdict = checkModel(loaded.model());
  EXPECT_TRUE(verdict) << verdict.message();
}

TEST(EulersDisc, LiesDownWithThePowerTwoThirds) {
  // A flat thin disc: (3/2) m g R α' = −μ_c m g R · 2 √(g/(R α)), so that α^(3/2) falls linearly.
  // At finite inclination the rate changes by terms of α² = 0.04 and, with the thickness, of l/(2 R
  // α) = 0.1, half of which differs between 12° and 6.5°.
  Scene scene("eulers_disc");
  std::vector<double> power{std::pow(M_PI / 15.0, 1.5)};
  for (const double t : {0.3, 0.6, 0.9}) {
    scene.run(t, 1e-4);
    double alpha = 0.2;  // z = R sin α + l/2 cos α
    for (int i = 0; i < 20; ++i)
      alpha = std::asin((scene.q("disc")[2] - 5e-4 * std::cos(alpha)) / 0.0375);
    power.push_back(std::pow(alpha, 1.5));
  }
  const double first = power[0] - power[1];
  EXPECT_NEAR((power[1] - power[2]) / first, 1.0, 0.06);
  EXPECT_NEAR((power[2] - power[3]) / first, 1.0, 0.06);
  // α itself does not: its rate grows by α^(−1/2).
  EXPECT_GT((std::pow(power[2], 2.0 / 3.0) - std::pow(power[3], 2.0 / 3.0)) /
                (std::pow(power[0], 2.0 / 3.0) - std::pow(power[1], 2.0 / 3.0)),
            1.1);
}

TEST(EulersDisc, RollsSteadilyWithoutFrictionAlongItsRim) {
  // The middle of the disc rests: one and a half turns of the precession; what moves it is the step
  // in which the contact closes at a gap of 1e-12, and the scheme's order 4 at 1e-4 s.
  SceneSetup setup;
  setup.set = {{"contour", "0"}, {"alpha", "0.2"}};
  Scene scene("eulers_disc", std::move(setup));
  const double z = scene.q("disc")[2];
  scene.run(0.1, 1e-4);
  EXPECT_NEAR(scene.q("disc")[2], z, 1e-9);
  EXPECT_NEAR(scene.q("disc").head<2>().norm(), 0.0, 1e-9);
}

}  // namespace
}  // namespace dynamy::reference
