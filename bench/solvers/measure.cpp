#include "measure.hpp"

#include <fcntl.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <dynamy/solver/problem/inclusion_solver.hpp>
#include <iostream>
#include <limits>
#include <sstream>

#include "solver/fclib_checker.hpp"

namespace dynamy::bench {

double cpuSeconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double measureOfFclib(const FclibProblem& local, const Eigen::VectorXd& r) {
  if (local.dim > 1) return fclibResidual(local, r);
  const Eigen::VectorXd u = local.W * r + local.q;
  return (r - (r - u).cwiseMax(0.0)).norm() / local.q.norm();
}

double roundingOfMeasure(const FclibProblem& local, const Eigen::VectorXd& r) {
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  const Eigen::SparseMatrix<double> W = local.W.cwiseAbs();
  return 4.0 * kEpsilon * (W * r.cwiseAbs() + local.q.cwiseAbs()).norm() / local.q.norm();
}

namespace {

/// The kernel ends the process after so much CPU time; 0: never.
void endAfter(double seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec =
      static_cast<suseconds_t>(1e6 * (seconds - static_cast<double>(timer.it_value.tv_sec)));
  setitimer(ITIMER_PROF, &timer, nullptr);
}

double median(std::vector<double> x) {
  if (x.empty()) return 0.0;
  std::sort(x.begin(), x.end());
  const std::size_t n = x.size();
  return n % 2 ? x[n / 2] : 0.5 * (x[n / 2 - 1] + x[n / 2]);
}

/// Median time of a solve: batches of at least 1 ms where a solve is shorter than the clock is
/// fine. `fresh`: every solver solves once.
double timed(Candidate& candidate, const Measurement& m, int rows, const Limits& limits, bool fresh,
             int& solves) {
  const double once = std::max(m.coldSeconds, 1e-7);
  if (once > limits.loopSeconds) return fresh ? m.coldSeconds : 0.0;
  const int batch = std::clamp(static_cast<int>(1e-3 / once), 1, 256);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(rows);
  std::vector<Eigen::VectorXd> r(static_cast<std::size_t>(batch), zero);
  if (!fresh) {
    candidate.prepare(m.tolerance, 1);
    candidate.solve(0, r.front(), 1e300);
  }
  std::vector<double> times;
  double total = 0.0;
  while (total < limits.loopSeconds || times.size() < 3) {
    if (fresh) candidate.prepare(m.tolerance, batch);
    for (Eigen::VectorXd& x : r) x = zero;
    const double begin = cpuSeconds();
    for (int k = 0; k < batch; ++k)
      candidate.solve(fresh ? k : 0, r[static_cast<std::size_t>(k)], 1e300);
    const double spent = cpuSeconds() - begin;
    times.push_back(spent / batch);
    total += std::max(spent, 1e-5);
    if (fresh) solves += batch;
  }
  return median(times);
}

/// E_f and E_u of r.
void scaleFree(const FclibProblem& local, Eigen::VectorXd& r, Measurement& m) {
  const auto given = inclusionProblem(local);
  std::vector<double> scratch;
  const Residuals e = residuals(given->problem(), ConstVec(r.data(), r.size()), scratch);
  m.Ef = e.Ef;
  m.Eu = e.Eu;
}

/// Solves once, with ever tighter tolerances while the solver is content and the measure is not.
void reach(Candidate& candidate, const FclibProblem& local, double level, const Limits& limits,
           Measurement& m, Eigen::VectorXd& r) {
  constexpr int kTighter = 4;
  m.tolerance = level;
  for (int k = 0; k <= kTighter; ++k) {
    candidate.prepare(m.tolerance, 1);
    r.setZero();
    endAfter(1.2 * limits.solveSeconds + 0.1);
    const double begin = cpuSeconds();
    const Said said = candidate.solve(0, r, begin + limits.solveSeconds);
    m.coldSeconds = cpuSeconds() - begin;
    endAfter(0.0);
    m.iterations = said.iterations;
    m.newton = said.newton;
    m.residual = measureOfFclib(local, r);
    m.rounding = roundingOfMeasure(local, r);
    const bool late = m.coldSeconds > limits.solveSeconds;
    m.outcome = late                               ? Outcome::limit
                : m.residual <= level + m.rounding ? Outcome::solved
                                                   : Outcome::notReached;
    if (m.outcome != Outcome::notReached || !said.content) return;
    m.tolerance *= std::min(0.3, 0.5 * level / m.residual);
  }
}

bool tell(int pipe, const Measurement& m) {
  return write(pipe, &m, sizeof m) == static_cast<ssize_t>(sizeof m);
}

/// The whole measurement, in the child. What is known is told before the repetitions begin, in
/// which a solver that kept something from its first run may go astray.
bool inside(int pipe, const std::function<std::unique_ptr<Candidate>()>& make,
            const FclibProblem& local, double level, const Limits& limits) {
  Measurement m;
  Eigen::VectorXd r = Eigen::VectorXd::Zero(local.rows());
  const auto candidate = make();
  reach(*candidate, local, level, limits, m, r);
  scaleFree(local, r, m);
  m.solves = 1;
  if (m.outcome != Outcome::solved) return tell(pipe, m);
  tell(pipe, m);
  endAfter(limits.solveSeconds + 10.0 * limits.loopSeconds);
  m.coldSeconds = timed(*candidate, m, local.rows(), limits, true, m.solves);
  tell(pipe, m);
  if (candidate->again())
    m.againSeconds = timed(*candidate, m, local.rows(), limits, false, m.solves);
  endAfter(0.0);
  return tell(pipe, m);
}

[[noreturn]] void child(int pipe, const std::function<std::unique_ptr<Candidate>()>& make,
                        const FclibProblem& local, double level, const Limits& limits) {
  // Solvers print; a child must not leave a core file of a gigabyte either.
  const int nothing = open("/dev/null", O_WRONLY);
  dup2(nothing, STDOUT_FILENO);
  dup2(nothing, STDERR_FILENO);
  bool sent = false;
  try {
    sent = inside(pipe, make, local, level, limits);
  } catch (const std::exception&) {
  }
  _exit(sent ? 0 : 1);
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ',');) out.push_back(part);
  return out;
}

