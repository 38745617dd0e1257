#include <algorithm>
#include <cmath>
#include <dynamy/solver/prox/relaxation.hpp>

namespace dynamy {
namespace {

/// λ_max of a symmetric block of rows [a, b) of a dim × dim matrix: exact up to 2 rows, bounded by
/// the row sum above.
double largestOfBlock(const double* block, int dim, int a, int b) {
  const auto at = [&](int r, int k) { return block[r * dim + k]; };
  if (b - a == 1) return at(a, a);
  if (b - a == 2) {
    const double mean = 0.5 * (at(a, a) + at(a + 1, a + 1)),
                 half = 0.5 * (at(a, a) - at(a + 1, a + 1));
    return mean + std::hypot(half, at(a, a + 1));
  }
  double largest = 0.0;
  for (int r = a; r < b; ++r) {
    double sum = 0.0;
    for (int k = a; k < b; ++k) sum += std::abs(at(r, k));
    largest = std::max(largest, sum);
  }
  return largest;
}

/// 1/λ; 0 if that is not finite.
double inverse(double lambda) {
  const double value = 1.0 / lambda;
  return lambda > 0.0 && std::isfinite(value) ? value : 0.0;
}

void exactSteps(const InclusionProblem& p, std::vector<double>& r) {
  for (int i = 0; i < p.size(); ++i) {
    const int dim = p.dim(i), first = p.row0(i);
    const double* block = p.G->diagonalBlock(i);
    for (int a = 0; a < dim;) {
      const int b = p.law(i).groupEnd(a, dim);
      const double lambda = largestOfBlock(block, dim, a, b);
      const double value = inverse(lambda);
      for (; a < b; ++a) r[static_cast<std::size_t>(first + a)] = value;
    }
  }
}

/// Rows of one group take the smallest r of the group, so that the projection stays the metric one.
void equaliseGroups(const InclusionProblem& p, std::vector<double>& r) {
  for (int i = 0; i < p.size(); ++i) {
    const int dim = p.dim(i);
    double* row = r.data() + p.row0(i);
    for (int a = 0; a < dim;) {
      const int b = p.law(i).groupEnd(a, dim);
      const double least = *std::min_element(row + a, row + b);
      std::fill(row + a, row + b, least);
      a = b;
    }
  }
}

/// λ_max(G) for shift = 0; else the largest eigenvalue of shift − G. Power iteration.
double largestOf(const InclusionProblem& p, double shift, int iterations) {
  const auto n = static_cast<std::size_t>(p.rows());
  std::vector<double> x(n), y(n);
  for (std::size_t k = 0; k < n; ++k) x[k] = 1.0 + 0.1 * static_cast<double>(k % 7);
  double lambda = 0.0;
  for (int it = 0; it < iterations; ++it) {
    double norm = 0.0;
    for (const double v : x) norm += v * v;
    norm = std::sqrt(norm);
    if (norm == 0.0) return 0.0;
    for (double& v : x) v /= norm;
    p.G->apply(x.data(), y.data());
    if (shift > 0.0)
      for (std::size_t k = 0; k < n; ++k) y[k] = shift * x[k] - y[k];
    double next = 0.0;
    for (std::size_t k = 0; k < n; ++k) next += x[k] * y[k];
    x.swap(y);
    if (std::abs(next - lambda) <= 1e-6 * std::abs(next)) return next;
    lambda = next;
  }
  return lambda;
}

/// 2/(λ_min + λ_max). For λ_min = 0 this would be the limit of convergence itself.
double optimalStep(const InclusionProblem& p) {
  constexpr double kLimit = 1.9;  // of 2
  const double largest = largestOf(p, 0.0, 200);
  if (!(largest > 0.0)) return 0.0;
  const double least = std::max(0.0, largest - largestOf(p, largest, 1000));
  return std::min(2.0 / (least + largest), kLimit / largest);
}

}  // namespace

void relaxation(const InclusionProblem& p, Relaxation rule, double factor, std::vector<double>& r) {
  const auto n = static_cast<std::size_t>(p.rows());
  r.resize(n);
  switch (rule) {
    case Relaxation::exact:
      exactSteps(p, r);
      break;
    case Relaxation::spectral: {
      const double lambda = largestOf(p, 0.0, 200);
      std::fill(r.begin(), r.end(), inverse(lambda));
      break;
    }
    case Relaxation::optimal:
      std::fill(r.begin(), r.end(), optimalStep(p));
      break;
    case Relaxation::rowSums:
    case Relaxation::diagonalDominance: {
      p.G->rowSums(r.data());
      bool dominant = rule == Relaxation::diagonalDominance;
      for (int i = 0; i < p.size() && dominant; ++i)
        for (int k = 0; k < p.dim(i) && dominant; ++k)
          dominant = 2.0 * std::abs(p.G->diagonalBlock(i)[k * p.dim(i) + k]) >=
                     r[static_cast<std::size_t>(p.row0(i) + k)];
      for (int i = 0; i < p.size(); ++i)
        for (int k = 0; k < p.dim(i); ++k) {
          double& value = r[static_cast<std::size_t>(p.row0(i) + k)];
          const double G = dominant ? std::abs(p.G->diagonalBlock(i)[k * p.dim(i) + k]) : value;
          value = inverse(G);
        }
      equaliseGroups(p, r);
      break;
    }
  }
  if (factor != 1.0)
    for (double& value : r) value *= factor;
}

}  // namespace dynamy
