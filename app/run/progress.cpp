#include "run/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <dynamy/core/utf8.hpp>

namespace dynamy::app {
namespace {

constexpr int kBarWidth = 16;
constexpr auto kQuietFor = std::chrono::seconds(10);
constexpr auto kRefresh = std::chrono::milliseconds(90);

/// Number of columns of the terminal. A longer line would be repeated instead of replaced.
int columns() {
  winsize size{};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

}  // namespace

StatusLine::StatusLine(bool quiet)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0), start_(Clock::now()), last_(start_) {}

bool StatusLine::due() const {
  return !quiet_ && Clock::now() - last_ >= (terminal_ ? Clock::duration(kRefresh) : kQuietFor);
}

void StatusLine::show(double part, const std::string& text) {
  if (!due()) return;
  last_ = Clock::now();
  if (!terminal_) {
    fmt::print(stderr, "{:.0f} %   {}\n", 100.0 * part, text);
    return;
  }
  const auto full = static_cast<std::size_t>(std::clamp(part, 0.0, 1.0) * kBarWidth);
  std::string line =
      fmt::format(" [{}{}] {}", std::string(full, '#'), std::string(kBarWidth - full, ' '), text);
  // Shorten a long line at its end, but never inside a character.
  while (characterCount(line) >= columns()) {
    while ((static_cast<unsigned char>(line.back()) & 0xc0) == 0x80) line.pop_back();
    line.pop_back();
  }
  fmt::print(stderr, "\r\x1b[K{}", line);
  std::fflush(stderr);
  shown_ = true;
}

void StatusLine::end() {
  if (shown_) fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
  shown_ = false;
}

double StatusLine::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Progress::show(const RunState& s) {
  if (!line_.due()) return;
  const double wall = line_.seconds(), way = until_ - begin_;
  const double part = way > 0.0 ? (s.t - begin_) / way : 1.0;
  std::string text = fmt::format("t = {:.4g} of {:.4g} s", s.t, until_);
  if (part > 0.0 && part < 1.0) text += "   " + durationText(wall * (1.0 - part) / part) + " to go";
  if (wall > 0.0) text += fmt::format("   x{:.3g}", (s.t - begin_) / wall);
  text +=
      fmt::format("   {} steps   {} contacts   residual {:.1e}", s.steps, s.contacts, s.residual);
  if (s.unsolved > 0) text += fmt::format("   {} NOT SOLVED", s.unsolved);
  line_.show(part, text);
}

std::string durationText(double seconds) {
  if (!(seconds < 60.0)) {
    const auto s = static_cast<long>(std::min(std::round(seconds), 1e15));
    return s < 3600 ? fmt::format("{} min {} s", s / 60, s % 60)
                    : fmt::format("{} h {} min", s / 3600, s / 60 % 60);
  }
  return fmt::format("{:.{}f} s", seconds, seconds < 10.0 ? 1 : 0);
}

}  // namespace dynamy::app
