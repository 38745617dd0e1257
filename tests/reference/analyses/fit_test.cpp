// Fits of noisy measurements whose parameters are known: of motions in closed form.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <cmath>
#include <dynamy/io/model/file_fit.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <random>

namespace dynamy {
namespace {

constexpr double kUnknownSigma = std::numeric_limits<double>::quiet_NaN();

/// A thrown point mass that bounces with friction: x, z and speeds, in closed form.
struct ThrownBall {
  double e = 0.7, mu = 0.15, h = 1.0, vx = 2.0;
  std::pair<double, double> at(double t) const {
    const double g = 9.81;
    double t0 = 0.0, x = 0.0, z = h, vz = 0.0, v = vx;
    for (;;) {
      const double next = t0 + (vz + std::sqrt(vz * vz + 2.0 * g * z)) / g;
      if (next > t) break;
      const double d = next - t0, hit = g * d - vz;  // speed of the impact
      x += v * d, z = 0.0, t0 = next, vz = e * hit;
      v = std::copysign(std::max(std::abs(v) - mu * (1.0 + e) * hit, 0.0), v);
    }
    const double d = t - t0;
    return {x + v * d, z + vz * d - 0.5 * g * d * d};
  }
};

const char* const kThrownModel = R"x(<parameter name="e" value="0.5"/>
  <parameter name="mu" value="0.1"/>
  <parameter name="vx" value="2"/>
  <parameter name="m" value="1"/>
  <systems>
    <PointMass name="ball" plane="xz" position="0 0 1.1" velocity="{vx} 0 0" mass="{m}"><Sphere radius="0.1" material="rubber"/></PointMass>
    <Ground name="world"><HalfSpace material="concrete"/></Ground>
  </systems>
  <forces><Gravity acceleration="0 0 -9.81"/></forces>
  <elements><Contact between="rubber concrete"><UnilateralCoulomb epsilonN="{e}" mu="{mu}"/></Contact></elements>
  <simulation until="1.5" tolerance="1e-8"/>)x";

/// The fit of a line in closed form: (y0, v), and C = σ² (AᵀA)⁻¹.
struct Line {
  Eigen::Vector2d best;
  Eigen::Matrix2d C;
};

class Fits : public ::testing::Test {
 protected:
  Fits() {
    registerFramework(registry_);
    plugins_.load(kStandardElements, registry_);
  }
  ModelMaker maker(const std::string& inside, const std::vector<Varied>& set = {}) {
    return [this, inside, set](const std::vector<Varied>& changed) {
      LoadOptions options;
      for (const std::vector<Varied>& all : {set, changed})
        for (const auto& [name, value] : all)
          options.set.emplace_back(name, fmt::format("{}", value));
      return loadModelText("<dynamy version=\"1\">" + inside + "</dynamy>", "test.xml", registry_,
                           plugins_, options);
    };
  }
  double noise(double sigma) { return std::normal_distribution<>(0.0, sigma)(random_); }

  /// A throw with a camera of 50 pictures a second.
  MeasuredRun thrown(const ThrownBall& ball, double sigma, double given) {
    MeasuredRun run;
    run.name = "throw", run.make = maker(kThrownModel, {{"vx", ball.vx}});
    for (int i = 0; i <= 75; ++i) {
      const double t = 0.02 * i;
      const auto [x, z] = ball.at(t);
      run.data.push_back({"ball.x", t, x + noise(sigma), given});
      run.data.push_back({"ball.z", t, 0.1 + z + noise(sigma), given});
    }
    return run;
  }
  /// Measures y = y0 + v t, whose errors have the standard deviation sigma, at eleven instants.
  Line measuredLine(MeasuredRun& run, double y0, double v, double sigma) {
    Eigen::MatrixX2d A(11, 2);
    Eigen::VectorXd y(11);
    for (int i = 0; i <= 10; ++i) {
      A.row(i) << 1.0, 0.1 * i;
      y[i] = y0 + v * (0.1 * i) + noise(sigma);
      run.data.push_back({"p.y", 0.1 * i, y[i], sigma});
    }
    const Eigen::Matrix2d N = A.transpose() * A;
    return {N.ldlt().solve(A.transpose() * y), sigma * sigma * N.inverse()};
  }

