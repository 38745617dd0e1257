#include <dynamy/solver/impact_law.hpp>

namespace dynamy {

SolveReport NewtonImpact::solve(InclusionProblem& problem, InclusionSolver& solver,
                                Vec Lambda) const {
  constexpr int kMaxDim = 8;
  for (int i = 0; i < problem.size(); ++i) {
    const int dim = problem.dim(i), first = problem.row0(i);
    double epsilon[kMaxDim] = {};
    problem.law(i).epsilon(dim, epsilon);
    for (int r = 0; r < dim; ++r) {
      const auto k = static_cast<std::size_t>(first + r);
      problem.c[k] = problem.gammaFree[k] + epsilon[r] * problem.gammaA[k];  // ξ = γ^E + ε γ^A
    }
  }
  return solver.solve(problem, Lambda);
}

void NewtonImpact::declare(Attributes& a) {
  a.about(
      "Newton's impact law in Moreau's inequality form: xi = gammaE + epsilon gammaA, one "
      "inclusion.");
  a.example("<simulation until=\"1\" step=\"1e-3\"><NewtonImpact/></simulation>");
}

}  // namespace dynamy
