#include "precision/precision_output.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <ctime>
#include <stdexcept>

#include "processes.hpp"

namespace dynamy::app {
namespace {

/// CPU time that a process has used so far [s]; 0 if it has ended.
double cpuTimeOf(pid_t process) {
  clockid_t clock = 0;
  timespec t{};
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &t) != 0) return 0.0;
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

// Rejected: RLIMIT_CPU, because with it the CPU clock of the process advances in ticks of 4 ms.
ProcessOutput outputOf(const std::function<int()>& work, double limit) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe for a process");
  const pid_t child = startProcess([&] {
    close(ends[0]);
    dup2(ends[1], STDOUT_FILENO);
    close(ends[1]);
    return work();
  });
  close(ends[1]);
  ProcessOutput out;
  pollfd ready{ends[0], POLLIN, 0};
  for (char buffer[4096];;) {
    if (poll(&ready, 1, 100) == 0) {
      if (cpuTimeOf(child) < limit || out.tooLong) continue;
      out.tooLong = true;
      kill(child, SIGKILL);
      continue;
    }
    const ssize_t n = read(ends[0], buffer, sizeof(buffer));
    if (n == 0 || (n < 0 && errno != EINTR)) break;
    if (n > 0) out.text.append(buffer, static_cast<std::size_t>(n));
  }
  close(ends[0]);
  while (waitpid(child, &out.status, 0) < 0 && errno == EINTR) {
  }
  return out;
}

ProcessOutput outputOfProgram(const std::vector<std::string>& words, double limit) {
  std::vector<std::string> copy = words;
  std::vector<char*> arguments;
  for (std::string& w : copy) arguments.push_back(w.data());
  arguments.push_back(nullptr);
  return outputOf(
      [&] {
        const int nowhere = open("/dev/null", O_WRONLY);
        if (nowhere >= 0) dup2(nowhere, STDERR_FILENO);
        execv(arguments.front(), arguments.data());
        return 127;
      },
      limit);
}

}  // namespace dynamy::app
