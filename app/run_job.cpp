#include "run_job.hpp"

#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <dynamy/io/file_error.hpp>
#include <dynamy/io/model_loader.hpp>
#include <dynamy/io/replay_page.hpp>
#include <dynamy/io/run_recording.hpp>
#include <dynamy/io/svg_plot.hpp>

#include "error_bar.hpp"
#include "progress.hpp"
#include "run_text.hpp"

namespace dynamy::app {
namespace fs = std::filesystem;
namespace {

/// Set by Ctrl-C; a second Ctrl-C ends the program at once.
std::atomic<bool>& interrupted() {
  static std::atomic<bool> flag{false};
  return flag;
}

extern "C" void onInterrupt(int) {
  interrupted() = true;
  std::signal(SIGINT, SIG_DFL);
}

std::string checkpointBytes(const RunChoice& choice, const std::string& modelText,
                            const std::string& simulation) {
  Archive a;
  a.section("dynamy run 1");
  RunChoice c = choice;
  std::string text = modelText, state = simulation;
  a(c), a(text), a(state);
  return a.bytes();
}

/// signals.svg and replay.html from the files of the folder.
ReplaySize writePictures(const RunFolder& folder, const Model& model) {
  SignalTable table = readSignals(folder.signals());
  const std::vector<SignalName> named = recordedSignals(model);
  for (std::size_t i = 0; i < table.signals.size() && i < named.size(); ++i)
    table.signals[i].unit = named[i].unit;
  writeSignalsSvg(folder.signalsPlot(), table, model.title);
  return writeReplay(folder.path());
}

int exitCode(const RunReport& report, const std::vector<CheckResult>& checks) {
  bool good = report.ended == RunReport::Ended::finished;
  for (const CheckResult& c : checks) good = good && c.pass;
  return good ? kOk : kFailed;
}

void print(const RunFolder& folder, const Model& model, const RunShow& show,
           const RunReport& report, const std::vector<CheckResult>& checks, const ReplaySize& size,
           const std::string& problems) {
  if (!show.quiet) fmt::print(stderr, "{}", thinningText(size));
  if (show.json)
    fmt::print("{}", readWholeFile(folder.facts()));
  else if (!show.quiet)
    fmt::print("{}{}", resultText(model, report, checks, folder.path()), problems);
  else
    fmt::print(stderr, "{}{}", failedChecks(checks), unsolvedText(report));
  if (report.ended == RunReport::Ended::failed) fmt::print(stderr, "dynamy: {}\n", report.reason);
}

/// run.json, pictures and words of a run that has ended.
void conclude(const RunFolder& folder, const Model& model, const RunChoice& choice,
              const RunShow& show, const RunReport& report, const std::vector<CheckResult>& checks,
              const ProblemDump* problems) {
  std::optional<ErrorBars> bars;
  const auto write = [&] {
    folder.writeFacts([&](JsonWriter& j) {
      writeFacts(j, model, choice, report, checks, "");
      if (problems) writeProblems(j, *problems);
      if (bars) writeErrorBars(j, *bars);
    });
  };
  write();
  const ReplaySize size = writePictures(folder, model);
  if (show.errorBars) bars = show.errorBars(checks, folder.signals()), write();
  if (show.tell)
    show.tell(report, checks);
  else
    print(folder, model, show, report, checks, size,
          problems ? problemsText(*problems, folder.problems()) : "");
  if (bars && !show.json && !show.quiet && !show.tell) fmt::print("{}", errorBarsText(*bars));
}

}  // namespace

void RunChoice::archive(Archive& a) {
  std::vector<std::string> names, values;
  for (const auto& [name, value] : set) names.push_back(name), values.push_back(value);
  a(model), a(names), a(values), a(until), a(step), a(tolerance), a(every), a(integrator),
      a(solver);
  a(libraries);
  set.clear();
  for (std::size_t i = 0; i < names.size() && i < values.size(); ++i)
    set.emplace_back(names[i], values[i]);
}

Model chosenModel(Program& program, RunChoice& choice, std::vector<fs::path>* files) {
  LoadOptions options;
  options.set = choice.set, options.files = files;
  Model model = loadModel(choice.model, program.registry, program.plugins, options);
  SimulationSettings& s = model.simulation;
  if (choice.until > 0.0) s.until = choice.until;
  if (choice.tolerance > 0.0) model.askTolerance(choice.tolerance);
  if (choice.step > 0.0 && choice.tolerance > 0.0)
    s.step = choice.step;  // the longest
  else if (choice.step > 0.0)
    model.askStep(choice.step);
  if (choice.every > 0.0) model.record.every = choice.every;
  if (!choice.integrator.empty())
    model.scheme(method<OneStep>(program.registry, choice.integrator));
  if (!choice.solver.empty())
    model.solver(method<InclusionSolver>(program.registry, choice.solver));
  // The default sample time depends on the end time; a resumed run keeps it.
  if (!(model.record.every > 0.0) && s.until > 0.0) model.record.every = s.until / 1000.0;
  choice.until = s.until, choice.every = model.record.every;
  choice.model = fs::absolute(choice.model).lexically_normal().string();
  return model;
}

int runInto(const fs::path& path, Model& model, const RunChoice& choice, const RunShow& show,
            const std::optional<std::string>& checkpoint, std::vector<CheckResult>& checks) {
  Simulation simulation(model);  // first: a model it refuses leaves an older run alone
  const RunFolder folder = checkpoint ? RunFolder::existing(path) : RunFolder(path);
  std::optional<RunRecording> recording;
  if (checkpoint)
    recording.emplace(folder, model, RunRecording::Resume{});
  else
    recording.emplace(folder, model);
  simulation.record(*recording);
  simulation.threads(show.threads);
  if (checkpoint)
    simulation.resume(*checkpoint);
  else
    writeWholeFile(folder.model(), model.sourceText);
  std::optional<ProblemDump> problems;
  if (show.dumpProblems >= 0)
    simulation.observe(problems.emplace(folder.problems(), show.dumpProblems));
  RunReport running = simulation.report();
  folder.writeFacts([&](JsonWriter& j) { writeFacts(j, model, choice, running, {}, "running"); });

  const bool silent = show.quiet || show.json || show.tell;
  Progress progress(silent, simulation.state().t, model.simulation.until);
  const auto save = [&](const std::string& bytes) {
    writeWholeFile(folder.checkpoint(), checkpointBytes(choice, model.sourceText, bytes));
  };
  simulation.onIdle([&] {
    recording->flushIfDue();
    const StepReport& last = simulation.lastStep();
    progress.show({simulation.state().t, simulation.report().steps, last.contacts,
                   last.solved.residuals.largest(), simulation.report().unconverged});
  });
  simulation.onCheckpoint(show.checkpointEvery, save);
  interrupted() = false;
  simulation.stopWhen(interrupted());
  const auto before = std::signal(SIGINT, onInterrupt);
  if (!silent) fmt::print("{}", headText(model, choice));
  const RunReport& report = simulation.run();
  std::signal(SIGINT, before);
  progress.end();

  // Files first: what is printed is then true.
  recording->flush();
  if (!simulation.checkpoint().empty()) save(simulation.checkpoint());
  checks = simulation.checks();
  conclude(folder, model, choice, show, report, checks, problems ? &*problems : nullptr);
  return exitCode(report, checks);
}

Checkpoint readCheckpoint(const fs::path& file) {
  if (!fs::exists(file))
    throw FileError(
        file.parent_path().string(),
        "holds no checkpoint: the run ended before its first one (--checkpoint says how "
        "often); run the model again");
  Archive a(readWholeFile(file));
  Checkpoint c;
  a.section("dynamy run 1");
  a(c.choice), a(c.modelText), a(c.simulation);
  return c;
}

}  // namespace dynamy::app
