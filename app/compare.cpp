/// dynamy compare MODEL: error against work of schemes and step lengths on the user's own model.
///
///   error = max over recorded signals of |s(T) − s_ref(T)| / (max s_ref − min s_ref)
///
/// The reference is a run of this program, which the output names: the first scheme with an eighth
/// of the smallest step. It cannot show an error that all schemes share.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <dynamy/io/files/output_file.hpp>
#include <memory>

#include "run/run_job.hpp"

namespace dynamy::app {
namespace {

constexpr double kReferenceFactor = 8.0;

/// Keeps the last row and the ranges of all columns.
class Ends final : public RecordSink {
 public:
  void row(double, std::span<const double> values) override {
    last.assign(values.begin(), values.end());
    if (low.empty()) low = high = last;
    for (std::size_t i = 0; i < last.size(); ++i)
      low[i] = std::min(low[i], last[i]), high[i] = std::max(high[i], last[i]);
  }
  void frame(FilmInstant, std::span<const FramePose>, std::span<const ContactRecord>) override {}
  std::vector<double> last, low, high;
};

struct Point {
  std::string integrator;
  double step = 0.0, error = 0.0;
  std::string worst;  ///< signal with the largest error
  RunReport report;
  Ends ends;
};

struct CompareTask {
  RunChoice choice;
  std::vector<std::string> set, integrators, steps;
  std::string until, csv;
};

Point runOnce(Program& program, const CompareTask& task, const std::string& integrator, double step,
              std::vector<std::string>& signals) {
  Point p;
  p.integrator = integrator, p.step = step;
  RunChoice choice = task.choice;
  choice.integrator = integrator, choice.step = step;
  Model model = chosenModel(program, choice);
  model.record.framesPerSecond = 0.0;
  model.checks.clear();
  signals.clear();
  for (const NamedSignal* s : chooseSignals(model, model.record.signals, model.record.places))
    signals.push_back(s->name);
  if (p.integrator.empty()) p.integrator = model.scheme().type();
  p.step = model.simulation.step;
  Simulation simulation(model);
  simulation.record(p.ends);
  p.report = simulation.run();
  return p;
}

void measure(Point& p, const Point& reference, const std::vector<std::string>& signals) {
  // What stays constant, up to rounding, is compared with the largest number of all.
  constexpr double kRounding = 1e-14;
  double largest = 0.0;
  for (std::size_t i = 0; i < reference.ends.last.size(); ++i)
    largest =
        std::max({largest, std::abs(reference.ends.low[i]), std::abs(reference.ends.high[i])});
  p.error = p.report.ended == RunReport::Ended::finished ? 0.0 : std::nan("");
  for (std::size_t i = 0; i < p.ends.last.size() && !std::isnan(p.error); ++i) {
    const double range = reference.ends.high[i] - reference.ends.low[i];
    const double e = std::abs(p.ends.last[i] - reference.ends.last[i]);
    const double scale = range > kRounding * largest ? range : largest;
    const double relative = e == 0.0 ? 0.0 : scale > 0.0 ? e / scale : e;
    if (relative > p.error || i == 0) p.error = relative, p.worst = signals[i];
  }
}

void compare(Program& program, CompareTask& task) {
  program.load();
  task.choice.set = assignments(task.set);
  if (!task.until.empty()) task.choice.until = seconds(task.until, "--until");
  std::vector<double> steps;
  for (const std::string& s : task.steps) steps.push_back(seconds(s, "--steps"));
  if (task.integrators.empty()) task.integrators.emplace_back();
  std::vector<std::string> signals;
  if (steps.empty()) {  // the model's own step, halved three times
    RunChoice choice = task.choice;
    const double own = chosenModel(program, choice).simulation.step;
    if (!(own > 0.0)) throw ModelError("the model says no step", "give --steps 1e-3,1e-4");
    for (const double part : {1.0, 2.0, 4.0, 8.0}) steps.push_back(own / part);
  }
  const double tightest = *std::min_element(steps.begin(), steps.end()) / kReferenceFactor;
  const Point reference = runOnce(program, task, task.integrators.front(), tightest, signals);
  if (reference.report.ended != RunReport::Ended::finished)
    throw std::runtime_error("the reference run failed: " + reference.report.reason);

  fmt::print("reference: {}, step {:g} s (own, tightest), {:.3g} s of CPU time\n",
             reference.integrator, reference.step, reference.report.cost.cpu);
  fmt::print(
      "error: largest difference of a recorded signal at t = {:g} s, as a part of its range\n",
      reference.report.t);
  fmt::print(" {:<20} {:>10} {:>11} {:>10} {:>12} {:>12}  {}\n", "integrator", "step [s]", "error",
             "CPU [s]", "evaluations", "unconverged", "worst signal");
  std::string csv = "integrator,step,error,cpu_s,evaluations,iterations,unconverged,worst_signal\n";
  for (const std::string& integrator : task.integrators)
    for (const double step : steps) {
      Point p = runOnce(program, task, integrator, step, signals);
      measure(p, reference, signals);
      const RunReport& r = p.report;
      fmt::print(" {:<20} {:>10.4g} {:>11.3e} {:>10.3g} {:>12} {:>12}  {}\n", p.integrator, p.step,
                 p.error, r.cost.cpu, r.cost.evaluations, r.solver.unconverged, p.worst);
      csv += fmt::format("{},{},{},{},{},{},{},{}\n", p.integrator, p.step, p.error, r.cost.cpu,
                         r.cost.evaluations, r.solver.iterations, r.solver.unconverged, p.worst);
      if (r.ended == RunReport::Ended::failed) program.exitCode = kFailed;
    }
  std::filesystem::path file(task.csv);
  if (file.empty()) {
    file = defaultRunFolder(task.choice.model);
    file += "-compare.csv";
  }
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  writeWholeFile(file, csv);
  fmt::print(" wrote   {}\n", file.string());
}

}  // namespace

void addCompare(CLI::App& app, Program& program) {
  auto t = std::make_shared<CompareTask>();
  CLI::App* c = app.add_subcommand("compare", "error against work of schemes and steps on a model");
  c->add_option("MODEL", t->choice.model, "XML file")->required();
  c->add_option("--integrators", t->integrators, "schemes; default: the model's")
      ->delimiter(',')
      ->type_name("SCHEMES");
  c->add_option("--steps", t->steps, "step lengths; default: the model's and its halves")
      ->delimiter(',')
      ->type_name("TIMES");
  c->add_option("--until", t->until, "end time")->type_name("TIME");
  c->add_option("--solver", t->choice.solver, "inclusion solver")->type_name("SOLVER");
  c->add_option("--set", t->set, "value of a parameter")->type_name("NAME=VALUE");
  c->add_option("--csv", t->csv, "table as a file; default: runs/MODEL-compare.csv")
      ->type_name("FILE");
  addPlugins(*c, program);
  c->callback([t, &program] { compare(program, *t); });
}

}  // namespace dynamy::app
