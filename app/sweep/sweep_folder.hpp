/// The folder of a sweep:
///
///   sweep.json     everything that determines the results, with a fingerprint of the model's files
///   manifest.csv   id and values of every run
///   results/7.csv  the line of run 7; the file is either complete or missing
///   results.csv, sweep.html   the lines of all runs, collected
///   runs/7/        the run folder of run 7, if it is kept
///
/// The line of run 7 is written to results/7.part, which is then renamed. The process that computes
/// run 7 holds a lock on that file, and the system releases the lock when the process ends. So no
/// run is computed twice, by any program on any machine of a cluster, and no run is lost when its
/// process is killed. Rejected: a list of active runs, which a killed process leaves behind; one
/// common file of results, in which a killed process leaves half a line.
#pragma once
#include <dynamy/io/files/json_reader.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "run/run_job.hpp"
#include "sweep/sweep_plan.hpp"

namespace dynamy::app {

/// Sets a parameter of the model, or "--step", "--until", "--integrator", "--solver". Throws
/// CLI::ValidationError if a value that must be a time is not one.
void choose(RunChoice& choice, const std::string& name, const std::string& value);

/// A column of the results.
struct Column {
  std::string name, unit;
};

/// A sweep as described by sweep.json and manifest.csv.
struct Sweep {
  RunChoice choice;  ///< what all runs share
  std::vector<std::string> measures;
  bool keep = false;        ///< keep the run folders
  std::string fingerprint;  ///< of the model's files
  std::string title;
  std::vector<Column> columns;  ///< of the measured values
  SweepPlan plan;
  std::size_t runs() const { return plan.rows.size(); }
  /// The choice of run `id`, counted from 1. Throws CLI::ValidationError, e.g. for a step that is
  /// not a time.
  RunChoice choiceOf(std::size_t id) const;
};

/// Lock on a run, held while the run is computed.
class Claim {
 public:
  Claim(Claim&& other) noexcept;
  Claim& operator=(Claim&&) = delete;
  ~Claim();

 private:
  friend class SweepFolder;
  explicit Claim(int file) : file_(file) {}
  int file_;
};

class SweepFolder {
 public:
  /// Creates the folder, or opens it if it holds the same sweep. Throws FileError, which names the
  /// difference, if the folder holds another sweep or something else.
  SweepFolder(const std::filesystem::path& path, const Sweep& sweep);
  /// Opens the folder of an existing sweep. Throws FileError.
  explicit SweepFolder(const std::filesystem::path& path);
  Sweep read() const;
  /// Removes the plan, the results and the kept run folders, so that another sweep can begin.
  static void clear(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path facts() const { return path_ / "sweep.json"; }
  std::filesystem::path manifest() const { return path_ / "manifest.csv"; }
  std::filesystem::path results() const { return path_ / "results.csv"; }
  std::filesystem::path page() const { return path_ / "sweep.html"; }
  std::filesystem::path result(std::size_t id) const;
  std::filesystem::path run(std::size_t id) const;

  bool has(std::size_t id) const { return std::filesystem::exists(result(id)); }
  /// Locks a run. Empty if the run has a result or another process computes it. Throws FileError.
  std::optional<Claim> claim(std::size_t id) const;
  /// Writes the line of a claimed run. Throws FileError.
  void finish(std::size_t id, const Claim& claim, const std::string& line) const;

 private:
  std::filesystem::path path_;
};

/// Fingerprint, 16 digits, of the content of those files that exist.
std::string fingerprintOf(const std::vector<std::filesystem::path>& files);

}  // namespace dynamy::app
