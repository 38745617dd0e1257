/// Events outside of the program that end a run: signals of the system, a full disk.
#pragma once
#include <atomic>
#include <string>

namespace dynamy::app {

/// During the life of the object the first SIGINT, SIGTERM, SIGHUP or SIGXCPU sets requested(), and
/// the next one ends the program at once. Signals that were ignored before (nohup) stay ignored.
/// Only one object may exist at a time.
class EndingSignals {
 public:
  EndingSignals();
  ~EndingSignals();
  EndingSignals(const EndingSignals&) = delete;
  EndingSignals& operator=(const EndingSignals&) = delete;
  const std::atomic<bool>& requested() const;
  /// Number of the received signal; 0: none.
  static int signal();
};

/// "stopped by SIGTERM"; "stopped by the user" for Ctrl-C.
std::string stopText(int signal);

/// Ignores SIGXFSZ. A file that grows beyond the limit of the system then gives a write error, as
/// on a full disk, instead of ending the program.
void takeFileLimitsAsErrors();

}  // namespace dynamy::app
