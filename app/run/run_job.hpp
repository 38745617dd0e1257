/// A run into its folder: what `run` and `resume` share.
#pragma once
#include <dynamy/io/run_files/checkpoint.hpp>
#include <dynamy/io/run_files/run_folder.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <functional>
#include <optional>

#include "run/run_status.hpp"

namespace dynamy::app {

struct ErrorBars;

/// How it is shown.
struct RunShow {
  bool json = false, quiet = false;
  bool checkpoints = true;
  double checkpointEvery = 10.0;  ///< [s] of wall time,
  double checkpointShare = 0.02;  ///< or longer, so that they take no more of it than this
  /// A second run with half the step, or a tenth of the tolerance: what it says about the checks
  /// and the recorded signals in that file. Empty: none.
  std::function<ErrorBars(const std::vector<CheckResult>&, const std::filesystem::path&)> errorBars;
  bool strict = false;    ///< a start that joints do not allow is refused
  Accepted accept;        ///< warnings that leave the exit status at 0
  int threads = 1;        ///< the same numbers with any
  int dumpProblems = -1;  ///< inclusion problems to write; −1: none, not even unsolved ones
  /// Gets the result instead of a person: nothing is printed then.
  std::function<void(const RunReport&, const std::vector<CheckResult>&)> tell;
};

/// The model with all choices applied; `choice` gets absolute path, end time, sample time
/// and the fingerprints of what was read; `files` gets all that was looked for (LoadOptions).
/// Throws ModelError.
Model chosenModel(Program& program, RunChoice& choice,
                  std::vector<std::filesystem::path>* files = nullptr);

/// Runs `model` into the folder `path` and prints the result. Returns the exit code; `checks`
/// receives their results. Throws FileError.
int runInto(const std::filesystem::path& path, Model& model, const RunChoice& choice,
            const RunShow& show, std::vector<CheckResult>& checks);

/// The same from a checkpoint of the folder; `choice` is that of the checkpoint, but for the end
/// time. Throws ModelError if the checkpoint does not belong to the model, FileError.
int resumeIn(RunFolder folder, Model& model, const RunChoice& choice, const RunShow& show,
             const Checkpoint& from, std::vector<CheckResult>& checks);

}  // namespace dynamy::app
