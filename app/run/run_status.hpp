/// The exit status of a run, for scripts: 0 only if the run fulfils the requirements of its model.
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/report/checks.hpp>
#include <dynamy/simulation/report/run_report.hpp>

#include "program.hpp"

namespace dynamy::app {

/// Kinds of warnings that the user accepts.
struct Accepted {
  bool all = false;
  std::vector<std::string> kinds;
  bool takes(const std::string& kind) const;
};

/// Declares the option --accept[=KIND,…]; `text` receives its value.
void addAccept(CLI::App& command, std::string& text);
/// Reads the value of --accept: "" (none), "all", or kinds separated by commas. Throws
/// CLI::ValidationError for a word that is not a kind of qualifying warning.
Accepted accepted(const std::string& text);

/// Exit status of a run: kOutOfMemory or kCannotWrite if that ended the run; else kFailed if the
/// run ended early or a check failed; else kQualified if a qualifying warning is not accepted; else
/// kOk.
int exitStatus(const RunReport& report, const std::vector<CheckResult>& checks,
               const Accepted& accepted);

/// The kinds, each once, of the warnings that qualify the run and are not accepted, as in
/// "unsolved, overlap"; empty if there are none.
std::string qualifyingKinds(const RunReport& report, const Accepted& accepted,
                            const std::string& separator = ", ");

/// For --strict: throws ModelError with all warnings about the initial state of a built model,
/// which report positions and velocities that violate joints.
void refuseInconsistentStart(Model& model);

}  // namespace dynamy::app
