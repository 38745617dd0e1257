#pragma once
/// \file
/// The folder a run writes: run.json, model.xml, signals.csv, signals.svg, events.csv, ledger.csv,
/// frames.bin, replay.html, checkpoint (doc/run_folder.md). An older run in it is replaced only if
/// its run.json carries the marker of dynamY, and then file by file: a command that empties whole
/// folders would some day empty the wrong one.

#include <dynamy/io/files/json_writer.hpp>
#include <filesystem>
#include <functional>

namespace dynamy {

/// Reserves a folder for one run; other processes are refused. The lock is released when the object
/// is destroyed or the process ends for any reason. It is an advisory lock (flock) on the file
/// `run.lock`, which names the process. Rejected: a file whose existence means "taken", because
/// nobody removes it after a kill.
class FolderLock {
 public:
  FolderLock() = default;
  /// \throws FileError, naming the run, if a run holds the folder; WriteError
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
  /// Creates the folder with its parents, or uses an empty one, or removes the files of an older
  /// run of dynamY from it. Then writes a run.json with "state": "running". Other processes are
  /// kept out during the lifetime of the object.
  /// \throws FileError if `path` is a file, or a folder with something else in it, or another run
  /// writes into it
  explicit RunFolder(const std::filesystem::path& path);

  /// Opens the folder of an earlier run for reading. \throws FileError if it holds no run
  static RunFolder existing(const std::filesystem::path& path);
  /// Opens the folder of an earlier run to continue it: nothing is removed, and other processes are
  /// kept out during the lifetime of the object. \throws FileError if it holds no run, or one that
  /// is running
  static RunFolder resumed(const std::filesystem::path& path);

  /// Writes run.json: the marker, then the members that `write` adds to the open object. Replaces
  /// the earlier file as a whole. \throws FileError
  void writeFacts(const std::function<void(JsonWriter&)>& write) const;
  /// Writes run.json at the end of a run, when the disk may be full. If necessary, the older
  /// checkpoint is removed to make room; if that is not enough, the text of `brief` overwrites the
  /// old file in place.
  /// \throws WriteError if even that fails
  void writeLastFacts(const std::function<void(JsonWriter&)>& write,
                      const std::function<void(JsonWriter&)>& brief) const;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path facts() const { return path_ / "run.json"; }
  /// The model as it was read; the replay shows it.
  std::filesystem::path model() const { return path_ / "model.xml"; }
  std::filesystem::path signals() const { return path_ / "signals.csv"; }
  std::filesystem::path signalsPlot() const { return path_ / "signals.svg"; }
  /// Impacts and changes of status.
  std::filesystem::path events() const { return path_ / "events.csv"; }
  /// Energies, works and the solver's figures along the run.
  std::filesystem::path ledger() const { return path_ / "ledger.csv"; }
  std::filesystem::path frames() const { return path_ / "frames.bin"; }
  std::filesystem::path replay() const { return path_ / "replay.html"; }
  /// The page that `dynamy report` writes.
  std::filesystem::path report() const { return path_ / "report.html"; }
  /// Inclusion problems, if they were requested.
  std::filesystem::path problems() const { return path_ / "problems"; }
  /// The checkpoint from which `dynamy resume` continues.
  std::filesystem::path checkpoint() const { return path_ / "checkpoint"; }
  /// The checkpoint before the last one, in case that one is damaged.
  std::filesystem::path olderCheckpoint() const { return path_ / "checkpoint.1"; }

  /// Space on the disk that a run reserves for its last checkpoint.
  std::filesystem::path spareRoom() const { return path_ / "checkpoint.room"; }

 private:
  RunFolder() = default;
  std::filesystem::path path_;
  FolderLock lock_;
};

/// Whether `folder` holds a run.json that a RunFolder wrote.
bool holdsRun(const std::filesystem::path& folder);

/// Folder of a run of `model` without --out: runs/MODEL, where MODEL is the file name without its
/// extension.
std::filesystem::path defaultRunFolder(const std::filesystem::path& model);

}  // namespace dynamy
