/// Progress on standard error: on a terminal one line that is replaced, elsewhere a new line every
/// ten seconds.
#pragma once
#include <chrono>
#include <string>

namespace dynamy::app {

/// The line of progress on standard error.
class StatusLine {
 public:
  explicit StatusLine(bool quiet);
  /// True if show() would print now; lets the caller avoid formatting an unused text.
  bool due() const;
  /// Shows a bar and `text`; `part` is the completed fraction, 0 … 1.
  void show(double part, const std::string& text);
  /// Removes the line.
  void end();
  double seconds() const;  ///< since the beginning [s]

 private:
  using Clock = std::chrono::steady_clock;
  bool quiet_, terminal_, shown_ = false;
  Clock::time_point start_, last_;
};

/// Figures of a run in progress.
struct RunState {
  double t = 0.0;  ///< [s]
  long steps = 0;
  int contacts = 0;       ///< contacts of the last step
  double residual = 0.0;  ///< residual of the inclusion of the last step
  long unsolved = 0;      ///< steps so far that missed the tolerance
};

/// Progress of a run: time, steps, real-time factor, contacts, residual, time to go.
class Progress {
 public:
  /// Progress of a run from time `begin` to `until` [s].
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
