/// One cell of the stability matrix: a scene, a scheme, a solver, a step and the verdict.
///
///   pass      all <check>s of the scene hold
///   refused   the program reports that this scheme or solver does not admit the scene, and why
///   fail      a check is missed, and the run's own report says that it cannot be trusted: the run
///             ended early, has a warning, or has an error bar that reaches the expected result
///   silent    a check is missed, but the report says that all is well
///
/// The error bar of a figure is twice its change when the step is halved, which is its error for a
/// scheme of order one. It is computed only if a check is missed and the run reports no fault.
#pragma once
#include <dynamy/core/archive.hpp>
#include <string_view>

#include "program.hpp"

namespace dynamy::app {

struct StabilityScene {
  std::string name, title, about;
  std::string text;           ///< the model; its step is the parameter dt
  std::vector<double> steps;  ///< [s]
  double quickStep = 0.0;     ///< [s], 0: not in the quick part
};

/// The scenes in the order of catalogue.txt. They are those of the program (bench/stability) if
/// `folder` is empty, else those of a folder of the user with such a file beside its models. Throws
/// FileError, std::runtime_error.
std::vector<StabilityScene> stabilityScenes(const std::string& folder);

enum class Verdict { pass, refused, fail, silent };
std::string_view verdictText(Verdict verdict);

/// The run of one cell.
struct StabilityTask {
  int scene = 0;
  std::string scheme, solver;  ///< with attributes, as --integrator and --solver take them
  double step = 0.0;           ///< [s]
  bool ofSchemes = false;      ///< belongs to the part: all schemes, one solver
  bool ofSolvers = false;      ///< belongs to the part: one scheme, all solvers
};

/// The result of one cell.
struct StabilityResult {
  Verdict verdict = Verdict::fail;
  double figure = 0.0;   ///< of the check that is farthest from the middle of its band
  std::string passMark;  ///< "ball.z at the end: 1 ± 1e-3"
  std::string words;     ///< reason and warnings of the run, one line each
  long steps = 0;
  double cpu = 0.0;  ///< [s]
  void archive(Archive& a) { a(verdict), a(figure), a(passMark), a(words), a(steps), a(cpu); }
};

/// Runs one cell. Throws ModelError if the scene itself is faulty.
StabilityResult runCell(Program& program, const StabilityScene& scene, const StabilityTask& task);

/// Runs every task in a separate process, `jobs` at once, so that a cell that crashes or does not
/// end within `limit` seconds of CPU time affects no other cell. `done` is called after each cell.
std::vector<StabilityResult> runCells(Program& program, const std::vector<StabilityScene>& scenes,
                                      const std::vector<StabilityTask>& tasks, int jobs,
                                      double limit, const std::function<void(std::size_t)>& done);

}  // namespace dynamy::app
