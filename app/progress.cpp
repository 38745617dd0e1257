#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace dynamy::app {
namespace {
constexpr int kWidth = 28;
constexpr auto kQuietFor = std::chrono::seconds(10);
}  // namespace

Progress::Progress(bool quiet)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0), start_(Clock::now()), last_(start_) {}

void Progress::show(double t, double until, long steps) {
  const auto now = Clock::now();
  if (quiet_ || (!terminal_ && now - last_ < kQuietFor)) return;
  last_ = now;
  const double wall = std::chrono::duration<double>(now - start_).count();
  if (!terminal_) {
    fmt::print(stderr, "t = {:.6g} of {:.6g} s, {} steps, {:.0f} s wall\n", t, until, steps, wall);
    return;
  }
  const double part = until > 0.0 ? std::clamp(t / until, 0.0, 1.0) : 1.0;
  const auto full = static_cast<std::size_t>(part * kWidth);
  fmt::print(stderr, "\r [{}{}] {:.3f} s   {} steps   {:.1f} s wall ", std::string(full, '#'),
             std::string(kWidth - full, ' '), t, steps, wall);
  std::fflush(stderr);
  shown_ = true;
}

void Progress::end() {
  if (shown_) fmt::print(stderr, "\r{:78}\r", "");
  shown_ = false;
}

}  // namespace dynamy::app
