#include "stability/stability_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/simulation/run/simulation.hpp>

#include "run/error_bar.hpp"

namespace dynamy::app {
namespace {

struct Run {
  RunReport report;
  std::vector<CheckResult> checks;
};

/// Runs the task with `part` times its step.
Run runOnce(Program& program, const StabilityScene& scene, const StabilityTask& task, double part) {
  LoadOptions options;
  options.set = {{"dt", numberText(task.step)}};
  Model model =
      loadModelText(scene.text, scene.name + ".xml", program.registry, program.plugins, options);
  if (!task.scheme.empty()) model.scheme(method<OneStep>(program.registry, task.scheme));
  if (!task.solver.empty()) model.solver(method<InclusionSolver>(program.registry, task.solver));
  model.simulation.step *= part;
  Simulation simulation(model);
  Run out;
  out.report = simulation.run();
  out.checks = simulation.checks();
  return out;
}

/// Distance of a figure from the middle of its band, normalised to 1 at the edges.
double strain(const CheckResult& c) {
  const double half = 0.5 * (c.high - c.low), off = std::abs(c.got - 0.5 * (c.low + c.high));
  if (std::isnan(off)) return std::numeric_limits<double>::infinity();
  return half > 0.0 ? off / half : off > 0.0 ? 1e300 : 0.0;
}

std::string markText(const CheckResult& c) {
  std::string out = c.measure == "value" ? c.signal : c.measure + " " + c.signal;
  if (!c.over.empty() && c.over != "at the end") out += " " + c.over;
  return out + ": " + c.expected;
}

/// How far a figure lies outside of its band.
double miss(const CheckResult& c) { return std::max(c.low - c.got, c.got - c.high); }

/// One line for each missed check whose error bar reaches the expected band.
std::string errorBarText(Program& program, const StabilityScene& scene, const StabilityTask& task,
                         const Run& run) {
  const Run half = runOnce(program, scene, task, 0.5);
  std::string out;
  if (half.report.ended != RunReport::Ended::finished)
    return "error bar: with half the step the run ends early: " + half.report.reason + '\n';
  const std::vector<double> bars = errorBars(run.checks, half.checks);
  for (std::size_t i = 0; i < run.checks.size(); ++i) {
    const CheckResult& c = run.checks[i];
    if (c.pass || !(bars[i] >= miss(c))) continue;
    out +=
        fmt::format("error bar: {} = {:.6g} ± {:.2g} by a run with half the step\n",
                    c.measure == "value" ? c.signal : c.measure + " " + c.signal, c.got, bars[i]);
  }
  for (const Warning& w : half.report.warnings)
    out += "with half the step: " + w.kind + ": " + w.text + '\n';
  return out;
}

void judge(Program& program, const StabilityScene& scene, const StabilityTask& task, const Run& run,
           StabilityResult& out) {
  bool pass = run.report.ended == RunReport::Ended::finished;
  const CheckResult* worst = nullptr;
  for (const CheckResult& c : run.checks) {
    pass = pass && c.pass;
    if (worst == nullptr || strain(c) > strain(*worst)) worst = &c;
  }
  if (worst != nullptr) out.figure = worst->got, out.passMark = markText(*worst);
  out.steps = run.report.steps, out.cpu = run.report.cost.cpu;
  if (!run.report.reason.empty()) out.words += run.report.reason + '\n';
  for (const Warning& w : run.report.warnings) out.words += w.kind + ": " + w.text + '\n';
  if (pass) {
    out.verdict = Verdict::pass;
    return;
  }
  if (run.report.refused) {
    out.verdict = Verdict::refused;
    return;
  }
  if (out.words.empty()) out.words = errorBarText(program, scene, task, run);
  out.verdict = out.words.empty() ? Verdict::silent : Verdict::fail;
}

}  // namespace

std::string_view verdictText(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::refused:
      return "refused";
    case Verdict::fail:
      return "fail";
    case Verdict::silent:
      return "silent";
  }
  return "";
}

StabilityResult runCell(Program& program, const StabilityScene& scene, const StabilityTask& task) {
  StabilityResult out;
  judge(program, scene, task, runOnce(program, scene, task, 1.0), out);
  return out;
}

}  // namespace dynamy::app
