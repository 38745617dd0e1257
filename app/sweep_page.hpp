/// results.csv and sweep.html of a sweep: the table of all runs, and pictures of it.
#pragma once
#include "sweep_folder.hpp"

namespace dynamy::app {

/// How many runs ended in which way.
struct Collected {
  std::size_t finished = 0, failed = 0, missing = 0;
  std::size_t failedChecks = 0;  ///< finished runs with a check of the model that does not hold
  std::string firstFault;        ///< message of the first run that failed
};

/// Writes both files from the lines that are there. Throws FileError.
Collected collect(const Sweep& sweep, const SweepFolder& folder);

}  // namespace dynamy::app
