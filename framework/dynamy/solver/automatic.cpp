#include <algorithm>
#include <cmath>
#include <dynamy/core/parameters.hpp>
#include <dynamy/solver/automatic.hpp>

namespace dynamy {
namespace {

constexpr double kColdResidual = 1e-2;  ///< above, a start is not near the solution
constexpr int kMostRestarted = 400;     ///< contacts; above, restarts cost seconds
constexpr int kRestartSweeps = 10, kRestartSteps = 1500;
/// Iterations of ADMM, two factorisations at most, before Newton steps whose factors are large.
constexpr int kAlternations = 20;

}  // namespace

Automatic::Automatic(const AutomaticOptions& options)
    : options_(options),
      newton_(
          {options.tolerance, options.maxNewton, options.maxIterations, 64, options.maxPatient}),
      lemke_({.tolerance = options.tolerance, .polish = false}),
      admm_({.tolerance = options.tolerance, .maxIterations = kAlternations}) {}

Automatic::Automatic(const Parameters& x)
    : InclusionSolver(x),
      options_{x["tolerance"], x["maxNewton"].integer(), 4 * x["maxNewton"].integer(),
               x["maxIterations"].integer(), x["minimalNorm"].flag()},
      newton_({options_.tolerance, options_.maxNewton, options_.maxIterations, 64,
               options_.maxPatient}),
      lemke_({.tolerance = options_.tolerance, .polish = false}),
      admm_({.tolerance = options_.tolerance, .maxIterations = kAlternations}) {}

SolveReport Automatic::solve(const InclusionProblem& p, Vec Lambda) {
  SolveReport report = chain(p, Lambda);
  if (options_.minimalNorm && p.rows() > 0) minimalNorm_.apply(p, newton_, Lambda, report);
  return report;
}

SolveReport Automatic::chain(const InclusionProblem& p, Vec Lambda) {
  SolveReport report;
  report.method = "start";
  if (p.rows() == 0) return report;
  report.residuals = residuals(p, view(Lambda), scratch_);
  if (!Lambda.allFinite()) {
    Lambda.setZero();
    report.residuals = residuals(p, view(Lambda), scratch_);
  }
  const double E = report.residuals.largest();
  if (E <= acceptedStart(p, options_.tolerance)) {
    report.warmAccepted = true;
    return report;
  }
  if (!std::isfinite(E)) {
    report.status = SolveStatus::notFinite;
    return report;
  }
  if (p.size() == 1 && easy_.oneContact(p, options_.tolerance, Lambda, report)) return report;
  const bool good = E <= options_.tolerance;  // and still worth a step
  const bool cold = !good && (E > kColdResidual || Lambda.isZero(0.0));
  if (cold && LemkeSolver::pays(p)) {
    report = lemke_.solve(p, Lambda);
    if (report.ok() || lemke_.proven()) return report;
  }
  if (cold && Admm::pays(p) && alternate(p, Lambda, report)) return report;
  if (cold) {
    const int before = report.iterations;
    const bool solved = easy_.sweeps(p, options_.tolerance, Lambda, report);
    report.note("sweeps", before);
    if (solved) return report;
  }
  report = newton_.refine(p, Lambda, report, cold, scratch_.data());
  if (!report.ok()) restarts(p, Lambda, report);
  return report;
}

bool Automatic::restarts(const InclusionProblem& p, Vec Lambda, SolveReport& report) {
  if (report.status == SolveStatus::notFinite || p.size() > kMostRestarted ||
      (p.rule && p.rule->enough()) || !rescue_.prepare(p))
    return false;
  relaxation(p, Relaxation::exact, 1.0, r_);
  Eigen::VectorXd trial(p.rows());
  for (const bool pressed : {false, true}) {
    NewtonSchedule schedule = NewtonSchedule::gentle();
    schedule.maxNewton = kRestartSteps;
    trial.setZero();
    if (pressed) {
      for (int i = 0; i < p.size(); ++i)
        if (const double lambda = contactLambda(p.G->diagonalBlock(i), p.dim(i));
            lambda > 0.0 && p.law(i).rowKind(0) == RowKind::normal)
          trial[p.row0(i)] = 10.0 * p.uRef / lambda;
    } else {
      schedule.separateNormal = true, schedule.rho = 10.0;
      p.G->begin(trial.data());
      for (int k = 0; k < kRestartSweeps; ++k) gaussSeidel_.sweep(p, r_.data(), trial.data());
    }
    SolveReport again;
    again.residuals = residuals(p, view(std::as_const(trial)), scratch_);
    rescue_.solve(p, schedule, options_.tolerance, view(trial), again);
    report.iterations += again.iterations, report.newton += again.newton;
    report.rejected += again.rejected;
    const bool better = again.residuals.largest() < report.residuals.largest();
    if (better) Lambda = trial, report.residuals = again.residuals;
    report.method = pressed ? "proximal Newton, pressed" : "proximal Newton, restarted";
    report.note(report.method, report.iterations - again.iterations);
    if (!again.ok()) continue;
    report.status = SolveStatus::solved;
    return true;
  }
  return false;
}

bool Automatic::alternate(const InclusionProblem& p, Vec Lambda, SolveReport& report) {
  start_.assign(Lambda.data(), Lambda.data() + Lambda.size());
  const SolveReport tried = admm_.solve(p, Lambda);
  report.iterations += tried.iterations;
  report.note(tried.method, report.iterations - tried.iterations);
  if (tried.ok()) {
    report.residuals = tried.residuals, report.method = tried.method;
    return true;
  }
  std::copy(start_.begin(), start_.end(), Lambda.data());
  return false;
}

void Automatic::declare(Attributes& a) {
  a.about(
      "Chooses: accepts a good start, one contact in closed form, sweeps while they pay, then the "
      "proximal Newton method, the same with other steps, Gauss-Seidel.");
  a.optional("tolerance", Unit::none, 1e-10, "residuals E_f and E_u at which the solver stops")
      .positive();
  a.add(AttributeType::integer, "maxNewton", "500",
        "Newton steps; four times as many of the second try")
      .min = 1;
  a.add(AttributeType::integer, "maxIterations", "10000", "sweeps of the last stage").min = 1;
  a.add(AttributeType::flag, "minimalNorm", "false",
        "of forces that are not unique, the smallest: equal shares; about five times the work");
  a.example("<simulation until=\"1\" step=\"1e-3\"><Automatic tolerance=\"1e-12\"/></simulation>");
}

}  // namespace dynamy
