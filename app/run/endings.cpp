#include "run/endings.hpp"

#include <array>
#include <csignal>
#include <cstring>

namespace dynamy::app {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP, SIGXCPU};

// A signal handler can only use objects that live as long as the program.
std::atomic<bool>& flag() {
  static std::atomic<bool> value{false};
  return value;
}
std::atomic<int>& number() {
  static std::atomic<int> value{0};
  return value;
}
std::array<struct sigaction, kSignals.size()>& before() {
  static std::array<struct sigaction, kSignals.size()> value{};
  return value;
}

extern "C" void onSignal(int which) {
  number() = which, flag() = true;
  for (const int s : kSignals) {
    struct sigaction now {};
    // The next signal of any kind ends the program at once. Only SIGXCPU is ignored from now on,
    // because the system repeats it every second.
    if (::sigaction(s, nullptr, &now) == 0 && now.sa_handler == onSignal)
      std::signal(s, s == SIGXCPU ? SIG_IGN : SIG_DFL);
  }
}

}  // namespace

EndingSignals::EndingSignals() {
  flag() = false, number() = 0;  // constructs them before a handler may need them
  struct sigaction action {};
  action.sa_handler = onSignal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  // Block all signals in the handler: a second signal waits until the handler of the first is done.
  for (const int s : kSignals) sigaddset(&action.sa_mask, s);
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    ::sigaction(kSignals[i], nullptr, &before()[i]);
    if (before()[i].sa_handler != SIG_IGN) ::sigaction(kSignals[i], &action, nullptr);
  }
}

EndingSignals::~EndingSignals() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &before()[i], nullptr);
}

const std::atomic<bool>& EndingSignals::requested() const { return flag(); }

int EndingSignals::signal() { return number(); }

std::string stopText(int signal) {
  if (signal == 0 || signal == SIGINT) return "stopped by the user";
  const char* const name = ::sigabbrev_np(signal);
  return std::string("stopped by SIG") + (name != nullptr ? name : "");
}

void takeFileLimitsAsErrors() { std::signal(SIGXFSZ, SIG_IGN); }

}  // namespace dynamy::app
