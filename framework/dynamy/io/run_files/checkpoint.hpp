#pragma once
/// \file
/// The file `checkpoint` of a run folder: the state from which a run continues, and the run that it
/// belongs to. The bytes are described in doc/run_folder.md:
///
///     head     "DYNCHECK" u32 layout, u32 0x01020304, u64 bytes of payload, u64 hash, u32 CRC, u32
///     0 payload  an Archive: program, choice, model, libraries, recorded files, state of the run
///
/// A CRC-32 finds every error of up to 32 bits in a row; together with the 64 bits of the hash, any
/// other error passes once in 2⁹⁶. The payload is read only if both agree. They guard against
/// accidents only, because anybody who can write the file can make both agree. Therefore all sizes
/// are limited by the bytes left, and all indices are checked (Simulation::resume).

#include <dynamy/core/archive.hpp>
#include <dynamy/io/plugin/library_file.hpp>
#include <dynamy/io/run_files/run_recording.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dynamy {

/// Everything that determines the numbers of a run: options of the command line, and the files that
/// were read.
struct RunChoice {
  std::string model;  ///< path
  std::vector<std::pair<std::string, std::string>> set;
  double until = 0.0, step = 0.0;      ///< [s]; 0: as the model says
  double every = 0.0;                  ///< [s]; 0: as the model says
  double tolerance = 0.0;              ///< 0: as the model says
  std::string integrator, solver;      ///< empty: as the model says
  std::vector<std::string> libraries;  ///< as the user named them; archived without their paths
  std::vector<Fingerprint> sources;    ///< the model and what it includes, in their order
  std::vector<Fingerprint> loaded;     ///< all libraries but the standard elements
  /// Paths of libraries are left out, because a person who can write a checkpoint must not choose
  /// which code runs. Throws ModelError.
  void archive(Archive& a);
};

struct Checkpoint {
  std::string program;  ///< version and build that wrote it
  double t = 0.0;       ///< time that the run had reached [s]
  RunChoice choice;
  std::string modelText;
  std::vector<RecordedFile> files;  ///< as they were at that time
  std::string simulation;           ///< the bytes for Simulation::resume
  void archive(Archive& a);
};

/// Version of the layout that is written and read.
inline constexpr std::uint32_t kCheckpointLayout = 1;

/// The bytes of the file.
std::string bytesOf(Checkpoint& checkpoint);
/// The checkpoint in these bytes; `file` is named in messages. \throws FileError if they are no
/// checkpoint, are incomplete, or have another layout
Checkpoint readCheckpoint(std::string_view bytes, const std::string& file);

/// Reserves this number of bytes on the disk for a checkpoint on a full disk. Does nothing if the
/// file system cannot reserve space.
void reserveRoom(const RunFolder& folder, std::uint64_t bytes);

/// Replaces the checkpoint of the folder; the previous one becomes the older one. At every moment
/// one of them is complete. `lasting`: they survive a loss of power. On a full disk the reserved
/// space is used, and that of the older checkpoint. \throws WriteError; the older one is lost then
void writeCheckpoint(const RunFolder& folder, Checkpoint& checkpoint, bool lasting);

/// A checkpoint of a folder that matches the recorded files.
struct FoundCheckpoint {
  Checkpoint checkpoint;
  std::string note;  ///< why it is not the last one; empty: it is
};

/// The last checkpoint of the folder, or the older one if the last is damaged or the recorded files
/// are shorter than it says. \throws FileError: there is none, or each has its fault
FoundCheckpoint findCheckpoint(const RunFolder& folder);

/// Call before a run continues from the older checkpoint: it becomes the last one, so that a
/// damaged checkpoint never takes its place. \throws WriteError
void keepOnly(const RunFolder& folder, const FoundCheckpoint& found);

}  // namespace dynamy
