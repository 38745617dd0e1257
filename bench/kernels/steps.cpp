/// Cost of one step of small models, without recording: what the stages and the solver take.
///
///   bench_steps [google-benchmark options]             microseconds a step, one line a model
///   bench_steps --count STEPS MODEL.xml STEP           exactly STEPS steps, for a counting tool
///
/// Times compare only within one run on a quiet machine; scripts in this folder count instructions
/// instead.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <cstring>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <dynamy/schemes/moreau_midpoint.hpp>
#include <iostream>
#include <string>

namespace {

using namespace dynamy;

/// A model ready to step.
struct Scene {
  Registry registry;
  PluginLoader plugins;
  Model model;
  MechanicalSystem system;
  State start;

  explicit Scene(const std::string& file)
      : model(load(file, registry, plugins)),
        system(model.mechanicalSystem()),
        start(model.initialState()) {}

  static Model load(const std::string& file, Registry& registry, PluginLoader& plugins) {
    registerFramework(registry);
    plugins.load(kStandardElements, registry);
    Model model = loadModel(file, registry, plugins);
    if (model.scheme().choosesSteps()) model.scheme(std::make_unique<MoreauMidpoint>());
    return model;
  }
};

/// Steps of length dt; starts anew after `steps` so that the motion stays the same mix of phases.
void run(benchmark::State& state, const std::string& file, double dt, long steps) {
  Scene scene(file);
  State x = scene.start;
  long k = 0, iterations = 0;
  for (auto _ : state) {
    if (k++ == steps) x = scene.start, k = 1;
    iterations +=
        scene.model.scheme().step(scene.system, scene.model.solver(), x, dt).solved.iterations;
  }
  benchmark::DoNotOptimize(x.u.data());
  state.counters["iterations"] =
      static_cast<double>(iterations) / static_cast<double>(state.iterations());
}

struct Case {
  const char* model;
  double dt;
  long steps;
};
constexpr Case kCases[] = {{"bouncing_ball", 1e-4, 20000},
                           {"woodpecker", 1e-5, 30000},
                           {"woodpecker_expressions", 1e-5, 30000},
                           {"double_pendulum", 1e-4, 50000},
                           {"block_on_slope", 1e-3, 10000},
                           {"falling_box", 1e-3, 2000},
                           {"tower", 1e-3, 10000},
                           {"tower_swung", 1e-3, 10000},
                           {"ratio_stack", 1e-3, 10000},
                           {"ratio_stack_swung", 1e-3, 10000},
                           {"heavy_chain", 1e-3, 5000}};

int count(long steps, const std::string& file, double dt) {
  Scene scene(file);
  State x = scene.start;
  for (long k = 0; k < steps; ++k)
    scene.model.scheme().step(scene.system, scene.model.solver(), x, dt);
  std::cout << x.t << '\n';
  return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 5 && std::strcmp(argv[1], "--count") == 0)
      return count(std::atol(argv[2]), argv[3], std::atof(argv[4]));
    for (const Case& c : kCases)
      benchmark::RegisterBenchmark(
          c.model, run, std::string(DYNAMY_MODELS) + "/" + c.model + ".xml", c.dt, c.steps);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
