// Formulas, transfer functions, continuous PID controllers and noise: closed forms.
#include <gtest/gtest.h>
#include <Eigen/Dense>
#include <dynamy_elements/blocks/sampled_blocks.hpp>

#include <cmath>
#include <string>
#include <unit/elements/blocks/block_scene.hpp>

namespace dynamy {
namespace {

TEST(Formula, IsAGainAndASumThatOthersRead) {
  BlockScene scene(
      cart(R"(<Formula name="e" of="0.1 - cart.x"/><Formula name="f" of="k*e.out - cart.vx"/>
    <ForceInput on="cart" force="f.out; 0; 0"/>)",
           R"(tolerance="1e-9">)"));
  const State x = scene.run();
  // x'' + x'/2 + 4 (x − 0.1) = 0 from 0.2 and 1.
  const double w = std::sqrt(4.0 - 0.0625);
  const double exact = 0.1 + std::exp(-0.25) * (0.2 * std::cos(w) + (1.0 + 0.05) / w * std::sin(w));
  EXPECT_NEAR(x.q[0], exact, 1e-8);  // some ten tolerances
  EXPECT_THROW(BlockScene(cart(R"(<Formula name="a" of="b.out"/><Formula name="b" of="2*a.out"/>
    <ForceInput on="cart" force="a.out; 0; 0"/>)",
                               R"(tolerance="1e-9">)")),
               ModelError);
}

TEST(TransferFunction, AnswersAStepAsTheMatrixExponentialSays) {
  // (2 s² + 3 s + 5)/(s² + s + 4): x' = A x + B, x(t) = A⁻¹ (e^{A t} − 1) B, out = C x + 2.
  const double t = 1.0;
  Eigen::Matrix2d A;
  A << 0.0, 1.0, -4.0, -1.0;
  const double w = std::sqrt(4.0 - 0.25);
  // e^{A t} = e^{−t/2} (cos wt I + sin wt/w (A + I/2))
  const Eigen::Matrix2d I = Eigen::Matrix2d::Identity();
  const Eigen::Matrix2d e =
      std::exp(-0.5 * t) * (std::cos(w * t) * I + std::sin(w * t) / w * (A + 0.5 * I));
  const Eigen::Vector2d x = A.inverse() * (e - I) * Eigen::Vector2d(0.0, 1.0);
  const double exact = Eigen::Vector2d(5.0 - 8.0, 3.0 - 2.0).dot(x) + 2.0;
  const std::string block = R"(<TransferFunction name="g" of="1" numerator="2 3 5"
    denominator="1 1 4"/>)";
  for (const auto& [simulation, tolerance] :
       {std::pair{R"(tolerance="1e-9">)", 1e-8},
        // Explicit, of order 1: h/2 times second derivatives below 2.
        std::pair{R"(step="1ms">)", 1e-3}}) {
    BlockScene scene(cart(block, simulation));
    const State end = scene.run();
    EXPECT_NEAR(scene.signal(end, "g.out"), exact, tolerance) << simulation;
    EXPECT_NEAR(scene.signal(end, "g.x1"), x[0], tolerance) << simulation;
  }
}

TEST(TransferFunction, ClosesALoopWithoutADirectPath) {
  // Unity feedback of 4/(s (s + 1)): out'' + out' + 4 out = 4, the cart aside.
  BlockScene scene(
      cart(R"(<TransferFunction name="g" of="1 - g.out" numerator="4" denominator="1 1 0"/>)",
           R"(tolerance="1e-9">)"));
  const double w = std::sqrt(3.75);
  const double exact = 1.0 - std::exp(-0.5) * (std::cos(w) + 0.5 / w * std::sin(w));
  EXPECT_NEAR(scene.signal(scene.run(), "g.out"), exact, 1e-8);  // some ten tolerances
  EXPECT_THROW(BlockScene(cart(R"(<TransferFunction name="g" of="g.out" numerator="1 1"
    denominator="1 2"/><ForceInput on="cart" force="g.out; 0; 0"/>)",
                               R"(step="1ms">)")),
               ModelError);
}

