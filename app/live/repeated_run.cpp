#include <fmt/format.h>

#include <cstdio>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/json_reader.hpp>
#include <dynamy/io/run_files/run_facts.hpp>

#include "build_text.hpp"
#include "live/driven_run.hpp"
#include "live/live_run.hpp"
#include "run/run_text.hpp"

namespace dynamy::app {
namespace {

/// What a live run was started with. Throws FileError if the facts are of another run.
RunChoice liveChoice(const JsonValue& facts, const RunFolder& folder) {
  const JsonValue& live = facts["live"];
  if (!live)
    throw FileError(folder.facts().string(),
                    "is of a run that nobody changed; dynamy run --live makes one that can be "
                    "repeated with what was done in it");
  RunChoice choice;
  choice.model = live["model"].text;
  choice.until = live["until"].value, choice.step = live["step"].value;
  choice.every = live["every"].value, choice.tolerance = live["tolerance"].value;
  choice.integrator = live["integrator"].text, choice.solver = live["solver"].text;
  for (const JsonValue& library : live["libraries"].items) choice.libraries.push_back(library.text);
  const JsonValue& set = live["set"];
  for (std::size_t i = 0; i < set.items.size(); ++i)
    choice.set.emplace_back(set.names[i], set.items[i].text);
  if (const std::string own = buildText(); live["program"].text != own)
    fmt::print(stderr,
               "dynamy: the run was made by another build ({}; this is {}): the last digits may "
               "differ\n",
               live["program"].text, own);
  return choice;
}

}  // namespace

int repeatRun(Program& program, const std::filesystem::path& from,
              const std::filesystem::path& path, const RunShow& show) {
  const RunFolder folder = RunFolder::existing(from);
  const std::string text = readWholeFile(folder.model());
  const JsonValue facts = readJson(readWholeFile(folder.facts()), folder.facts().string());
  program.load();
  addHands(program.registry);
  const RunChoice choice = liveChoice(facts, folder);
  const std::vector<Action> actions = readInputs(folder.path() / kInputsName);
  DrivenRun run(program, choice, path);
  if (run.model().file.text != text)
    throw ModelError(run.choice().model + " has changed since the run",
                     "the run's own model is " + folder.model().string());
  run.start(show);
  std::size_t next = 0;
  do {
    for (; next < actions.size() && actions[next].step <= run.steps(); ++next) {
      const Action& a = actions[next];
      const std::string refused = a.t == run.t() ? run.apply(a) : "the run is at another instant";
      if (!refused.empty())
        throw FileError((folder.path() / kInputsName).string() + ':' + std::to_string(next + 2),
                        fmt::format("cannot be repeated at step {}, t = {} s: {}", run.steps(),
                                    run.t(), refused));
    }
  } while (run.step());
  const int status = run.conclude(show);
  const std::string before = facts["hash"].text, now = hashText(run.report().hash);
  if (before == now) {
    if (!show.quiet && !show.json) fmt::print(" the same motion as {}\n", from.string());
    return status;
  }
  fmt::print(stderr, "dynamy: the motion is not that of {}: its hash is {}, not {}\n",
             from.string(), now, before.empty() ? "known" : before);
  return kFailed;
}

}  // namespace dynamy::app
