#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/kept_text.hpp>
#include <dynamy/solver/lemke_solver.hpp>

namespace dynamy {
namespace {

ProximalNewtonOptions newtonOptions(double tolerance) {
  ProximalNewtonOptions out;
  out.tolerance = tolerance;
  return out;
}

}  // namespace

LemkeSolver::LemkeSolver(const LemkeOptions& options)
    : options_(options),
      faceted_(keptText("Lemke, " + std::to_string(options.facets) + " facets")),
      polished_(keptText(std::string(faceted_) + ", proximal Newton")),
      newton_(newtonOptions(options.tolerance)) {
  expects(options.facets >= 4 && options.facets % 2 == 0, "facets: an even number from 4");
}

LemkeSolver::LemkeSolver(const Parameters& x)
    : InclusionSolver(x),
      options_{x["tolerance"], x["maxPivots"].integer(), 2 * (x["facets"].integer() / 2),
               x["polish"].flag()},
      faceted_(keptText("Lemke, " + std::to_string(options_.facets) + " facets")),
      polished_(keptText(std::string(faceted_) + ", proximal Newton")),
      newton_(newtonOptions(options_.tolerance)) {}

bool LemkeSolver::pays(const InclusionProblem& p) {
  constexpr int kMostPivoted = 200;
  if (p.G->hasBodies() || p.rows() > kMostPivoted) return false;
  for (int i = 0; i < p.size(); ++i)
    if (!(contactLambda(p.G->diagonalBlock(i), p.dim(i)) > 0.0)) return true;
  return false;
}

SolveReport LemkeSolver::solve(const InclusionProblem& p, Vec Lambda) {
  SolveReport report;
  report.method = "start";
  outcome_ = LcpOutcome::solved;
  if (p.rows() == 0) return report;
  report.residuals = residuals(p, view(Lambda), scratch_);
  if (report.residuals.largest() <= std::min(kExactStart, options_.tolerance)) {
    report.warmAccepted = true;
    return report;
  }
  const Residuals start = report.residuals;
  best_.assign(Lambda.data(), Lambda.data() + Lambda.size());
  form_.pose(p, options_.facets);
  z_.resize(form_.size());
  outcome_ =
      lemke_.solve(form_.M(), form_.q(), view(z_), options_.maxPivots, [&p] { return p.enough(); });
  report.iterations = lemke_.pivots();
  report.method = form_.exact() ? "Lemke" : faceted_;
  report.status = SolveStatus::stalled;
  if (outcome_ == LcpOutcome::pivotLimit) report.status = SolveStatus::maxIterations;
  if (outcome_ == LcpOutcome::infeasible) report.method = "Lemke: there is no solution";
  if (outcome_ == LcpOutcome::ray) report.method = "Lemke: ray";
  if (outcome_ == LcpOutcome::notFinite) {
    report.status = SolveStatus::notFinite;
    return report;
  }
  if (outcome_ == LcpOutcome::solved) {
    form_.forces(z_.data(), Lambda);
    report.residuals = residuals(p, view(Lambda), scratch_);
    if (report.residuals.largest() <= options_.tolerance) {
      report.status = SolveStatus::solved;
      return report;
    }
  }
  if (!std::isfinite(report.residuals.largest())) {
    std::copy(best_.begin(), best_.end(), Lambda.data());
    report.residuals = start;
  }
  if (!options_.polish || proven() || !std::isfinite(start.largest())) return report;
  best_.assign(Lambda.data(), Lambda.data() + Lambda.size());
  const Residuals before = report.residuals;
  const std::string_view found = report.method;
  const bool cold = outcome_ != LcpOutcome::solved;
  report = newton_.refine(p, Lambda, report, cold);
  if (report.ok()) {
    if (!cold) report.method = form_.exact() ? "Lemke, proximal Newton" : polished_;
  } else if (!(report.residuals.largest() <= before.largest())) {
    std::copy(best_.begin(), best_.end(), Lambda.data());
    report.residuals = before, report.method = found;
  }
  return report;
}

void LemkeSolver::declare(Attributes& a) {
  a.about(
      "Lemke's pivoting: the inclusion as a linear complementarity problem, solved in finitely "
      "many "
      "pivots. Exact for joints, contacts without friction, force limits and planar friction; "
      "friction discs become polygons, from whose solution proximal Newton steps go on.");
  a.optional("tolerance", Unit::none, 1e-10, "residuals E_f and E_u at which the solver stops")
      .positive();
  a.add(AttributeType::integer, "maxPivots", "10000", "pivots after which it gives up").min = 1;
  a.add(AttributeType::integer, "facets", "8",
        "vertices of the polygon in a friction disc, even; the direction of friction errs by up to "
        "180°/facets")
      .min = 4;
  a.add(AttributeType::flag, "polish", "true",
        "proximal Newton steps where pivoting does not reach the tolerance");
  a.example("<simulation until=\"1\" step=\"1e-3\"><Lemke facets=\"16\"/></simulation>");
}

}  // namespace dynamy
