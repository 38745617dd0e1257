/// MinimalNorm: the smallest of all forces that give the same velocities.          (theory 7.9)
///
///   −(GΛ_a + c + a Λ_a) ∈ N_C(Λ_a),   a → 0:   Λ_a → argmin |Λ|  over { Λ : ξ and laws as before }
///
/// a falls to 1e-8 of the smallest λ_i. The problem itself (a = 0), started from the last Λ_a, ends
/// at the nearest solution, O(a) away. Loads are shared as equal springs would share them.
/// Rejected: −G⁺c, which ignores the sets C; the proximal outer iteration alone, which ends near
/// its start and keeps the uneven shares left by earlier sweeps.
#pragma once
#include <dynamy/solver/problem/inclusion_solver.hpp>

namespace dynamy {

class MinimalNorm {
 public:
  /// `Lambda`, `report`: a solution, which is replaced by the smallest one. They stay as they are
  /// if that is not found or is not smaller. Allocates memory.
  void apply(const InclusionProblem& problem, InclusionSolver& solver, Vec Lambda,
             SolveReport& report);

 private:
  Delassus G_;
  InclusionProblem problem_;
  Eigen::VectorXd trial_;
};

}  // namespace dynamy