  Registry registry_;
  PluginLoader plugins_{{DYNAMY_BINARY_DIR "/lib/dynamy"}};
  std::mt19937_64 random_{7};
};

WantedParameter wanted(const std::string& name, double start) {
  WantedParameter p;
  p.name = name, p.start = start;
  return p;
}

const FittedParameter& parameterOf(const Fit& f, const std::string& name) {
  for (const FittedParameter& p : f.parameters)
    if (p.name == name) return p;
  throw std::out_of_range(name);
}

/// Five standard deviations: a wrong fit is far beyond, a right one misses it once in a million.
void expectTruth(const Fit& f, const std::string& name, double truth) {
  const FittedParameter& p = parameterOf(f, name);
  EXPECT_TRUE(p.identifiable) << name;
  EXPECT_NEAR(p.value, truth, 5.0 * p.sigma) << name;
  EXPECT_LT(p.low, p.value) << name;
  EXPECT_GT(p.high, p.value) << name;
}

TEST_F(Fits, FindFrictionAndRestitutionOfABouncingBall) {
  FitRequest request;
  request.parameters = {wanted("e", 0.6), wanted("mu", 0.1)};
  request.runs = {thrown({}, 2e-3, 2e-3), thrown({.vx = 3.0}, 2e-3, 2e-3)};
  const Fit f = fit(request);
  EXPECT_TRUE(f.converged) << f.why;
  expectTruth(f, "e", 0.7);
  expectTruth(f, "mu", 0.15);
  // Sums of 302 squares: 300 ± 24.5 each standard deviation.
  EXPECT_NEAR(f.chi2, f.freedom, 5.0 * std::sqrt(2.0 * f.freedom));
  EXPECT_EQ(f.freedom, 302);
  EXPECT_EQ(f.points.size(), 304u);
}

TEST_F(Fits, EstimateTheNoiseWhereItIsNotGiven) {
  FitRequest request;
  request.parameters = {wanted("e", 0.6), wanted("mu", 0.1)};
  request.runs = {thrown({}, 2e-3, kUnknownSigma)};
  const Fit f = fit(request);
  expectTruth(f, "e", 0.7);
  ASSERT_EQ(f.signals.size(), 2u);
  for (const FittedSignal& s : f.signals) {
    EXPECT_TRUE(s.estimated);
    // Of 76 residuals: a standard deviation of 8 %, five of them.
    EXPECT_NEAR(s.sigma, 2e-3, 5.0 * 2e-3 / std::sqrt(2.0 * 76.0));
  }
}

TEST_F(Fits, GiveTheCovarianceOfALinearProblem) {
  const std::string line =
      R"x(<parameter name="a" value="0"/><parameter name="v" value="1"/>
      <systems><Coordinates name="p" q="y" q0="{a}" u0="{v}" M="1" h="0"/></systems>
      <simulation until="1" tolerance="1e-8"/>)x";
  FitRequest request;
  request.parameters = {wanted("a", 0.0), wanted("v", 1.0)};
  MeasuredRun& run = request.runs.emplace_back();
  run.make = maker(line);
  const double sigma = 0.1;
  const auto [best, C] = measuredLine(run, 0.3, 0.5, sigma);
  const Fit f = fit(request);
  for (int i = 0; i < 2; ++i) {
    const FittedParameter& p = f.parameters[static_cast<std::size_t>(i)];
    // The search ends where χ² changes by 1e-10 of itself, a hundred-thousandth of σ.
    EXPECT_NEAR(p.value, best[i], 1e-4 * sigma);
    EXPECT_NEAR(p.low, best[i] - 1.959964 * std::sqrt(C(i, i)), 1e-4 * sigma);
    EXPECT_EQ(p.interval, FittedParameter::Interval::gaussian);
    for (int k = 0; k < 2; ++k)  // derivatives are good to 1e-9
      EXPECT_NEAR(f.covariance(i, k), C(i, k), 1e-7 * C(i, i));
  }
}

TEST_F(Fits, GiveIntervalsBesideParametersThatCannotBeToldApart) {
  // y = y0 + b c t: of b and c only the product is seen, which varies with y0 all the same. The
  // interval of y0 is that of a line whose slope is free.
  const std::string line =
      R"x(<parameter name="a" value="0"/><parameter name="b" value="1"/><parameter name="c" value="2"/>
      <systems><Coordinates name="p" q="y" q0="{a}" u0="{b*c}" M="1" h="0"/></systems>
      <simulation until="1" tolerance="1e-8"/>)x";
  FitRequest request;
  request.parameters = {wanted("a", 0.0), wanted("b", 1.0), wanted("c", 2.0)};
  MeasuredRun& run = request.runs.emplace_back();
  run.make = maker(line);
  const double sigma = 0.1;
  const auto [best, C] = measuredLine(run, 0.3, 2.5, sigma);
  const Fit f = fit(request);
  const FittedParameter& p = parameterOf(f, "a");
  EXPECT_TRUE(p.identifiable);
  EXPECT_FALSE(parameterOf(f, "b").identifiable);
  // χ² is not quadratic in b and c: ends that are searched are good to 1 % of the rise, half of it.
  const double half = 1.959964 * std::sqrt(C(0, 0));
  EXPECT_NEAR(p.low, best[0] - half, 0.01 * half);
  EXPECT_NEAR(p.high, best[0] + half, 0.01 * half);
}

