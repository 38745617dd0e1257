#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/newton/elimination.hpp>
#include <dynamy/solver/semismooth_newton.hpp>
#include <limits>

namespace dynamy {
namespace {

constexpr double kColdMerit = 1e-2;       ///< above: start by sweeps
constexpr int kMostDenseRows = 200;       ///< rows up to which A + BG is dense, with row pivoting
constexpr double kSingularPivot = 1e-14;  ///< pivots below this part of the largest entry are zero
constexpr double kArmijo = 1e-4;          ///< fraction of the predicted decrease that is required
constexpr int kMeritsKept = 5;            ///< values of |F|² a nonmonotone step is compared with
constexpr int kMeritHalvings = 12;
constexpr int kPatientSteps = 20;  ///< steps in a row without a sufficient decrease
constexpr double kRho = 2.0;

SemismoothOptions read(const Parameters& x) {
  SemismoothOptions o;
  o.tolerance = x["tolerance"];
  o.maxNewton = x["maxNewton"].integer();
  o.sweeps = x["sweeps"].integer();
  o.formulation = x["formulation"].text == "fischerBurmeister"
                      ? SemismoothOptions::Formulation::fischerBurmeister
                      : SemismoothOptions::Formulation::alartCurnier;
  const std::string search = x["lineSearch"].text;
  o.lineSearch = search == "none"     ? SemismoothOptions::LineSearch::none
                 : search == "armijo" ? SemismoothOptions::LineSearch::armijo
                                      : SemismoothOptions::LineSearch::nonmonotone;
  return o;
}

}  // namespace

SemismoothNewton::SemismoothNewton(const SemismoothOptions& options)
    : options_(options), starter_({options.tolerance, options.sweeps, Relaxation::exact, 1.0}) {}

SemismoothNewton::SemismoothNewton(const Parameters& x)
    : InclusionSolver(x),
      options_(read(x)),
      starter_({options_.tolerance, options_.sweeps, Relaxation::exact, 1.0}) {}

bool SemismoothNewton::prepare(const InclusionProblem& p) {
  const auto rows = static_cast<std::size_t>(p.rows()), size = static_cast<std::size_t>(p.size());
  lambda_.resize(size), cone_.resize(size), blocks_.block0.resize(size);
  std::ptrdiff_t entries = 0;
  int dim = 1;
  for (int i = 0; i < p.size(); ++i) {
    dim = std::max(dim, p.dim(i));
    lambda_[i] = contactLambda(p.G->diagonalBlock(i), p.dim(i));
    if (!(lambda_[i] > 0.0)) return false;
    cone_[i] = options_.formulation == Formulation::fischerBurmeister ? coneOf(p.law(i), p.input(i))
                                                                      : LawCone{};
    blocks_.block0[i] = entries;
    entries += static_cast<std::ptrdiff_t>(p.dim(i)) * p.dim(i);
  }
  blocks_.A.resize(entries), blocks_.B.resize(entries);
  blocks_.F.resize(rows), blocks_.a.assign(size, 0.0);
  for (std::vector<double>* v :
       {&r_, &Lambda_, &xi_, &dLambda_, &dXi_, &trialLambda_, &trialXi_, &trialF_, &best_})
    v->resize(rows);
  relaxation(p, Relaxation::exact, kRho, r_);
  for (int i = 0; i < p.size(); ++i) {
    // If the normal force comes first, the rows may have their own r; otherwise all share one.
    double* r = r_.data() + p.row0(i);
    if (p.law(i).rowKind(0) == RowKind::normal && cone_[i].kind == LawCone::Kind::other &&
        p.dim(i) <= 3)
      continue;
    std::fill(r, r + p.dim(i), kRho / lambda_[i]);
  }
  if (p.rows() <= kMostDenseRows) {
    G_.resize(rows * rows), J_.resize(rows * rows);
    for (int k = 0; k < p.rows(); ++k) {
      std::fill(dLambda_.begin(), dLambda_.end(), 0.0);
      dLambda_[k] = 1.0;
      p.G->apply(dLambda_.data(), G_.data() + static_cast<std::ptrdiff_t>(k) * p.rows());
    }
    return true;
  }
  if (!system_ || systemDim_ != dim) system_ = NewtonSystem::inPercussions(dim);
  systemDim_ = dim;
  return system_ && system_->prepare(p);
}

double SemismoothNewton::map(const InclusionProblem& p, const double* Lambda, const double* xi,
                             double* F, bool derivative) {
  double sum = 0.0;
  for (int i = 0; i < p.size(); ++i) {
    const int first = p.row0(i), dim = p.dim(i);
    const LawInput in = p.input(i);
    const double *r = r_.data() + first, rho = r[dim - 1];
    double *A = blocks_.A.data() + blocks_.block0[i], *B = blocks_.B.data() + blocks_.block0[i];
    double e2 = 0.0, scaled[kMostRows];
    if (cone_[i].kind != LawCone::Kind::other) {
      fischerBurmeister(cone_[i], dim, rho, xi + first, Lambda + first, F + first,
                        derivative ? A : nullptr, B);
    } else {
      std::copy(Lambda + first, Lambda + first + dim, F + first);
      p.law(i).prox(in, r, xi + first, F + first);
      for (int k = 0; k < dim; ++k) F[first + k] = Lambda[first + k] - F[first + k];
      // The derivative of a law takes one ρ: z = Λ − ρ ξ' with ξ' = R ξ/ρ, and B = P R = B' R/ρ.
      for (int k = 0; k < dim; ++k) scaled[k] = xi[first + k] * (r[k] / rho);
      if (derivative && !p.law(i).proxDerivative(in, rho, scaled, Lambda + first, A, B))
        return -1.0;
      for (int k = 0; derivative && k < dim; ++k)
        for (int m = 0; m < dim; ++m) B[k * dim + m] *= r[m] / rho;
    }
    for (int k = 0; k < dim; ++k) e2 += F[first + k] * F[first + k];
    sum += lambda_[i] * e2;
  }
  return sum;
}

bool SemismoothNewton::denseStep(const InclusionProblem& p) {
  // G_ holds the columns of G one after the other.
  const int n = p.rows();
  std::fill(J_.begin(), J_.end(), 0.0);
  double largest = 0.0;
  for (int i = 0; i < p.size(); ++i) {
    const int dim = p.dim(i), first = p.row0(i);
    const double *A = blocks_.A.data() + blocks_.block0[i],
                 *B = blocks_.B.data() + blocks_.block0[i];
    for (int k = 0; k < dim; ++k) {
      double* row = J_.data() + static_cast<std::ptrdiff_t>(first + k) * n;
      for (int m = 0; m < dim; ++m) row[first + m] += A[k * dim + m];
      for (int m = 0; m < dim; ++m) {
        if (B[k * dim + m] == 0.0) continue;
        for (int j = 0; j < n; ++j)
          row[j] += B[k * dim + m] * G_[static_cast<std::ptrdiff_t>(j) * n + first + m];
      }
      for (int j = 0; j < n; ++j) largest = std::max(largest, std::abs(row[j]));
      dLambda_[first + k] = -blocks_.F[first + k];
    }
  }
  return eliminate(J_.data(), dLambda_.data(), n, 1, kSingularPivot * largest);
}

bool SemismoothNewton::step(const InclusionProblem& p) {
  if (p.rows() <= kMostDenseRows) {
    if (!denseStep(p)) return false;
  } else if (!system_->solve(p, blocks_, dLambda_)) {
    return false;
  }
  p.G->apply(dLambda_.data(), dXi_.data());
  return std::all_of(dXi_.begin(), dXi_.end(), [](double x) { return std::isfinite(x); });
}

bool SemismoothNewton::advance(const InclusionProblem& p, double reference) {
  double least = std::numeric_limits<double>::infinity(), best = 1.0, t = 1.0;
  bool good = options_.lineSearch == LineSearch::none;
  for (int h = 0; h <= kMeritHalvings && !good; ++h, t *= 0.5) {
    for (std::size_t k = 0; k < Lambda_.size(); ++k) {
      trialLambda_[k] = Lambda_[k] + t * dLambda_[k];
      trialXi_[k] = xi_[k] + t * dXi_[k];
    }
    const double merit = map(p, trialLambda_.data(), trialXi_.data(), trialF_.data(), false);
    if (merit < least) least = merit, best = t;
    good = merit <= (1.0 - 2.0 * kArmijo * t) * reference;
  }
  for (std::size_t k = 0; k < Lambda_.size(); ++k) {
    Lambda_[k] += best * dLambda_[k];
    xi_[k] += best * dXi_[k];
  }
  return good;
}

SolveStatus SemismoothNewton::iterate(const InclusionProblem& p, SolveReport& report) {
  p.G->apply(Lambda_.data(), xi_.data());
  for (int k = 0; k < p.rows(); ++k) xi_[k] += p.c[k];
  double recent[kMeritsKept];
  double merit = map(p, Lambda_.data(), xi_.data(), blocks_.F.data(), true);
  std::fill(recent, recent + kMeritsKept, merit);
  const int memory = options_.lineSearch == LineSearch::armijo ? 1 : kMeritsKept;
  for (int it = 0, poor = 0; it < options_.maxNewton; ++it) {
    if (!(merit >= 0.0) || poor >= kPatientSteps || !step(p)) return SolveStatus::stalled;
    ++report.newton, ++report.iterations;
    const double reference = *std::max_element(recent, recent + memory);
    poor = advance(p, reference) ? 0 : poor + 1;
    const Residuals now = residuals(p, ConstVec(Lambda_.data(), p.rows()), scratch_);
    if (!std::isfinite(now.largest())) return SolveStatus::diverged;
    if (now.largest() < report.residuals.largest()) report.residuals = now, best_ = Lambda_;
    if (report.residuals.largest() <= options_.tolerance) return SolveStatus::solved;
    if (p.enough()) return SolveStatus::maxIterations;
    merit = map(p, Lambda_.data(), xi_.data(), blocks_.F.data(), true);
    recent[it % memory] = merit;
  }
  return SolveStatus::maxIterations;
}

SolveReport SemismoothNewton::solve(const InclusionProblem& p, Vec Lambda) {
  SolveReport report;
  report.method = options_.formulation == Formulation::alartCurnier ? "Alart-Curnier Newton"
                                                                    : "Fischer-Burmeister Newton";
  if (p.rows() == 0) return report;
  report.residuals = residuals(p, view(Lambda), scratch_);
  const double E = report.residuals.largest();
  if (E <= acceptedStart(p, options_.tolerance)) {
    report.warmAccepted = true;
    return report;
  }
  if (!(E <= kColdMerit) && options_.sweeps > 0) {
    const SolveReport start = starter_.solve(p, Lambda);
    report.iterations = start.iterations, report.residuals = start.residuals;
    if (start.ok()) return report;
  }
  if (!prepare(p)) {
    report.status = SolveStatus::stalled;
    return report;
  }
  std::copy(Lambda.data(), Lambda.data() + Lambda.size(), Lambda_.begin());
  best_ = Lambda_;
  report.status = iterate(p, report);
  // A start within the tolerance that no step improves is a solution.
  if (report.residuals.largest() <= options_.tolerance) report.status = SolveStatus::solved;
  std::copy(best_.begin(), best_.end(), Lambda.data());
  return report;
}

void SemismoothNewton::declare(Attributes& a) {
  a.about(
      "Generalised Newton method without a proximal term, for problems whose contacts are not "
      "redundant. Says `stalled` where the matrix is singular.");
  a.optional("tolerance", Unit::none, 1e-10, "residuals E_f and E_u at which the solver stops")
      .positive();
  a.choice("formulation", {"alartCurnier", "fischerBurmeister"}, "alartCurnier",
           "function whose zero is sought");
  a.choice("lineSearch", {"nonmonotone", "armijo", "none"}, "nonmonotone",
           "a step must reduce |F| below the largest of the last five, or below the last one");
  a.add(AttributeType::integer, "maxNewton", "200", "Newton steps").min = 1;
  a.add(AttributeType::integer, "sweeps", "10", "Gauss-Seidel sweeps before a cold start").min = 0;
  a.example(
      "<simulation until=\"1\" step=\"1e-3\"><SemismoothNewton formulation=\"fischerBurmeister\"/>"
      "</simulation>");
}

}  // namespace dynamy
