/// Measures one solver on one problem at one level, the same way for every program of this folder.
///
///   solve until √(Σ|r_c − P_K(r_c − û_c)|²)/|q| ≤ level, recomputed from r; then repeat and time
///
/// Every measurement runs in a child process: a crash, a call of exit() or a solver that does not
/// look at the clock costs one entry of the table and not the run. Rejected: threads, which cannot
/// be stopped from outside.
#pragma once
#include <dynamy/io/fclib/fclib_file.hpp>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace dynamy::bench {

/// CPU time of this thread [s]. Not that of the process, which Linux counts in ticks while a timer
/// of CPU time is armed; the solvers measured have one thread.
double cpuSeconds();

/// What a solver says about its own run.
struct Said {
  bool content = false;  ///< it believes to have reached its tolerance
  int iterations = 0;
  int newton = 0;  ///< Newton steps among them, if it tells
};

/// A solver in the hands of the stopwatch.
class Candidate {
 public:
  virtual ~Candidate() = default;
  /// Makes `count` solvers that have not solved anything yet; not timed.
  virtual void prepare(double tolerance, int count) = 0;
  /// Solver k improves r; timed. `until`: CPU time at which no more work is wanted [s].
  virtual Said solve(int k, Eigen::VectorXd& r, double until) = 0;
  /// True: a solver may solve twice.
  virtual bool again() const { return true; }
};

enum class Outcome : int { solved, notReached, limit, crashed };

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// One line of the table.
struct Measurement {
  Outcome outcome = Outcome::crashed;
  int iterations = 0, newton = 0;
  int solves = 0;           ///< how many were timed
  double coldSeconds = 0;   ///< CPU time of a solve by a fresh solver
  double againSeconds = 0;  ///< CPU time of a solve by a solver that has solved this problem before
  double tolerance = 0;     ///< asked of the solver; below the level if its measure is looser
  double residual = kUnknown;           ///< measure of FCLIB of the answer
  double rounding = kUnknown;           ///< how much of that may be rounding
  double start = kUnknown;              ///< the same of r = 0
  double Ef = kUnknown, Eu = kUnknown;  ///< of the answer
};

struct Limits {
  double solveSeconds = 10.0;  ///< CPU time of one solve
  double loopSeconds = 0.2;    ///< CPU time over which solves are repeated
};

/// The measure of FCLIB, written down apart from the solvers; plain complementarity problems too.
double measureOfFclib(const FclibProblem& local, const Eigen::VectorXd& r);

/// How much of it may be rounding of u = W r + q: 4ε ‖|W||r| + |q|‖ / ‖q‖. With a W of condition
/// 1e10 it exceeds 1e-12, and the exact solution fails where an accident passes.
double roundingOfMeasure(const FclibProblem& local, const Eigen::VectorXd& r);

/// Tightens the tolerance up to four times while the solver is content too early, then times it.
Measurement measured(const std::function<std::unique_ptr<Candidate>()>& make,
                     const FclibProblem& local, double level, const Limits& limits);

/// Arguments shared by the programs: [--limit S] [--loop S] [--levels a,b] [--only NAME,NAME]
/// FILE…
struct Job {
  Limits limits;
  std::vector<double> levels = {1e-4, 1e-8, 1e-12};
  std::vector<std::string> only;  ///< empty: all
  std::vector<std::filesystem::path> files;
  bool wants(const std::string& solver) const;
};
Job jobOf(int argc, char** argv);

/// A named way to make candidates for a problem; null: not meant for this problem.
struct Entry {
  std::string name;
  std::function<std::unique_ptr<Candidate>(const FclibProblem& local)> make;
};

/// Runs all entries on all files of the job and writes the table. A solver that fails at a level is
/// not asked for the tighter ones.
void run(const Job& job, const std::string& program, const std::vector<Entry>& entries,
         std::ostream& out);

}  // namespace dynamy::bench
