/// Progress on standard error: one line that is replaced on a terminal, a line every ten seconds
/// elsewhere.
#pragma once
#include <chrono>
#include <string>

namespace dynamy::app {

/// The line itself.
class StatusLine {
 public:
  explicit StatusLine(bool quiet);
  /// Whether a text would be shown now; saves making one.
  bool due() const;
  /// `part` of the whole is done, 0 … 1.
  void show(double part, const std::string& text);
  /// Removes the line.
  void end();
  double seconds() const;  ///< since the beginning [s]

 private:
  using Clock = std::chrono::steady_clock;
  bool quiet_, terminal_, shown_ = false;
  Clock::time_point start_, last_;
};

/// What a run tells about itself while it goes on.
struct RunState {
  double t = 0.0;  ///< [s]
  long steps = 0;
  int contacts = 0;       ///< of the last step
  double residual = 0.0;  ///< of its inclusion
  long unsolved = 0;      ///< steps that missed the tolerance so far
};

/// Progress of a run: time, steps, real-time factor, contacts, residual, time to go.
class Progress {
 public:
  /// From time `begin` to `until` [s].
  Progress(bool quiet, double begin, double until) : line_(quiet), begin_(begin), until_(until) {}
  void show(const RunState& s);
  void end() { line_.end(); }

 private:
  StatusLine line_;
  double begin_, until_;
};

/// "4.2 s", "3 min 20 s", "5 h 12 min"
std::string durationText(double seconds);

}  // namespace dynamy::app
