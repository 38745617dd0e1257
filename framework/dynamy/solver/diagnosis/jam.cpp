#include <algorithm>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/diagnosis/jam.hpp>

namespace dynamy {
namespace {

constexpr int kMostJamSteps = 20000;
constexpr double kAgree = 1e-11;  ///< fraction of the start's length: the two projections agree
constexpr double kEmpty = 1e-3;   ///< below this part of the start the limit counts as zero
constexpr double kSecant = 1e9;   ///< t of prox(t z)/t, the projection on a recession cone

/// Nearest point x of N·B to z_T at given N; returns S_B(z_T − x) = (z_T − x)·x/N.
double projectTangential(const DenseProblem& dense, int contact, double N, const double* z,
                         double* x) {
  const InclusionProblem& p = dense.problem();
  const int dim = p.dim(contact);
  double r[kMostRows], zero[kMostRows] = {};
  std::fill(r, r + dim, 1.0);
  std::copy(z, z + dim, x);
  x[0] = N;
  p.law(contact).prox(p.input(contact), r, zero, x);
  double product = 0.0;
  for (int k = 1; k < dim; ++k) product += (z[k] - x[k]) * x[k];
  return product / N;
}

}  // namespace

void projectOnCone(const DenseProblem& dense, int contact, double* z) {
  const InclusionProblem& p = dense.problem();
  const int dim = p.dim(contact);
  double x[kMostRows];
  if (!dense.hasNormal(contact) || dim == 1) {
    double r[kMostRows], zero[kMostRows] = {};
    std::fill(r, r + dim, 1.0);
    for (int k = 0; k < dim; ++k) x[k] = kSecant * z[k];
    p.law(contact).prox(p.input(contact), r, zero, x);
    for (int k = 0; k < dim; ++k) z[k] = x[k] / kSecant;
    return;
  }
  // min (N − z_N)² + dist²(z_T, N B): its derivative 2 (N − z_N − S_B(z_T − x)) grows with N.
  double size = 0.0;
  for (int k = 0; k < dim; ++k) size += std::abs(z[k]);
  if (size == 0.0) return;
  double low = 1e-12 * size, high = size;
  const auto slope = [&](double N) {
    return N - z[0] - projectTangential(dense, contact, N, z, x);
  };
  while (slope(high) < 0.0) high *= 2.0;
  if (slope(low) >= 0.0) {
    std::fill(z, z + dim, 0.0);
    return;
  }
  for (int k = 0; k < 60 && high - low > 1e-15 * size; ++k) {
    const double middle = 0.5 * (low + high);
    (slope(middle) < 0.0 ? low : high) = middle;
  }
  projectTangential(dense, contact, 0.5 * (low + high), z, x);
  std::copy(x, x + dim, z);
}

Eigen::VectorXd jammedForces(const DenseProblem& dense) {
  const InclusionProblem& p = dense.problem();
  Eigen::VectorXd Lambda = Eigen::VectorXd::Zero(p.rows());
  const std::vector<int> rows = dense.rowsOf([&](int i) { return dense.isClosed(i); });
  const Eigen::MatrixXd Z = dense.kernel(rows);
  if (Z.cols() == 0) return Lambda;
  // y = S⁻¹Λ; one factor per contact keeps the cones.
  Eigen::VectorXd y = Eigen::VectorXd::Zero(Z.rows()), increment = y;
  std::vector<std::pair<int, Eigen::Index>> closed;  // contact, its first place in y
  Eigen::Index at = 0;
  for (int i = 0; i < p.size(); ++i) {
    if (!dense.isClosed(i)) continue;
    if (dense.hasNormal(i)) y[at] = 1.0;
    closed.emplace_back(i, at);
    at += p.dim(i);
  }
  const double start = y.norm();
  if (start == 0.0) return Lambda;
  Eigen::VectorXd x = y;
  bool met = false;
  for (int k = 0; k < kMostJamSteps && !met; ++k) {
    x = Z * (Z.transpose() * y);
    const Eigen::VectorXd moved = x + increment, before = y;
    y = moved;
    for (const auto& [contact, place] : closed) projectOnCone(dense, contact, y.data() + place);
    increment = moved - y;
    if (y.norm() <= 1e-6 * start) return Lambda;
    met = k > 10 && std::max((x - y).norm(), (y - before).norm()) <= kAgree * start;
  }
  // Unconverged results count if they lie in both sets well enough to be reported as forces.
  if (y.norm() <= kEmpty * start || (x - y).norm() > 1e-6 * y.norm()) return Lambda;
  double largest = 0.0;
  for (const auto& [contact, place] : closed) {
    const int first = p.row0(contact), dim = p.dim(contact);
    Lambda.segment(first, dim) = dense.scale()[first] * y.segment(place, dim);
    if (dense.hasNormal(contact)) largest = std::max(largest, Lambda[first]);
  }
  if (largest > 0.0) Lambda /= largest;
  return largest > 0.0 ? Lambda : Eigen::VectorXd::Zero(p.rows());
}

}  // namespace dynamy
