/// Block Gauss–Seidel: each contact is solved exactly while the others rest.      (theory 4.13)
///
///   Λ_i ← solution of  −(G_ii Λ_i + b_i) ∈ N_{C_i}(Λ_i),   b_i = c_i + Σ_{j≠i} G_ij Λ_j
///
/// Closed forms where the set is simple (LocalSolutions), a local Newton method elsewhere. A
/// contact without solution makes a prox step.
#pragma once
#include <dynamy/solver/ball_sweeps.hpp>
#include <dynamy/solver/local_solution.hpp>
#include <dynamy/solver/prox_solvers.hpp>

namespace dynamy {

class BlockGaussSeidel final : public ProxSolver {
 public:
  explicit BlockGaussSeidel(const ProxOptions& options = {}) : ProxSolver(options) {}
  explicit BlockGaussSeidel(const Parameters& x) : ProxSolver(x, Relaxation::exact) {}
  static void declare(Attributes& a);

  void prepare(const InclusionProblem& problem) override {
    if (options().symmetric || !balls_.prepare(problem)) local_.prepare(problem);
  }
  /// True: sweep() needs no r of the prepared problem.
  bool allSimple() const { return balls_.prepared() || local_.allSimple(); }
  void sweep(const InclusionProblem& problem, const double* r, double* Lambda) override;

 private:
  void contact(const InclusionProblem& problem, int i, const double* r, double* Lambda);
  LocalSolutions local_;
  BallSweeps balls_;  // if the problem is of that kind
};

}  // namespace dynamy
