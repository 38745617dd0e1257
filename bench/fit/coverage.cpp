/// How often intervals of fits hold the truth (theory 56.4): measurements of thrown balls in closed
/// form with noise of a fixed seed are fitted again and again.
///
///     bench_fit [REPETITIONS [RUNS]]      default: 2000 fits of 20 runs each
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <dynamy/simulation/fit/fit.hpp>
#include <random>

namespace {

using namespace dynamy;

constexpr double kE = 0.7, kMu = 0.15, kNoise = 5e-3, kGravity = 9.81;
constexpr int kPictures = 15;      ///< of a run
constexpr double kPicture = 0.07;  ///< between two [s]

/// A point mass with the speed vx falls from h and bounces with friction.
std::pair<double, double> thrown(double h, double vx, double t) {
  double t0 = 0.0, x = 0.0, z = h, vz = 0.0, v = vx;
  for (;;) {
    const double next = t0 + (vz + std::sqrt(vz * vz + 2.0 * kGravity * z)) / kGravity;
    if (next > t) break;
    const double d = next - t0, hit = kGravity * d - vz;
    x += v * d, z = 0.0, t0 = next, vz = kE * hit;
    v = std::max(v - kMu * (1.0 + kE) * hit, 0.0);
  }
  const double d = t - t0;
  return {x + v * d, z + vz * d - 0.5 * kGravity * d * d};
}

const char* const kModel = R"x(<dynamy version="1">
  <parameter name="e" value="0.5"/><parameter name="mu" value="0.1"/>
  <parameter name="h" value="1"/><parameter name="vx" value="2"/>
  <systems>
    <PointMass name="ball" plane="xz" position="0 0 {h}" velocity="{vx} 0 0" mass="1"><Point material="rubber"/></PointMass>
    <Ground name="world"><HalfSpace material="concrete"/></Ground>
  </systems>
  <forces><Gravity acceleration="0 0 -9.81"/></forces>
  <elements><Contact between="rubber concrete"><UnilateralCoulomb epsilonN="{e}" mu="{mu}"/></Contact></elements>
  <simulation until="2" tolerance="1e-8"/>
</dynamy>)x";

struct Bench {
  Registry registry;
  PluginLoader plugins;
  std::mt19937_64 random{20261125};
  Bench() {
    registerFramework(registry);
    plugins.load(kStandardElements, registry);
  }

  MeasuredRun run(double h, double vx, double given) {
    MeasuredRun out;
    out.make = [this, h, vx](const std::vector<Varied>& changed) {
      LoadOptions options;
      options.set = {{"h", fmt::format("{}", h)}, {"vx", fmt::format("{}", vx)}};
      for (const auto& [name, value] : changed)
        options.set.emplace_back(name, fmt::format("{}", value));
      return loadModelText(kModel, "thrown.xml", registry, plugins, options);
    };
    std::normal_distribution<> noise(0.0, kNoise);
    for (int i = 1; i <= kPictures; ++i) {
      const double t = kPicture * i;
      const auto [x, z] = thrown(h, vx, t);
      out.data.push_back({"ball.x", t, x + noise(random), given});
      out.data.push_back({"ball.z", t, z + noise(random), given});
    }
    return out;
  }

  FitRequest request(int runs, double given) {
    FitRequest out;
    out.tolerance = 1e-8;
    out.parameters.resize(2);
    out.parameters[0].name = "e", out.parameters[0].start = 0.65;
    out.parameters[1].name = "mu", out.parameters[1].start = 0.12;
    std::uniform_real_distribution<> height(0.4, 1.2), speed(1.0, 3.0);
    for (int k = 0; k < runs; ++k) {
      const double h = height(random), vx = speed(random);
      out.runs.push_back(run(h, vx, given));
    }
    return out;
  }
};

struct Tally {
  int fits = 0, covered[2] = {0, 0}, profiles = 0, unconverged = 0, reordered = 0, across = 0;
  long motions = 0;
  double deviations[2] = {0.0, 0.0};  // squares, in standard deviations

  void add(const Fit& f) {
    const double truth[] = {kE, kMu};
    ++fits, unconverged += !f.converged;
    for (std::size_t i = 0; i < 2; ++i) {
      const FittedParameter& p = f.parameters[i];
      covered[i] += p.low <= truth[i] && truth[i] <= p.high;
      profiles += p.interval == FittedParameter::Interval::profile;
      deviations[i] += std::pow((p.value - truth[i]) / p.sigma, 2);
    }
    for (const FittedRun& r : f.runs) {
      motions += r.effort.runs, reordered += r.effort.reordered > 0;
      across += r.effort.across > 0;
    }
  }
  void print(const char* title, int runs) const {
    fmt::print("{}: {} fits of {} runs\n", title, fits, runs);
    for (int i = 0; i < 2; ++i)
      fmt::print("  {:<3} covered {:.2f} % ± {:.2f} %, mean square {:.3f} of its variance\n",
                 i == 0 ? "e" : "mu", 100.0 * covered[i] / fits,
                 100.0 * std::sqrt(0.95 * 0.05 / fits), deviations[i] / fits);
    fmt::print("  {} of {} intervals by profile, {} not converged, {} motions a fit\n", profiles,
               2 * fits, unconverged, motions / fits);
    fmt::print("  of {} runs {} changed their order of switches, {} took differences across\n",
               fits * runs, reordered, across);
    std::fflush(stdout);
  }
};

}  // namespace

int main(int count, char** words) {
  const int repetitions = count > 1 ? std::atoi(words[1]) : 2000;
  const int runs = count > 2 ? std::atoi(words[2]) : 20;
  Bench bench;
  for (const bool given : {true, false}) {
    Tally tally;
    for (int k = 0; k < repetitions; ++k)
      tally.add(fit(bench.request(runs, given ? kNoise : std::nan(""))));
    tally.print(given ? "noise given" : "noise of the residuals", runs);
  }
  return 0;
}
