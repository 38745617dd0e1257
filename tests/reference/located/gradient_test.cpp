// Derivatives of runs against closed forms, differentiated, and against the saltation matrix.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <cmath>
#include <dynamy/io/model/file_gradient.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <fstream>

namespace dynamy {
namespace {

using Exact = long double;
constexpr Exact kGravity = 9.81L;

struct Derivatives {
  Registry registry;
  PluginLoader plugins{{DYNAMY_BINARY_DIR "/lib/dynamy"}};
  Derivatives() {
    registerFramework(registry);
    plugins.load(kStandardElements, registry);
  }
  /// Of a file of models/.
  Gradient operator()(const std::string& model, const std::vector<std::string>& of,
                      const std::vector<std::string>& by, double tolerance = 1e-10) {
    return gradient({.file = DYNAMY_SOURCE_DIR "/models/" + model + ".xml",
                     .of = of,
                     .by = by,
                     .tolerance = tolerance},
                    registry, plugins);
  }
  /// Of a text with one parameter p.
  Gradient ofText(const std::string& inside, const std::vector<SignalAt>& of, double p) {
    return gradient(
        [&](const std::vector<Varied>& changed) {
          LoadOptions options;
          for (const auto& [name, value] : changed)
            options.set.emplace_back(name, "{" + numberText(value) + "}");
          return loadModelText("<dynamy version=\"1\">" + inside + "</dynamy>", "test.xml",
                               registry, plugins, options);
        },
        {.of = of, .by = {{"p", p}}, .tolerance = 1e-10});
  }
};

/// f′(x) by five points; with 19 digits and this δ it is good to 1e-12 for the forms here.
template <class F>
double derivative(const F& f, Exact x) {
  const Exact d = 1e-4L * x;
  return static_cast<double>((8 * (f(x + d) - f(x - d)) - (f(x + 2 * d) - f(x - 2 * d))) /
                             (12 * d));
}

/// Derivatives are good to 1e-8 of max(|d|, |value/p|) at a tolerance of 1e-10: the smallest steps
/// of the differences are 5e-6 p, and values are rounded to about 1e-15. Their errors are not larger
/// than said.
void expectExact(const GradientValue& v, std::size_t i, double p, double exact) {
  const double scale = std::max(std::abs(exact), std::abs(v.value / p));
  const double error = std::abs(v.d[i] - exact);
  EXPECT_LE(error, 1e-8 * scale) << v.of << " by parameter " << i << ": " << v.d[i];
  EXPECT_LE(error, v.dError[i]) << v.of << " by parameter " << i;
}

TEST(Gradient, OfABallThatBouncesIsThatOfItsClosedForm) {
  Derivatives of;
  const std::vector<double> times{0.6, 1.1, 1.25};
  const Gradient g =
      of("bouncing_ball", {"ball.z@0.6", "ball.z@1.1", "ball.z@1.25"}, {"h0", "e", "g"});
  ASSERT_EQ(g.values.size(), 3u);
  const auto z = [](Exact t, Exact h, Exact e, Exact a) {
    const Exact first = std::sqrt(2 * h / a);
    Exact from = first, speed = e * a * first;
    while (from + 2 * speed / a < t) from += 2 * speed / a, speed *= e;
    return 0.1L + speed * (t - from) - a / 2 * (t - from) * (t - from);
  };
  for (std::size_t k = 0; k < times.size(); ++k) {
    const Exact t = times[k], e = 0.5L;
    const auto& v = g.values[k];
    expectExact(v, 0, 1.0, derivative([&](Exact h) { return z(t, h, e, kGravity); }, 1));
    expectExact(v, 1, 0.5, derivative([&](Exact x) { return z(t, 1, x, kGravity); }, e));
    expectExact(v, 2, 9.81, derivative([&](Exact a) { return z(t, 1, e, a); }, kGravity));
  }
  // The values of the theory, to their digits.
  EXPECT_NEAR(g.values[0].d[0], -0.006749, 5e-7);
}

TEST(Gradient, OfABallThatHasComeToRestIsZero) {
  Derivatives of;
  const Gradient g = of("bouncing_ball", {"ball.z", "ball.vz"}, {"h0", "e"});
  for (const GradientValue& v : g.values)
    for (const double d : v.d) EXPECT_NEAR(d, 0.0, 1e-9) << v.of;
}

TEST(Gradient, GoesThroughTheTurnOfABlockOnASlope) {
  Derivatives of;
  const Gradient g = of("block_on_slope_slide", {"block.x@2"}, {"mu", "v0", "alpha"});
  const auto x = [](Exact mu, Exact v, Exact alpha) {
    const Exact up = kGravity * (std::sin(alpha) + mu * std::cos(alpha));
    const Exact back = kGravity * (std::sin(alpha) - mu * std::cos(alpha)), s = 2 - v / up;
    return (v * v / (2 * up) - back / 2 * s * s) * std::cos(alpha) - 0.05L * std::sin(alpha);
  };
  const Exact alpha = std::acos(-1.0L) / 9;
  const GradientValue& v = g.values[0];
  expectExact(v, 0, 0.3, derivative([&](Exact m) { return x(m, 2, alpha); }, 0.3L));
  expectExact(v, 1, 2.0, derivative([&](Exact u) { return x(0.3L, u, alpha); }, 2));
  expectExact(v, 2, static_cast<double>(alpha),
              derivative([&](Exact a) { return x(0.3L, 2, a); }, alpha));
}

TEST(Gradient, GoesThroughTheEndOfASlipInSpace) {
  Derivatives of;
  const Gradient puck = of("sliding_puck", {"puck.x"}, {"mu", "v0", "heading"});
  const double c = std::cos(std::acos(-1.0) / 6.0), way = 4.0 / (2.0 * 0.3 * 9.81);
  expectExact(puck.values[0], 0, 0.3, -way * c / 0.3);
  expectExact(puck.values[0], 1, 2.0, way * c);
  expectExact(puck.values[0], 2, std::acos(-1.0) / 6.0, -way * 0.5);
  const Gradient ball = of("slide_to_roll", {"ball.x@0.45"}, {"mu", "v0"});
  const auto x = [](Exact mu, Exact v) {
    const Exact t = 2 * v / (7 * mu * kGravity);
    return v * t - mu * kGravity / 2 * t * t + 5 * v / 7 * (0.45L - t);
  };
  expectExact(ball.values[0], 0, 0.3, derivative([&](Exact m) { return x(m, 3); }, 0.3L));
  expectExact(ball.values[0], 1, 3.0, derivative([&](Exact v) { return x(0.3L, v); }, 3));
}

TEST(Gradient, GoesThroughManyReversalsOfDryFriction) {
  Derivatives of;
  // At rest after 13 half swings: x = −(x0 − 26 μ m g/k), m = 1 kg.
  const Gradient g = of("coulomb_oscillator", {"block.x"}, {"mu", "k", "x0"});
  const GradientValue& v = g.values[0];
  expectExact(v, 0, 0.2, 26.0 * 9.81 / 100.0);
  expectExact(v, 1, 100.0, -26.0 * 0.2 * 9.81 / 1e4);
  expectExact(v, 2, 0.5, -1.0);
}

/// The flight of ẍ + ẋ/10 + x = cos 2.5 t from (t0, x0, v0) at time t: x, v.
std::pair<Exact, Exact> flight(Exact t0, Exact x0, Exact v0, Exact t) {
  const Exact w = 2.5L, a = 1 - w * w, b = 0.1L * w, n = a * a + b * b;
  const Exact A = a / n, B = b / n, decay = 0.05L, f = std::sqrt(1 - decay * decay);
  const auto forced = [&](Exact s) { return A * std::cos(w * s) + B * std::sin(w * s); };
  const auto rate = [&](Exact s) { return w * (B * std::cos(w * s) - A * std::sin(w * s)); };
  const Exact p = x0 - forced(t0), q = (v0 - rate(t0) + decay * p) / f, s = t - t0;
  const Exact c = std::cos(f * s), d = std::sin(f * s), fall = std::exp(-decay * s);
  return {forced(t) + fall * (p * c + q * d),
          rate(t) + fall * ((f * q - decay * p) * c - (f * p + decay * q) * d)};
}

TEST(Gradient, AgreesWithTheSaltationMatrixOfADrivenOscillator) {
  const Exact e = 0.6L;
  Exact t = 0, x = -0.5L, v = 0, dx = 0, dv = 0;
  // Variations obey the equation without the force.
  const auto vary = [&](Exact s) {
    const Exact decay = 0.05L, f = std::sqrt(1 - decay * decay), q = (dv + decay * dx) / f;
    const Exact c = std::cos(f * s), d = std::sin(f * s), fall = std::exp(-decay * s), p = dx;
    dx = fall * (p * c + q * d), dv = fall * ((f * q - decay * p) * c - (f * p + decay * q) * d);
  };
  for (Exact hit :
       {1.068470041262129L, 3.503294713946020L, 6.140644164242998L, 8.664150575340344L}) {
    for (int i = 0; i < 4; ++i) {  // Newton's method
      const auto [at, speed] = flight(t, x, v, hit);
      hit -= at / speed;
    }
    vary(hit - t);
    const Exact before = flight(t, x, v, hit).second, after = -e * before;
    const Exact dt = -dx / before, force = std::cos(2.5L * hit);
    const Exact aBefore = force - 0.1L * before, aAfter = force - 0.1L * after;
    dx += (before - after) * dt;
    dv = -e * dv - before + (-e * aBefore - aAfter) * dt;
    t = hit, x = 0, v = after;
  }
  vary(10 - t);
  Derivatives of;
  const Gradient g = of("impact_oscillator", {"mass.x", "mass.x_dot"}, {"e"}, 1e-11);
  expectExact(g.values[0], 0, 0.6, static_cast<double>(dx));
  expectExact(g.values[1], 0, 0.6, static_cast<double>(dv));
}

TEST(Gradient, IsRefusedWhereAnImpactComesOrGoes) {
  // x = −cos t reaches the wall at p = 1 with velocity 0: with p < 1 it hits, with p > 1 it does not.
  Derivatives of;
  const Gradient g = of.ofText(R"xml(<parameter name="p" value="1"/>
    <systems><Coordinates name="mass" q="x" q0="-1" M="1" potential="x^2/2"/></systems>
    <elements><CoordinateContact name="wall" on="mass" gap="{p} - x"><Unilateral epsilonN="0.5"/>
    </CoordinateContact></elements><simulation until="5" tolerance="1e-8"/>)xml",
                               {{"mass.x", 2.0}, {"mass.x", 4.0}}, 1.0);
  EXPECT_NE(g.refused[0].find("wall"), std::string::npos) << g.refused[0];
  EXPECT_NE(g.refused[0].find("t = 3.1"), std::string::npos) << g.refused[0];
  EXPECT_TRUE(std::isnan(g.values[1].d[0]));
}

TEST(Gradient, OfManyParametersTakesFewRuns) {
  Derivatives all;
  int made = 0;
  const auto make = [&](const std::vector<Varied>& changed) {
    ++made;
    LoadOptions options;
    for (const auto& [name, value] : changed)
      options.set.emplace_back(name, "{" + numberText(value) + "}");
    return loadModel(DYNAMY_SOURCE_DIR "/models/woodpecker_expressions.xml", all.registry,
                     all.plugins, options);
  };
  const Gradient g = gradient(make, {.of = {{"toy.phiS_dot", 3.0}},
                                     .by = {{"mu", 0.3},
                                            {"eN1", 0.5},
                                            {"mM", 3e-4},
                                            {"mS", 4.5e-3},
                                            {"JM", 5e-9},
                                            {"JS", 7e-7},
                                            {"c", 5.6e-3},
                                            {"g", 9.81},
                                            {"lM", 0.01},
                                            {"lG", 0.015}},
                                     .tolerance = 1e-8});
  for (const std::string& refused : g.refused) EXPECT_EQ(refused, "");
  // The model, a run for each of two accuracies, four runs a parameter, and one for each in which
  // differences of order 4 find other switches at once. They were 100.
  EXPECT_LE(made, 3 + 10 * 5 + 10);
}

TEST(Gradient, ByAParameterWithoutEffectIsZero) {
  Derivatives of;
  const Gradient g = of.ofText(R"xml(<parameter name="p" value="0"/>
    <systems><Coordinates name="mass" q="x" q0="1" M="1" potential="x^2/2"/></systems>
    <simulation until="5" tolerance="1e-8"/>)xml",
                               {{"mass.x", 5.0}}, 0.0);
  EXPECT_EQ(g.values[0].d[0], 0.0);
  EXPECT_NEAR(g.values[0].value, std::cos(5.0), 1e-9);
}

}  // namespace
}  // namespace dynamy
