/// Runs a model into a run folder; shared by `run` and `resume`.
#pragma once
#include <dynamy/io/run_files/checkpoint.hpp>
#include <dynamy/io/run_files/run_folder.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <functional>
#include <optional>

#include "run/run_status.hpp"

namespace dynamy {
class ProblemDump;
}

namespace dynamy::app {

struct ErrorBars;

/// Options of a run that do not change its numbers: output, checkpoints, threads.
struct RunShow {
  bool json = false, quiet = false;
  bool explain = false;  ///< print why joints are coordinates or constraints, and what may sleep
  bool checkpoints = true;
  double checkpointEvery = 10.0;  ///< least interval of checkpoints [s] of wall time
  double checkpointShare = 0.02;  ///< largest share of the wall time that they may take
  /// Makes a second run with half the step or a tenth of the tolerance, and returns the error bars
  /// of the checks and of the signals recorded in the given file. Empty: no second run.
  std::function<ErrorBars(const std::vector<CheckResult>&, const std::filesystem::path&)> errorBars;
  bool strict = false;       ///< refuse an initial state that violates joints
  Accepted accept;           ///< warnings that leave the exit status at 0
  int threads = 1;           ///< any number gives the same results
  std::optional<bool> pack;  ///< true: signals become HDF5 at the end; empty: as the model says
  int dumpProblems = -1;     ///< number of problems to write; −1: none, not even unsolved ones
  /// Writes further members of run.json; empty: none.
  std::function<void(JsonWriter&)> facts;
  /// Receives the result; if it is set, nothing is printed.
  std::function<void(const RunReport&, const std::vector<CheckResult>&)> tell;
};

/// The model with all choices applied. `choice` receives the absolute path, the end time, the
/// sample time and the fingerprints of the files that were read. `files` receives all files that
/// were searched for, `reduce` is as there (LoadOptions). Throws ModelError.
Model chosenModel(Program& program, RunChoice& choice,
                  std::vector<std::filesystem::path>* files = nullptr, bool reduce = true);

/// Writes run.json of a run that begins.
void writeFirstFacts(const RunFolder& folder, const Model& model, const RunChoice& choice,
                     const RunShow& show, const RunReport& report);

/// How a run ended, in addition to its report.
struct RunEnd {
  int status = kOk;                       ///< exit status, unless a file cannot be written
  std::string fault;                      ///< why a file could not be written; empty: none
  const ProblemDump* problems = nullptr;  ///< dumped problems; null: none
};

/// Writes run.json and the pictures of a run that has ended, and prints its result. Returns the exit
/// status.
int conclude(const RunFolder& folder, const Model& model, const RunChoice& choice,
             const RunShow& show, const RunReport& report, const RunRecording& recording,
             const std::vector<CheckResult>& checks, RunEnd end);

/// Runs `model` into the folder `path` and prints the result. Returns the exit code; `checks`
/// receives their results. Throws FileError.
int runInto(const std::filesystem::path& path, Model& model, const RunChoice& choice,
            const RunShow& show, std::vector<CheckResult>& checks);

/// Continues a run from a checkpoint of its folder. `choice` is that of the checkpoint, except for
/// the end time. Throws ModelError if the checkpoint does not belong to the model, and FileError.
int resumeIn(RunFolder folder, Model& model, const RunChoice& choice, const RunShow& show,
             const Checkpoint& from, std::vector<CheckResult>& checks);

}  // namespace dynamy::app
