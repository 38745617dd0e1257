#include <algorithm>
#include <cmath>
#include <dynamy/solver/inclusion_solver.hpp>

namespace dynamy {

double contactLambda(const double* block, int dim) {
  double largest = 0.0;
  for (int r = 0; r < dim; ++r) {
    double sum = 0.0;
    for (int k = 0; k < dim; ++k) sum += std::abs(block[r * dim + k]);
    largest = std::max(largest, sum);
  }
  return largest;
}

std::string_view solveStatusText(SolveStatus status) {
  switch (status) {
    case SolveStatus::solved:
      return "solved";
    case SolveStatus::maxIterations:
      return "iteration limit reached";
    case SolveStatus::stalled:
      return "stalled";
    case SolveStatus::diverged:
      return "diverged";
    case SolveStatus::notFinite:
      return "not finite";
  }
  return "unknown";
}

Residuals residuals(const InclusionProblem& problem, ConstVec Lambda,
                    std::vector<double>& scratch) {
  Residuals out;
  const int n = problem.rows();
  if (n == 0) return out;
  scratch.resize(static_cast<std::size_t>(n));
  problem.G->apply(Lambda.data(), scratch.data());
  double largestLambda = problem.lambdaFloor, worstE = 0.0, worstU = 0.0, spurious = 0.0,
         available = 0.0;
  constexpr int kMaxDim = 8;
  for (int i = 0; i < problem.size(); ++i) {
    const int first = problem.row0(i), dim = problem.dim(i);
    double* xi = scratch.data() + first;
    const double lambda = contactLambda(problem.G->diagonalBlock(i), dim);
    const double rho = lambda > 0.0 ? 1.0 / lambda : 0.0;
    double e[kMaxDim] = {}, e2 = 0.0, L2 = 0.0, c2 = 0.0;
    for (int r = 0; r < dim; ++r) {
      const double c = problem.c[static_cast<std::size_t>(first + r)];
      xi[r] += c;
      c2 += c * c;
      L2 += Lambda[first + r] * Lambda[first + r];
    }
    problem.law(i).naturalMap(problem.input(i), rho, xi, Lambda.data() + first, e);
    for (int r = 0; r < dim; ++r) e2 += e[r] * e[r];
    const double norm = std::sqrt(e2);
    if (!(norm <= worstE)) worstE = norm;
    if (rho > 0.0 && !(norm / rho <= worstU)) worstU = norm / rho, out.worst = i;
    largestLambda = std::max(largestLambda, std::sqrt(L2));
    spurious += rho > 0.0 ? e2 / rho : 0.0;
    available += rho * c2;
  }
  out.Ef = worstE == 0.0 ? 0.0 : (largestLambda > 0.0 ? worstE / largestLambda : 1.0);
  out.Eu = worstU == 0.0 ? 0.0 : (problem.uRef > 0.0 ? worstU / problem.uRef : 1.0);
  out.energy = spurious == 0.0 ? 0.0 : (available > 0.0 ? spurious / available : 1.0);
  return out;
}

}  // namespace dynamy
