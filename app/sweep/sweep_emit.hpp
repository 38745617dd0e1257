/// Scripts with which other engines compute the runs of a sweep.
#pragma once
#include "sweep/sweep_folder.hpp"

namespace dynamy::app {

/// Writes parallel.sh or slurm.sh into the folder, with the plug-ins and the trust of this command;
/// returns what to do with it. Throws FileError.
std::string emit(const std::string& engine, const Program& program, const Sweep& sweep,
                 const SweepFolder& folder);

}  // namespace dynamy::app
