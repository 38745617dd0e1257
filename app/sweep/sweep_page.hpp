/// Writes results.csv and sweep.html of a sweep: the table of all runs, and its pictures.
#pragma once
#include "sweep/sweep_folder.hpp"

namespace dynamy::app {

/// Number of runs that ended in each way.
struct Collected {
  std::size_t finished = 0, failed = 0, missing = 0;
  std::size_t qualified = 0;     ///< finished runs with a warning that qualifies them
  std::size_t failedChecks = 0;  ///< finished runs with a check of the model that does not hold
  std::string firstFault;        ///< message of the first run that failed
  std::string firstQualified;    ///< the same of the first one with such a warning: its kinds
};

/// Writes results.csv and sweep.html from the lines of the runs that are done. Warnings in `accept`
/// do not qualify a run. Throws FileError.
Collected collect(const Sweep& sweep, const SweepFolder& folder, const Accepted& accept);

}  // namespace dynamy::app
