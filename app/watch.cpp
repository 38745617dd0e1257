#include "watch.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <map>
#include <stdexcept>
#include <thread>

#include "processes.hpp"
#include "program.hpp"

namespace dynamy::app {
namespace fs = std::filesystem;
namespace {

constexpr auto kPause = std::chrono::milliseconds(250);

std::atomic<bool>& interrupted() {
  static std::atomic<bool> flag{false};
  return flag;
}
extern "C" void onWatchInterrupt(int) { interrupted() = true; }

/// Identifies a state of a file; equal for all files that do not exist.
struct Stamp {
  bool there = false;
  std::uintmax_t size = 0;
  fs::file_time_type time;
  bool operator==(const Stamp&) const = default;
};

Stamp stampOf(const fs::path& file) {
  std::error_code error;
  Stamp s;
  s.there = fs::exists(file, error);
  if (!s.there) return s;
  s.size = fs::file_size(file, error);
  s.time = fs::last_write_time(file, error);
  return s;
}

/// One run, and the files that it has reported.
class Watched {
 public:
  Watched(std::map<fs::path, Stamp> files, const std::function<int(const TellFiles&)>& run)
      : files_(std::move(files)) {
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0)
      throw std::runtime_error(std::string("cannot watch: ") + std::strerror(errno));
    in_ = pipe[0];
    ::fcntl(in_, F_SETFL, O_NONBLOCK);
    child_ = startProcess([&] {
      return withErrorsTold([&] {
        return run([&pipe](const std::vector<fs::path>& named) {
          std::string text;
          for (const fs::path& file : named) text += fs::absolute(file).string() + '\n';
          for (std::size_t at = 0; at < text.size();) {
            const ssize_t n = ::write(pipe[1], text.data() + at, text.size() - at);
            if (n <= 0) return;
            at += static_cast<std::size_t>(n);
          }
        });
      });
    });
    ::close(pipe[1]);
  }
  ~Watched() {
    end(SIGKILL);
    ::close(in_);
  }
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;

  /// The first file that has changed; empty: none.
  fs::path changed() {
    takeNames();
    for (auto& [file, stamp] : files_)
      if (stampOf(file) != stamp) return file;
    return {};
  }
  /// The present state of all files.
  std::map<fs::path, Stamp> now() const {
    std::map<fs::path, Stamp> out;
    for (const auto& [file, stamp] : files_) out[file] = stampOf(file);
    return out;
  }
  bool running() {
    if (child_ > 0 && ::waitpid(child_, &status_, WNOHANG) == child_) child_ = -1;
    return child_ > 0;
  }
  void end(int signal) {
    if (!running()) return;
    ::kill(child_, signal);
    ::waitpid(child_, &status_, 0);
    child_ = -1;
  }
  int status() const { return status_; }
  std::size_t files() const { return files_.size(); }

 private:
  void takeNames() {
    std::array<char, 4096> bytes{};
    for (ssize_t n = 0; (n = ::read(in_, bytes.data(), bytes.size())) > 0;)
      names_.append(bytes.data(), static_cast<std::size_t>(n));
    for (std::size_t end = 0; (end = names_.find('\n')) != std::string::npos;) {
      const fs::path file = fs::path(names_.substr(0, end)).lexically_normal();
      names_.erase(0, end + 1);
      files_.try_emplace(file, stampOf(file));
    }
  }
  std::map<fs::path, Stamp> files_;
  std::string names_;
  int in_ = -1, status_ = 0;
  pid_t child_ = -1;
};

}  // namespace

int watch(const std::string& model, const std::function<int(const TellFiles&)>& run) {
  struct sigaction action {};
  action.sa_handler = onWatchInterrupt;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
  const fs::path first = fs::absolute(model).lexically_normal();
  std::map<fs::path, Stamp> files{{first, stampOf(first)}};
  while (!interrupted()) {
    Watched watched(files, run);
    bool told = false;
    fs::path changed;
    while (!interrupted() && changed.empty()) {
      std::this_thread::sleep_for(kPause);
      changed = watched.changed();
      if (told || watched.running()) continue;
      told = true;
      if (const std::string how = endText(watched.status()); how.starts_with("killed"))
        fmt::print(stderr, "dynamy: the run was {}\n", how);
      fmt::print(stderr, " waiting for a change of {} files; Ctrl-C ends\n", watched.files());
    }
    if (interrupted()) {
      watched.end(SIGINT);
      break;
    }
    // An editor or a linker may still be writing: wait until two successive states are equal.
    for (files = watched.now();;) {
      std::this_thread::sleep_for(kPause);
      auto later = watched.now();
      if (later == files) break;
      files = std::move(later);
    }
    watched.end(SIGKILL);
    fmt::print(stderr, "\n {} has changed\n", changed.filename().string());
  }
  return kOk;
}

}  // namespace dynamy::app
