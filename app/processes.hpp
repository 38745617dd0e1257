/// Work in processes of its own, several at once: a crash ends one piece of work and not the
/// program, and a plug-in needs no word about threads.
#pragma once
#include <sys/types.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

namespace dynamy::app {

/// Calls `work` with 0 … count − 1, each in a process forked from this one, `jobs` at once, and
/// `ended` with its number and how it ended (status of waitpid) here. The processes die with this
/// one, even if it is killed; once `stop` is true those that run are killed and no more begin.
void inProcesses(std::size_t count, int jobs, const std::atomic<bool>& stop,
                 const std::function<int(std::size_t)>& work,
                 const std::function<void(std::size_t, int)>& ended);

/// Starts a process that does `work` and ends with what it returns. It dies with this one, and
/// Ctrl-C on the terminal does not reach it. Throws std::runtime_error.
pid_t startProcess(const std::function<int()>& work);

/// "" if it ended by itself with 0; else "killed by signal 9 (Killed)" or "exit status 3".
std::string endText(int status);

}  // namespace dynamy::app
