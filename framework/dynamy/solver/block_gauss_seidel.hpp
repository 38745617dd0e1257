/// Block Gauss–Seidel: each contact is solved exactly for fixed forces of the others.
/// (theory 4.13)
///
///   Λ_i ← solution of  −(G_ii Λ_i + b_i) ∈ N_{C_i}(Λ_i),   b_i = c_i + Σ_{j≠i} G_ij Λ_j
///
/// A contact is solved in closed form if its set is simple (LocalSolutions), otherwise by a local
/// Newton method. A contact without solution makes a prox step.
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
  /// r: rows() prox parameters of this problem [kg]. They serve contacts that have no closed form,
  /// or no solution for the present forces of the others.
  void sweep(const InclusionProblem& problem, const double* r, double* Lambda) override;

 private:
  /// `prepared`: index of contact i in local_.
  void contact(const InclusionProblem& problem, int i, int prepared, const double* r,
               double* Lambda);
  LocalSolutions local_;  // of all contacts, or of those that balls_ leaves out
  BallSweeps balls_;      // used if there are many contacts of balls
};

}  // namespace dynamy
