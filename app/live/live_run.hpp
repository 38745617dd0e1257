/// dynamy run --live and --repeat: a run that a person watches and changes in the browser, and the
/// same run once more.
#pragma once
#include <string>

#include "program.hpp"
#include "run/run_job.hpp"

namespace dynamy::app {

/// Runs a model while the browser shows it. The run waits for the page, keeps to the pace that the
/// page sets, and carries out its commands between two steps. `browser`: open the page; otherwise
/// only its address is printed. Returns the exit status.
int runLive(Program& program, const RunChoice& choice, const std::filesystem::path& folder,
            const RunShow& show, bool browser);

/// Runs what was run in the folder `from` once more, with the same actions before the same steps,
/// and compares the hashes. Returns the exit status, 1 if the motions differ. Throws FileError.
int repeatRun(Program& program, const std::filesystem::path& from,
              const std::filesystem::path& folder, const RunShow& show);

}  // namespace dynamy::app
