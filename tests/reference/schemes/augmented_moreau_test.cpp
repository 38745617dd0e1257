/// Augmented time-stepping (theory 51): orders of the extrapolation, and what the localisation of
/// switches makes of them on an impact oscillator.
#include <gtest/gtest.h>

#include <reference/schemes/scheme_table.hpp>

namespace dynamy::reference {
namespace {

std::string scheme(int order, double dtMin = 0.0, bool checkEnds = true) {
  return "AugmentedMoreau order=\"" + std::to_string(order) + "\" dtMin=\"" + numberText(dtMin) +
         "\" checkEnds=\"" + (checkEnds ? "true" : "false") + "\"";
}

// ---- impact oscillator
// ---------------------------------------------------------------------------

/// m = 1 kg, d = 0.1 N s/m, c = 1 N/m, F = 1 N, Ω = 2.5 rad/s, wall x ≤ 0, ε = 0.6, from (−0.5 m,
/// 0).
const char* const kOscillator =
    "<systems><Coordinates name=\"x\" q=\"x\" q0=\"-0.5\" u0=\"0\" M=\"1\" h=\"-0.1*x_dot - x + "
    "cos(2.5*t)\"/></systems><elements><CoordinateContact on=\"x\" gap=\"-x\"><Unilateral "
    "epsilonN=\"0.6\"/></CoordinateContact></elements>";

struct Outcome {
  double error = 0.0;  ///< largest of q, u at 10 s
  long evaluations = 0;
  int switches = 0, rejected = 0;
};

/// Blocks of at most 2^−k s, Δt_min = 2^(−kN)/4 s.
Outcome oscillator(int order, int k, bool checkEnds) {
  const double dtMax = std::ldexp(1.0, -k), dtMin = std::pow(dtMax, order) / 4;
  Scene scene("oscillator", {.text = modelWith(scheme(order, dtMin, checkEnds), kOscillator)});
  Outcome out;
  while (10.0 - scene.state().t > 1e-13) {
    const StepReport& r = scene.oneStep(std::min(dtMax, 10.0 - scene.state().t));
    out.switches += r.counts.switches, out.rejected += r.counts.rejected;
  }
  out.evaluations = scene.system().evaluations();
  out.error = std::max(std::abs(scene.q("x")[0] + 0.725560570799648),
                       std::abs(scene.u("x")[0] - 0.032815801830002));
  return out;
}

/// Errors of an independent implementation of the algorithm, orders 1 … 4, two digits.
constexpr double kTable[5][4] = {{8.6e-3, 1.7e-3, 1.3e-4, 5.6e-6},
                                 {4.1e-3, 2.7e-4, 2.3e-6, 4.2e-7},
                                 {5.2e-3, 4.4e-5, 8.5e-7, 9.8e-9},
                                 {1.5e-3, 9.0e-6, 7.7e-8, 1.9e-9},
                                 {1.7e-3, 6.4e-6, 9.5e-9, 1.1e-10}};
/// Its base steps for order 4; those of a block that fails are given up in another order here.
constexpr int kBaseSteps[5] = {2416, 4221, 7552, 14177, 27139};

TEST(AugmentedMoreau, HasTheErrorsOfAnIndependentImplementation) {
  for (int k = 4; k <= 8; ++k)
    for (int N = 1; N <= 4; ++N) {
      const Outcome o = oscillator(N, k, true);
      const double expected = kTable[k - 4][N - 1];
      // Half a unit of the second digit of 1.1 is 5 %.
      EXPECT_NEAR(o.error, expected, 0.05 * expected) << "2^-" << k << ", N = " << N;
      // At switches errors are erratic; they stay below 20 Δt_max^N all the same.
      EXPECT_LT(o.error, 20.0 * std::pow(2.0, -k * N)) << "2^-" << k << ", N = " << N;
      EXPECT_GE(o.switches, 4);  // four impacts
      if (N == 4) {
        EXPECT_LE(o.evaluations, kBaseSteps[k - 4]) << k;
        EXPECT_GE(o.evaluations, 0.95 * kBaseSteps[k - 4]) << k;
      }
    }
}

TEST(AugmentedMoreau, IsOfItsOrderAcrossImpactsOnlyWithTheCheckOfEnds) {
  // Fits over a factor of 16 in Δt_max; what is erratic at a switch bends them by 0.6 at most.
  for (int N = 1; N <= 4; ++N) {
    std::vector<double> dt, with, without;
    for (int k = 4; k <= 8; ++k) {
      dt.push_back(std::ldexp(1.0, -k));
      with.push_back(oscillator(N, k, true).error);
      without.push_back(oscillator(N, k, false).error);
    }
    EXPECT_NEAR(fitOrder(dt, with).order, N, 0.6) << N << ": " << fitOrder(dt, with);
    // Without, a block ends behind the wall and the impact comes up to H/(2N) late: the error
    // stagnates.
    if (N < 3) continue;
    for (std::size_t i = 0; i < dt.size(); ++i) EXPECT_GT(without[i], 1e-6) << N << ", " << dt[i];
    if (N < 4) continue;
    EXPECT_GT(without.back(), 1e4 * with.back());
  }
}

// ---- smooth motion
// -------------------------------------------------------------------------------

const char* const kDriven =
    "<systems><Coordinates name=\"x\" q=\"x\" q0=\"1\" u0=\"0\" M=\"1\" h=\"-x + "
    "cos(2*t)\"/></systems>";
const char* const kDamped =
    "<systems><Coordinates name=\"x\" q=\"x\" q0=\"1\" u0=\"0\" M=\"1\" h=\"-x - 0.3*x_dot "
    "+ cos(2*t)\"/></systems>";
/// 1 m, released at 1 rad from the hanging position.
const char* const kPendulum =
    "<systems><PointMass name=\"x\" plane=\"xz\" position=\"{sin(1)} 0 {-cos(1)}\" mass=\"1\"/>"
    "<Ground name=\"world\"/></systems><forces><Gravity/></forces><elements><Distance name=\"rod\" "
    "between=\"world x\"/></elements>";

/// At 1 s, from Runge–Kutta's method.
Truth driven(double damping) {
  const auto y = rungeKutta<3>({1.0, 0.0, 0.0}, 1.0, [damping](const std::array<double, 3>& s) {
    return std::array{s[1], -s[0] - damping * s[1] + std::cos(2.0 * s[2]), 1.0};
  });
  return {Eigen::VectorXd::Constant(1, y[0]), Eigen::VectorXd::Constant(1, y[1])};
}
Truth pendulum() {
  const auto y = rungeKutta<2>({1.0, 0.0}, 1.0, [](const std::array<double, 2>& s) {
    return std::array{s[1], -9.81 * std::sin(s[0])};
  });
  return {Eigen::Vector2d(std::sin(y[0]), -std::cos(y[0])),
          y[1] * Eigen::Vector2d(std::cos(y[0]), std::sin(y[0]))};
}

/// Order of q and u at t, blocks of H = first, first/2, …; errors above the rounding of the runs.
double order(int N, const std::string& sections, const std::string& name, const Truth& truth,
             double t, double first, int count) {
  std::vector<double> H, error;
  for (const double h : halvings(first, count)) {
    Scene scene("scene", {.text = modelWith(scheme(N), sections)});
    scene.run(t, h);
    EXPECT_TRUE(scene.solved());
    const double e = std::hypot((scene.q(name) - truth.q).norm(), (scene.u(name) - truth.u).norm());
    if (e < 2e-13 && !H.empty()) break;
    H.push_back(h), error.push_back(e);
  }
  EXPECT_GE(H.size(), 3u);
  return fitOrder(H, error).order;
}

TEST(AugmentedMoreau, IsOfOrderNInSmoothPhases) {
  // The driven oscillator has h(q, t): the base rule is symmetric, and every second row is a gift.
  constexpr double kDrivenOrder[] = {2, 2, 4, 4, 6};
  constexpr double kPendulumOrder[] = {1, 1, 2, 3, 4};
  const Truth undamped = driven(0.0), damped = driven(0.3), swung = pendulum();
  for (int N = 1; N <= 5; ++N) {
    // Tolerances as for the other schemes: the next term bends fits over a factor of 8 by 0.2. N =
    // 5 comes to rounding within two halvings from 1/4 s, where the next term bends more.
    const double first = N < 5 ? 0.125 : 0.25, bend = N < 5 ? 0.2 : 0.6;
    EXPECT_NEAR(order(N, kDriven, "x", undamped, 1.0, first, 5), kDrivenOrder[N - 1], bend) << N;
    EXPECT_NEAR(order(N, kDamped, "x", damped, 1.0, first, 5), N, bend) << N;
    // A curved constraint that acts: the velocity obeys that of the last midpoint, N − 1.
    EXPECT_NEAR(order(N, kPendulum, "x", swung, 1.0, 1.0 / 16, 4), kPendulumOrder[N - 1], 0.2) << N;
  }
}

TEST(AugmentedMoreau, LosesOneOrderOnACurvedSurfaceAlsoInSlip) {
  for (const double mu : {0.0, 0.2})
    for (int N = 2; N <= 4; ++N)
      EXPECT_NEAR(order(N, Bowl::sections(mu), "p", Bowl::truth(mu, 0.4), 0.4, 0.02, 4), N - 1, 0.2)
          << N << ", mu = " << mu;
}

TEST(AugmentedMoreau, GoesOnFromItsStateAlone) {
  // What it keeps from step to step is in the state: a second scheme object goes on bit by bit.
  const std::string text = modelWith(scheme(3), kOscillator);
  Scene straight("oscillator", {.text = text}), first("oscillator", {.text = text}),
      second("oscillator", {.text = text});
  for (int i = 0; i < 400; ++i) straight.oneStep(0.05);
  for (int i = 0; i < 200; ++i) first.oneStep(0.05);
  second.state() = first.state();
  for (int i = 0; i < 200; ++i) second.oneStep(0.05);
  EXPECT_GT(straight.state().t, 1.1);  // behind the first impact
  EXPECT_EQ(straight.state().t, second.state().t);
  EXPECT_EQ(straight.state().q, second.state().q);
  EXPECT_EQ(straight.state().u, second.state().u);
}

}  // namespace
}  // namespace dynamy::reference
