#pragma once
/// \file
/// The folder a run writes: run.json, model.xml, signals.csv, signals.svg, events.csv,
/// ledger.csv, frames.bin, replay.html, checkpoint
/// (doc/run_folder.md). An older run in it is replaced only if its run.json carries our marker, and
/// then file by file: emptying a folder named on a command line would one day empty the wrong one.

#include <dynamy/io/files/json_writer.hpp>
#include <filesystem>
#include <functional>

namespace dynamy {

/// Holds a folder for one run: another process that tries is refused. Released when it goes, or
/// when the process dies, however that happens. An advisory lock (flock) on the file `run.lock`, in
/// which it says who it is. Rejected: a file that says "taken" by being there, because nobody
/// removes it after a kill.
class FolderLock {
 public:
  FolderLock() = default;
  /// \throws FileError if a run holds it, saying which; WriteError
  explicit FolderLock(const std::filesystem::path& folder);
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&& other) noexcept;
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();
  /// Who holds the folder: "process 4711 on host since 2026-11-21 12:00:00"; "": nobody.
  static std::string holder(const std::filesystem::path& folder);

 private:
  void release() noexcept;
  std::filesystem::path file_;
  int opened_ = -1;
};

class RunFolder {
 public:
  /// Where a run of `model` goes without --out: runs/MODEL, MODEL being the file name without its
  /// ending.
  static std::filesystem::path defaultPath(const std::filesystem::path& model);

  /// Creates the folder with its parents, or takes an empty one, or removes the files of an older
  /// run of ours from it; then writes a run.json with "state": "running". Other processes are kept
  /// out as long as it lives.
  /// \throws FileError if `path` is a file, or a folder with something else in it, or another run
  /// writes into it
  explicit RunFolder(const std::filesystem::path& path);

  /// The folder of an earlier run, to read it. \throws FileError if it holds no run
  static RunFolder existing(const std::filesystem::path& path);
  /// The folder of an earlier run, to go on in it: nothing is removed, and other processes are kept
  /// out as long as it lives. \throws FileError if it holds no run, or one that is running
  static RunFolder resumed(const std::filesystem::path& path);

  /// Writes run.json: the marker, then the members that `write` adds to the open object.
  /// Replaces the earlier one in one go. \throws FileError
  void writeFacts(const std::function<void(JsonWriter&)>& write) const;
  /// The same at the end of a run, when the disk may be full: if need be the older checkpoint makes
  /// room, and if that is not enough the old file gets what `brief` writes, in its place.
  /// \throws WriteError if even that fails
  void writeLastFacts(const std::function<void(JsonWriter&)>& write,
                      const std::function<void(JsonWriter&)>& brief) const;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path facts() const { return path_ / "run.json"; }
  /// The model as it was read: shown by the replay.
  std::filesystem::path model() const { return path_ / "model.xml"; }
  std::filesystem::path signals() const { return path_ / "signals.csv"; }
  std::filesystem::path signalsPlot() const { return path_ / "signals.svg"; }
  /// Impacts and changes of status.
  std::filesystem::path events() const { return path_ / "events.csv"; }
  /// Energies, works and the solver's figures along the run.
  std::filesystem::path ledger() const { return path_ / "ledger.csv"; }
  std::filesystem::path frames() const { return path_ / "frames.bin"; }
  std::filesystem::path replay() const { return path_ / "replay.html"; }
  /// What `dynamy report` writes.
  std::filesystem::path report() const { return path_ / "report.html"; }
  /// Inclusion problems, if they were asked for.
  std::filesystem::path problems() const { return path_ / "problems"; }
  /// What `dynamy resume` goes on from.
  std::filesystem::path checkpoint() const { return path_ / "checkpoint"; }
  /// The one before it, for the case that the last is damaged.
  std::filesystem::path olderCheckpoint() const { return path_ / "checkpoint.1"; }

  /// Room on the disk that a run keeps for its last checkpoint.
  std::filesystem::path spareRoom() const { return path_ / "checkpoint.room"; }

 private:
  RunFolder() = default;
  std::filesystem::path path_;
  FolderLock lock_;
};

/// Whether `folder` holds a run.json that a RunFolder wrote.
bool holdsRun(const std::filesystem::path& folder);

}  // namespace dynamy
