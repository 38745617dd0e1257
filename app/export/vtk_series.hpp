/// The film of a run for ParaView: one file of polygons and one of contacts for each frame (VTK XML, .vtp), and two
/// lists of them with their times, bodies.pvd and contacts.pvd.
///
/// Numbers stand behind the XML as they lie in memory (appended, raw), little-endian: ten times smaller than text,
/// and read at once. Rejected: one file of VTKHDF, which ParaView reads from 5.12 on only.
#pragma once
#include <filesystem>

namespace dynamy::app {

struct VtkTask {
  std::string run;  ///< folder of a run
  std::string out;  ///< folder to write; empty: `vtk` in the run's
  int sides = 24;   ///< of round shapes
};

struct VtkResult {
  std::filesystem::path folder;
  std::size_t frames = 0;
};

/// Throws FileError, WriteError.
VtkResult writeVtkSeries(const VtkTask& task);

}  // namespace dynamy::app
