/// How a run is ended from outside: signals of the system, a full disk.
#pragma once
#include <atomic>
#include <string>

namespace dynamy::app {

/// As long as it lives, the first SIGINT, SIGTERM, SIGHUP or SIGXCPU sets requested(), and
/// the next one ends the program at once. What was ignored before (nohup) stays ignored. One at a
/// time.
class EndingSignals {
 public:
  EndingSignals();
  ~EndingSignals();
  EndingSignals(const EndingSignals&) = delete;
  EndingSignals& operator=(const EndingSignals&) = delete;
  const std::atomic<bool>& requested() const;
  /// Number of the signal that came; 0: none.
  static int signal();
};

/// "stopped by SIGTERM"; "stopped by the user" for Ctrl-C.
std::string stopText(int signal);

/// A file that grows beyond what the system allows is then an error of its writer, as a full disk
/// is, and does not kill the program.
void takeFileLimitsAsErrors();

}  // namespace dynamy::app
