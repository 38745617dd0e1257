/// results.csv and sweep.html of a sweep: the table of all runs, and pictures of it.
#pragma once
#include "sweep/sweep_folder.hpp"

namespace dynamy::app {

/// How many runs ended in which way.
struct Collected {
  std::size_t finished = 0, failed = 0, missing = 0;
  std::size_t qualified = 0;     ///< finished runs with a warning that qualifies them
  std::size_t failedChecks = 0;  ///< finished runs with a check of the model that does not hold
  std::string firstFault;        ///< message of the first run that failed
};

/// Writes both files from the lines that are there; `accept`: warnings that qualify no run. Throws
/// FileError.
Collected collect(const Sweep& sweep, const SweepFolder& folder, const Accepted& accept);

}  // namespace dynamy::app
