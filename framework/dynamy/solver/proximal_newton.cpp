#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/newton/elimination.hpp>
#include <dynamy/solver/proximal_newton.hpp>

namespace dynamy {
namespace {

constexpr double kColdStart = 1e-2;  ///< above: start by sweeps and a large a
constexpr double kWarm =
    1e-8;  ///< start of a after a warm start: one outer step for regular problems
constexpr double kWarmBlock = 1e-8;       ///< start of a after a warm start, for block rows
constexpr double kWarmVelocities = 1e-6;  ///< the same for systems in velocities, which divide by a
/// If no contact changes its state, one step with the smallest a that rounding allows is enough. It
/// is tried first, twice at most.
constexpr double kTried = 1e-8;
constexpr int kProximalTries = 2;
constexpr double kCold = 3e-3;     ///< start of a after sweeps
constexpr double kPressed = 3e-4;  ///< start of a when all contacts are pressed at first
/// ρ of the second attempt: for 88 inclusions of landing stacks, ρ = 2 needs up to 2150 steps, ρ =
/// 10 up to 1650.
constexpr double kPatientRho = 10.0;
constexpr double kInnerShare = 0.8;  ///< part of its first |F| at which an inner problem is solved
/// Rows up to which the dense form is faster than the sparse one in velocities.
constexpr int kMinVelocities = 16;
/// Newton steps of the dense form, after which block rows are tried; fewer where a step is tried
/// again, which often has forces that are not unique: block rows then need less.
constexpr int kMostDenseSteps = 200, kMostDenseAgain = 60;
constexpr double kSmallest = 1e-9;  ///< floor of a: below, the regularisation drowns in rounding

}  // namespace

ProximalNewton::ProximalNewton(const ProximalNewtonOptions& options)
    : options_(options),
      starter_({options.tolerance, 10, Relaxation::exact, 1.0}),
      fallback_({options.tolerance, options.maxIterations, Relaxation::exact, 1.0}) {
  reserve();
}

ProximalNewton::ProximalNewton(const Parameters& x)
    : InclusionSolver(x),
      options_{x["tolerance"], x["maxNewton"].integer(), x["maxIterations"].integer(), 64, 2000},
      starter_({options_.tolerance, 10, Relaxation::exact, 1.0}),
      fallback_({options_.tolerance, options_.maxIterations, Relaxation::exact, 1.0}) {
  reserve();
}

void ProximalNewton::reserve() {
  // The dense form must not allocate in a step, even when its first contact occurs.
  const auto rows = static_cast<std::size_t>(options_.maxRows);
  for (std::vector<double>* v : {&lambda_, &xi_, &F_, &dLambda_, &centre_, &trial_, &best_})
    v->reserve(rows);
  A_.reserve(rows * kMostRows), B_.reserve(rows * kMostRows), J_.reserve(rows * rows);
  scratch_.reserve(4 * rows);
}

bool ProximalNewton::prepare(const InclusionProblem& p) {
  const int n = p.rows();
  if (n > options_.maxRows || p.G->dense() == nullptr) return false;
  const auto rows = static_cast<std::size_t>(n);
  lambda_.resize(static_cast<std::size_t>(p.size()));
  std::size_t blocks = 0;
  for (int i = 0; i < p.size(); ++i) {
    const int dim = p.dim(i);
    lambda_[static_cast<std::size_t>(i)] = contactLambda(p.G->diagonalBlock(i), dim);
    if (!(lambda_[static_cast<std::size_t>(i)] > 0.0)) return false;
    blocks += static_cast<std::size_t>(dim * dim);
  }
  xi_.resize(rows), F_.resize(rows), dLambda_.resize(rows), centre_.resize(rows),
      trial_.resize(rows), best_.resize(rows);
  A_.resize(blocks), B_.resize(blocks), J_.resize(rows * rows);
  return true;
}

double ProximalNewton::evaluate(const InclusionProblem& p, double a, const double* Lambda,
                                bool derivative) {
  const int n = p.rows();
  const double* G = p.G->dense();
  double merit = 0.0;
  double *A = A_.data(), *B = B_.data();
  for (int i = 0; i < p.size(); ++i) {
    const int dim = p.dim(i), first = p.row0(i);
    const double lambda = lambda_[static_cast<std::size_t>(i)], rho = 2.0 / lambda;
    double *xi = xi_.data() + first, *F = F_.data() + first, r[kMostRows], e2 = 0.0;
    for (int k = 0; k < dim; ++k) {
      const int row = first + k;
      double sum = p.c[static_cast<std::size_t>(row)] +
                   a * lambda * (Lambda[row] - centre_[static_cast<std::size_t>(row)]);
      for (int j = 0; j < n; ++j) sum += G[row * n + j] * Lambda[j];
      xi[k] = sum, r[k] = rho, F[k] = Lambda[row];
    }
    const LawInput in = p.input(i);
    p.law(i).prox(in, r, xi, F);  // F = Λ − prox_C(Λ − ρ ξ)
    for (int k = 0; k < dim; ++k) {
      F[k] = Lambda[first + k] - F[k];
      e2 += F[k] * F[k];
    }
    merit += lambda * e2;
    if (!derivative) continue;
    if (!p.law(i).proxDerivative(in, rho, xi, Lambda + first, A, B)) return -1.0;
    A += dim * dim, B += dim * dim;
  }
  return merit;
}

bool ProximalNewton::step(const InclusionProblem& p, double a) {
  const int n = p.rows();
  const double* G = p.G->dense();
  const double *A = A_.data(), *B = B_.data();
  std::fill(J_.begin(), J_.begin() + static_cast<std::ptrdiff_t>(n) * n, 0.0);
  for (int i = 0; i < p.size(); ++i) {
    const int dim = p.dim(i), first = p.row0(i);
    const double lambda = lambda_[static_cast<std::size_t>(i)];
    for (int k = 0; k < dim; ++k) {
      double* row = J_.data() + static_cast<std::ptrdiff_t>(first + k) * n;
      for (int m = 0; m < dim; ++m) {
        const double b = B[k * dim + m];
        row[first + m] += A[k * dim + m] + b * a * lambda;
        if (b == 0.0) continue;
        const double* g = G + static_cast<std::ptrdiff_t>(first + m) * n;
        for (int j = 0; j < n; ++j) row[j] += b * g[j];
      }
      dLambda_[static_cast<std::size_t>(first + k)] = -F_[static_cast<std::size_t>(first + k)];
    }
    A += dim * dim, B += dim * dim;
  }
  return eliminate(J_.data(), dLambda_.data(), n, 1);
}

int ProximalNewton::newton(const InclusionProblem& p, double a, double stop, Vec Lambda) {
  constexpr int kMaxInner = 40, kMemory = 5, kHalvings = 9;
  const auto n = static_cast<std::size_t>(p.rows());
  double recent[kMemory];
  double merit = evaluate(p, a, Lambda.data(), true);
  std::fill(recent, recent + kMemory, merit);
  for (int it = 0; it < kMaxInner; ++it) {
    if (!(merit >= 0.0) || p.enough()) return -1;
    if (it > 0 && std::sqrt(merit) <= stop) return it;
    if (!step(p, a)) return -1;
    const double bound = *std::max_element(recent, recent + kMemory);
    double t = 1.0;
    for (int h = 0; h <= kHalvings; ++h, t *= 0.5) {
      for (std::size_t k = 0; k < n; ++k)
        trial_[k] = Lambda[static_cast<Eigen::Index>(k)] + t * dLambda_[k];
      merit = evaluate(p, a, trial_.data(), true);
      if (merit < bound || merit == 0.0) break;
    }
    std::copy(trial_.begin(), trial_.begin() + static_cast<std::ptrdiff_t>(n), Lambda.data());
    recent[it % kMemory] = merit;
  }
  return -1;
}

SolveReport ProximalNewton::solve(const InclusionProblem& p, Vec Lambda) {
  SolveReport report;
  if (p.rows() == 0) return report;
  report.residuals = residuals(p, view(Lambda), scratch_);
  const double E = report.residuals.largest();
  if (E <= acceptedStart(p, options_.tolerance)) {
    report.warmAccepted = true;
    return report;
  }
  const bool good = E <= options_.tolerance;
  const bool cold = !good && (!(E <= kColdStart) || Lambda.isZero(0.0));
  if (cold) {
    const SolveReport start = starter_.solve(p, Lambda);
    report.iterations = start.iterations;
    report.residuals = start.residuals;
    report.note("sweeps", 0);
    if (start.ok()) return report;
  }
  return refine(p, Lambda, report, cold, scratch_.data());
}

SolveReport ProximalNewton::improve(const InclusionProblem& p, Vec Lambda, SolveReport report) {
  std::copy(Lambda.data(), Lambda.data() + Lambda.size(), centre_.begin());
  const double outer = std::sqrt(std::max(0.0, evaluate(p, 0.0, Lambda.data(), false)));
  const int used = newton(p, kWarm, kInnerShare * outer, Lambda);
  const Residuals after = residuals(p, view(Lambda), scratch_);
  report.iterations += std::max(1, used), report.newton += std::max(1, used);
  if (used > 0 && after.largest() < report.residuals.largest())
    report.residuals = after;
  else  // rounding decides: the start was as good
    std::copy(centre_.begin(), centre_.begin() + Lambda.size(), Lambda.data());
  return report;
}

bool ProximalNewton::press(const InclusionProblem& p, Vec Lambda) {
  const auto normal = [&p](int i) {
    return p.law(i).unilateral() && p.law(i).rowKind(0) == RowKind::normal;
  };
  bool any = false;
  for (int i = 0; i < p.size(); ++i) {
    if (!normal(i)) continue;
    if (!(Lambda[p.row0(i)] > 0.0) || !(contactLambda(p.G->diagonalBlock(i), p.dim(i)) > 0.0))
      return false;
    any = true;
  }
  for (int i = 0; i < p.size() && any; ++i) {
    if (!normal(i)) continue;
    Lambda.segment(p.row0(i), p.dim(i)).setZero();
    Lambda[p.row0(i)] = p.uRef / contactLambda(p.G->diagonalBlock(i), p.dim(i));
  }
  return any;
}

bool ProximalNewton::dense(const InclusionProblem& p, Vec Lambda, double a, int most,
                           SolveReport& report) {
  most = std::min(most, p.effort == Effort::full ? kMostDenseSteps : kMostDenseAgain);
  double bestE = report.residuals.largest();
  std::copy(Lambda.data(), Lambda.data() + Lambda.size(), best_.begin());
  Residuals best = report.residuals;
  for (int steps = 0; steps < most && !p.enough();) {
    std::copy(Lambda.data(), Lambda.data() + Lambda.size(), centre_.begin());
    const double outer = std::sqrt(std::max(0.0, evaluate(p, 0.0, Lambda.data(), false)));
    const int used = newton(p, a, kInnerShare * outer, Lambda), counted = used < 0 ? 40 : used;
    steps += counted, report.iterations += counted, report.newton += counted;
    if (used < 0) {
      ++report.rejected;
      std::copy(centre_.begin(), centre_.begin() + Lambda.size(), Lambda.data());
      a = std::min(1.0, 4.0 * a);
      continue;
    }
    report.residuals = residuals(p, view(Lambda), scratch_);
    if (report.residuals.largest() <= options_.tolerance) return true;
    if (report.residuals.largest() < bestE) {
      best = report.residuals, bestE = best.largest();
      std::copy(Lambda.data(), Lambda.data() + Lambda.size(), best_.begin());
    }
    a = std::max(kSmallest, used <= 4 ? 0.1 * a : (used <= 12 ? 0.5 * a : a));
  }
  std::copy(best_.begin(), best_.begin() + Lambda.size(), Lambda.data());
  report.residuals = best;
  return false;
}

SolveReport ProximalNewton::refine(const InclusionProblem& p, Vec Lambda, SolveReport report,
                                   bool cold, const double* xi, const NewtonLimits* given) {
  const NewtonLimits limits =
      given ? *given
            : NewtonLimits{options_.maxNewton, options_.maxPatient, options_.maxIterations};
  report.status = SolveStatus::solved, report.method = "proximal Newton";
  const bool good = report.residuals.largest() <= options_.tolerance;
  if (xi && !cold && !good && p.G->hasBodies() && p.rows() > kMinVelocities &&
      held_.solve(p, xi, options_.tolerance, Lambda, report))
    return report;
  const bool pressed = cold && press(p, Lambda);
  if (pressed) report.residuals = residuals(p, view(Lambda), scratch_);
  // Few bodies under many contacts: velocities are the smaller system.
  const bool blocks =
      p.G->hasBodies() && p.rows() > kMinVelocities && block_.prepare(p) && block_.inVelocities();
  if (!blocks && prepare(p)) {
    if (good) return improve(p, Lambda, report);
    const int before = report.iterations;
    const double start = pressed ? kPressed : (cold ? kCold : kWarm);
    const bool solved = dense(p, Lambda, start, limits.maxNewton, report);
    report.note("proximal Newton, dense", before);
    if (solved) return report;
    if (p.enough()) {
      report.status = SolveStatus::maxIterations;
      return report;
    }
  }
  const auto left = [&] {
    report.status = SolveStatus::maxIterations;
    return limits.maxIterations == 0 ? report : finish(p, limits.maxIterations, Lambda, report);
  };
  if (!blocks && !block_.prepare(p)) return left();
  if (good) {
    block_.improve(p, Lambda, report);
    return report;
  }
  const double warm = block_.inVelocities() ? kWarmVelocities : kWarmBlock;
  const double start = pressed ? kPressed : (cold ? kCold : warm);
  byBlocks(p, limits, start, !cold, Lambda, report);
  return report.ok() || p.enough() ? report : left();
}

void ProximalNewton::byBlocks(const InclusionProblem& p, const NewtonLimits& limits, double start,
                              bool near, Vec Lambda, SolveReport& report) {
  const auto done = [&](const NewtonSchedule& schedule, std::string_view note) {
    const int before = report.iterations;
    block_.solve(p, schedule, options_.tolerance, Lambda, report);
    report.note(note.empty() ? report.method : note, before);
    return report.ok();
  };
  NewtonSchedule schedule;
  schedule.separateNormal = true;
  schedule.maxNewton = limits.maxNewton;
  schedule.start = start;
  if (near && block_.inVelocities()) {
    NewtonSchedule once = schedule;
    once.start = kTried, once.maxNewton = kProximalTries;
    if (done(once, "proximal Newton, tried")) return;
  }
  if (done(schedule, {}) || p.enough()) return;
  if (limits.maxPatient == 0 || block_.tooLarge()) return;
  schedule.start = kCold, schedule.rho = kPatientRho;
  schedule.maxNewton = limits.maxPatient;
  report.method = "proximal Newton, longer steps";
  done(schedule, {});
}

SolveReport ProximalNewton::finish(const InclusionProblem& p, int most, Vec Lambda,
                                   SolveReport report) {
  // Sweeps may lose what Newton's method has gained: the better one is kept.
  best_.assign(Lambda.data(), Lambda.data() + Lambda.size());
  const Residuals reached = report.residuals;
  const SolveReport last = fallback_.solve(p, options_.tolerance, most, Lambda);
  report.iterations += last.iterations;
  // If sweeps gain nothing, more of them would not help.
  const bool gained = last.residuals.largest() < 0.5 * reached.largest();
  const bool finite = std::isfinite(reached.largest());
  report.status =
      last.ok() || gained ? last.status : (finite ? SolveStatus::stalled : SolveStatus::notFinite);
  report.residuals = last.residuals;
  report.method = "Gauss-Seidel";
  if (!last.ok() && !(last.residuals.largest() <= reached.largest())) {
    std::copy(best_.begin(), best_.end(), Lambda.data());
    report.residuals = reached;
  }
  report.note(report.method, report.iterations - last.iterations);
  return report;
}

void ProximalNewton::declare(Attributes& a) {
  a.about(
      "Dual proximal-point method with Alart-Curnier Newton steps; dense up to 64 rows, above by "
      "sparse block rows.");
  a.optional("tolerance", Unit::none, 1e-10, "residuals E_f and E_u at which the solver stops")
      .positive();
  a.add(AttributeType::integer, "maxNewton", "500",
        "Newton steps, then four times as many with longer steps rho, and Gauss-Seidel")
      .min = 1;
  a.add(AttributeType::integer, "maxIterations", "10000", "sweeps of Gauss-Seidel").min = 1;
  a.example(
      "<simulation until=\"1\" step=\"1e-3\"><ProximalNewton tolerance=\"1e-12\"/></simulation>");
}

}  // namespace dynamy