TEST_F(Fits, NameAMassThatNothingDependsOn) {
  FitRequest request;
  request.parameters = {wanted("e", 0.6), wanted("mu", 0.1), wanted("m", 1.0)};
  request.runs = {thrown({}, 2e-3, 2e-3)};
  const Fit f = fit(request);
  EXPECT_FALSE(f.identifiable());
  EXPECT_FALSE(parameterOf(f, "m").identifiable);
  EXPECT_TRUE(std::isnan(parameterOf(f, "m").low));
  ASSERT_EQ(f.unknown.size(), 1u);
  EXPECT_EQ(f.unknown[0].find("m itself is not identifiable"), 0u) << f.unknown[0];
  expectTruth(f, "e", 0.7);
}

const char* const kOscillatorModel =
    R"x(<parameter name="k" value="30"/><parameter name="m" value="1"/>
  <parameter name="d" value="0"/>
  <systems><Coordinates name="p" q="y" q0="1" M="{m}" h="{-k}*y - {d}*y_dot"/></systems>
  <simulation until="3" tolerance="1e-8"/>)x";

MeasuredRun oscillator(const ModelMaker& make, double sigma, const std::function<double()>& noise) {
  MeasuredRun run;
  run.make = make;
  for (int i = 0; i <= 60; ++i)
    run.data.push_back({"p.y", 0.05 * i, std::cos(5.0 * 0.05 * i) + noise(), sigma});
  return run;
}

TEST_F(Fits, NameParametersThatCannotBeToldApart) {
  // y = cos √(k/m) t: the ratio of k and m alone can be seen.
  FitRequest request;
  request.parameters = {wanted("k", 24.0), wanted("m", 1.0)};
  request.runs = {oscillator(maker(kOscillatorModel), 0.01, [this] { return noise(0.01); })};
  const Fit f = fit(request);
  EXPECT_FALSE(parameterOf(f, "k").identifiable);
  EXPECT_FALSE(parameterOf(f, "m").identifiable);
  ASSERT_EQ(f.unknown.size(), 1u);
  EXPECT_NE(f.unknown[0].find("k and m cannot be told apart: changes by +1 % and +1 %"),
            std::string::npos)
      << f.unknown[0];
  const double ratio = parameterOf(f, "k").value / parameterOf(f, "m").value;
  EXPECT_NEAR(ratio, 25.0, 0.1);  // ω to 0.01/√60/3 s⁻¹ by the fit of a phase: 2 ω of this, 5σ
}

TEST_F(Fits, ResolveThemByAPrior) {
  FitRequest request;
  request.parameters = {wanted("k", 24.0), wanted("m", 1.0)};
  request.parameters[1].priorMean = 2.0, request.parameters[1].priorSigma = 0.1;
  request.runs = {oscillator(maker(kOscillatorModel), 0.01, [this] { return noise(0.01); })};
  const Fit f = fit(request);
  EXPECT_TRUE(f.identifiable());
  EXPECT_NEAR(parameterOf(f, "m").value, 2.0, 1e-3);  // nothing pulls m away from its prior
  EXPECT_NEAR(parameterOf(f, "m").sigma, 0.1, 1e-3);
  EXPECT_NEAR(parameterOf(f, "k").value, 50.0, 0.2);
  EXPECT_NEAR(parameterOf(f, "k").sigma, 2.5, 0.05);  // 25 times that of m
}

TEST_F(Fits, EndAnIntervalAtABound) {
  // The oscillator has no damping; a damping cannot be negative.
  FitRequest request;
  request.parameters = {wanted("k", 24.0), wanted("d", 0.02)};
  request.parameters[1].lower = 0.0;
  request.runs = {oscillator(maker(kOscillatorModel), 0.1, [this] { return noise(0.1); })};
  const Fit f = fit(request);
  const FittedParameter& d = parameterOf(f, "d");
  EXPECT_EQ(d.interval, FittedParameter::Interval::profile);
  EXPECT_EQ(d.low, 0.0);
  EXPECT_GT(d.high, 0.0);
}