TEST(TransferFunction, RefusesWhatIsNone) {
  const auto refused = [](const std::string& attributes) {
    try {
      BlockScene scene(
          cart("<TransferFunction name=\"g\" of=\"1\" " + attributes + "/>", R"(step="1ms">)"));
    } catch (const ModelError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(refused(R"(numerator="1 0 0" denominator="1 1")").find("higher power"),
            std::string::npos);
  EXPECT_NE(refused(R"(numerator="1" denominator="2")").find("no power of s"), std::string::npos);
  EXPECT_NE(refused(R"(numerator="1" denominator="0 1 1")").find("first coefficient"),
            std::string::npos);
}

TEST(ContinuousPid, IsTheClosedFormOfALinearLoop) {
  // 2 x'' = 30 e + I + 12 e', I' = 20 e, e = 1 − x:  (s + 1)(s² + 5 s + 10) = s³ + 6 s² + 15 s + 10.
  // e(0) = 0.7, e' = −1, and e''(0) = −x'' = −(30·0.7 − 12)/2.
  const double e0 = 0.7, e1 = -1.0, e2 = -(30.0 * 0.7 - 12.0) / 2.0, w = std::sqrt(3.75);
  // e = a e^{−t} + e^{−5t/2} (b cos wt + c sin wt)
  const double a = (e2 + 5.0 * e1 + 10.0 * e0) / 6.0, b = e0 - a, c = (e1 + a + 2.5 * b) / w;
  const double e = a * std::exp(-1.0) + std::exp(-2.5) * (b * std::cos(w) + c * std::sin(w));
  const std::string pid = R"(<ContinuousPid name="pid" error="1 - cart.x" rate="-cart.vx" kp="30"
    ki="20" kd="12"/><ForceInput on="cart" force="pid.out; 0; 0"/>)";
  for (const auto& [simulation, tolerance] : {std::pair{R"(tolerance="1e-9">)", 1e-8},
                                              // order 1, h/2 times second derivatives of 4
                                              std::pair{R"(step="1ms">)", 2e-3}}) {
    BlockScene scene(cart(pid, simulation));
    EXPECT_NEAR(scene.run().q[0], 1.0 - e, tolerance) << simulation;
  }
}

TEST(ContinuousPid, StopsItsIntegralAtALimit) {
  // The error stays 1: I' = 2, the output reaches its limit 3 at t = 0.5 (kp e = 2); then clamp
  // keeps I = 1, back takes it to 1 + 2·0.1 with the time constant 0.1 s.
  const auto integral = [](const std::string& way) {
    BlockScene scene(
        cart("<ContinuousPid name=\"p\" error=\"1\" kp=\"2\" ki=\"2\" upper=\"3\" tracking=\"0.1\" "
             "antiWindup=\"" +
                 way + "\"/>",
             R"(tolerance="1e-9">)"));
    return scene.signal(scene.run(), "p.integral");
  };
  // The kink is met by the control of errors, not located.
  EXPECT_NEAR(integral("clamp"), 1.0, 1e-6);
  EXPECT_NEAR(integral("back"), 1.0 + 0.2 * (1.0 - std::exp(-5.0)), 1e-6);
  EXPECT_NEAR(integral("none"), 2.0, 1e-9);
}

TEST(Noise, IsTheSameWithEveryScheme) {
  // SplitMix64 of seed 0 begins with these numbers.
  EXPECT_EQ(Noise::bits(0, 0), 0xe220a8397b1dcdafU);
  EXPECT_EQ(Noise::bits(0, 1), 0x6e789e6aa1b965f4U);
  const std::string noise = R"(<Noise name="n" seed="3" deviation="0.5" mean="2" period="10ms"/>
    <Integrator name="i" rate="n.out"/><Integrator name="j" rate="n.out^2"/>)";
  std::vector<double> ends, means;
  for (const char* simulation : {R"(tolerance="1e-6">)", R"(step="3ms">)", R"(step="40ms">)"}) {
    BlockScene scene(cart(noise, simulation));
    const State x = scene.run();
    ends.push_back(scene.signal(x, "n.out")), means.push_back(scene.signal(x, "i.out"));
    const double mean = means.back(), square = scene.signal(x, "j.out");
    // A hundred numbers: the mean within 4 σ/√100, the deviation within 4 σ/√200.
    EXPECT_NEAR(mean, 2.0, 0.2);
    EXPECT_NEAR(std::sqrt(square - mean * mean), 0.5, 0.15);
  }
  EXPECT_EQ(ends[0], ends[1]);
  EXPECT_EQ(ends[0], ends[2]);
  EXPECT_NEAR(means[1], means[0], 1e-9);
}

}  // namespace
}  // namespace dynamy
