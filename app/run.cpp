/// dynamy run MODEL, dynamy resume DIR.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/run_files/packed_signals.hpp>
#include <memory>

#include "build_text.hpp"
#include "live/live_run.hpp"
#include "numbers.hpp"
#include "paths.hpp"
#include "run/error_bar.hpp"
#include "run/run_job.hpp"
#include "watch.hpp"

namespace dynamy::app {
namespace {

/// Options of run and resume as texts, before they are converted.
struct Texts {
  std::string until, step, checkpoint, out, accept, repeat, signals;
  std::vector<std::string> set;
  RunChoice choice;
  RunShow show;
  bool watch = false, errorBar = false, noCheckpoint = false, anyBuild = false;
  bool live = false, noBrowser = false;
};

void addShow(CLI::App& command, Texts& t) {
  command.add_flag("--json", t.show.json, "print the content of run.json, nothing else");
  command.add_flag("--quiet", t.show.quiet, "print errors and warnings only");
  command.add_flag("--explain", t.show.explain,
                   "say why joints are coordinates or constraints, and which bodies may sleep");
  command
      .add_option("--dump-problems", t.show.dumpProblems,
                  "write the N inclusion problems with the most iterations, and all that were not "
                  "solved, to DIR/problems, for dynamy solve")
      ->type_name("N")
      ->check(wholeNumber(0));
  command
      .add_option("--threads", t.show.threads,
                  "threads that work on a step of many contacts; the same numbers with any")
      ->type_name("N")
      ->check(wholeNumber(1, 64));
  command
      .add_option(
          "--signals", t.signals,
          "format of the recorded signals, replaces the model's: csv, or hdf5 for long runs")
      ->type_name("FORMAT")
      ->check([](const std::string& text) {
        return text == "csv" || text == "hdf5" ? std::string()
                                               : '"' + text +
                                                     "\" is no format, which are csv and hdf5; "
                                                     "which signals are recorded stands "
                                                     "in the model: <record signals=\"…\"/>";
      });
  addAccept(command, t.accept);
  auto* every = command.add_option("--checkpoint", t.checkpoint,
                                   "write a checkpoint every TIME of wall time; default: 10 s, "
                                   "less often where that took more than 2 % of it");
  every->type_name("TIME");
  command.add_flag("--no-checkpoint", t.noCheckpoint, "write none: the run cannot be resumed")
      ->excludes(every);
}

/// Reads the options for what is written, and how often.
void readShow(Texts& t) {
  t.show.accept = accepted(t.accept);
  if (!t.signals.empty()) t.show.pack = t.signals == "hdf5";
  t.show.checkpoints = !t.noCheckpoint;
  if (t.checkpoint.empty()) return;
  t.show.checkpointEvery = seconds(t.checkpoint, "--checkpoint");
  t.show.checkpointShare = 1.0;  // as often as the user wants
}

double given(const std::string& text, const std::string& option) {
  return text.empty() ? 0.0 : seconds(text, option);
}

/// Runs a model. `tell` receives the files that were read, also if the model is faulty.
int run(Program& program, Texts& t, const TellFiles& tell) {
  std::vector<std::filesystem::path> files;
  for (const std::string& library : program.libraries)
    for (const auto& file : program.plugins.candidates(library)) files.push_back(file);
  std::optional<Model> model;
  try {
    program.load();
    model = chosenModel(program, t.choice, &files);
  } catch (const ModelError&) {
    tell(files);
    throw;
  }
  tell(files);
  const auto folder =
      t.out.empty() ? defaultRunFolder(t.choice.model) : std::filesystem::path(t.out);
  std::vector<CheckResult> checks;
  if (t.errorBar)
    t.show.errorBars = [&](const std::vector<CheckResult>& whole,
                           const std::filesystem::path& signals) {
      return errorBars(program, t.choice, whole, signals);
    };
  return runInto(folder, *model, t.choice, t.show, checks);
}

/// Runs a model in the browser, or what was done in such a run once more.
int runByHand(Program& program, Texts& t) {
  if (t.live) {
    const auto folder =
        t.out.empty() ? defaultRunFolder(t.choice.model) : std::filesystem::path(t.out);
    return runLive(program, t.choice, folder, t.show, !t.noBrowser);
  }
  std::filesystem::path from = std::filesystem::path(t.repeat).lexically_normal();
  if (!from.has_filename()) from = from.parent_path();
  std::filesystem::path folder = t.out;
  if (t.out.empty()) folder = from, folder += "_repeated";
  std::error_code none;
  if (std::filesystem::equivalent(from, folder, none))
    throw FileError(t.out, "is the run that is to be repeated: choose another --out");
  return repeatRun(program, from, folder, t.show);
}

/// Compares the fingerprints of files or libraries in a checkpoint with the present ones. Throws
/// FileError if one differs.
void compare(const std::vector<Fingerprint>& then, const std::vector<Fingerprint>& now,
             const std::string& what, const std::string& hint) {
  for (std::size_t i = 0; i < std::max(then.size(), now.size()); ++i) {
    const bool both = i < then.size() && i < now.size();
    if (both && then[i].fingerprint == now[i].fingerprint) continue;
    const std::string& name = i < then.size() ? then[i].name : now[i].name;
    throw FileError(what + ' ' + name, "is not what the run was made with — " + hint);
  }
}

int resume(Program& program, Texts& t, double until) {
  RunFolder folder = RunFolder::resumed(t.out);
  // A run keeps the format of its signals.
  if (std::error_code none; !t.show.pack && std::filesystem::exists(packedSignals(folder), none))
    t.show.pack = true;
  unpackSignals(folder);
  FoundCheckpoint found = findCheckpoint(folder);
  Checkpoint& from = found.checkpoint;
  if (!found.note.empty())
    fmt::print(stderr, "dynamy: {}; the run goes on from the checkpoint before it, of t = {:g} s\n",
               found.note, from.t);
  program.load();
  if (const std::string own = buildText(); from.program != own && !t.anyBuild)
    throw FileError(t.out, "was begun by another build of dynamY (" + from.program + "; this is " +
                               own +
                               ") — go on with that one, or with --any-build, which may change "
                               "the last digits");
  RunChoice choice = from.choice;
  if (until > 0.0) choice.until = until;
  // Load the libraries that were given to the run. A path that the user gives now takes precedence
  // over the stored name.
  for (const Fingerprint& library : from.choice.loaded)
    if (std::count(choice.libraries.begin(), choice.libraries.end(), library.name) > 0)
      program.plugins.load(library, program.registry);
  for (const std::string& library : program.libraries)
    if (std::count(choice.libraries.begin(), choice.libraries.end(), nameOfLibrary(library)) == 0)
      choice.libraries.push_back(nameOfLibrary(library));
  Model model = chosenModel(program, choice);
  if (model.file.text != from.modelText)
    throw ModelError(choice.model + " has changed since the run",
                     "the run's own model is " + folder.model().string());
  compare(from.choice.sources, choice.sources, "file", "bring it back as it was then");
  compare(from.choice.loaded, choice.loaded, "library",
          "name the right one with --plugin, or put it into a folder of DYNAMY_PLUGIN_PATH");
  keepOnly(folder, found);
  std::vector<CheckResult> checks;
  return resumeIn(std::move(folder), model, choice, t.show, from, checks);
}

/// Declares --live, --no-browser and --repeat.
void addByHand(CLI::App& c, Texts& t, CLI::Option* model) {
  CLI::Option* live = c.add_flag("--live", t.live,
                                 "show the run in the browser while it computes: pause it, change "
                                 "parameters, pull bodies; what was done is recorded");
  c.add_flag("--no-browser", t.noBrowser, "with --live: only print the address of the page")
      ->needs(live);
  CLI::Option* repeat = c.add_option("--repeat", t.repeat,
                                     "run what was run live in the folder DIR once more, with all "
                                     "that was done, and compare the hashes");
  repeat->type_name("DIR")->check(someName());
  for (const char* other : {"--watch", "--error-bar", "--dump-problems", "--signals"})
    c.get_option(other)->excludes(live)->excludes(repeat);
  repeat->excludes(live)->excludes(model);
  for (const char* other :
       {"--until", "--step", "--tolerance", "--integrator", "--solver", "--set"})
    repeat->excludes(c.get_option(other));
}

}  // namespace

void addRun(CLI::App& app, Program& program) {
  auto t = std::make_shared<Texts>();
  CLI::App* c = app.add_subcommand("run", "simulate a model; results go to a folder");
  CLI::Option* model = c->add_option("MODEL", t->choice.model, "XML file");
  c->add_option("--until", t->until, "end time, replaces the model's")->type_name("TIME");
  CLI::Option* step =
      c->add_option("--step", t->step, "step length, replaces the model's")->type_name("TIME");
  c->add_option("--tolerance", t->choice.tolerance,
                "accuracy, replaces the model's; the program chooses the steps")
      ->type_name("NUMBER")
      ->check(positiveNumber())
      ->excludes(step);
  c->add_option("--integrator", t->choice.integrator,
                "scheme, replaces the model's; with attributes: \"ThetaMethod theta=1\"")
      ->type_name("SCHEME");
  c->add_option("--solver", t->choice.solver, "inclusion solver, replaces the model's")
      ->type_name("SOLVER");
  c->add_option("--set", t->set, "value of a parameter")->type_name("NAME=VALUE");
  c->add_option("--out", t->out, "folder of the results; default: runs/MODEL")
      ->type_name("DIR")
      ->check(someName());
  addPlugins(*c, program);
  c->add_flag("--strict", t->show.strict,
              "refuse a start that joints do not allow, instead of projecting it");
  c->add_flag("--error-bar", t->errorBar,
              "run again with half the step, or a tenth of the tolerance, and say how far the "
              "figures of the checks and the recorded signals move");
  addShow(*c, *t);
  c->add_flag("--watch", t->watch,
              "run again whenever the model, what it includes or one of its plug-ins changes");
  addByHand(*c, *t, model);
  c->callback([t, &program] {
    if (t->choice.model.empty() && t->repeat.empty()) throw CLI::RequiredError("MODEL");
    t->choice.until = given(t->until, "--until");
    t->choice.step = given(t->step, "--step");
    readShow(*t);
    t->choice.set = assignments(t->set);
    t->choice.libraries = program.libraries;
    program.exitCode =
        t->live || !t->repeat.empty() ? runByHand(program, *t)
        : t->watch
            ? watch(t->choice.model, [&](const TellFiles& tell) { return run(program, *t, tell); })
            : run(program, *t, [](const auto&) {});
  });
}

void addResume(CLI::App& app, Program& program) {
  auto t = std::make_shared<Texts>();
  CLI::App* c =
      app.add_subcommand("resume", "continue a run, bit for bit as if it had not been stopped");
  c->add_option("DIR", t->out, "folder of the run")->required();
  c->add_option("--until", t->until, "new end time")->type_name("TIME");
  addPlugins(*c, program);
  c->add_flag(
      "--any-build", t->anyBuild,
      "continue with another build of dynamY than that of the run: the last digits may differ");
  addShow(*c, *t);
  c->callback([t, &program] {
    const double until = given(t->until, "--until");
    readShow(*t);
    program.exitCode = resume(program, *t, until);
  });
}

}  // namespace dynamy::app
