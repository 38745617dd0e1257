/// Dual proximal-point method with an Alart–Curnier Newton iteration, dense form for small
/// problems.
///
///   outer:  find Λ with ξ = GΛ + c + a D (Λ − Λ_k),  F(Λ) = Λ − prox_C(Λ − ρ ξ) = 0;  Λ_{k+1} = Λ
///   D = diag(λ_i) inner:  (A + B (G + aD)) ΔΛ = −F,   A = ∂F/∂Λ, B = ∂F/∂ξ per contact, ρ_i =
///   2/λ_i
///
/// λ_i bounds the largest eigenvalue of G_ii, so a has no unit. The proximal term makes every inner
/// problem regular whatever the rank of G (redundant contacts); it vanishes at the solution, so
/// that the exact law is solved. Plain Newton (a = 0) was rejected: it fails on rank-deficient
/// stacks. Laws that do not offer a derivative and problems above `maxRows` go to Gauss–Seidel.
#pragma once
#include <dynamy/solver/prox_solvers.hpp>

namespace dynamy {

struct ProximalNewtonOptions {
  double tolerance = 1e-10;   ///< of E_f and E_u
  int maxNewton = 200;        ///< Newton steps in all, then Gauss–Seidel goes on
  int maxIterations = 10000;  ///< of Gauss–Seidel
  int maxRows = 64;           ///< dense form up to here
};

class ProximalNewton final : public InclusionSolver {
 public:
  explicit ProximalNewton(const ProximalNewtonOptions& options = {});
  explicit ProximalNewton(const Parameters& x);
  static void declare(Attributes& a);
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) override;

 private:
  bool prepare(const InclusionProblem& problem);
  /// Inner Newton iteration from Λ with proximal parameter a; steps used, or −1 if it did not
  /// converge.
  int newton(const InclusionProblem& problem, double a, double stop, Vec Lambda);
  /// F and, if asked for, A and B at Λ; returns Σ λ_i |F_i|².
  double evaluate(const InclusionProblem& problem, double a, const double* Lambda, bool derivative);
  bool step(const InclusionProblem& problem, double a);
  /// One outer step for a start that fulfils the tolerance; kept only if it is better.
  SolveReport improve(const InclusionProblem& problem, Vec Lambda, SolveReport report);
  SolveReport finish(const InclusionProblem& problem, Vec Lambda, SolveReport report);

  ProximalNewtonOptions options_;
  ProxGaussSeidel starter_, fallback_;
  std::vector<double> lambda_, xi_, F_, A_, B_, J_, dLambda_, centre_, trial_, best_, scratch_;
};

}  // namespace dynamy
