/// Writes scripts with which GNU parallel or Slurm compute the runs of a sweep.
#pragma once
#include "sweep/sweep_folder.hpp"

namespace dynamy::app {

/// Writes parallel.sh or slurm.sh into the folder; the script repeats --plugin and --trust of this
/// command. Returns a text that says how to start the script. Throws FileError.
std::string emit(const std::string& engine, const Program& program, const Sweep& sweep,
                 const SweepFolder& folder);

}  // namespace dynamy::app
