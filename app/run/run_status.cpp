#include "run/run_status.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/simulation/report/consistent_start.hpp>
#include <dynamy/simulation/report/run_watch.hpp>
#include <sstream>

namespace dynamy::app {
namespace {

std::vector<std::string> qualifying() {
  std::vector<std::string> out;
  for (const WarningKind& k : warningKinds())
    if (k.says == Says::qualifies) out.emplace_back(k.name);
  return out;
}

}  // namespace

bool Accepted::takes(const std::string& kind) const {
  return all || std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

void addAccept(CLI::App& command, std::string& text) {
  command
      .add_flag("--accept{all}", text,
                "exit with 0 instead of 3 if a warning qualifies the result; --accept=KIND,... for "
                "warnings of these kinds only")
      ->type_name("KINDS");
}

Accepted accepted(const std::string& text) {
  Accepted out;
  if (text.empty() || text == "false") return out;
  out.all = text == "all" || text == "true";
  const std::vector<std::string> known = qualifying();
  std::istringstream in(out.all ? "" : text);
  for (std::string kind; std::getline(in, kind, ',');) {
    if (std::find(known.begin(), known.end(), kind) == known.end())
      throw CLI::ValidationError(
          "--accept",
          "no kind of warning \"" + kind + "\" qualifies a run — " + unknownNameHint(kind, known));
    out.kinds.push_back(kind);
  }
  return out;
}

int exitStatus(const RunReport& report, const std::vector<CheckResult>& checks,
               const Accepted& accepted) {
  if (report.cause == RunReport::Cause::memory) return kOutOfMemory;
  if (report.cause == RunReport::Cause::files) return kCannotWrite;
  bool good = report.ended == RunReport::Ended::finished;
  for (const CheckResult& c : checks) good = good && c.pass;
  if (!good) return kFailed;
  return qualifyingKinds(report, accepted).empty() ? kOk : kQualified;
}

std::string qualifyingKinds(const RunReport& report, const Accepted& accepted,
                            const std::string& separator) {
  std::string out;
  std::vector<std::string> seen;
  for (const Warning& w : report.warnings) {
    if (says(w) != Says::qualifies || accepted.takes(w.kind)) continue;
    if (std::find(seen.begin(), seen.end(), w.kind) != seen.end()) continue;
    out += (seen.empty() ? "" : separator) + w.kind, seen.push_back(w.kind);
  }
  return out;
}

void refuseInconsistentStart(Model& model) {
  MechanicalSystem system = model.mechanicalSystem();
  State x = model.initialState();
  system.evaluate(x);
  const StartReport start = makeConsistent(model, system, x);
  std::vector<Diagnostic> all;
  for (const Warning& w : startWarnings(start, model.length())) {
    Diagnostic d;
    d.place = Place(model.file.name);
    d.text = w.kind + ": " + w.text;
    d.hint = "without --strict the run starts all the same and says so";
    all.push_back(std::move(d));
  }
  if (!all.empty()) throw ModelError(all);
}

}  // namespace dynamy::app
