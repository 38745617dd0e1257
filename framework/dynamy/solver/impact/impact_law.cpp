#include <algorithm>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/impact/impact_law.hpp>

namespace dynamy {
namespace {

/// Is γ^A of row k more than rounding?
bool beyondNoise(const InclusionProblem& problem, std::size_t k) {
  return std::abs(problem.gammaA[k]) > (problem.cNoise.empty() ? 0.0 : problem.cNoise[k]);
}

}  // namespace

SolveReport ImpactLaw::solve(InclusionProblem& problem, InclusionSolver& solver, Vec Lambda) const {
  SolveReport report = guarded(problem, solver, Lambda);
  count(problem, report);
  if (!report.ok() && guard_.bound(problem, Lambda))
    report.residuals = residuals(problem, view(Lambda), scratch_);
  return report;
}

SolveReport ImpactLaw::guarded(InclusionProblem& problem, InclusionSolver& solver,
                               Vec Lambda) const {
  std::vector<double>& factor = guard_.factor(problem);
  SolveReport report = percussions(problem, solver, factor, Lambda);
  if (!rebounds(problem)) return report;  // ε = 0 only dissipates (theory 32.3)
  if (!report.ok() && problem.effort != Effort::full) return report;  // the step is tried again
  guard_.begin(problem, view(Lambda));
  if (guard_.gain() <= 0.0) return report;
  const double gain = guard_.gain();
  const int repaired = guard_.gaining();
  const Effort effort = problem.effort;
  // Find the largest factors, one per group, at which no group gains energy.
  while (guard_.next()) {
    if (report.inVain && effort == Effort::full) problem.effort = Effort::retried;
    const SolveReport again = percussions(problem, solver, factor, Lambda);
    const bool neither = !report.ok() && !again.ok();
    addSolve(report, again);
    report.status = again.status;  // the last percussions are the result
    if (neither) break;            // gains of percussions that solve nothing say nothing of the law
    guard_.judge(problem, view(Lambda));
  }
  problem.effort = effort;
  report.energyGain = gain, report.repaired = repaired;
  return report;
}

void poseRestitution(InclusionProblem& problem, const std::vector<double>& factor) {
  const SetValuedForceLaw* last = nullptr;
  double epsilon[kMostRows] = {};
  int rows = 0;
  for (int i = 0; i < problem.size(); ++i) {
    const int dim = problem.dim(i), first = problem.row0(i);
    if (&problem.law(i) != last || dim != rows) {  // most neighbours share one law
      last = &problem.law(i), rows = dim;
      std::fill(epsilon, epsilon + kMostRows, 0.0);
      last->epsilon(dim, epsilon);
    }
    const double f = factor[static_cast<std::size_t>(i)];
    for (int r = 0; r < dim; ++r) {
      const auto k = static_cast<std::size_t>(first + r);
      problem.c[k] = problem.gammaFree[k] + f * epsilon[r] * problem.gammaA[k];
    }
  }
}

void addSolve(SolveReport& total, const SolveReport& last) {
  const int iterations = total.iterations + last.iterations, newton = total.newton + last.newton;
  const int rejected = total.rejected + last.rejected;
  const SolveStatus status = total.ok() ? last.status : total.status;
  const bool inVain = total.inVain || last.inVain;
  total = last;
  total.iterations = iterations, total.newton = newton, total.rejected = rejected;
  total.status = status, total.inVain = inVain;
}

bool rebounds(const InclusionProblem& problem) {
  const SetValuedForceLaw* without = nullptr;  // most neighbours share one law, which has ε = 0
  int rows = 0;
  for (int i = 0; i < problem.size(); ++i) {
    const int dim = problem.dim(i), first = problem.row0(i);
    if (&problem.law(i) == without && dim == rows) continue;
    double epsilon[kMostRows] = {};
    problem.law(i).epsilon(dim, epsilon);
    if (std::all_of(epsilon, epsilon + dim, [](double e) { return e == 0.0; })) {
      without = &problem.law(i), rows = dim;
      continue;
    }
    for (int r = 0; r < dim; ++r)
      if (epsilon[r] != 0.0 && beyondNoise(problem, static_cast<std::size_t>(first + r)))
        return true;
  }
  return false;
}

SolveReport NewtonImpact::percussions(InclusionProblem& problem, InclusionSolver& solver,
                                      const std::vector<double>& factor, Vec Lambda) const {
  poseRestitution(problem, factor);  // ξ = γ^E + ε γ^A
  return solver.solve(problem, Lambda);
}

void NewtonImpact::declare(Attributes& a) {
  a.about(
      "Newton's impact law in Moreau's inequality form: xi = gammaE + epsilon gammaA, one "
      "inclusion.");
  a.example("<simulation until=\"1\" step=\"1e-3\"><NewtonImpact/></simulation>");
}

}  // namespace dynamy
