#include <algorithm>
#include <dynamy/solver/minimal_norm.hpp>
#include <dynamy/solver/problem/stop_with.hpp>
#include <limits>

namespace dynamy {
namespace {

/// a in units of the smallest λ_i.
constexpr double kPath[] = {1e-2, 1e-5, 1e-8};
constexpr double kSameVelocity = 1e-6;  ///< fraction of u_ref: smaller differences are none

}  // namespace

void MinimalNorm::apply(const InclusionProblem& p, InclusionSolver& solver, Vec Lambda,
                        SolveReport& report) {
  double unit = std::numeric_limits<double>::infinity();
  for (int i = 0; i < p.size(); ++i)
    if (const double lambda = contactLambda(p.G->diagonalBlock(i), p.dim(i)); lambda > 0.0)
      unit = std::min(unit, lambda);
  if (!report.ok() || !std::isfinite(unit)) return;
  problem_ = p;
  const StopWith stop(p.rule);
  problem_.G = &G_, problem_.rule = &stop, problem_.stop = p.stop;
  trial_ = Lambda;
  double a = 0.0;
  for (const double part : kPath) {
    a = part * unit;
    BlockRows rows = p.G->blockRows();
    for (int i = 0; i < p.size(); ++i)
      for (int k = 0; k < p.dim(i); ++k)
        rows.value[static_cast<std::size_t>(rows.value0[static_cast<std::size_t>(rows.find(i, i))] +
                                            k * (p.dim(i) + 1))] += a;
    G_.given(*p.contacts, std::move(rows));
    const SolveReport step = solver.solve(problem_, view(trial_));
    report.iterations += step.iterations, report.newton += step.newton;
    if (!step.ok()) return;
  }
  SolveReport last = solver.solve(p, view(trial_));
  report.iterations += last.iterations, report.newton += last.newton;
  if (!last.ok() || trial_.norm() > (1.0 + 1e-9) * Lambda.norm()) return;
  // A solution with other velocities is discarded.
  Eigen::VectorXd change = trial_ - Lambda, velocity(p.rows());
  p.G->apply(change.data(), velocity.data());
  if (velocity.lpNorm<Eigen::Infinity>() > kSameVelocity * p.uRef) return;
  Lambda = trial_;
  report.residuals = last.residuals;
}

}  // namespace dynamy
