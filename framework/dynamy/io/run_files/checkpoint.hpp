#pragma once
/// \file
/// The file `checkpoint` of a run folder: what a run goes on from, and what it belongs to. The
/// bytes are in doc/run_folder.md:
///
///     head     "DYNCHECK" u32 layout, u32 0x01020304, u64 bytes of payload, u64 hash, u32 CRC, u32
///     0 payload  an Archive: program, choice, model, libraries, recorded files, state of the run
///
/// A CRC-32 finds every error of up to 32 bits in a row; with the 64 bits of the hash any other
/// passes once in 2⁹⁶. Nothing of the payload is read before both agree. They guard against
/// accidents: who can write the file can make both agree, so whatever is read is bounded by what is
/// left, and what is used as an index is looked at (Simulation::resume).

#include <dynamy/core/archive.hpp>
#include <dynamy/io/plugin/library_file.hpp>
#include <dynamy/io/run_files/run_recording.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dynamy {

/// What decides the numbers of a run: what is said on the command line, and what was read.
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
  /// Who can write a checkpoint must not choose what code runs. Throws ModelError.
  void archive(Archive& a);
};

struct Checkpoint {
  std::string program;  ///< version and build that wrote it
  double t = 0.0;       ///< where the run was [s]
  RunChoice choice;
  std::string modelText;
  std::vector<RecordedFile> files;  ///< as they were then
  std::string simulation;           ///< what Simulation::resume takes
  void archive(Archive& a);
};

/// Layout that is written and read.
inline constexpr std::uint32_t kCheckpointLayout = 1;

/// The bytes of the file.
std::string bytesOf(Checkpoint& checkpoint);
/// The checkpoint in these bytes; `file` is named in messages. \throws FileError if they are none,
/// or not whole, or of another layout
Checkpoint readCheckpoint(std::string_view bytes, const std::string& file);

/// Keeps so much of the disk for a checkpoint that finds no other room; where the disk cannot
/// reserve, nothing.
void reserveRoom(const RunFolder& folder, std::uint64_t bytes);

/// Replaces the checkpoint of the folder; the one before becomes the older one. At every moment one
/// of them is whole. `lasting`: they outlive a loss of power. On a full disk the reserved room is
/// used, and that of the older one. \throws WriteError; the older one has gone then
void writeCheckpoint(const RunFolder& folder, Checkpoint& checkpoint, bool lasting);

/// A checkpoint of a folder that its files go with.
struct FoundCheckpoint {
  Checkpoint checkpoint;
  std::string note;  ///< why it is not the last one; empty: it is
};

/// The last checkpoint of the folder, or the older one if the last is damaged or the recorded files
/// are shorter than it says. \throws FileError: there is none, or each has its fault
FoundCheckpoint findCheckpoint(const RunFolder& folder);

/// Before a run goes on from the older one: that becomes the last, so that a damaged one never
/// takes its place. \throws WriteError
void keepOnly(const RunFolder& folder, const FoundCheckpoint& found);

}  // namespace dynamy
