// Any bytes as a file of the FCLIB layout: it is read, or refused with a ModelError. What is read
// has the sizes that solvers rely on, and a small problem is solved for a moment.
//
// The HDF5 library reads files, no memory: the bytes go through one file per process.
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <dynamy/core/error.hpp>
#include <dynamy/io/fclib/fclib_file.hpp>
#include <dynamy/solver/automatic.hpp>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

namespace fs = std::filesystem;
using namespace dynamy;

void must(bool holds) {
  if (!holds) std::abort();
}

/// What every reader of a problem takes for granted.
void checkSizes(const FclibProblem& p) {
  const int rows = p.rows();
  must(p.dim >= 1 && p.dim <= 5 && rows == p.dim * p.contacts());
  must(p.mu.size() == (p.dim == 1 ? 0 : p.contacts()));
  must(p.muRolling.size() == (p.dim == 5 ? p.contacts() : 0));
  if (p.global)
    must(p.M.rows() == p.M.cols() && p.H.rows() == p.M.rows() && p.H.cols() == rows &&
         p.f.size() == p.M.rows());
  else
    must(p.W.rows() == rows && p.W.cols() == rows && p.q.allFinite());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fs::path file =
      fs::temp_directory_path() / ("fclib_fuzz_" + std::to_string(::getpid()) + ".hdf5");
  std::ofstream(file, std::ios::binary | std::ios::trunc)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    const FclibProblem problem = readFclib(file);
    checkSizes(problem);
    constexpr int kFew = 100;  // rows that are solved
    if (problem.rows() <= kFew && problem.M.rows() <= kFew) {
      const std::unique_ptr<GivenProblem> given = inclusionProblem(condensed(problem));
      Automatic solver({.tolerance = 1e-8, .maxNewton = 5, .maxPatient = 5, .maxIterations = 20});
      Eigen::VectorXd Lambda = Eigen::VectorXd::Zero(problem.rows());
      solver.solve(given->problem(), view(Lambda));
    }
  } catch (const ModelError&) {
    // refused
  }
  std::error_code ignored;
  fs::remove(file, ignored);
  return 0;
}
