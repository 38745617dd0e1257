/// The exit status of a run, for scripts: 0 only if a run is what its model asks for.
#pragma once
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/report/checks.hpp>
#include <dynamy/simulation/report/run_report.hpp>

#include "program.hpp"

namespace dynamy::app {

/// Kinds of warnings that a caller takes for good.
struct Accepted {
  bool all = false;
  std::vector<std::string> kinds;
  bool takes(const std::string& kind) const;
};

/// Declares --accept[=KIND,…]; `text` gets what is said.
void addAccept(CLI::App& command, std::string& text);
/// "" none, "all", or kinds separated by commas. Throws CLI::ValidationError for a word that is no
/// kind of warning that qualifies a run.
Accepted accepted(const std::string& text);

/// kOutOfMemory, kCannotWrite where that ended it, kFailed if the run ended early or a check
/// failed; else kQualified if a warning says that the run is not what the model asks for, and is
/// not accepted; else kOk.
int exitStatus(const RunReport& report, const std::vector<CheckResult>& checks,
               const Accepted& accepted);

/// The kinds, each once, of the warnings that qualify the run and are not accepted: "unsolved,
/// overlap"; empty: none.
std::string qualifyingKinds(const RunReport& report, const Accepted& accepted,
                            const std::string& separator = ", ");

/// For --strict: throws ModelError with all warnings about the start of a built model (bodies that
/// joints do not allow to be where they are, or to move as they do).
void refuseInconsistentStart(Model& model);

}  // namespace dynamy::app
