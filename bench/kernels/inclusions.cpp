/// Cost of one solve of contact problems in FCLIB's layout, from Λ = 0.
///
///   bench_inclusions [OPTIONS] FILE.hdf5 …         one line a problem: CPU time, sweeps, steps
///   bench_inclusions [OPTIONS] --count N FILE …    exactly N solves each, for a counting tool
///
///   --own            judged by E_f and E_u instead of FCLIB's measure
///   --warm SIZE      started at the solution, each c changed by up to SIZE of itself
///   --tolerance T    1e-8
///   --solver NAME    Automatic, ProxGaussSeidel, BlockGaussSeidel, ProximalNewton
///   --anderson M     depth of the acceleration of sweeps
///   --symmetric      sweeps to and fro
///
/// Times are the median of repeated solves in CPU time; they compare only within one run.
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <dynamy/io/fclib/fclib_file.hpp>
#include <dynamy/solver/automatic.hpp>
#include <dynamy/solver/block_gauss_seidel.hpp>
#include <filesystem>
#include <iostream>
#include <random>

namespace {

using namespace dynamy;

struct Choice {
  bool own = false;
  double warm = 0.0;
  int count = 0;
  std::string solver = "Automatic";
  ProxOptions sweeps{.tolerance = 1e-8, .maxIterations = 10000};
};

double cpuSeconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

std::unique_ptr<InclusionSolver> make(const Choice& choice) {
  const double tolerance = choice.sweeps.tolerance;
  if (choice.solver == "Automatic")
    return std::make_unique<Automatic>(AutomaticOptions{.tolerance = tolerance});
  if (choice.solver == "ProximalNewton")
    return std::make_unique<ProximalNewton>(ProximalNewtonOptions{.tolerance = tolerance});
  if (choice.solver == "ProxGaussSeidel") return std::make_unique<ProxGaussSeidel>(choice.sweeps);
  if (choice.solver == "BlockGaussSeidel") return std::make_unique<BlockGaussSeidel>(choice.sweeps);
  std::cerr << "unknown solver " << choice.solver << '\n';
  std::exit(EXIT_FAILURE);
}

void run(const Choice& choice, const std::string& file) {
  const FclibProblem problem = readFclib(file);
  const auto given = inclusionProblem(condensed(problem));
  InclusionProblem& p = given->problem();
  const FclibRule rule;
  if (!choice.own) p.rule = &rule;
  const auto solver = make(choice);
  Eigen::VectorXd start = Eigen::VectorXd::Zero(p.rows()), Lambda = start;
  if (choice.warm > 0.0) {
    solver->solve(p, view(start));
    std::mt19937 random(1);
    for (double& c : p.c)
      c *= 1.0 + choice.warm * (static_cast<double>(random()) / 2147483648.0 - 1.0);
  }
  SolveReport report;
  std::vector<double> times;
  const double begin = cpuSeconds();
  for (int k = 0; choice.count > 0 ? k < choice.count : k < 3 || cpuSeconds() - begin < 0.2;) {
    // Small problems are timed in groups, so that the clock does not count.
    const int group = choice.count > 0 ? 1 : (p.rows() < 1000 ? 20 : 1);
    const double from = cpuSeconds();
    for (int i = 0; i < group; ++i, ++k) {
      Lambda = start;
      report = solver->solve(p, view(Lambda));
    }
    times.push_back((cpuSeconds() - from) / group);
  }
  std::sort(times.begin(), times.end());
  std::printf("%-42.42s %6d %7d %6d %4d %9.2f  %.1e %.1e  %s %s\n",
              std::filesystem::path(file).stem().c_str(), p.size(),
              report.iterations - report.newton, report.newton, report.rejected,
              1e6 * times[times.size() / 2], report.residuals.largest(), report.residuals.Eu,
              std::string(solveStatusText(report.status)).c_str(),
              std::string(report.method).c_str());
}

}  // namespace

int main(int argc, char** argv) {
  Choice choice;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] { return ++i < argc ? argv[i] : ""; };
    if (word == "--own")
      choice.own = true;
    else if (word == "--symmetric")
      choice.sweeps.symmetric = true;
    else if (word == "--warm")
      choice.warm = std::atof(value());
    else if (word == "--count")
      choice.count = std::atoi(value());
    else if (word == "--solver")
      choice.solver = value();
    else if (word == "--tolerance")
      choice.sweeps.tolerance = std::atof(value());
    else if (word == "--anderson")
      choice.sweeps.anderson = std::atoi(value());
    else
      files.push_back(word);
  }
  std::printf("%-42s %6s %7s %6s %4s %9s  %s\n", "problem", "n", "sweeps", "Newton", "lost", "us",
              "residuals");
  for (const std::string& file : files) run(choice, file);
  return EXIT_SUCCESS;
}
