#include <algorithm>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/solver/impact/sequential_impact.hpp>

namespace dynamy {
namespace {

constexpr int kHitsPerContact = 10000;  ///< plastic hits of n bodies converge geometrically
constexpr int kLocalIterations = 200;
constexpr double kClosing = 1e-15;  ///< fraction of u_ref: slower approach is rounding

}  // namespace

int SequentialImpact::fastest(const InclusionProblem& problem) const {
  int out = -1;
  double largest = kClosing * problem.uRef;
  for (int i = 0; i < problem.size(); ++i) {
    if (!problem.law(i).unilateral() || together_[static_cast<std::size_t>(groups_.of(i))])
      continue;
    const double closing = -gamma_[static_cast<std::size_t>(problem.row0(i))];
    if (closing > largest) largest = closing, out = i;
  }
  return out;
}

void SequentialImpact::hit(InclusionProblem& problem, int i, double factor) const {
  const int dim = problem.dim(i), first = problem.row0(i);
  const double* G = problem.G->diagonalBlock(i);
  double epsilon[kMostRows] = {}, c[kMostRows], xi[kMostRows], r[kMostRows], L[kMostRows] = {};
  problem.law(i).epsilon(dim, epsilon);
  for (int k = 0; k < dim; ++k)
    c[k] = (1.0 + factor * epsilon[k]) * gamma_[static_cast<std::size_t>(first + k)];
  std::fill_n(r, dim, 1.0 / contactLambda(G, dim));
  const LawInput in = problem.contacts->input(i, 0.0, gamma_.data());
  for (int step = 0; step < kLocalIterations; ++step) {
    double before[kMostRows], change = 0.0, size = 0.0;
    std::copy_n(L, dim, before);
    for (int a = 0; a < dim; ++a) {
      xi[a] = c[a];
      for (int b = 0; b < dim; ++b) xi[a] += G[a * dim + b] * L[b];
    }
    problem.law(i).prox(in, r, xi, L);
    for (int a = 0; a < dim; ++a)
      change = std::max(change, std::abs(L[a] - before[a])), size = std::max(size, std::abs(L[a]));
    if (change <= 1e-16 * size) break;
  }
  for (int a = 0; a < dim; ++a) Lambda_[static_cast<std::size_t>(first + a)] += L[a];
  problem.G->neighbours(i, near_);
  for (const int j : near_) {
    block_.resize(static_cast<std::size_t>(problem.dim(j) * dim));
    problem.G->block(j, i, block_.data());
    for (int a = 0; a < problem.dim(j); ++a)
      for (int b = 0; b < dim; ++b)
        gamma_[static_cast<std::size_t>(problem.row0(j) + a)] +=
            block_[static_cast<std::size_t>(a * dim + b)] * L[b];
  }
}

SolveReport SequentialImpact::percussions(InclusionProblem& problem, InclusionSolver& solver,
                                          const std::vector<double>& factor, Vec Lambda) const {
  if (!rebounds(problem)) {
    bool closing = false;
    for (int i = 0; i < problem.size(); ++i)
      closing = closing || (problem.law(i).unilateral() &&
                            problem.gammaA[static_cast<std::size_t>(problem.row0(i))] <
                                -kClosing * problem.uRef);
    if (!closing) {  // no impact: forces alone
      problem.c = problem.gammaFree;
      return solver.solve(problem, Lambda);
    }
  }
  const auto n = static_cast<std::size_t>(problem.rows());
  groups_.find(problem);
  together_.assign(static_cast<std::size_t>(groups_.size()), 0);
  for (int i = 0; i < problem.size(); ++i)
    if (!problem.law(i).unilateral()) together_[static_cast<std::size_t>(groups_.of(i))] = 1;
  gamma_ = problem.gammaA;
  Lambda_.assign(n, 0.0);
  long hits = 0;
  for (int i = fastest(problem); i >= 0 && hits < long{kHitsPerContact} * problem.size();
       i = fastest(problem), ++hits)
    hit(problem, i, factor[static_cast<std::size_t>(i)]);

  // Solve for the forces of the step, and for groups that are hit together, after all hits.
  poseRestitution(problem, factor);
  std::vector<double>& pushed = gamma_;
  problem.G->apply(Lambda_.data(), pushed.data());
  for (int i = 0; i < problem.size(); ++i) {
    if (together_[static_cast<std::size_t>(groups_.of(i))]) continue;
    for (int k = problem.row0(i); k < problem.row0(i) + problem.dim(i); ++k) {
      const auto row = static_cast<std::size_t>(k);
      problem.c[row] = problem.gammaFree[row] + pushed[row];
    }
  }
  Lambda.setZero();
  SolveReport report = solver.solve(problem, Lambda);
  for (Eigen::Index k = 0; k < Lambda.size(); ++k)
    Lambda[k] += Lambda_[static_cast<std::size_t>(k)];
  report.iterations += static_cast<int>(hits);
  return report;
}

void SequentialImpact::declare(Attributes& a) {
  a.about(
      "Multiple impacts one after the other, the fastest contact first, by Newton's law, until "
      "none "
      "closes; as in Newton's cradle. Contacts linked to joints are hit together.");
  a.example("<simulation until=\"1\" step=\"1e-3\"><SequentialImpact/></simulation>");
}

}  // namespace dynamy
