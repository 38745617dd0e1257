/// Scripts with which other engines compute the runs of a sweep.
#pragma once
#include "sweep_folder.hpp"

namespace dynamy::app {

/// Writes parallel.sh or slurm.sh into the folder; returns what to do with it. Throws FileError.
std::string emit(const std::string& engine, const Sweep& sweep, const SweepFolder& folder);

}  // namespace dynamy::app
