// Jumps of hybrid systems against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <cmath>
#include <dynamy/io/model/file_orbit.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <dynamy/simulation/run/simulation.hpp>

namespace dynamy {
namespace {

struct Jumps {
  Registry registry;
  PluginLoader plugins{{DYNAMY_BINARY_DIR "/lib/dynamy"}};
  Jumps() {
    registerFramework(registry);
    plugins.load(kStandardElements, registry);
  }
  Model load(const std::string& jump, const std::string& accuracy, double until) {
    return loadModelText(
        "<dynamy version=\"1\"><systems><Coordinates name=\"ball\" q=\"y\" units=\"m\" q0=\"1\" "
        "M=\"1\" "
        "h=\"-9.81\">\n" +
            jump + "</Coordinates></systems><simulation until=\"" + numberText(until) + "\" " +
            accuracy + "/></dynamy>",
        "ball.xml", registry, plugins);
  }
  std::string faultOf(const std::string& jump) {
    try {
      load(jump, "tolerance=\"1e-8\"", 1.0);
    } catch (const ModelError& e) {
      return e.what();
    }
    return {};
  }
};

const char* const kRebound = R"(<Jump guard="y" direction="falling" u="-0.5*y_dot"/>)";

TEST(Jump, OfABallThatReboundsIsLocated) {
  Jumps jumps;
  Model model = jumps.load(kRebound, "tolerance=\"1e-10\"", 1.1);
  Simulation run(model);
  const RunReport& report = run.run();
  ASSERT_EQ(report.ended, RunReport::Ended::finished) << report.reason;
  const double g = 9.81, first = std::sqrt(2.0 / g);
  // Two bounces: at `first`, and 2 · 0.5 · first later.
  const double t = 1.1 - 2.0 * first, v = 0.25 * g * first;
  // Ten tolerances.
  EXPECT_NEAR(run.state().q[0], v * t - 0.5 * g * t * t, 1e-9);
  EXPECT_NEAR(run.state().u[0], v - g * t, 1e-9);
}

TEST(Jump, OfFixedStepsIsAtTheEndOfTheStepThatPassedTheGuard) {
  Jumps jumps;
  Model model = jumps.load(kRebound, "step=\"1e-3\"", 0.6);
  Simulation run(model);
  ASSERT_EQ(run.run().ended, RunReport::Ended::finished);
  const double g = 9.81, first = std::sqrt(2.0 / g), t = 0.6 - first, v = 0.5 * g * first;
  // The jump is late by a step at most, in which the speeds before and after it differ by 1.5 gt.
  EXPECT_NEAR(run.state().q[0], v * t - 0.5 * g * t * t, 1e-3 * 1.5 * g * first);
}

TEST(Jump, BooksItsEnergyOutsideOfTheBalance) {
  Jumps jumps;
  Model model = jumps.load(kRebound, "tolerance=\"1e-10\"", 1.2);
  Simulation run(model);
  for (const Warning& w : run.run().warnings) EXPECT_NE(w.kind, "energy") << w.text;
}

TEST(Jump, TellsWhatIsWrongInItsFormulas) {
  Jumps jumps;
  const auto expectFault = [&](const std::string& jump, const std::string& text) {
    const std::string said = jumps.faultOf(jump);
    EXPECT_NE(said.find(text), std::string::npos) << jump << '\n' << said;
    EXPECT_NE(said.find("ball.xml:2:"), std::string::npos) << said;
  };
  expectFault("<Jump guard=\"y\"/>", "the jump changes nothing");
  expectFault("<Jump guard=\"y_dot\" u=\"0\"/>", "a guard depends on t and positions only");
  expectFault("<Jump guard=\"y\" u=\"0 ; 1\"/>", "one formula for each of the 1 coordinates");
  expectFault("<Jump guard=\"y ; y\" u=\"0\"/>", "expects one formula");
  expectFault("<Jump guard=\"z\" u=\"0\"/>", "z");
}

/// Motion of the walker from (θ, θ̇, φ, φ̇) over time T, by Runge and Kutta's method with 4000
/// steps: errors of 1e-14.
void walk(double gamma, double T, long double* x) {
  const auto rate = [&](const long double* y, long double* f) {
    f[0] = y[1], f[1] = std::sin(y[0] - gamma), f[2] = y[3];
    f[3] = f[1] + y[1] * y[1] * std::sin(y[2]) - std::cos(y[0] - gamma) * std::sin(y[2]);
  };
  const int n = 4000;
  const long double h = static_cast<long double>(T) / n;
  for (int i = 0; i < n; ++i) {
    long double k[4][4], y[4];
    for (int s = 0; s < 4; ++s) {
      for (int j = 0; j < 4; ++j) y[j] = s == 0 ? x[j] : x[j] + (s == 3 ? h : h / 2) * k[s - 1][j];
      rate(y, k[s]);
    }
    for (int j = 0; j < 4; ++j) x[j] += h / 6 * (k[0][j] + 2 * k[1][j] + 2 * k[2][j] + k[3][j]);
  }
}

/// Keeps the instants at which system 0 jumps.
class JumpInstants final : public RecordSink {
 public:
  void row(double, std::span<const double>) override {}
  void frame(FilmInstant, std::span<const FramePose>, std::span<const ContactRecord>) override {}
  void event(const ContactEvent& e) override {
    if (e.system == 0) t.push_back(e.t);
  }
  std::vector<double> t;
};

TEST(Jump, IsAnEventOfTheRun) {
  Jumps jumps;
  const double first =
      std::sqrt(2.0 / 9.81);  // of a fall of 1 m; with half the speed again as long
  // The error of the place, 1e-10 m, over the speed; and the end of a fixed step.
  for (const auto& [accuracy, error] :
       {std::pair{"tolerance=\"1e-10\"", 1e-9}, std::pair{"step=\"1e-3\"", 2e-3}}) {
    Model model = jumps.load(kRebound, accuracy, 1.0);
    Simulation run(model);
    JumpInstants found;
    run.record(found);
    run.run();
    ASSERT_EQ(found.t.size(), 2U) << accuracy;
    EXPECT_NEAR(found.t[0], first, error) << accuracy;
    EXPECT_NEAR(found.t[1], 2.0 * first, error) << accuracy;
  }
}

TEST(Jump, OfTheSimplestWalkerGivesItsGait) {
  Jumps jumps;
  const Orbit o = orbit({.file = DYNAMY_SOURCE_DIR "/models/simplest_walker.xml"}, jumps.registry,
                        jumps.plugins);
  EXPECT_LE(o.residual, 1e-12);
  EXPECT_LE(o.newton, 8);
  EXPECT_NEAR(o.period, 3.88246375285137, 1e-10);
  ASSERT_EQ(o.multipliers.size(), 2);
  // Twice what was measured; the error that is told is 1e-10.
  EXPECT_NEAR(o.multipliers[0].real(), -0.19009984106589, 2e-10);
  EXPECT_NEAR(std::abs(o.multipliers[0].imag()), 0.55759877668207, 2e-10);
  // The strike maps four numbers to two; the section holds one of them.
  EXPECT_EQ(o.zeros, 1);

  // From the published state right after the strike to the section θ = 0.
  const double theta = 0.200310900544247, speed = -0.199832473004952;
  long double x[4] = {theta, speed, 2.0L * theta, (1.0L - std::cos(2.0L * theta)) * speed};
  double T = 0.0;
  for (double dT = 0.9; std::abs(dT) > 1e-15 && T < 10.0;) {
    walk(0.009, dT, x), T += dT;
    dT = static_cast<double>(-x[0] / x[1]);
  }
  const double found[] = {o.at.q[0], o.at.u[0], o.at.q[1], o.at.u[1]};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(found[i], static_cast<double>(x[i]), 1e-10) << i;
}

}  // namespace
}  // namespace dynamy
