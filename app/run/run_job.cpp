#include "run/run_job.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/replay/replay_page.hpp>
#include <dynamy/io/replay/svg_plot.hpp>
#include <dynamy/io/run_files/packed_signals.hpp>
#include <dynamy/io/run_files/run_facts.hpp>
#include <dynamy/io/run_files/run_recording.hpp>
#include <set>

#include "run/endings.hpp"
#include "run/error_bar.hpp"
#include "run/progress.hpp"
#include "run/run_text.hpp"
#include "run/saver.hpp"

namespace dynamy::app {
namespace fs = std::filesystem;
namespace {

/// Writes signals.svg and replay.html from the files of the folder.
ReplaySize writePictures(const RunFolder& folder, const Model& model) {
  SignalTable table = readSignals(folder.signals());
  const std::vector<SignalName> named = recordedSignals(model);
  for (std::size_t i = 0; i < table.signals.size() && i < named.size(); ++i)
    table.signals[i].unit = named[i].unit;
  writeSignalsSvg(folder.signalsPlot(), table, model.title);
  return writeReplay(folder.path());
}

/// Puts signals.h5 in the place of signals.csv, in the list of the recorded files, too.
void pack(const RunFolder& folder, const Model& model, std::vector<RecordedFile>& files) {
  const RecordedFile packed = packSignals(folder, recordedSignals(model), model.title);
  for (RecordedFile& f : files)
    if (f.name == folder.signals().filename().string()) f = packed;
}

void print(const RunFolder& folder, const Model& model, const RunShow& show,
           const RunReport& report, const std::vector<CheckResult>& checks, const ReplaySize& size,
           const std::string& problems, long eventsLeftOut) {
  if (!show.quiet) fmt::print(stderr, "{}", thinningText(size));
  if (!show.quiet && eventsLeftOut > 0)
    fmt::print(stderr, "dynamy: events.csv has the first {} of {} events\n",
               EventsFile::kMostEvents, EventsFile::kMostEvents + eventsLeftOut);
  if (show.json)
    fmt::print("{}", readWholeFile(folder.facts()));
  else if (!show.quiet)
    fmt::print("{}{}", resultText(model, report, checks, folder.path()), problems);
  else
    fmt::print(stderr, "{}{}{}", failedChecks(checks), unsolvedText(report),
               warningsText(report, &show.accept));
  if (!show.quiet && !show.json) fmt::print("{}", qualifiedText(report, checks, show.accept));
  if (!report.reason.empty()) fmt::print(stderr, "dynamy: {}\n", report.reason);
}

}  // namespace

void writeFirstFacts(const RunFolder& folder, const Model& model, const RunChoice& choice,
                     const RunShow& show, const RunReport& report) {
  folder.writeFacts([&](JsonWriter& j) {
    writeRunFacts(j, model, report, {}, "running", choice.set);
    if (show.facts) show.facts(j);
  });
}

int conclude(const RunFolder& folder, const Model& model, const RunChoice& choice,
             const RunShow& show, const RunReport& report, const RunRecording& recording,
             const std::vector<CheckResult>& checks, RunEnd end) {
  const ProblemDump* problems = end.problems;
  if (end.fault.empty()) end.fault = recording.fault();
  std::optional<ErrorBars> bars;
  std::vector<RecordedFile> files = recording.files();
  const auto write = [&] {
    folder.writeLastFacts(
        [&](JsonWriter& j) {
          writeRunFacts(j, model, report, checks, stateText(report), choice.set);
          writeFiles(j, files);
          j.member("eventsLeftOut", recording.eventsLeftOut());
          if (show.facts) show.facts(j);
          if (!end.fault.empty()) j.member("fileFault", end.fault);
          if (problems) writeProblems(j, *problems);
          if (bars) writeErrorBars(j, *bars);
        },
        [&](JsonWriter& j) {
          j.member("state", stateText(report)).member("t", report.t);
          if (!report.reason.empty()) j.member("reason", report.reason);
        });
  };
  ReplaySize size;
  try {
    write();
    size = writePictures(folder, model);
  } catch (const WriteError& e) {
    if (end.fault.empty()) end.fault = e.what();
  }
  if (!end.fault.empty() && (end.status == kOk || end.status == kQualified))
    end.status = kCannotWrite;
  if (show.errorBars && end.fault.empty()) bars = show.errorBars(checks, folder.signals()), write();
  if (show.pack.value_or(model.record.packed) && end.fault.empty()) {
    try {
      pack(folder, model, files);
      write();
    } catch (const FileError& e) {
      end.fault = e.what();
      if (end.status == kOk || end.status == kQualified) end.status = kCannotWrite;
    }
  }
  if (show.tell)
    show.tell(report, checks);
  else
    print(folder, model, show, report, checks, size,
          problems ? problemsText(*problems, folder.problems()) : "", recording.eventsLeftOut());
  if (!end.fault.empty() && end.fault != report.reason)
    fmt::print(stderr, "dynamy: {}\n", end.fault);
  if (bars && !show.json && !show.quiet && !show.tell) fmt::print("{}", errorBarsText(*bars));
  return end.status;
}

namespace {

/// Starts as many threads as the system provides. Fewer threads do not change the results, so that
/// the run continues.
void startThreads(Simulation& simulation, const RunShow& show) {
  const int count = simulation.threads(show.threads);
  if (count < show.threads)
    fmt::print(stderr, "dynamy: the system gives {} of {} threads; the numbers are the same\n",
               count, show.threads);
}

void noteSources(const Program& program, const std::vector<fs::path>& files, RunChoice& choice) {
  choice.sources.clear();
  choice.loaded = program.plugins.fingerprints();
  std::set<fs::path> seen;
  std::error_code error;
  for (const PluginLoader::Loaded& l : program.plugins.loaded()) seen.insert(l.file);
  for (const fs::path& file : files)
    if (file.extension() != ".so" && fs::is_regular_file(file, error) &&
        seen.insert(fs::canonical(file)).second)
      choice.sources.push_back({file.string(), fingerprintOfBytes(readWholeFile(file))});
}

}  // namespace

Model chosenModel(Program& program, RunChoice& choice, std::vector<fs::path>* files, bool reduce) {
  LoadOptions options;
  std::vector<fs::path> read;
  options.reduce = reduce, options.until = choice.until;
  options.set = choice.set, options.files = files != nullptr ? files : &read;
  options.prepare = [&](Model& model) {
    if (choice.tolerance > 0.0) model.askTolerance(choice.tolerance);
    if (choice.step > 0.0 && choice.tolerance > 0.0)
      model.simulation.step = choice.step;  // the longest step
    else if (choice.step > 0.0)
      model.askStep(choice.step);
    if (!choice.integrator.empty())
      model.scheme(method<OneStep>(program.registry, choice.integrator));
    if (!choice.solver.empty())
      model.solver(method<InclusionSolver>(program.registry, choice.solver));
  };
  Model model = loadModel(choice.model, program.registry, program.plugins, options);
  SimulationSettings& s = model.simulation;
  if (choice.until > 0.0) s.until = choice.until;
  if (choice.every > 0.0) model.record.every = choice.every;
  // The default sample time depends on the end time; a resumed run keeps it.
  if (!(model.record.every > 0.0) && model.record.at.empty() && s.until > 0.0)
    model.record.every = s.until / 1000.0;
  choice.until = s.until, choice.every = model.record.every;
  choice.model = fs::absolute(choice.model).lexically_normal().string();
  noteSources(program, *options.files, choice);
  return model;
}

namespace {

/// Carries out a run in an existing folder, from the initial state or from a checkpoint.
int carryOut(const RunFolder& folder, Model& model, const RunChoice& choice, const RunShow& show,
             Simulation& simulation, RunRecording& recording, std::vector<CheckResult>& checks) {
  std::optional<ProblemDump> problems;
  if (show.dumpProblems >= 0)
    simulation.observe(problems.emplace(folder.problems(), show.dumpProblems));
  writeFirstFacts(folder, model, choice, show, simulation.report());

  const bool silent = show.quiet || show.json || show.tell;
  Progress progress(silent, simulation.state().t, model.simulation.until);
  Saver saver(folder, choice, model, recording);
  simulation.onIdle([&] {
    recording.flushIfDue();
    const StepReport& last = simulation.lastStep();
    progress.show({simulation.state().t, simulation.report().steps, last.contacts,
                   last.solved.residuals.largest(), simulation.report().solver.unconverged});
  });
  if (show.checkpoints)
    simulation.onCheckpoint(
        show.checkpointEvery, show.checkpointShare,
        [&](const std::string& bytes) { saver.save(bytes, simulation.state().t, true); });
  const EndingSignals signals;
  simulation.stopWhen(signals.requested());
  if (!silent) fmt::print("{}{}", headText(model, choice), show.explain ? reasonsText(model) : "");
  const RunReport& report = simulation.run();
  progress.end();

  // Write the files before printing, so that the printed result holds for them.
  recording.flush();
  if (show.checkpoints && !simulation.checkpoint().empty()) saver.saveLast(simulation);
  checks = simulation.checks();
  RunEnd end;
  end.status = report.ended == RunReport::Ended::stopped ? kSignalled + EndingSignals::signal()
                                                         : exitStatus(report, checks, show.accept);
  end.fault = saver.fault();
  if (problems) end.problems = &*problems;
  return conclude(folder, model, choice, show, report, recording, checks, std::move(end));
}

}  // namespace

int runInto(const fs::path& path, Model& model, const RunChoice& choice, const RunShow& show,
            std::vector<CheckResult>& checks) {
  if (show.strict) refuseInconsistentStart(model);
  Simulation simulation(model);  // first: if it throws, an older run in the folder stays
  const RunFolder folder(path);
  RunRecording recording(folder, model);
  simulation.record(recording);
  startThreads(simulation, show);
  writeWholeFile(folder.model(), model.file.text);
  return carryOut(folder, model, choice, show, simulation, recording, checks);
}

int resumeIn(RunFolder folder, Model& model, const RunChoice& choice, const RunShow& show,
             const Checkpoint& from, std::vector<CheckResult>& checks) {
  Simulation simulation(model);
  RunRecording recording(folder, model, RunRecording::Resume{});
  simulation.record(recording);
  startThreads(simulation, show);
  simulation.resume(from.simulation);
  std::error_code none;
  fs::remove(packedSignals(folder), none);  // signals.csv was made of it
  return carryOut(folder, model, choice, show, simulation, recording, checks);
}

}  // namespace dynamy::app
