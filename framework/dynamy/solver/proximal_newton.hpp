/// Dual proximal-point method with an Alart–Curnier Newton iteration: dense form for small
/// problems, block rows for large ones (BlockNewton).
///
///   outer:  find Λ with ξ = GΛ + c + a D (Λ − Λ_k),  F(Λ) = Λ − prox_C(Λ − ρ ξ) = 0;  Λ_{k+1} = Λ
///   inner:  (A + B (G + aD)) ΔΛ = −F,   A = ∂F/∂Λ, B = ∂F/∂ξ per contact
///           D = diag(λ_i),   ρ_i = 2/λ_i
///
/// λ_i bounds the largest eigenvalue of G_ii, so a has no unit. The proximal term makes every inner
/// problem regular whatever the rank of G (redundant contacts); it vanishes at the solution, so
/// that the exact law is solved. Plain Newton (a = 0) was rejected: it fails on rank-deficient
/// stacks. A problem that the schedule does not solve is tried with another ρ, then by
/// Gauss–Seidel. Problems with a law without derivative go to Gauss–Seidel at once.
#pragma once
#include <dynamy/solver/newton/block_newton.hpp>
#include <dynamy/solver/newton/held_states.hpp>
#include <dynamy/solver/prox_solvers.hpp>

namespace dynamy {

struct ProximalNewtonOptions {
  double tolerance = 1e-10;   ///< bound on E_f and E_u
  int maxNewton = 500;        ///< Newton steps of the first attempt
  int maxIterations = 10000;  ///< sweeps of Gauss–Seidel
  int maxRows = 64;           ///< rows up to which the dense form is used
  int maxPatient = 2000;      ///< Newton steps with another ρ, before Gauss–Seidel
};

/// What a call of ProximalNewton::refine may cost.
struct NewtonLimits {
  int maxNewton = 500;        ///< Newton steps of the first attempt
  int maxPatient = 2000;      ///< Newton steps with another ρ; 0: none
  int maxIterations = 10000;  ///< sweeps of Gauss–Seidel; 0: none
};

class ProximalNewton final : public InclusionSolver {
 public:
  explicit ProximalNewton(const ProximalNewtonOptions& options = {});
  explicit ProximalNewton(const Parameters& x);
  static void declare(Attributes& a);
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) override;
  /// Continues from Λ, whose residuals are in `report`. `cold`: Λ is not near the solution.
  /// xi: GΛ + c if Λ is near, null if unknown. `limits`: null for the solver's own limits.
  SolveReport refine(const InclusionProblem& problem, Vec Lambda, SolveReport report, bool cold,
                     const double* xi = nullptr, const NewtonLimits* limits = nullptr);

 private:
  /// Solves in dense form with a proximal parameter that starts at `a`, in about `most` Newton
  /// steps; true: solved.
  bool dense(const InclusionProblem& problem, Vec Lambda, double a, int most, SolveReport& report);
  /// True if all unilateral contacts carry a force, as in a stack. Λ then becomes normal forces
  /// that each alone give their own contact the same normal velocity.
  static bool press(const InclusionProblem& problem, Vec Lambda);
  void reserve();
  bool prepare(const InclusionProblem& problem);
  /// Makes the inner Newton iteration from Λ with proximal parameter a. Returns the steps used, or
  /// −1 if it did not converge.
  int newton(const InclusionProblem& problem, double a, double stop, Vec Lambda);
  /// Computes F and, if `derivative`, A and B at Λ; returns Σ λ_i |F_i|².
  double evaluate(const InclusionProblem& problem, double a, const double* Lambda, bool derivative);
  bool step(const InclusionProblem& problem, double a);
  /// Makes one outer step from a start that fulfils the tolerance, kept only if it is better.
  SolveReport improve(const InclusionProblem& problem, Vec Lambda, SolveReport report);
  /// Solves in block rows with a proximal parameter that starts at `start`: one try with a small
  /// one first if Λ is `near`, and longer steps at the end.
  void byBlocks(const InclusionProblem& problem, const NewtonLimits& limits, double start,
                bool near, Vec Lambda, SolveReport& report);
  SolveReport finish(const InclusionProblem& problem, int most, Vec Lambda, SolveReport report);

  ProximalNewtonOptions options_;
  ProxGaussSeidel starter_, fallback_;
  HeldStates held_;
  BlockNewton block_;
  std::vector<double> lambda_, xi_, F_, A_, B_, J_, dLambda_, centre_, trial_, best_, scratch_;
};

}  // namespace dynamy
