/// Block Gauss–Seidel: each contact is solved exactly while the others rest.      (theory 4.13)
///
///   Λ_i ← solution of  −(G_ii Λ_i + b_i) ∈ N_{C_i}(Λ_i),   b_i = c_i + Σ_{j≠i} G_ij Λ_j
///
/// Closed forms where the set is simple (LocalSolutions), a local Newton method elsewhere. A
/// contact without solution makes a prox step.
#pragma once
#include <dynamy/solver/local/ball_sweeps.hpp>
#include <dynamy/solver/local/local_solution.hpp>
#include <dynamy/solver/prox_solvers.hpp>

namespace dynamy {

class BlockGaussSeidel final : public ProxSolver {
 public:
  explicit BlockGaussSeidel(const ProxOptions& options = {}) : ProxSolver(options) {}
  explicit BlockGaussSeidel(const Parameters& x) : ProxSolver(x, Relaxation::exact) {}
  static void declare(Attributes& a);

  void prepare(const InclusionProblem& problem) override;
  /// r: rows() prox parameters of this problem, needed by every contact that has no closed form or
  /// no solution while the others rest [kg].
  void sweep(const InclusionProblem& problem, const double* r, double* Lambda) override;

 private:
  /// `prepared`: number of contact i in local_.
  void contact(const InclusionProblem& problem, int i, int prepared, const double* r,
               double* Lambda);
  LocalSolutions local_;  // of all contacts, or of the rest
  BallSweeps balls_;      // if there are many of that kind
};

}  // namespace dynamy
