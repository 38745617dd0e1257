/// One cell of the stability matrix: a scene, a scheme, a solver and a step, and the verdict.
///
///   pass      all <check>s of the scene hold
///   refused   the program says that this scheme or solver does not admit the scene, and why
///   fail      a check is missed, and the run's own report says that it cannot be trusted: it ended
///             early, warns, or its error bar reaches what should have come out
///   silent    a check is missed while the report says that all is well
///
/// The error bar of a figure is twice its change when the step is halved, which is its error for a
/// scheme of order one. It is asked for only where nothing else tells.
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

/// The scenes in the order of catalogue.txt: of the program itself (bench/stability), or of a
/// folder of the user's with such a file beside its models. Throws FileError, std::runtime_error.
std::vector<StabilityScene> stabilityScenes(const std::string& folder);

enum class Verdict { pass, refused, fail, silent };
std::string_view verdictText(Verdict verdict);

/// What is run.
struct StabilityTask {
  int scene = 0;
  std::string scheme, solver;  ///< with attributes, as --integrator and --solver take them
  double step = 0.0;           ///< [s]
  bool ofSchemes = false;      ///< in the part schemes × one solver
  bool ofSolvers = false;      ///< in the part one scheme × solvers
};

/// What came of it.
struct StabilityResult {
  Verdict verdict = Verdict::fail;
  double figure = 0.0;   ///< of the check that is missed by most, or met by least
  std::string passMark;  ///< "ball.z at the end: 1 ± 1e-3"
  std::string words;     ///< what the report says, a line each
  long steps = 0;
  double cpu = 0.0;  ///< [s]
  void archive(Archive& a) { a(verdict), a(figure), a(passMark), a(words), a(steps), a(cpu); }
};

/// Runs one cell. Throws ModelError where the scene itself is at fault.
StabilityResult runCell(Program& program, const StabilityScene& scene, const StabilityTask& task);

/// Runs the tasks in `jobs` processes of their own, so that a cell that crashes or does not end
/// within `limit` seconds of CPU time is one bad cell. `done` is called after each.
std::vector<StabilityResult> runCells(Program& program, const std::vector<StabilityScene>& scenes,
                                      const std::vector<StabilityTask>& tasks, int jobs,
                                      double limit, const std::function<void(std::size_t)>& done);

}  // namespace dynamy::app
