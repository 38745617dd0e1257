#include "processes.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <map>
#include <new>
#include <stdexcept>
#include <string>

namespace dynamy::app {
pid_t startProcess(const std::function<int()>& work) {
  const pid_t parent = ::getpid();
  std::fflush(nullptr);  // else the child writes the buffers a second time
  const pid_t child = ::fork();
  if (child < 0)
    throw std::runtime_error(std::string("cannot start a process: ") + std::strerror(errno));
  if (child > 0) return child;
  // Ctrl-C on the terminal reaches only the parent, which then kills its children.
  ::setpgid(0, 0);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // the parent died before the line above
  int status = 1;
  try {
    status = work();
  } catch (const std::bad_alloc&) {
    std::fputs("dynamy: out of memory\n", stderr);
    status = 71;
  } catch (const std::exception& e) {
    fmt::print(stderr, "dynamy: {}\n", e.what());
  }
  std::fflush(nullptr);
  ::_exit(status);
}

void inProcesses(std::size_t count, int jobs, const std::atomic<bool>& stop,
                 const std::function<int(std::size_t)>& work,
                 const std::function<void(std::size_t, int)>& ended) {
  // Where the caller ignores SIGCHLD, nobody would learn how a process ended.
  std::signal(SIGCHLD, SIG_DFL);
  std::map<pid_t, std::size_t> running;
  for (std::size_t next = 0;;) {
    while (!stop && next < count && running.size() < static_cast<std::size_t>(jobs)) {
      running.emplace(startProcess([&] { return work(next); }), next);
      ++next;
    }
    if (stop)
      for (const auto& [child, number] : running) ::kill(child, SIGKILL);
    if (running.empty()) return;
    int status = 0;
    const pid_t child = ::waitpid(-1, &status, 0);
    if (child < 0 && errno != EINTR)
      throw std::runtime_error(std::string("cannot wait for processes: ") + std::strerror(errno));
    const auto found = running.find(child);
    if (found == running.end()) continue;  // waitpid was interrupted by a signal
    const std::size_t number = found->second;
    running.erase(found);
    ended(number, status);
  }
}

std::string endText(int status) {
  if (WIFSIGNALED(status))
    return fmt::format("killed by signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)));
  return WEXITSTATUS(status) == 0 ? "" : fmt::format("exit status {}", WEXITSTATUS(status));
}

}  // namespace dynamy::app
