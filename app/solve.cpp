/// dynamy solve PROBLEM: solves one contact problem in FCLIB's layout, judged by FCLIB's measure
///
///   √( Σ_c |r_c − P_K(r_c − û_c)|² ) / |q|        of the condensed problem u = W r + q
///
/// The measure of r = 0 is printed as well: |q| contains the sliding velocities, so that even the
/// zero vector has a small measure on some problems.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <dynamy/io/fclib/fclib_file.hpp>
#include <dynamy/io/files/json_writer.hpp>
#include <dynamy/solver/diagnosis/diagnosis.hpp>
#include <dynamy/solver/problem/inclusion_solver.hpp>
#include <memory>

#include "numbers.hpp"
#include "program.hpp"

namespace dynamy::app {
namespace {

using Clock = std::chrono::steady_clock;

struct Task {
  std::string problem, solver = "automatic", maxTime, reactions;
  double tolerance = 1e-8;
  bool json = false;
};

/// FCLIB's measure, and the time limit of --max-time.
class TimedRule final : public FclibRule {
 public:
  explicit TimedRule(double limit) : end_(Clock::now() + std::chrono::duration<double>(limit)) {}
  bool enough() const override { return Clock::now() > end_; }

 private:
  std::chrono::time_point<Clock, std::chrono::duration<double>> end_;
};

struct Solved {
  SolveReport report;
  double atZero = 0.0;   ///< FCLIB's measure of r = 0
  double seconds = 0.0;  ///< time of the solver alone
  FclibSolution solution;
  Diagnosis diagnosis;
};

/// Unlimited time, in effect [s].
constexpr double kLong = 1e9;
/// A problem that takes longer than this [s] is not solved again from other starts.
constexpr double kPatience = 2.0;

Solved solveProblem(const Program& program, const Task& task, const FclibProblem& problem,
                    GivenProblem& given) {
  const std::string name = task.solver == "automatic" ? "Automatic" : task.solver;
  methodElement(program.registry, name, Kind::solver);  // throws the error for an unknown name
  const RegisteredType* type = program.registry.find(name);
  const auto element = type->make(Parameters::of(
      type->attributes, name, "", {{"tolerance", fmt::format("{}", task.tolerance)}}));
  auto& solver = static_cast<InclusionSolver&>(*element);  // the kind was checked
  InclusionProblem& p = given.problem();
  Solved s;
  s.solution.r.setZero(p.rows());
  std::vector<double> scratch;
  const TimedRule rule(task.maxTime.empty() ? kLong : seconds(task.maxTime, "--max-time"));
  p.rule = &rule;
  s.atZero = residuals(p, {s.solution.r.data(), s.solution.r.size()}, scratch).given;
  const auto begin = Clock::now();
  s.report = solver.solve(p, view(s.solution.r));
  if (p.rows() == 0) s.report.residuals = residuals(p, {s.solution.r.data(), 0}, scratch);
  s.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  s.solution.u.resize(p.rows());
  p.G->apply(s.solution.r.data(), s.solution.u.data());
  s.solution.u += ConstVec(p.c.data(), p.rows());
  if (problem.global) s.solution.v = velocities(problem, s.solution.r);
  // The other starts have a second time limit and end by E_f and E_u, not by the FCLIB measure.
  const TimedRule again(task.maxTime.empty() ? kLong : seconds(task.maxTime, "--max-time"));
  p.rule = &again;
  DiagnosisOptions options;
  options.tolerance = task.tolerance;
  options.otherStarts = s.seconds < kPatience;
  s.diagnosis = diagnose(p, {s.solution.r.data(), s.solution.r.size()}, s.report, solver, options);
  return s;
}

std::string text(const Task& task, const FclibProblem& problem, const Solved& s) {
  const SolveReport& r = s.report;
  std::string out =
      fmt::format("{}: {}\n", task.problem,
                  r.ok() ? "solved" : "NOT solved: " + std::string(solveStatusText(r.status)));
  if (!problem.title.empty()) out += fmt::format(" {}\n", problem.title);
  out += fmt::format(" {} contacts of {} rows, {} form\n", problem.contacts(), problem.dim,
                     problem.global ? "global" : "local");
  out += fmt::format(
      " residual {:.3e} of FCLIB (tolerance {:g}; of r = 0 {:.3e}), E_f {:.2e}, E_u {:.2e}\n",
      r.residuals.given, task.tolerance, s.atZero, r.residuals.Ef, r.residuals.Eu);
  out += fmt::format(
      " {} iterations, {} Newton steps of them, {} inner problems given up; {:.4g} ms\n",
      r.iterations, r.newton, r.rejected, 1e3 * s.seconds);
  if (!r.method.empty()) out += fmt::format(" by {}\n", r.method);
  out += s.diagnosis.text(" ");
  if (!r.ok() && r.residuals.given < 1e-3)
    out += fmt::format(" Try --tolerance {:g}, another --solver, or more --max-time\n",
                       10.0 * r.residuals.given);
  return out;
}

std::string json(const Task& task, const FclibProblem& problem, const Solved& s) {
  const SolveReport& r = s.report;
  std::string out;
  JsonWriter j(out, 2);
  j.beginObject().member("problem", task.problem).member("solver", task.solver);
  j.member("solved", r.ok()).member("status", solveStatusText(r.status));
  j.member("method", r.method).member("contacts", problem.contacts()).member("dim", problem.dim);
  j.member("global", problem.global).member("tolerance", task.tolerance);
  j.member("residual", r.residuals.given).member("residualAtZero", s.atZero);
  j.member("Ef", r.residuals.Ef).member("Eu", r.residuals.Eu);
  j.member("worstContact", r.residuals.worst).member("iterations", r.iterations);
  j.member("newton", r.newton).member("rejected", r.rejected).member("seconds", s.seconds);
  const Diagnosis& d = s.diagnosis;
  j.member("closed", d.closed).member("rows", d.rows).member("rank", d.rank);
  j.member("freedom", d.freedom).key("findings").beginArray();
  for (const Finding& f : d.findings) {
    j.beginObject().member("name", findingName(f.kind)).member("value", f.value);
    j.key("contacts").beginArray();
    for (const int i : f.contacts) j.value(i);
    j.endArray().member("text", f.text).member("advice", f.advice).endObject();
  }
  j.endArray().key("tried").beginArray();
  for (int k = 0; k < r.attempts; ++k) {
    const Attempt& a = r.attempt[static_cast<std::size_t>(k)];
    j.beginObject().member("method", a.method).member("iterations", a.iterations);
    j.member("residual", a.residual).endObject();
  }
  j.endArray().endObject();
  return out + '\n';
}

void solve(Program& program, const Task& task) {
  program.load();
  const FclibProblem problem = readFclib(task.problem);
  const std::unique_ptr<GivenProblem> given = inclusionProblem(condensed(problem));
  const Solved s = solveProblem(program, task, problem, *given);
  fmt::print("{}", task.json ? json(task, problem, s) : text(task, problem, s));
  if (!task.reactions.empty()) {
    writeFclib(task.reactions, problem, s.solution);
    if (!task.json) fmt::print(" wrote   {}\n", task.reactions);
  }
  if (!s.report.ok()) program.exitCode = kFailed;
}

}  // namespace

void addSolve(CLI::App& app, Program& program) {
  auto t = std::make_shared<Task>();
  CLI::App* c = app.add_subcommand("solve", "a contact problem of the FCLIB layout (HDF5)");
  c->add_option("PROBLEM", t->problem, "HDF5 file, local or global, 2D or 3D")->required();
  c->add_option("--solver", t->solver, "inclusion solver")
      ->type_name("SOLVER")
      ->capture_default_str();
  c->add_option("--tolerance", t->tolerance, "FCLIB's residual at which the solver stops")
      ->capture_default_str()
      ->check(positiveNumber());
  c->add_option("--max-time", t->maxTime, "time after which it gives up")->type_name("TIME");
  c->add_option("--reactions", t->reactions, "HDF5 file for the problem with /solution/r and u")
      ->type_name("FILE");
  c->add_flag("--json", t->json, "the result as JSON");
  addPlugins(*c, program, false);
  c->callback([t, &program] { solve(program, *t); });
}

}  // namespace dynamy::app
