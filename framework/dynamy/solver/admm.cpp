#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/law/convex_sets.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/admm.hpp>

namespace dynamy {
namespace {

constexpr double kEta = 1e-6;  ///< proximal part η
/// Factor of the first σ = τρ. The value ½ for convex problems takes more iterations and
/// factorisations on contacts.
constexpr double kOverRelaxed = 0.015;
/// Problems with large factors have at least so many contacts, each of them coupled with so many on
/// average, itself included.
constexpr int kManyContactsOfAdmm = 200;
constexpr double kManyNeighbours = 16.0;
constexpr double kBalanced = 10.0;  ///< residuals that differ by a smaller factor are balanced
constexpr double kLargestChange = 10.0;
/// Residuals are compared after 10, 20, 40 … iterations.
constexpr int kFirstBalance = 10;
constexpr int kTestEvery = 5, kPowerSteps = 20;

template <int n>
void projectCone(double mu, double* x) {
  Eigen::Map<convex::Point<n>> point(x);
  point = convex::prox(convex::FrictionCone<n>{mu}, convex::Point<n>(point));
}

}  // namespace

Admm::Admm(const Parameters& x)
    : InclusionSolver(x),
      options_{x["tolerance"], x["maxIterations"].integer(), x["maxFactorisations"].integer()} {}

bool Admm::pays(const InclusionProblem& p) {
  if (p.G->hasBodies() || p.size() < kManyContactsOfAdmm) return false;
  const auto blocks = static_cast<double>(p.G->blockRows().column.size());
  return blocks >= kManyNeighbours * p.size();
}

bool Admm::prepare(const InclusionProblem& p, Vec Lambda) {
  const auto rows = static_cast<std::size_t>(p.rows()), size = static_cast<std::size_t>(p.size());
  lambda_.resize(size), shift_.resize(size), cone_.resize(size);
  for (std::vector<double>* v : {&x_, &y_, &z_, &right_, &before_}) v->resize(rows);
  for (int i = 0; i < p.size(); ++i) {
    lambda_[i] = contactLambda(p.G->diagonalBlock(i), p.dim(i));
    if (!(lambda_[i] > 0.0)) return false;
    cone_[i] = coneOf(p.law(i), p.input(i));
  }
  system_ = systems_.prepare(p);
  if (!system_) return false;
  // Largest eigenvalue L of D^-½ G D^-½ by power iteration; the smallest one is η.
  std::fill(x_.begin(), x_.end(), 1.0);
  double L = 1.0;
  for (int k = 0; k < kPowerSteps; ++k) {
    p.G->apply(x_.data(), y_.data());
    double sum = 0.0;
    for (int i = 0; i < p.size(); ++i)
      for (int r = p.row0(i); r < p.row0(i) + p.dim(i); ++r)
        x_[r] = y_[r] / lambda_[i], sum += x_[r] * x_[r];
    const double norm = std::sqrt(sum);
    if (!(norm > 0.0)) break;
    if (k > 0) L = norm;
    for (double& x : x_) x /= norm;
  }
  sigma_ = kOverRelaxed * std::sqrt(L * kEta) * std::pow(L / kEta, 0.2);
  // Start: z = ξ^ of the given Λ.
  std::copy(Lambda.data(), Lambda.data() + Lambda.size(), x_.begin());
  y_ = x_;
  p.G->apply(x_.data(), z_.data());
  for (int i = 0; i < p.size(); ++i) {
    double slip2 = 0.0;
    for (int r = p.row0(i); r < p.row0(i) + p.dim(i); ++r) {
      z_[r] += p.c[r];
      if (r > p.row0(i)) slip2 += z_[r] * z_[r];
    }
    if (cone_[i].kind == LawCone::Kind::cone) z_[p.row0(i)] += cone_[i].mu * std::sqrt(slip2);
  }
  factorisations_ = 0, nextBalance_ = kFirstBalance;
  return factor(p);
}

bool Admm::factor(const InclusionProblem& p) {
  ++factorisations_;
  for (int i = 0; i < p.size(); ++i) shift_[i] = (kEta + sigma_) * lambda_[i];
  return system_->factorShifted(p, shift_);
}

void Admm::project(const InclusionProblem& p, int i, double* y) const {
  const int dim = p.dim(i);
  if (cone_[i].kind == LawCone::Kind::cone) {
    if (dim == 2)
      projectCone<2>(cone_[i].mu, y);
    else
      projectCone<3>(cone_[i].mu, y);
    return;
  }
  double r[kMostRows], zero[kMostRows] = {};
  std::fill(r, r + dim, 1.0);
  p.law(i).prox(p.input(i), r, zero, y);
}

bool Admm::iterate(const InclusionProblem& p) {
  for (int i = 0; i < p.size(); ++i) {
    const int first = p.row0(i), dim = p.dim(i);
    double slip2 = 0.0;
    for (int r = first; r < first + dim; ++r) {
      right_[r] = z_[r] - p.c[r] + lambda_[i] * (sigma_ * y_[r] + kEta * x_[r]);
      if (r > first) slip2 += z_[r] * z_[r];
    }
    if (cone_[i].kind == LawCone::Kind::cone) right_[first] -= cone_[i].mu * std::sqrt(slip2);
  }
  before_ = x_;
  if (!system_->solveShifted(p, right_.data(), x_)) return false;
  primal_ = dual_ = 0.0;
  for (int i = 0; i < p.size(); ++i) {
    const int first = p.row0(i), dim = p.dim(i);
    const double weight = sigma_ * lambda_[i], root = std::sqrt(lambda_[i]);
    double old[kMostRows];
    for (int r = 0; r < dim; ++r) {
      old[r] = y_[first + r];
      y_[first + r] = x_[first + r] - z_[first + r] / weight;
    }
    project(p, i, y_.data() + first);
    for (int r = 0; r < dim; ++r) {
      const int at = first + r;
      z_[at] -= weight * (x_[at] - y_[at]);
      // In contact-scaled units: √λ Λ and ξ/√λ.
      primal_ = std::max(primal_, root * std::abs(x_[at] - y_[at]));
      dual_ = std::max(dual_,
                       root * std::abs(sigma_ * (y_[at] - old[r]) + kEta * (x_[at] - before_[at])));
    }
  }
  return std::isfinite(primal_ + dual_);
}

bool Admm::balance(const InclusionProblem& p, int iteration) {
  if (iteration < nextBalance_ || factorisations_ >= options_.maxFactorisations) return true;
  nextBalance_ = 2 * iteration;
  if (primal_ <= kBalanced * dual_ && dual_ <= kBalanced * primal_) return true;
  sigma_ *= std::clamp(std::sqrt(primal_ / dual_), 1.0 / kLargestChange, kLargestChange);
  return factor(p);
}

SolveReport Admm::solve(const InclusionProblem& p, Vec Lambda) {
  SolveReport report;
  report.method = "ADMM";
  if (p.rows() == 0) return report;
  report.residuals = residuals(p, view(Lambda), scratch_);
  if (report.residuals.largest() <= acceptedStart(p, options_.tolerance)) {
    report.warmAccepted = true;
    return report;
  }
  const bool good = report.residuals.largest() <= options_.tolerance;
  report.status = SolveStatus::maxIterations;
  best_.assign(Lambda.data(), Lambda.data() + Lambda.size());
  if (!prepare(p, Lambda)) report.status = SolveStatus::stalled;
  while (report.status == SolveStatus::maxIterations &&
         report.iterations < options_.maxIterations) {
    if (!iterate(p)) {
      report.status = SolveStatus::diverged;
      break;
    }
    ++report.iterations;
    const bool enough = p.enough();
    if (report.iterations % kTestEvery != 0 && !enough) continue;
    const Residuals now = residuals(p, ConstVec(y_.data(), p.rows()), scratch_);
    if (now.largest() < report.residuals.largest()) report.residuals = now, best_ = y_;
    if (report.residuals.largest() <= options_.tolerance) {
      report.status = SolveStatus::solved;
    } else if (enough) {
      break;
    } else if (!balance(p, report.iterations)) {
      report.status = SolveStatus::stalled;
    }
  }
  if (good) report.status = SolveStatus::solved;
  std::copy(best_.begin(), best_.end(), Lambda.data());
  return report;
}

void Admm::declare(Attributes& a) {
  a.about(
      "Alternating directions with De Saxcé's shift: one factorisation for many iterations. For "
      "moderate tolerances and problems whose factors are large; any rank of G.");
  a.optional("tolerance", Unit::none, 1e-10, "residuals E_f and E_u at which the solver stops")
      .positive();
  a.add(AttributeType::integer, "maxIterations", "5000", "iterations").min = 1;
  a.add(AttributeType::integer, "maxFactorisations", "10", "how often the step may be changed")
      .min = 1;
  a.example("<simulation until=\"1\" step=\"1e-3\"><Admm tolerance=\"1e-6\"/></simulation>");
}

}  // namespace dynamy