void addFiles(const std::filesystem::path& place, std::vector<std::filesystem::path>& files) {
  if (!std::filesystem::is_directory(place)) return files.push_back(place);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(place))
    if (entry.path().extension() == ".hdf5") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
}

constexpr const char* kOutcomes[] = {"solved", "notReached", "limit", "crashed"};

}  // namespace

Measurement measured(const std::function<std::unique_ptr<Candidate>()>& make,
                     const FclibProblem& local, double level, const Limits& limits) {
  int ends[2];
  if (pipe(ends) != 0) return {};
  std::cout.flush();
  const pid_t id = fork();
  if (id == 0) child(ends[1], make, local, level, limits);
  close(ends[1]);
  Measurement m, heard;
  bool any = false;
  while (read(ends[0], &heard, sizeof heard) == static_cast<ssize_t>(sizeof heard))
    m = heard, any = true;
  close(ends[0]);
  int status = 0;
  if (id > 0) waitpid(id, &status, 0);
  if (!any && WIFSIGNALED(status))
    m.outcome = WTERMSIG(status) == SIGPROF ? Outcome::limit : Outcome::crashed;
  m.start = measureOfFclib(local, Eigen::VectorXd::Zero(local.rows()));
  return m;
}

bool Job::wants(const std::string& solver) const {
  return only.empty() || std::find(only.begin(), only.end(), solver) != only.end();
}

Job jobOf(int argc, char** argv) {
  Job job;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.rfind("--", 0) != 0) {
      addFiles(word, job.files);
      continue;
    }
    const std::string value = i + 1 < argc ? argv[++i] : "";
    if (word == "--limit") {
      job.limits.solveSeconds = std::stod(value);
    } else if (word == "--loop") {
      job.limits.loopSeconds = std::stod(value);
    } else if (word == "--only") {
      job.only = split(value);
    } else if (word == "--levels") {
      job.levels.clear();
      for (const std::string& level : split(value)) job.levels.push_back(std::stod(level));
    } else {
      throw std::invalid_argument("unknown option " + word);
    }
  }
  return job;
}

void run(const Job& job, const std::string& program, const std::vector<Entry>& entries,
         std::ostream& out) {
  out << "program,problem,group,form,dim,contacts,solver,level,outcome,iterations,newton,solves,"
         "cold_us,again_us,tolerance,residual,rounding,start,Ef,Eu,limit_s\n";
  for (const std::filesystem::path& file : job.files) {
    const FclibProblem problem = readFclib(file), local = condensed(problem);
    // Sweeps over ten times as many contacts take ten times as long.
    Limits limits = job.limits;
    limits.solveSeconds *= std::max(1.0, local.contacts() / 700.0);
    for (const Entry& entry : entries) {
      if (!job.wants(entry.name) || !entry.make(local)) continue;
      for (const double level : job.levels) {
        const Measurement m = measured([&] { return entry.make(local); }, local, level, limits);
        out << program << ',' << file.stem().string() << ','
            << file.parent_path().filename().string() << ','
            << (problem.global ? "global" : "local") << ',' << local.dim << ',' << local.contacts()
            << ',' << entry.name << ',' << level << ',' << kOutcomes[static_cast<int>(m.outcome)]
            << ',' << m.iterations << ',' << m.newton << ',' << m.solves << ','
            << 1e6 * m.coldSeconds << ',' << 1e6 * m.againSeconds << ',' << m.tolerance << ','
            << m.residual << ',' << m.rounding << ',' << m.start << ',' << m.Ef << ',' << m.Eu
            << ',' << limits.solveSeconds << std::endl;
        if (m.outcome != Outcome::solved) break;
      }
    }
  }
}

}  // namespace dynamy::bench
