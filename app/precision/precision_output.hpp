/// What a process prints, with a limit of its CPU time.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace dynamy::app {

struct ProcessOutput {
  std::string text;
  int status = 0;        ///< of waitpid
  bool tooLong = false;  ///< it was ended by the limit
};

/// Runs `work` in a process forked from this one, standard output into `text`; `limit` in seconds
/// of CPU time. Throws std::runtime_error.
ProcessOutput outputOf(const std::function<int()>& work, double limit);

/// The same for a program with arguments; what it says on standard error is dropped.
ProcessOutput outputOfProgram(const std::vector<std::string>& words, double limit);

}  // namespace dynamy::app
