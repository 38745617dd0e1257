#pragma once
/// \file
/// Inclusion problems of a run as files in the FCLIB layout (doc/run_folder.md), so that `dynamy
/// solve` and other programs can be tested on exactly the problems of a run.
///
///   ξ = G Λ + c   →   u = W r + q,   one file a problem, with the run's Λ as /solution/r

#include <dynamy/io/fclib/fclib_file.hpp>
#include <dynamy/simulation/model/observer.hpp>

namespace dynamy {

/// A problem in the local layout, or the reason why the layout cannot hold it.
struct FclibCopy {
  FclibProblem problem;
  FclibSolution solution;
  std::vector<int> contact;  ///< for every contact of the file, its contact in the problem
  std::string refused;       ///< empty: it could be written
  int refusedAt = -1;        ///< contact whose law is to blame, or −1
};

/// Joints are eliminated, W = G_cc − G_cj G_jj⁺ G_jc. All contacts get as many rows as the largest
/// one; the added rows have W = λ_i, q = 0 and no force. Laws that FCLIB cannot hold (given
/// friction, ellipses, springs …) are refused. `Lambda`: rows() entries.
FclibCopy fclibCopy(const InclusionProblem& problem, ConstVec Lambda);

/// Keeps the problems of a run that took the most iterations and those that were not solved, and
/// writes them at the end.
class ProblemDump final : public Observer {
 public:
  /// `count` ≥ 0 problems besides the unsolved ones, of which the first 100 are kept.
  ProblemDump(std::filesystem::path folder, int count)
      : folder_(std::move(folder)), count_(count) {}
  void step(const StepView& view) override { consider(view); }
  void failed(const StepView& view) override { consider(view); }
  /// Writes the kept problems; a resumed run adds its own.
  void finish(const StepView& last) override;

  struct File {
    std::string name;  ///< in the folder
    long step = 0;
    double t = 0.0;  ///< [s]
    int iterations = 0, contacts = 0;
    bool solved = true;
  };
  /// The written files, in the order of time.
  const std::vector<File>& files() const { return files_; }
  /// Number of problems that the layout cannot hold, and the reason for the first one.
  long refused() const { return refused_; }
  const std::string& refusedBecause() const { return refusedBecause_; }

 private:
  struct Kept {
    File file;
    FclibCopy copy;
  };
  void consider(const StepView& view);
  std::filesystem::path folder_;
  int count_;
  std::vector<Kept> hard_, unsolved_;
  std::vector<File> files_;
  long refused_ = 0;
  std::string refusedBecause_;
};

}  // namespace dynamy
