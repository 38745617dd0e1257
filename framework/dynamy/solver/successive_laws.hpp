/// SuccessiveLaws: the laws one after the other, each with the others' percussions frozen.
///                                                                               (theory 4.8)
///   outer:  1  all normal forces (and joints) with the friction percussions frozen:
///              −ξ_N ∈ N_{ℝ₀⁺}(Λ_N),                    a convex problem
///           2  all frictions (and joints) with Λ_N frozen:
///              −ξ_T ∈ N_{C_T(Λ_N)}(Λ_T), fixed sets,   a convex problem
///
/// Each inner problem is solved by prox Gauss–Seidel and has a unique ξ. The outer map contracts
/// for small μ; for one sliding contact its factor is μ|G_NT|/G_NN. Above 1 the iteration diverges
/// or jumps between two states, even if the solution is unique; SolveReport says so. The solver is
/// kept because the book describes it, and for sets whose size depends on another law in a cascade.
/// The other solvers treat both laws together and do not have this limit.
#pragma once
#include <dynamy/solver/problem/inclusion_solver.hpp>

namespace dynamy {

struct SuccessiveOptions {
  double tolerance = 1e-10;  ///< bound on E_f and E_u
  int maxOuter = 200;
  int maxIterations = 2000;  ///< sweeps of one inner problem
};

class SuccessiveLaws final : public InclusionSolver {
 public:
  explicit SuccessiveLaws(const SuccessiveOptions& options = {}) : options_(options) {}
  explicit SuccessiveLaws(const Parameters& x);
  static void declare(Attributes& a);
  /// `iterations` counts sweeps of the inner problems.
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) override;
  /// Outer rounds of the last solve.
  int rounds() const { return rounds_; }

 private:
  enum class Phase { normal, friction };
  int inner(const InclusionProblem& problem, Phase phase, Vec Lambda);
  double sweep(const InclusionProblem& problem, Phase phase, double* Lambda);

  SuccessiveOptions options_;
  int rounds_ = 0;
  std::vector<double> r_, scratch_, best_;
};

}  // namespace dynamy
