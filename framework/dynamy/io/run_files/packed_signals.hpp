#pragma once
/// \file
/// signals.h5: the signals of a run that has ended as HDF5, for long runs (`<record format="hdf5">`):
///
///     /names            the names in the order of the columns
///     /t                times [s]
///     /signals/NAME     values; attribute `unit`
///     /provenance/…     run.json and model.xml of the run
///
/// Every column is cut into chunks that are shuffled, compressed and have a checksum. A run writes
/// signals.csv until it ends, and packs it then: what is written row by row survives a kill, can be
/// followed while the run computes, and can be continued from any byte. Numbers have all bits in both
/// files, so that unpacking gives the same bytes again. Rejected: writing HDF5 while the run computes,
/// because a process that is killed may leave such a file unreadable.

#include <dynamy/io/run_files/run_recording.hpp>

namespace dynamy {

/// The file signals.h5 of a run folder.
std::filesystem::path packedSignals(const RunFolder& folder);

/// Writes signals.h5 from signals.csv, with the `title` of the run, and removes signals.csv. Does not
/// read the whole file at once. \throws WriteError; signals.csv stays
RecordedFile packSignals(const RunFolder& folder, std::span<const SignalName> signals,
                         const std::string& title);
/// Writes signals.csv from signals.h5, which stays; does nothing without signals.h5 or with both.
/// \throws FileError, WriteError
void unpackSignals(const RunFolder& folder);
/// Reads signals.h5. \throws FileError if it is no such file, or a checksum is wrong
SignalTable readPackedSignals(const std::filesystem::path& path);
/// The signals of a run folder, from signals.csv or signals.h5; no table if there is neither.
/// \throws FileError
SignalTable signalsOf(const std::filesystem::path& folder);

}  // namespace dynamy
