/// How much the recorded signals of two runs of one model differ, and how fast the difference
/// grows.
#pragma once
#include <dynamy/io/run_files/signals_file.hpp>

namespace dynamy {

struct SignalDifference {
  std::string name;
  double end = 0.0;               ///< value in the first run at the last common instant
  double difference = 0.0;        ///< at the last common instant
  double largest = 0.0, t = 0.0;  ///< the largest difference and when [s]
};

struct RunDifference {
  std::vector<SignalDifference> signals;
  /// Growth rate of the differences [1/s]: the slope of ln d(t), where d is the largest difference
  /// of all signals so far, each over its range. It is taken in the second half of the run, or of
  /// the part before d reaches kLost.
  double growth = 0.0;
  /// True if the differences grow exponentially: by more than e⁶ in that time at that rate. A power
  /// of t up to the fourth gives less.
  bool chaotic = false;
  /// Time at which d reaches kLost [s]: observed in the run or, if it is chaotic, extrapolated by
  /// the rate; otherwise infinity. A jump of a status or a velocity that is shifted by less than a
  /// row does not count.
  double horizon = 0.0;
  static constexpr double kLost = 0.1;
};

/// Compares both at their common instants. Differences below `noise` times the range of a signal
/// count as zero, and so do those of signals that are rounding: constant beside the largest of all.
RunDifference runDifference(const SignalTable& a, const SignalTable& b, double noise = 1e-14);

}  // namespace dynamy
