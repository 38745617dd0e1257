/// How far the recorded signals of two runs of one model are apart, and how fast that grows.
#pragma once
#include <dynamy/io/run_files/signals_file.hpp>

namespace dynamy {

struct SignalDifference {
  std::string name;
  double end = 0.0;               ///< at the last common instant, of the first run
  double difference = 0.0;        ///< there
  double largest = 0.0, t = 0.0;  ///< the largest difference and when [s]
};

struct RunDifference {
  std::vector<SignalDifference> signals;
  /// Growth rate of the differences in the second half of the run, or of its part before they reach
  /// kLost: the slope of ln d(t), d = largest of all signals so far, each over its range [1/s].
  double growth = 0.0;
  /// Differences grow exponentially: by more than e⁶ in that time at that rate, while a power of t
  /// up to the fourth gives less.
  bool chaotic = false;
  /// When d reaches kLost: met in the run, or, if it is chaotic, by the rate [s]; else infinity. A
  /// jump that comes sooner or later by less than a row, of a status or a velocity, is no loss.
  double horizon = 0.0;
  static constexpr double kLost = 0.1;
};

/// Both at the instants that both have. Differences below `noise` of a signal's range are none.
RunDifference runDifference(const SignalTable& a, const SignalTable& b, double noise = 1e-14);

}  // namespace dynamy
