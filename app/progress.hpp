/// Progress of a run on standard error: a bar on a terminal, a line every ten seconds elsewhere.
#pragma once
#include <chrono>
#include <string>

namespace dynamy::app {

class Progress {
 public:
  explicit Progress(bool quiet);
  void show(double t, double until, long steps);
  /// Removes the bar.
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  bool quiet_, terminal_, shown_ = false;
  Clock::time_point start_, last_;
};

}  // namespace dynamy::app
