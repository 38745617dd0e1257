/// Captures the standard output of a process and limits its CPU time.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace dynamy::app {

struct ProcessOutput {
  std::string text;
  int status = 0;        ///< status of waitpid
  bool tooLong = false;  ///< the process was killed at the limit
};

/// Runs `work` in a process forked from this one and returns its standard output in `text`; `limit`
/// is in seconds of CPU time. Throws std::runtime_error.
ProcessOutput outputOf(const std::function<int()>& work, double limit);

/// Runs a program with its arguments, `words`, as outputOf() runs a function; its standard error is
/// discarded.
ProcessOutput outputOfProgram(const std::vector<std::string>& words, double limit);

}  // namespace dynamy::app