TEST_F(Fits, FindAProfileThatIsNotQuadratic) {
  // The block comes to rest at v²/(2 μ g): σ of the place is large, so μ has a skew interval.
  const std::string block = R"x(<parameter name="mu" value="0.3"/>
      <systems><PointMass name="b" plane="xz" velocity="1 0 0" mass="1"><Point material="wood"/></PointMass>
      <Ground name="table"><HalfSpace material="wood"/></Ground></systems>
      <forces><Gravity acceleration="0 0 -9.81"/></forces>
      <elements><Contact between="wood wood"><UnilateralCoulomb mu="{mu}"/></Contact></elements>
      <simulation until="2" tolerance="1e-8"/>)x";
  FitRequest request;
  request.parameters = {wanted("mu", 0.3)};
  MeasuredRun& run = request.runs.emplace_back();
  run.make = maker(block);
  const double sigma = 0.04, place = 1.0 / (2.0 * 0.3 * 9.81);
  run.data.push_back({"b.x", 2.0, place, sigma});
  const Fit f = fit(request);
  const FittedParameter& mu = parameterOf(f, "mu");
  EXPECT_EQ(mu.interval, FittedParameter::Interval::profile);
  const double q = 1.959964;
  // One residual: its ends are where the place is q σ farther or nearer. Ends are good to half a
  // percent of the half width.
  EXPECT_NEAR(mu.low, 1.0 / (2.0 * 9.81 * (place + q * sigma)), 0.005 * (mu.value - mu.low));
  EXPECT_NEAR(mu.high, 1.0 / (2.0 * 9.81 * (place - q * sigma)), 0.005 * (mu.high - mu.value));
}

TEST_F(Fits, FindTheStartOfEachRun) {
  FitRequest request;
  request.parameters = {wanted("e", 0.6), wanted("mu", 0.1), wanted("vx", 2.0)};
  request.parameters[2].each = true;
  request.runs = {thrown({.vx = 2.0}, 2e-3, 2e-3), thrown({.vx = 3.0}, 2e-3, 2e-3)};
  request.runs[1].own = {{"vx", 2.8}};
  for (MeasuredRun& run : request.runs) run.make = maker(kThrownModel);
  const Fit f = fit(request);
  expectTruth(f, "e", 0.7);
  expectTruth(f, "mu", 0.15);
  ASSERT_EQ(f.parameters.size(), 4u);
  for (int run = 0; run < 2; ++run) {
    const FittedParameter& p = f.parameters[static_cast<std::size_t>(2 + run)];
    EXPECT_EQ(p.run, run);
    EXPECT_NEAR(p.value, 2.0 + run, 5.0 * p.sigma);
  }
}

TEST_F(Fits, GoOnWhereTheOrderOfImpactsChanges) {
  // Two balls: which of them hits its floor first depends on h, and the search begins on the other
  // side. The heights are those of free bounces.
  const std::string balls = R"x(<parameter name="h" value="0.8"/>
      <systems><Coordinates name="a" q="y" q0="{h}" M="1" h="-9.81"/>
      <Coordinates name="b" q="y" q0="1" M="1" h="-9.81"/></systems>
      <elements><CoordinateContact name="f" on="a" gap="y"><Unilateral epsilonN="0.5"/></CoordinateContact>
      <CoordinateContact name="g" on="b" gap="y"><Unilateral epsilonN="0.5"/></CoordinateContact></elements>
      <simulation until="0.8" tolerance="1e-8"/>)x";
  FitRequest request;
  request.parameters = {wanted("h", 0.8)};
  MeasuredRun& run = request.runs.emplace_back();
  run.make = maker(balls);
  const ThrownBall truth{.e = 0.5, .h = 1.1};
  for (int i = 0; i <= 40; ++i)
    run.data.push_back({"a.y", 0.02 * i, truth.at(0.02 * i).second + noise(1e-3), 1e-3});
  const Fit f = fit(request);
  EXPECT_TRUE(f.converged) << f.why;
  expectTruth(f, "h", 1.1);
  EXPECT_GE(f.runs[0].effort.reordered, 1);
}

TEST_F(Fits, TellWhyARunFailsFromTheStart) {
  FitRequest request;
  request.parameters = {wanted("e", 2.0)};  // no coefficient of restitution
  request.runs = {thrown({}, 2e-3, 2e-3)};
  EXPECT_THROW(fit(request), ModelError);
  request.parameters = {wanted("e", 0.5)};
  request.runs[0].data.clear();
  EXPECT_THROW(fit(request), ModelError);
}

}  // namespace
}  // namespace dynamy
