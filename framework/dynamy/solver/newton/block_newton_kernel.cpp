#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/newton/block_newton.hpp>
#include <limits>

namespace dynamy {
namespace {

constexpr int kNormsKept = 5;     ///< values of |F| a step is compared with
constexpr int kStepHalvings = 9;  ///< t = 1 … 2⁻⁹
constexpr int kMaxGrowth = 24;    ///< failed inner problems in a row until the schedule gives up
constexpr double kLargest = 1e3;
/// Above this number of contacts, sweeps are the better use of memory and time.
constexpr int kMaxContacts = 20'000;

/// λ_max of the symmetric part of rows [a, b) of a dim × dim block.
double largestEigenvalue(const double* block, int dim, int a, int b) {
  const auto at = [&](int r, int k) { return 0.5 * (block[r * dim + k] + block[k * dim + r]); };
  if (b - a == 1) return at(a, a);
  if (b - a == 2) {
    const double mean = 0.5 * (at(a, a) + at(a + 1, a + 1)),
                 half = 0.5 * (at(a, a) - at(a + 1, a + 1));
    return mean + std::hypot(half, at(a, a + 1));
  }
  if (b - a > 3) return contactLambda(block, dim);  // a bound is enough
  Mat3 S;
  for (int r = 0; r < 3; ++r)
    for (int k = 0; k < 3; ++k) S(r, k) = at(a + r, a + k);
  Eigen::SelfAdjointEigenSolver<Mat3> eigen;
  return eigen.computeDirect(S, Eigen::EigenvaluesOnly).eigenvalues()[2];
}

}  // namespace

NewtonSchedule NewtonSchedule::gentle() {
  NewtonSchedule s;
  s.fast = 2, s.shrink = 0.1, s.slow = 6, s.maxInner = 25, s.grow = 2.0, s.maxNewton = 2000;
  s.least = 1e-9, s.inner = 0.3, s.lineSearch = true;
  return s;
}

bool BlockNewton::prepare(const InclusionProblem& p) {
  if (p.size() > kMaxContacts) return false;
  const auto rows = static_cast<std::size_t>(p.rows()), size = static_cast<std::size_t>(p.size());
  lambda_.resize(size);
  blocks_.block0.resize(size);
  std::ptrdiff_t entries = 0;
  std::vector<double> row;
  for (int i = 0; i < p.size(); ++i) {
    lambda_[i] = largestEigenvalue(p.G->diagonalBlock(i), p.dim(i), 0, p.dim(i));
    if (!(lambda_[i] > 0.0)) {
      // G_ii may be zero in complementarity problems: the row sums of G are a scale as well.
      if (row.empty()) row.resize(rows), p.G->rowSums(row.data());
      for (int k = p.row0(i); k < p.row0(i) + p.dim(i); ++k)
        lambda_[i] = std::max(lambda_[i], row[k]);
      if (!(lambda_[i] > 0.0)) return false;
    }
    blocks_.block0[i] = entries;
    entries += static_cast<std::ptrdiff_t>(p.dim(i)) * p.dim(i);
  }
  system_ = systems_.prepare(p);
  if (!system_) return false;
  blocks_.A.resize(entries), blocks_.B.resize(entries);
  blocks_.F.resize(rows), blocks_.a.resize(size);
  for (std::vector<double>* v : {&r_, &Lambda_, &xi_, &dLambda_, &dXi_, &trialLambda_, &trialXi_,
                                 &trialF_, &centre_, &best_})
    v->resize(rows);
  recent_.reserve(64);
  // A law without derivative is found at once; most neighbours share one law.
  const SetValuedForceLaw* last = nullptr;
  for (int i = 0; i < p.size(); ++i) {
    if (&p.law(i) == last) continue;
    last = &p.law(i);
    double A[kMostRows * kMostRows], B[kMostRows * kMostRows];
    const double Lambda[kMostRows] = {};
    if (!last->proxDerivative(p.input(i), 1.0, p.c.data() + p.row0(i), Lambda, A, B)) return false;
  }
  return true;
}

void BlockNewton::chooseSteps(const InclusionProblem& p, const NewtonSchedule& s) {
  weight_ = lambda_;
  if (s.velocities)
    for (double& w : weight_) w *= w;
  for (int i = 0; i < p.size(); ++i) {
    const int dim = p.dim(i);
    double* r = r_.data() + p.row0(i);
    std::fill(r, r + dim, s.rho / lambda_[i]);
    // A separate r_N is allowed if the normal force comes first and the other rows are projected
    // for given Λ_N.
    if (!s.separateNormal || dim < 2 || p.law(i).rowKind(0) != RowKind::normal) continue;
    const double* block = p.G->diagonalBlock(i);
    const double tangential = largestEigenvalue(block, dim, 1, dim);
    if (!(block[0] > 0.0) || !(tangential > 0.0)) continue;
    r[0] = s.rho / block[0];
    std::fill(r + 1, r + dim, s.rho / tangential);
  }
}

double BlockNewton::map(const InclusionProblem& p, const double* Lambda, const double* xi,
                        double* F, bool derivative) {
  double sum = 0.0;
  for (int i = 0; i < p.size(); ++i) {
    const int first = p.row0(i), dim = p.dim(i);
    const double* r = r_.data() + first;
    const LawInput in = p.input(i);
    double e2 = 0.0;
    std::copy(Lambda + first, Lambda + first + dim, F + first);
    p.law(i).prox(in, r, xi + first, F + first);
    for (int k = first; k < first + dim; ++k) {
      F[k] = Lambda[k] - F[k];
      e2 += F[k] * F[k];
    }
    sum += weight_[i] * e2;
    if (!derivative) continue;
    // The derivative of a law takes one ρ: z = Λ − ρ ξ' with ξ' = R ξ/ρ, and B = P R = B' R/ρ.
    const double rho = r[dim - 1];
    double scaled[kMostRows];
    for (int k = 0; k < dim; ++k) scaled[k] = xi[first + k] * (r[k] / rho);
    double *A = blocks_.A.data() + blocks_.block0[i], *B = blocks_.B.data() + blocks_.block0[i];
    if (!p.law(i).proxDerivative(in, rho, scaled, Lambda + first, A, B)) return -1.0;
    for (int k = 0; k < dim; ++k)
      for (int m = 0; m < dim; ++m) B[k * dim + m] *= r[m] / rho;
  }
  return std::sqrt(sum);
}

void BlockNewton::relativeVelocity(const InclusionProblem& p, const double* Lambda,
                                   double* xi) const {
  system_->multiply(p, Lambda, xi);
  for (int k = 0; k < p.rows(); ++k) xi[k] += p.c[k];
}

bool BlockNewton::judge(const InclusionProblem& p, double tolerance, SolveReport& report) {
  const Residuals now =
      residuals(p, {Lambda_.data(), static_cast<Eigen::Index>(Lambda_.size())}, scratch_);
  if (now.largest() < report.residuals.largest()) {
    report.residuals = now;
    best_ = Lambda_;
  }
  return report.residuals.largest() <= tolerance;
}

double BlockNewton::lineSearch(const InclusionProblem& p) {
  const auto from = recent_.size() > kNormsKept ? recent_.end() - kNormsKept : recent_.begin();
  const double reference = *std::max_element(from, recent_.end());
  // ξ is linear in t: the search needs no product with G.
  double least = std::numeric_limits<double>::infinity(), best = 1.0, t = 1.0;
  for (int h = 0; h <= kStepHalvings; ++h, t *= 0.5) {
    for (std::size_t k = 0; k < Lambda_.size(); ++k) {
      trialLambda_[k] = Lambda_[k] + t * dLambda_[k];
      trialXi_[k] = xi_[k] + t * dXi_[k];
    }
    const double norm = map(p, trialLambda_.data(), trialXi_.data(), trialF_.data(), false);
    if (norm < least) least = norm, best = t;
    if (norm < reference) break;
  }
  return best;
}

void BlockNewton::go(double t) {
  for (std::size_t k = 0; k < Lambda_.size(); ++k) {
    Lambda_[k] += t * dLambda_[k];
    xi_[k] += t * dXi_[k];
  }
}

BlockNewton::Inner BlockNewton::inner(const InclusionProblem& p, const NewtonSchedule& s,
                                      double tolerance, SolveReport& report, int& steps) {
  // At Λ = Λ_k the proximal term vanishes.
  relativeVelocity(p, Lambda_.data(), xi_.data());
  const double first = map(p, Lambda_.data(), xi_.data(), blocks_.F.data(), true);
  recent_.assign(1, first);
  for (steps = 0; steps < s.maxInner && report.newton < s.maxNewton;) {
    if (p.enough()) return Inner::enough;
    ++steps, ++report.newton, ++report.iterations;
    if (!system_->solve(p, blocks_, dLambda_))
      return system_->tooLarge() ? Inner::tooLarge : Inner::failed;
    const int* row0 = p.contacts->row0.data();
    system_->multiply(p, dLambda_.data(), dXi_.data());
    for (int i = 0; i < p.size(); ++i)
      for (int k = row0[i]; k < row0[i + 1]; ++k) dXi_[k] += blocks_.a[i] * dLambda_[k];
    go(s.lineSearch ? lineSearch(p) : 1.0);
    if (judge(p, tolerance, report)) return Inner::solved;
    recent_.push_back(map(p, Lambda_.data(), xi_.data(), blocks_.F.data(), true));
    if (recent_.back() <= s.inner * first) return Inner::converged;
  }
  return Inner::failed;
}

void BlockNewton::improve(const InclusionProblem& p, Vec Lambda, SolveReport& report) {
  constexpr double kNear = 1e-6;
  NewtonSchedule s;
  s.separateNormal = true, s.maxInner = 3, s.maxNewton += report.newton;
  chooseSteps(p, s);
  std::copy(Lambda.data(), Lambda.data() + Lambda.size(), Lambda_.begin());
  best_ = Lambda_;
  for (int i = 0; i < p.size(); ++i) blocks_.a[i] = kNear * lambda_[i];
  int steps = 0;
  inner(p, s, 0.0, report, steps);
  std::copy(best_.begin(), best_.end(), Lambda.data());
}

void BlockNewton::solve(const InclusionProblem& p, const NewtonSchedule& s, double tolerance,
                        Vec Lambda, SolveReport& report) {
  const int before = report.newton;
  NewtonSchedule schedule = s;
  schedule.maxNewton += before;
  chooseSteps(p, s);
  std::copy(Lambda.data(), Lambda.data() + Lambda.size(), Lambda_.begin());
  best_ = Lambda_;
  bool solved = report.residuals.largest() <= tolerance, enough = false;
  double a = s.start, failed = 0.0;
  int growth = 0, steps = 0;
  while (!solved && !enough && report.newton < schedule.maxNewton) {
    for (int i = 0; i < p.size(); ++i) blocks_.a[i] = a * lambda_[i];
    centre_ = Lambda_;
    const Inner result = inner(p, schedule, tolerance, report, steps);
    solved = result == Inner::solved, enough = result == Inner::enough;
    if (result == Inner::converged) {
      a *= steps <= s.fast ? s.shrink : (steps <= s.slow ? 0.5 : 1.0);
      a = std::max({a, s.least, 1.5 * failed});
      failed *= 0.5;
      growth = 0;
    } else if (result == Inner::tooLarge) {
      break;
    } else if (result == Inner::failed) {
      ++report.rejected;
      Lambda_ = centre_;
      failed = a;
      a *= s.grow;
      if (++growth > kMaxGrowth || a > kLargest) break;
    }
  }
  std::copy(best_.begin(), best_.end(), Lambda.data());
  report.status = solved
                      ? SolveStatus::solved
                      : (enough || report.newton >= schedule.maxNewton ? SolveStatus::maxIterations
                                                                       : SolveStatus::stalled);
}

}  // namespace dynamy
