/// Runs pieces of work in separate processes, several at once. A crash ends one piece of work and
/// not the program, and a plug-in need not be thread-safe.
#pragma once
#include <sys/types.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

namespace dynamy::app {

/// Calls `work` with 0 … count − 1, each in a process forked from this one, `jobs` at once. When a
/// process ends, the calling process calls `ended` with its number and the status of waitpid. All
/// children die with the calling process, even if it is killed. Once `stop` is true, running
/// children are killed and no more begin.
void inProcesses(std::size_t count, int jobs, const std::atomic<bool>& stop,
                 const std::function<int(std::size_t)>& work,
                 const std::function<void(std::size_t, int)>& ended);

/// Starts a child process that calls `work` and exits with the status that `work` returns. The
/// child dies with its parent, and Ctrl-C on the terminal does not reach it. Throws
/// std::runtime_error.
pid_t startProcess(const std::function<int()>& work);

/// Describes a status of waitpid: "" if the process exited with 0, else "killed by signal 9
/// (Killed)" or "exit status 3".
std::string endText(int status);

}  // namespace dynamy::app
