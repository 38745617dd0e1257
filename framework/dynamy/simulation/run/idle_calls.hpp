/// IdleCalls: a function that is called about ten times a second of wall time between steps.
#pragma once
#include <chrono>
#include <functional>
#include <utility>

namespace dynamy {

class IdleCalls {
 public:
  using Clock = std::chrono::steady_clock;
  void call(std::function<void()> function) { function_ = std::move(function); }
  /// Begins a run: the first call is 0.1 s later.
  void begin(Clock::time_point now) { last_ = now; }
  /// Calls the function if the last call was 0.1 s ago or more.
  void at(Clock::time_point now) {
    if (!function_ || std::chrono::duration<double>(now - last_).count() < kSeconds) return;
    last_ = now;
    function_();
  }

 private:
  static constexpr double kSeconds = 0.1;
  std::function<void()> function_;
  Clock::time_point last_;
};

}  // namespace dynamy
