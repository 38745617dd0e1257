/// dynamy run MODEL, dynamy resume DIR.
#include <fmt/format.h>

#include <memory>

#include "error_bar.hpp"
#include "run_job.hpp"
#include "watch.hpp"

namespace dynamy::app {
namespace {

/// Texts of options until they are read.
struct Texts {
  std::string until, step, checkpoint, out;
  std::vector<std::string> set;
  RunChoice choice;
  RunShow show;
  bool watch = false, errorBar = false;
};

void addShow(CLI::App& command, Texts& t) {
  command.add_flag("--json", t.show.json, "print the content of run.json, nothing else");
  command.add_flag("--quiet", t.show.quiet, "print errors only");
  command
      .add_option("--dump-problems", t.show.dumpProblems,
                  "write the N inclusion problems with the most iterations, and all that were not "
                  "solved, to DIR/problems, for dynamy solve")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber);
  command
      .add_option("--threads", t.show.threads,
                  "threads that work on a step of many contacts; the same numbers with any")
      ->type_name("N")
      ->check(CLI::Range(1, 64));
  command.add_option("--checkpoint", t.checkpoint, "write a checkpoint every TIME of wall time")
      ->type_name("TIME");
}

double given(const std::string& text, const std::string& option) {
  return text.empty() ? 0.0 : seconds(text, option);
}

/// `tell` gets the files that were read, also if the model is faulty.
int run(Program& program, Texts& t, const TellFiles& tell) {
  std::vector<std::filesystem::path> files;
  for (const std::string& library : program.libraries)
    for (const auto& file : program.plugins.candidates(library, ".")) files.push_back(file);
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
      t.out.empty() ? RunFolder::defaultPath(t.choice.model) : std::filesystem::path(t.out);
  std::vector<CheckResult> checks;
  if (t.errorBar)
    t.show.errorBars = [&](const std::vector<CheckResult>& whole,
                           const std::filesystem::path& signals) {
      return errorBars(program, t.choice, whole, signals);
    };
  return runInto(folder, *model, t.choice, t.show, std::nullopt, checks);
}

}  // namespace

void addRun(CLI::App& app, Program& program) {
  auto t = std::make_shared<Texts>();
  CLI::App* c = app.add_subcommand("run", "simulate a model; results go to a folder");
  c->add_option("MODEL", t->choice.model, "XML file")->required();
  c->add_option("--until", t->until, "end time, replaces the model's")->type_name("TIME");
  c->add_option("--step", t->step, "step length, replaces the model's")->type_name("TIME");
  c->add_option("--tolerance", t->choice.tolerance,
                "accuracy, replaces the model's; the program chooses the steps")
      ->type_name("NUMBER")
      ->check(CLI::PositiveNumber);
  c->add_option("--integrator", t->choice.integrator,
                "scheme, replaces the model's; with attributes: \"ThetaMethod theta=1\"")
      ->type_name("SCHEME");
  c->add_option("--solver", t->choice.solver, "inclusion solver, replaces the model's")
      ->type_name("SOLVER");
  c->add_option("--set", t->set, "value of a parameter")->type_name("NAME=VALUE");
  c->add_option("--out", t->out, "folder of the results; default: runs/MODEL")->type_name("DIR");
  c->add_option("--plugin", program.libraries, "shared library with further types")
      ->type_name("LIBRARY");
  c->add_flag("--error-bar", t->errorBar,
              "run again with half the step, or a tenth of the tolerance, and say how far the "
              "figures of the checks and the recorded signals move");
  addShow(*c, *t);
  c->add_flag("--watch", t->watch,
              "run again whenever the model, what it includes or one of its plug-ins changes");
  c->callback([t, &program] {
    t->choice.until = given(t->until, "--until");
    t->choice.step = given(t->step, "--step");
    t->show.checkpointEvery = given(t->checkpoint, "--checkpoint");
    for (const std::string& s : t->set) t->choice.set.push_back(assignment(s));
    t->choice.libraries = program.libraries;
    program.exitCode =
        t->watch
            ? watch(t->choice.model, [&](const TellFiles& tell) { return run(program, *t, tell); })
            : run(program, *t, [](const auto&) {});
  });
}

void addResume(CLI::App& app, Program& program) {
  auto t = std::make_shared<Texts>();
  CLI::App* c =
      app.add_subcommand("resume", "go on with a run, bit for bit as if it had not been stopped");
  c->add_option("DIR", t->out, "folder of the run")->required();
  c->add_option("--until", t->until, "new end time")->type_name("TIME");
  addShow(*c, *t);
  c->callback([t, &program] {
    const double until = given(t->until, "--until");
    t->show.checkpointEvery = given(t->checkpoint, "--checkpoint");
    const RunFolder folder = RunFolder::existing(t->out);
    Checkpoint from = readCheckpoint(folder.checkpoint());
    if (until > 0.0) from.choice.until = until;
    program.libraries = from.choice.libraries;
    program.load();
    Model model = chosenModel(program, from.choice);
    if (model.sourceText != from.modelText)
      throw ModelError(from.choice.model + " has changed since the run",
                       "the run's own model is " + folder.model().string());
    std::vector<CheckResult> checks;
    program.exitCode = runInto(folder.path(), model, from.choice, t->show, from.simulation, checks);
  });
}

}  // namespace dynamy::app
