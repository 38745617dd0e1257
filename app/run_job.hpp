/// A run into its folder: what `run` and `resume` share.
#pragma once
#include <dynamy/io/run_folder.hpp>
#include <dynamy/simulation/simulation.hpp>
#include <functional>
#include <optional>

#include "program.hpp"

namespace dynamy::app {

struct ErrorBars;

/// What decides the numbers of a run, as said on the command line; stored in the checkpoint.
struct RunChoice {
  std::string model;  ///< path
  std::vector<std::pair<std::string, std::string>> set;
  double until = 0.0, step = 0.0;  ///< [s]; 0: as the model says
  double every = 0.0;              ///< [s]; 0: as the model says
  double tolerance = 0.0;          ///< 0: as the model says
  std::string integrator, solver;  ///< empty: as the model says
  std::vector<std::string> libraries;
  void archive(Archive& a);
};

/// How it is shown.
struct RunShow {
  bool json = false, quiet = false;
  double checkpointEvery = 0.0;  ///< [s] of wall time; 0: only at the end
  /// A second run with half the step, or a tenth of the tolerance: what it says about the checks
  /// and the recorded signals in that file. Empty: none.
  std::function<ErrorBars(const std::vector<CheckResult>&, const std::filesystem::path&)> errorBars;
  int threads = 1;        ///< the same numbers with any
  int dumpProblems = -1;  ///< inclusion problems to write; −1: none, not even unsolved ones
  /// Gets the result instead of a person: nothing is printed then.
  std::function<void(const RunReport&, const std::vector<CheckResult>&)> tell;
};

/// The model with all choices applied; `choice` gets absolute path, end time and sample time.
/// `files` gets those that were read (LoadOptions). Throws ModelError.
Model chosenModel(Program& program, RunChoice& choice,
                  std::vector<std::filesystem::path>* files = nullptr);

/// Runs `model` into the folder `path`, from `checkpoint` if it is given, and prints the result.
/// Returns the exit code; `checks` receives their results. Throws FileError.
int runInto(const std::filesystem::path& path, Model& model, const RunChoice& choice,
            const RunShow& show, const std::optional<std::string>& checkpoint,
            std::vector<CheckResult>& checks);

/// A checkpoint file in parts. Throws FileError, ModelError.
struct Checkpoint {
  RunChoice choice;
  std::string modelText, simulation;
};
Checkpoint readCheckpoint(const std::filesystem::path& file);

}  // namespace dynamy::app
