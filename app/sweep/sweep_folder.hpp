/// The folder of a sweep:
///
///   sweep.json     everything that decides the numbers, with a fingerprint of the model's files
///   manifest.csv   id and values of every run
///   results/7.csv  the line of run 7; it is there as a whole or not at all
///   results.csv, sweep.html   all lines, collected
///   runs/7/        the run folder of run 7, if it is kept
///
/// A line is written to results/7.part and renamed. Whoever computes run 7 holds a lock on that
/// file, which the system lets go with the process: no run is taken twice, by whatever program and
/// on whatever machine of a cluster, and none is lost when its process is killed. Rejected: a list
/// of running runs, which a killed process leaves behind; one common file of results, in which a
/// killed process leaves half a line.
#pragma once
#include <dynamy/io/files/json_reader.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "run/run_job.hpp"
#include "sweep/sweep_plan.hpp"

namespace dynamy::app {

/// Sets a parameter, or "--step", "--until", "--integrator", "--solver". Throws
/// CLI::ValidationError for a time that is none.
void choose(RunChoice& choice, const std::string& name, const std::string& value);

/// A column of the results.
struct Column {
  std::string name, unit;
};

/// A sweep as sweep.json and manifest.csv say it.
struct Sweep {
  RunChoice choice;  ///< what all runs share
  std::vector<std::string> measures;
  bool keep = false;        ///< run folders
  std::string fingerprint;  ///< of the model's files
  std::string title;
  std::vector<Column> columns;  ///< of the measured values
  SweepPlan plan;
  std::size_t runs() const { return plan.rows.size(); }
  /// Of run `id`, from 1. Throws CLI::ValidationError, e.g. for a step that is no time.
  RunChoice choiceOf(std::size_t id) const;
};

/// Held while a run is computed.
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
  /// Creates the folder, or goes on in it if it holds the same sweep. Throws FileError, with what
  /// differs, if it holds another one or something else.
  SweepFolder(const std::filesystem::path& path, const Sweep& sweep);
  /// An existing one. Throws FileError.
  explicit SweepFolder(const std::filesystem::path& path);
  Sweep read() const;
  /// Removes plan and results of a sweep, so that another one can begin; kept run folders, too.
  static void clear(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path facts() const { return path_ / "sweep.json"; }
  std::filesystem::path manifest() const { return path_ / "manifest.csv"; }
  std::filesystem::path results() const { return path_ / "results.csv"; }
  std::filesystem::path page() const { return path_ / "sweep.html"; }
  std::filesystem::path result(std::size_t id) const;
  std::filesystem::path run(std::size_t id) const;

  bool has(std::size_t id) const { return std::filesystem::exists(result(id)); }
  /// Empty if the run has a result or somebody else computes it. Throws FileError.
  std::optional<Claim> claim(std::size_t id) const;
  /// Writes the line of a claimed run. Throws FileError.
  void finish(std::size_t id, const Claim& claim, const std::string& line) const;

 private:
  std::filesystem::path path_;
};

/// Of the content of all these files that exist, 16 digits.
std::string fingerprintOf(const std::vector<std::filesystem::path>& files);

}  // namespace dynamy::app
