/// RunPatience: what a run to a tolerance may spend on locating before what is most expensive is
/// stepped in time (theory 50.7).
///
///   B = p max(B₀, b n),   up to time t of t_E:  B (1/2 + t/2t_E)
///
/// in evaluations of one velocity, with n velocities and the attribute p, `patience`. Work is counted
/// and not timed, so that a run repeats bit for bit. A run without an end, stepped by hand, has no
/// such bound.
#pragma once
#include <algorithm>
#include <dynamy/core/number_archive.hpp>
#include <limits>

namespace dynamy {

/// What RunPatience grants at present.
struct WorkAllowance {
  bool over = false;  ///< the run has spent more than it may up to now
  double rate = std::numeric_limits<double>::infinity();  ///< B/t_E, work a second [1/s]
  double end = std::numeric_limits<double>::infinity();   ///< of the run [s]
};

class RunPatience {
 public:
  /// end: of the run [s]; velocities: of the whole model.
  WorkAllowance allowance(double patience, double velocities, double t, double end) const;
  /// Work of so many visits of contacts by solvers, in problems of `rows` rows: a visit costs as much as
  /// one velocity (theory 37.7), and more among many rows.
  static double ofVisits(double visits, int rows) {
    return visits * std::max(1.0, rows / kFewRows);
  }
  void spend(double work) { spent_ += work; }
  void archive(NumberArchive& a) { a(spent_); }

 private:
  static constexpr double kFewRows = 80.0;
  double spent_ = 0.0;  // evaluations of one velocity, since the run began
};

/// Whether one island is among those that spend too much.
class WorkPace {
 public:
  /// Notes a step of length h [s] and its work. True: over a while the island has spent more than its
  /// share of what the run may.
  bool tooDear(double h, double work, const WorkAllowance& allowed);
  void archive(NumberArchive& a) { a(time_), a(work_); }

 private:
  double time_ = 0.0, work_ = 0.0;  // since the last check
};

}  // namespace dynamy
