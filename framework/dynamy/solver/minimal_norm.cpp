#include <algorithm>
#include <cmath>
#include <dynamy/solver/minimal_norm.hpp>
#include <dynamy/solver/problem/stop_with.hpp>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace dynamy {
namespace {

/// a in units of the smallest λ_i.
constexpr double kPath[] = {1e-2, 1e-5, 1e-8};
/// To stay at the solution of a path, at most so many proximal steps −(GΛ + c + a (Λ − Λ_k)) ∈ N_C(Λ)
/// follow from its second a: with less Newton's method may go to a solution that moves.
constexpr int kProximal = 8;
constexpr double kExact = 1e-12;
constexpr double kSameVelocity = 1e-6;  ///< fraction of u_ref: smaller differences are none

}  // namespace

bool MinimalNorm::follow(const InclusionProblem& p, InclusionSolver& solver, double stays,
                         SolveReport& report) {
  double unit = std::numeric_limits<double>::infinity();
  for (int i = 0; i < p.size(); ++i)
    if (const double lambda = contactLambda(p.G->diagonalBlock(i), p.dim(i)); lambda > 0.0)
      unit = std::min(unit, lambda);
  if (!std::isfinite(unit)) return false;
  problem_ = p;
  const StopWith stop(p.rule);
  problem_.G = &G_, problem_.rule = &stop, problem_.stop = p.stop;
  const auto solved = [&](const InclusionProblem& problem) {
    const SolveReport step = solver.solve(problem, view(trial_));
    report.iterations += step.iterations, report.newton += step.newton;
    if (step.ok()) report.residuals = step.residuals;
    return step.ok();
  };
  for (const double part : kPath) {
    if (stays > 0.0 && part == *std::rbegin(kPath)) break;
    BlockRows rows = p.G->blockRows();
    for (int i = 0; i < p.size(); ++i)
      for (int k = 0; k < p.dim(i); ++k)
        rows.value[static_cast<std::size_t>(rows.value0[static_cast<std::size_t>(rows.find(i, i))] +
                                            k * (p.dim(i) + 1))] += part * unit;
    G_.given(*p.contacts, std::move(rows));
    if (!solved(problem_)) return false;
  }
  if (!(stays > 0.0)) return solved(p);
  problem_.corrected = Corrected::never;  // each step begins near its solution, and is taken
  std::vector<double> scratch;
  double last = std::numeric_limits<double>::infinity();
  for (int k = 0;; ++k) {
    report.residuals = residuals(p, view(std::as_const(trial_)), scratch);
    const double now = report.residuals.largest();
    // Velocities of contacts that contradict each other, by rounding, leave a residual.
    if (now <= kExact || k == kProximal || now > 0.5 * last) return now <= stays;
    last = now;
    const double a = kPath[1] * unit;
    for (Eigen::Index i = 0; i < trial_.size(); ++i)
      problem_.c[static_cast<std::size_t>(i)] = p.c[static_cast<std::size_t>(i)] - a * trial_[i];
    if (!solved(problem_)) return false;
  }
}

void MinimalNorm::apply(const InclusionProblem& p, InclusionSolver& solver, Vec Lambda,
                        SolveReport& report) {
  if (!report.ok()) return;
  trial_ = Lambda;
  const Residuals before = report.residuals;
  const bool found = follow(p, solver, 0.0, report);
  const Residuals last = std::exchange(report.residuals, before);
  if (!found || trial_.norm() > (1.0 + 1e-9) * Lambda.norm()) return;
  // A solution with other velocities is discarded.
  Eigen::VectorXd change = trial_ - Lambda, velocity(p.rows());
  p.G->apply(change.data(), velocity.data());
  if (velocity.lpNorm<Eigen::Infinity>() > kSameVelocity * p.uRef) return;
  Lambda = trial_;
  report.residuals = last;
}

bool MinimalNorm::rest(const InclusionProblem& p, InclusionSolver& solver, double tolerance,
                       Vec Lambda, SolveReport& report) {
  trial_.setZero(p.rows());
  const SolveReport before = report;
  if (follow(p, solver, tolerance, report)) {
    Eigen::VectorXd xi(p.rows());
    p.G->apply(trial_.data(), xi.data());
    xi += Eigen::Map<const Eigen::VectorXd>(p.c.data(), p.rows());
    if (xi.lpNorm<Eigen::Infinity>() <= kSameVelocity * p.uRef) {
      Lambda = trial_;
      report.method = "rest", report.status = SolveStatus::solved;
      return true;
    }
  }
  const int iterations = report.iterations, newton = report.newton;
  report = before;
  report.iterations = iterations, report.newton = newton;
  return false;
}

}  // namespace dynamy
