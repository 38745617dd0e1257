#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/solver/packed_gauss_seidel.hpp>
#include <limits>

namespace dynamy {
namespace {

/// One of so many sweeps is over all batches, the others pass over those that carry nothing. That
/// a contact begins to carry is seen by the one, and by each test.
constexpr int kSweepsPerWhole = 5;
constexpr int kSweepsBetweenTests = 10;  ///< a test costs about as much as two sweeps
/// A start with a larger residual is compared with Λ = 0: its contacts may have turned since. From
/// 1 on, walls that were hit took 80 to 110 sweeps a step instead of 65 to 79.
constexpr double kFarStart = 10.0;
/// Fraction of the tolerance for the packed measure, which differs from the full one by rounding.
constexpr double kSafe = 0.999;
/// Sweeps have stalled if the best residual does not fall to this fraction of itself in time.
constexpr double kLeastProgress = 0.99;
/// Sweeps within which the best residual must fall, or half of all sweeps if those are more.
constexpr int kSweepsOfPatience = 1000;
/// If a residual exceeds the best one by this factor, sweeps return to the best Λ, and β is
/// multiplied by kLess. Corners of faces have λ down to −0.5 in (4.25), and diverge with β > ½.
constexpr double kLostFrom = 3.0, kLess = 0.8;
/// Largest β of problems that cannot be packed: the default of BlockGaussSeidel.
constexpr double kPlainMomentum = 0.7;

ProxOptions plain(const PackedOptions& options) {
  return {.tolerance = options.tolerance,
          .maxIterations = options.maxIterations,
          .momentum = std::min(options.momentum, kPlainMomentum)};
}

}  // namespace

PackedGaussSeidel::PackedGaussSeidel(const PackedOptions& options)
    : options_(options), plain_(plain(options)) {}

PackedGaussSeidel::PackedGaussSeidel(const Parameters& x)
    : InclusionSolver(x),
      options_{x["tolerance"], x["maxIterations"].integer(), x["momentum"]},
      plain_(plain(options_)) {}

SolveReport PackedGaussSeidel::solve(const InclusionProblem& p, Vec Lambda) {
  SolveReport report;
  if (p.rows() == 0) return report;
  report.residuals = residuals(p, view(Lambda), scratch_);
  if (report.residuals.largest() <= acceptedStart(p, options_.tolerance)) {
    report.warmAccepted = true;
    return report;
  }
  if (!std::isfinite(report.residuals.largest())) {
    report.status = SolveStatus::notFinite;
    return report;
  }
  sweeps(p, options_.tolerance, options_.maxIterations, Lambda, report);
  return report;
}

bool PackedGaussSeidel::plainSweeps(const InclusionProblem& p, double tolerance, int most,
                                    Vec Lambda, SolveReport& report) {
  const SolveReport found = plain_.solve(p, tolerance, most, Lambda);
  report.status = found.status, report.residuals = found.residuals;
  report.warmAccepted = found.warmAccepted;
  report.iterations += found.iterations;
  report.method = "sweeps";
  return report.ok();
}

void PackedGaussSeidel::chooseStart(const InclusionProblem& p, Vec Lambda, SolveReport& report) {
  if (report.residuals.largest() <= kFarStart || Lambda.isZero(0.0)) return;
  best_.assign(Lambda.data(), Lambda.data() + Lambda.size());
  Lambda.setZero();
  const Residuals cold = residuals(p, view(Lambda), scratch_);
  if (cold.largest() < report.residuals.largest())
    report.residuals = cold;
  else
    std::copy(best_.begin(), best_.end(), Lambda.data());
}

double PackedGaussSeidel::tested(const InclusionProblem& p) {
  const PackedMeasure now = packed_.measure(p);
  const double force = std::max(std::sqrt(now.Lambda2), packed_.largestRho() * p.uRef);
  const double Ef = force > 0.0 ? std::sqrt(now.force2) / force : 0.0;
  const double Eu = p.uRef > 0.0 ? std::sqrt(now.velocity2) / p.uRef : 0.0;
  return std::isfinite(Ef + Eu) ? std::max(Ef, Eu) : std::numeric_limits<double>::infinity();
}

bool PackedGaussSeidel::sweeps(const InclusionProblem& p, double tolerance, int most, Vec Lambda,
                               SolveReport& report) {
  // Batches cannot evaluate a problem's own measure.
  if (p.rule || !p.G->hasBodies()) return plainSweeps(p, tolerance, most, Lambda, report);
  chooseStart(p, Lambda, report);
  if (!packed_.prepare(p, Lambda.data())) return plainSweeps(p, tolerance, most, Lambda, report);
  report.method = "packed sweeps";
  packed_.load(Lambda.data());
  best_.assign(Lambda.data(), Lambda.data() + Lambda.size());
  double best = report.residuals.largest(), bound = options_.momentum, mark = best;
  double asked = kSafe * tolerance;
  report.status = SolveStatus::maxIterations;
  for (int sweep = 1, k = 1, marked = 0; sweep <= most; ++sweep) {
    const double beta = std::min(bound, (k - 1.0) / (k + 2.0));
    k = packed_.sweep(p, beta, sweep % kSweepsPerWhole == 1) > 0.0 ? 1 : k + 1;
    ++report.iterations;
    if (sweep % kSweepsBetweenTests != 0 && sweep != most) continue;
    const double now = tested(p);
    if (now < best) best = now, packed_.store(best_.data());
    if (!(now <= kLostFrom * best)) {
      packed_.load(best_.data());
      bound *= kLess, k = 1;
    }
    if (best <= kLeastProgress * mark) mark = best, marked = sweep;
    if (p.enough()) break;
    if (sweep - marked > std::max(kSweepsOfPatience, sweep / 2)) {
      report.status = SolveStatus::stalled;
      break;
    }
    if (now > asked) continue;
    packed_.store(Lambda.data());
    report.residuals = residuals(p, view(Lambda), scratch_);
    if (report.residuals.largest() <= tolerance) {
      report.status = SolveStatus::solved;
      return true;
    }
    asked *= 0.5;
  }
  std::copy(best_.begin(), best_.end(), Lambda.data());
  report.residuals = residuals(p, view(Lambda), scratch_);
  if (report.residuals.largest() <= tolerance) report.status = SolveStatus::solved;
  return report.ok();
}

void PackedGaussSeidel::declare(Attributes& a) {
  a.about(
      "Gauss-Seidel over eight contacts at a time, with momentum: many contacts of rigid bodies at "
      "engineering accuracy.");
  a.optional("tolerance", Unit::none, 1e-2, "residuals E_f and E_u at which the solver stops")
      .positive();
  a.add(AttributeType::integer, "maxIterations", "10000", "sweeps after which it gives up").min = 1;
  a.optional("momentum", Unit::none, 0.9,
             "part of the last change by which a sweep starts further on; 0: none")
      .between(0.0, 1.0);
  a.example(
      "<simulation until=\"1\" step=\"2ms\"><PackedGaussSeidel "
      "maxIterations=\"50\"/></simulation>");
}

}  // namespace dynamy
