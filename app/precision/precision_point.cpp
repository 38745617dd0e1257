/// Runs one point. This program and the programs of peers print the same lines:
///
///   values V …       measured values of the checks of the scene, in their order
///   cpu S            [s] of CPU time from the first step to the last; the median of several runs
///   evaluations N
///   note TEXT        why there are no values, or a remark about them
#include "precision/precision_point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <sstream>

#include "precision/precision_output.hpp"
#include "processes.hpp"

namespace dynamy::app {
namespace {

// A process repeats a short run, so that the cold caches of the first run do not count.
constexpr double kRepeatFor = 0.05;  // [s]
constexpr std::size_t kRepeatMost = 20;

double processTime() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double median(std::vector<double> all) {
  std::sort(all.begin(), all.end());
  const std::size_t n = all.size();
  return n == 0 ? 0.0 : 0.5 * (all[(n - 1) / 2] + all[n / 2]);
}

Model ownModel(Program& program, const PrecisionScene& scene, const PrecisionPoint& p) {
  const auto form = static_cast<std::size_t>(p.form);
  Model model = loadModelText(scene.texts[form], scene.name + ".xml", program.registry,
                              program.plugins, LoadOptions{});
  if (p.setting.empty()) return model;
  if (!p.own.words.empty()) model.scheme(method<OneStep>(program.registry, p.own.words));
  const double setting = seconds(p.setting, "the catalogue");
  model.simulation.tolerance = p.own.byTolerance ? setting : 0.0;
  model.simulation.step = p.own.byTolerance ? 0.0 : setting;
  return model;
}

void printOwn(Program& program, const PrecisionScene& scene, const PrecisionPoint& p) {
  std::vector<double> times;
  for (double all = 0.0; times.empty() || (all < kRepeatFor && times.size() < kRepeatMost);) {
    Model model = ownModel(program, scene, p);
    Simulation simulation(model);
    const double begin = processTime();
    const RunReport& report = simulation.run();
    times.push_back(processTime() - begin);
    all += times.back();
    if (times.size() > 1) continue;
    if (report.ended != RunReport::Ended::finished) {
      fmt::print("note {}\n", report.reason);
      return;
    }
    fmt::print("values");
    for (const CheckResult& c : simulation.checks()) fmt::print(" {:.17g}", c.got);
    fmt::print("\nevaluations {}\n", report.cost.evaluations);
    if (report.solver.unconverged > 0)
      fmt::print("note {} of {} steps not solved to tolerance\n", report.solver.unconverged,
                 report.steps);
  }
  fmt::print("cpu {:.9g}\n", median(times));
}

/// Computes a point of this program; called in the child process.
int ownWork(Program& program, const PrecisionScene& scene, const PrecisionPoint& p) {
  try {
    printOwn(program, scene, p);
  } catch (const ModelError& e) {  // the method does not admit the scene
    fmt::print("note {}\n", e.what());
  }
  return 0;
}

/// Reads the printed lines of a point and compares the values with the checks of the scene.
PrecisionResult read(const std::string& text, const std::vector<CheckSettings>& checks) {
  PrecisionResult out;
  out.error = std::nan("");
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "cpu") words >> out.cpu;
    if (key == "evaluations") words >> out.evaluations;
    if (key == "note" && line.size() > 5)
      out.note += (out.note.empty() ? "" : "; ") + line.substr(5);
    if (key != "values") continue;
    double error = 0.0;
    std::size_t n = 0;
    for (std::string word; words >> word; ++n) {
      if (n >= checks.size()) continue;
      const double got = std::strtod(word.c_str(), nullptr);
      const double value = 0.5 * (checks[n].low + checks[n].high);
      const double e = std::abs(got - value) / (0.5 * (checks[n].high - checks[n].low));
      error = std::isfinite(e) ? std::max(error, e) : std::numeric_limits<double>::infinity();
    }
    if (n == checks.size())
      out.error = error;
    else
      out.note += fmt::format("{} values for {} checks", n, checks.size());
  }
  if (std::isnan(out.error) && out.note.empty()) out.note = "no values";
  if (std::isinf(out.error)) {
    out.error = std::nan("");
    out.note += out.note.empty() ? "not finite" : "; not finite";
  }
  return out;
}

}  // namespace

PrecisionResult runPoint(Program& program, const std::vector<PrecisionScene>& scenes,
                         const PrecisionPoint& point, double limit) {
  const PrecisionScene& scene = scenes[static_cast<std::size_t>(point.scene)];
  PrecisionPoint plain;  // the unchanged model, for its checks
  plain.form = point.form;
  const Model model = ownModel(program, scene, plain);
  const ProcessOutput output =
      point.program.empty()
          ? outputOf([&] { return ownWork(program, scene, point); }, limit)
          : outputOfProgram({point.program, scene.name, point.method, point.setting}, limit);
  PrecisionResult out = read(output.text, model.checks);
  if (output.tooLong)
    out.note = fmt::format("not done after {:g} s of CPU time", limit);
  else if (output.status != 0)
    out.note += (out.note.empty() ? "" : "; ") + endText(output.status);
  if (output.status != 0) out.error = std::nan("");
  return out;
}

}  // namespace dynamy::app
