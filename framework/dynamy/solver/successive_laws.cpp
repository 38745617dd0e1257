#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/prox/relaxation.hpp>
#include <dynamy/solver/successive_laws.hpp>

namespace dynamy {
namespace {

constexpr double kInner = 0.1;     ///< inner problems are solved to this part of the tolerance
constexpr double kDiverged = 1e6;  ///< growth of the residual over its best: divergence

}  // namespace

SuccessiveLaws::SuccessiveLaws(const Parameters& x)
    : InclusionSolver(x),
      options_{x["tolerance"], x["maxRounds"].integer(), x["maxIterations"].integer()} {}

double SuccessiveLaws::sweep(const InclusionProblem& p, Phase phase, double* Lambda) {
  double largest = 0.0;
  for (int i = 0; i < p.size(); ++i) {
    const int dim = p.dim(i), first = p.row0(i);
    // A law with a normal force takes part with its normal row or its friction rows, others with
    // all rows.
    const bool coupled = p.law(i).unilateral();
    if (coupled && dim == 1 && phase == Phase::friction) continue;
    double xi[kMostRows], old[kMostRows];
    p.G->row(i, Lambda, xi);
    for (int k = 0; k < dim; ++k) {
      xi[k] += p.c[static_cast<std::size_t>(first + k)];
      old[k] = Lambda[first + k];
      if (coupled && (k == 0) != (phase == Phase::normal)) xi[k] = 0.0;
    }
    p.law(i).prox(p.input(i), r_.data() + first, xi, Lambda + first);
    if (coupled && phase == Phase::normal) std::copy(old + 1, old + dim, Lambda + first + 1);
    for (int k = 0; k < dim; ++k) {
      old[k] = Lambda[first + k] - old[k];
      const double r = r_[static_cast<std::size_t>(first + k)] * p.uRef;
      if (r > 0.0) largest = std::max(largest, std::abs(old[k]) / r);
      if (!std::isfinite(old[k])) return old[k];
    }
    p.G->changed(i, old);
  }
  return largest;
}

int SuccessiveLaws::inner(const InclusionProblem& p, Phase phase, Vec Lambda) {
  p.G->begin(Lambda.data());
  for (int k = 1; k <= options_.maxIterations; ++k)
    if (!(sweep(p, phase, Lambda.data()) > kInner * options_.tolerance) || p.enough()) return k;
  return options_.maxIterations;
}

SolveReport SuccessiveLaws::solve(const InclusionProblem& p, Vec Lambda) {
  SolveReport report;
  report.method = "successive laws";
  rounds_ = 0;
  if (p.rows() == 0) return report;
  report.residuals = residuals(p, view(Lambda), scratch_);
  double best = report.residuals.largest();
  if (best <= std::min(kExactStart, options_.tolerance)) {
    report.warmAccepted = true;
    return report;
  }
  if (!std::isfinite(best)) {
    report.status = SolveStatus::notFinite;
    return report;
  }
  Residuals bestResiduals = report.residuals;
  relaxation(p, Relaxation::exact, 1.0, r_);
  best_.assign(Lambda.data(), Lambda.data() + Lambda.size());
  report.status = SolveStatus::maxIterations;
  while (rounds_ < options_.maxOuter) {
    ++rounds_;
    report.iterations += inner(p, Phase::normal, Lambda);
    report.iterations += inner(p, Phase::friction, Lambda);
    report.residuals = residuals(p, view(Lambda), scratch_);
    const double now = report.residuals.largest();
    if (now <= options_.tolerance) {
      report.status = SolveStatus::solved;
      return report;
    }
    if (now < best) {
      best = now, bestResiduals = report.residuals;
      best_.assign(Lambda.data(), Lambda.data() + Lambda.size());
    }
    if (!(now <= kDiverged * std::max(best, 1.0))) {
      report.status = SolveStatus::diverged;
      break;
    }
    if (p.enough()) break;
  }
  std::copy(best_.begin(), best_.end(), Lambda.data());
  report.residuals = bestResiduals;
  return report;
}

void SuccessiveLaws::declare(Attributes& a) {
  a.about(
      "The laws one after the other: all normal forces with frozen friction, then all frictions "
      "with "
      "frozen normal forces, and again. Contracts for small mu only.");
  a.optional("tolerance", Unit::none, 1e-10, "residuals E_f and E_u at which the solver stops")
      .positive();
  a.add(AttributeType::integer, "maxRounds", "200", "rounds over the two kinds of laws").min = 1;
  a.add(AttributeType::integer, "maxIterations", "2000", "sweeps of one inner problem").min = 1;
  a.example("<simulation until=\"1\" step=\"1e-3\"><SuccessiveLaws/></simulation>");
}

}  // namespace dynamy
