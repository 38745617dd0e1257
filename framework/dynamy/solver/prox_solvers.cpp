#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/prox_solvers.hpp>

namespace dynamy {
namespace {

Relaxation relaxationByName(const std::string& word) {
  if (word == "diagonalDominance") return Relaxation::diagonalDominance;
  if (word == "rowSums") return Relaxation::rowSums;
  if (word == "spectral") return Relaxation::spectral;
  if (word == "optimal") return Relaxation::optimal;
  return Relaxation::exact;
}

/// Ratio of the residual to the change of the last sweep, until a test has measured it. If this
/// ratio times the change is below the tolerance, a full test is made, which costs as much as three
/// sweeps.
constexpr double kPart = 0.1;
/// Sweeps have stalled if the best residual does not fall to this fraction of itself in time.
constexpr double kProgress = 0.99;
/// Sweeps within which the best residual must fall, or half of all sweeps if those are more.
constexpr int kPatience = 1000;
/// Ratio of a sweep's change to that of the first sweep, above which a stall is a slow divergence.
constexpr double kGrowth = 1e3;

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
  options_.anderson = x["anderson"].integer();
  options_.momentum = x["momentum"];
  options_.symmetric = x.has("order") && x["order"].text == "symmetric";
}

void ProxSolver::declareCommon(Attributes& a, const char* defaultRule, double momentum) {
  a.optional("tolerance", Unit::none, 1e-10, "residuals E_f and E_u at which the solver stops")
      .positive();
  Attribute& n =
      a.add(AttributeType::integer, "maxIterations", "10000", "sweeps after which it gives up");
  n.min = 1;
  a.choice("relaxation", {"exact", "diagonalDominance", "rowSums", "spectral", "optimal"},
           defaultRule, "rule for the prox parameters r");
  a.optional("factor", Unit::none, 1.0, "multiplies r").positive();
  Attribute& depth = a.add(AttributeType::integer, "anderson", "0",
                           "depth of Anderson's acceleration, 5 to 10 are usual; 0: none");
  depth.min = 0, depth.max = Anderson::kMaxMemory;
  a.optional("momentum", Unit::none, momentum,
             "part of the last change by which a sweep starts further on, if not anderson; 0: none")
      .between(0.0, 1.0);
}

void ProxSolver::declareOrder(Attributes& a) {
  a.choice("order", {"forward", "symmetric"}, "forward",
           "symmetric: every sweep to and fro, counted as two");
}

SolveReport ProxSolver::solve(const InclusionProblem& problem, double tolerance, int most,
                              Vec Lambda) {
  SolveReport report;
  if (problem.rows() == 0) return report;
  report.residuals = residuals(problem, view(Lambda), scratch_);
  if (report.residuals.largest() <= acceptedStart(problem, tolerance)) {
    report.warmAccepted = true;
    return report;
  }
  if (!std::isfinite(report.residuals.Eu)) {
    report.status = SolveStatus::notFinite;
    return report;
  }
  const auto rows = static_cast<std::size_t>(problem.rows());
  relaxation(problem, options_.relaxation, options_.factor, r_);
  prepare(problem);
  before_.resize(rows), best_.resize(rows);
  if (options_.anderson > 0) {
    // 1/r: the norm of an energy.
    weights_.resize(rows);
    for (std::size_t k = 0; k < rows; ++k) weights_[k] = r_[k] > 0.0 ? 1.0 / r_[k] : 1.0;
    anderson_.begin(options_.anderson, weights_.data(), problem.rows());
  }
  iterate(problem, tolerance, most, Lambda, report);
  return report;
}

void ProxSolver::goBack(const InclusionProblem& problem, Vec Lambda) {
  Lambda = ConstVec(best_.data(), problem.rows());
  problem.G->begin(Lambda.data());
}

void ProxSolver::iterate(const InclusionProblem& problem, double tolerance, int most, Vec Lambda,
                         SolveReport& report) {
  const int passes = options_.symmetric ? 2 : 1;
  double first = -1.0, mark = report.residuals.largest(), part = kPart;
  Residuals best = report.residuals;
  Vec(best_.data(), problem.rows()) = Lambda;
  int nextTest = 1, marked = 0;
  report.status = SolveStatus::maxIterations;
  problem.G->begin(Lambda.data());
  momentum_.begin(options_.anderson > 0 ? 0.0 : options_.momentum);
  for (bool fresh = true; report.iterations < most; fresh = false) {
    if (!fresh && options_.anderson > 0) {
      anderson_.next(before_.data(), Lambda.data(), Lambda.data());
      problem.G->begin(Lambda.data());
    } else if (!fresh) {
      momentum_.next(problem, Lambda.data());
    }
    Vec(before_.data(), problem.rows()) = Lambda;
    sweep(problem, r_.data(), Lambda.data());
    report.iterations += passes;
    const double d = change(problem, r_.data(), before_.data(), Lambda.data());
    if (first < 0.0) first = d;
    const bool lost = !std::isfinite(d) || d > 1e12 * (first + 1.0);
    if (lost && momentum_.end()) {
      goBack(problem, Lambda);
      continue;
    }
    if (lost) report.status = std::isfinite(d) ? SolveStatus::diverged : SolveStatus::notFinite;
    // The change alone underestimates the error of a slow iteration: it only decides when the full
    // test is worth its price.
    const bool enough = problem.enough();
    const bool last = lost || enough || report.iterations >= most;
    if (part * d > tolerance && report.iterations < nextTest && !last) continue;
    const Residuals now = residuals(problem, view(Lambda), scratch_);
    if (d > 0.0) part = std::max(kPart, now.largest() / d);
    if (now.largest() < best.largest()) {
      best = now;
      Vec(best_.data(), problem.rows()) = Lambda;
    } else {
      momentum_.halve();
    }
    if (now.largest() <= tolerance) report.status = SolveStatus::solved;
    if (now.largest() <= tolerance || lost || enough) break;
    if (best.largest() <= kProgress * mark) mark = best.largest(), marked = report.iterations;
    if (report.iterations - marked > std::max(kPatience * passes, report.iterations / 2)) {
      if (momentum_.end()) {
        goBack(problem, Lambda), marked = report.iterations;
        continue;
      }
      report.status = d > kGrowth * (first + 1.0) ? SolveStatus::diverged : SolveStatus::stalled;
      break;
    }
    problem.G->begin(Lambda.data());
    nextTest = 2 * report.iterations + passes;
  }
  Lambda = ConstVec(best_.data(), problem.rows());
  report.residuals = best;
}

void ProxGaussSeidel::sweep(const InclusionProblem& problem, const double* r, double* Lambda) {
  for (int i = 0; i < problem.size(); ++i) contact(problem, i, r, Lambda);
  if (!options().symmetric) return;
  for (int i = problem.size() - 1; i >= 0; --i) contact(problem, i, r, Lambda);
}

void ProxGaussSeidel::contact(const InclusionProblem& problem, int i, const double* r,
                              double* Lambda) {
  const int dim = problem.dim(i), first = problem.row0(i);
  double xi[kMostRows], old[kMostRows];
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
  declareOrder(a);
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
