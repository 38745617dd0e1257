/// One run of a sweep: from its line of the manifest to its line of the results.
#pragma once
#include "sweep/sweep_folder.hpp"

namespace dynamy::app {

/// Figures of every run that stand behind the measured values in its line.
std::vector<Column> factColumns();

/// Checks the measures against the model of run `id`, and fills columns, title and fingerprint; a
/// second call for another run renames columns whose instant depends on what varies. Throws
/// ModelError and CLI::ValidationError.
void verify(Program& program, Sweep& sweep, std::size_t id);

/// Computes a claimed run and writes its line; a faulty model gives a line, too. False if it was
/// stopped from outside: then there is none. Throws FileError.
bool computeRun(Program& program, const Sweep& sweep, const SweepFolder& folder, std::size_t id,
                const Claim& claim);

/// Loads the plug-ins, and throws ModelError if the files are no longer those of the sweep.
void prepare(Program& program, const Sweep& sweep);

}  // namespace dynamy::app
