/// One run of a sweep: from its line of the manifest to its line of the results.
#pragma once
#include "sweep/sweep_folder.hpp"

namespace dynamy::app {

/// Columns that follow the measured values in the line of every run.
std::vector<Column> factColumns();

/// Checks the measures against the model of run `id`, and fills columns, title and fingerprint of
/// the sweep. A second call for another run renames columns that contain an instant which depends
/// on a varied parameter. Throws ModelError and CLI::ValidationError.
void verify(Program& program, Sweep& sweep, std::size_t id);

/// Computes a claimed run and writes its line; a faulty model gives a line, too. Returns false and
/// writes no line if the run was stopped from outside. Throws FileError.
bool computeRun(Program& program, const Sweep& sweep, const SweepFolder& folder, std::size_t id,
                const Claim& claim);

/// Loads the plug-ins. Throws ModelError if the files of the model have changed since the sweep
/// began.
void prepare(Program& program, const Sweep& sweep);

}  // namespace dynamy::app
