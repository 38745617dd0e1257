#include <algorithm>
#include <cmath>
#include <dynamy/core/parameters.hpp>
#include <dynamy/solver/prox_solvers.hpp>

namespace dynamy {
namespace {

constexpr int kMaxDim = 8;

Relaxation relaxationByName(const std::string& word) {
  if (word == "diagonalDominance") return Relaxation::diagonalDominance;
  if (word == "rowSums") return Relaxation::rowSums;
  if (word == "spectral") return Relaxation::spectral;
  if (word == "optimal") return Relaxation::optimal;
  return Relaxation::exact;
}

/// A sweep that changes Λ by less than this fraction of the tolerance is worth a full residual
/// test.
constexpr double kPreTest = 10.0;

/// max_i |ΔΛ_i| / (r_i u_ref): the velocity form of the last sweep's change, a cheap pre-test of
/// E_u.
double change(const InclusionProblem& p, const double* r, const double* before,
              const double* Lambda) {
  double largest = 0.0;
  for (int k = 0; k < p.rows(); ++k) {
    const double d = std::abs(Lambda[k] - before[k]);
    const double scale = r[k] > 0.0 ? r[k] * p.uRef : 0.0;
    const double value = scale > 0.0 ? d / scale : (d > 0.0 ? 1.0 : 0.0);
    if (!std::isfinite(value)) return value;
    largest = std::max(largest, value);
  }
  return largest;
}

}  // namespace

ProxSolver::ProxSolver(const Parameters& x, Relaxation) : InclusionSolver(x) {
  options_.tolerance = x["tolerance"];
  options_.maxIterations = x["maxIterations"].integer();
  options_.relaxation = relaxationByName(x["relaxation"].text);
  options_.factor = x["factor"];
}

void ProxSolver::declareCommon(Attributes& a, const char* defaultRule) {
  a.optional("tolerance", Unit::none, 1e-10, "residuals E_f and E_u at which the solver stops")
      .positive();
  Attribute& n =
      a.add(AttributeType::integer, "maxIterations", "10000", "sweeps after which it gives up");
  n.min = 1;
  a.choice("relaxation", {"exact", "diagonalDominance", "rowSums", "spectral", "optimal"},
           defaultRule, "rule for the prox parameters r");
  a.optional("factor", Unit::none, 1.0, "multiplies r").positive();
}

SolveReport ProxSolver::solve(const InclusionProblem& problem, Vec Lambda) {
  SolveReport report;
  if (problem.rows() == 0) return report;
  const auto done = [&] {
    report.residuals = residuals(problem, view(Lambda), scratch_);
    return report.residuals.largest() <= options_.tolerance;
  };
  done();
  if (report.residuals.largest() <= acceptedStart(problem, options_.tolerance)) {
    report.warmAccepted = true;
    return report;
  }
  if (!std::isfinite(report.residuals.Eu)) {
    report.status = SolveStatus::notFinite;
    return report;
  }
  relaxation(problem, options_.relaxation, options_.factor, r_);
  prepare(problem);
  before_.resize(static_cast<std::size_t>(problem.rows()));
  problem.G->begin(Lambda.data());
  double first = -1.0;
  int nextTest = 1;
  while (report.iterations < options_.maxIterations) {
    Vec(before_.data(), problem.rows()) = Lambda;
    sweep(problem, r_.data(), Lambda.data());
    ++report.iterations;
    const double d = change(problem, r_.data(), before_.data(), Lambda.data());
    if (first < 0.0) first = d;
    if (!std::isfinite(d) || d > 1e12 * (first + 1.0)) {
      report.status = std::isfinite(d) ? SolveStatus::diverged : SolveStatus::notFinite;
      report.residuals = residuals(problem, view(Lambda), scratch_);
      return report;
    }
    // The change alone would flatter a creeping iteration: it only says when the full test is worth
    // its price.
    if (d > kPreTest * options_.tolerance && report.iterations < nextTest) continue;
    if (done()) return report;
    if (problem.rule && problem.rule->enough()) break;
    problem.G->begin(Lambda.data());
    nextTest = report.iterations + 1 + report.iterations / 8;
  }
  report.status = SolveStatus::maxIterations;
  report.residuals = residuals(problem, view(Lambda), scratch_);
  return report;
}

void ProxGaussSeidel::sweep(const InclusionProblem& problem, const double* r, double* Lambda) {
  for (int i = 0; i < problem.size(); ++i) {
    const int dim = problem.dim(i), first = problem.row0(i);
    double xi[kMaxDim], old[kMaxDim];
    problem.G->row(i, Lambda, xi);
    for (int k = 0; k < dim; ++k) {
      xi[k] += problem.c[static_cast<std::size_t>(first + k)];
      old[k] = Lambda[first + k];
    }
    problem.law(i).prox(problem.input(i), r + first, xi,
                        Lambda + first);  // Λ_i ← prox_C(Λ_i − r_i ξ_i), newest Λ at once
    for (int k = 0; k < dim; ++k) old[k] = Lambda[first + k] - old[k];
    problem.G->changed(i, old);
  }
}

void ProxJacobi::sweep(const InclusionProblem& problem, const double* r, double* Lambda) {
  xi_.resize(static_cast<std::size_t>(problem.rows()));
  problem.G->apply(Lambda, xi_.data());
  for (int i = 0; i < problem.size(); ++i) {
    const int first = problem.row0(i);
    for (int k = 0; k < problem.dim(i); ++k)
      xi_[static_cast<std::size_t>(first + k)] += problem.c[static_cast<std::size_t>(first + k)];
    problem.law(i).prox(problem.input(i), r + first, xi_.data() + first,
                        Lambda + first);  // all i from the old Λ
  }
}

void ProxGaussSeidel::declare(Attributes& a) {
  declareCommon(a, "exact");
  a.about(
      "Projected Gauss-Seidel (prox SOR): Lambda_i <- prox(Lambda_i - r_i xi_i), newest values at "
      "once.");
  a.example(
      "<simulation until=\"1\" step=\"1e-3\"><ProxGaussSeidel tolerance=\"1e-10\"/></simulation>");
}

void ProxJacobi::declare(Attributes& a) {
  declareCommon(a, "diagonalDominance");
  a.about(
      "Projected Jacobi (prox JOR): all contacts from the old values; r by diagonal dominance "
      "(Studer 2009, 4.59-4.60).");
  a.example("<simulation until=\"1\" step=\"1e-3\"><ProxJacobi/></simulation>");
}

}  // namespace dynamy
