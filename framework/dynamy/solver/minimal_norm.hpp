/// Of all forces with the same velocities, the smallest.                           (theory 7.9)
///
///   −(GΛ_a + c + a Λ_a) ∈ N_C(Λ_a),   a → 0:   Λ_a → argmin |Λ|  over { Λ : ξ and laws as before }
///
/// a falls to 1e-8 of the smallest λ_i; the problem itself, started there, ends at the nearest
/// solution, O(a) away. Loads are shared as equal springs would share them. Rejected: −G⁺c, which
/// knows no sets; the proximal outer iteration alone, which ends near its start and keeps the
/// uneven shares of the sweeps before.
#pragma once
#include <dynamy/solver/problem/inclusion_solver.hpp>

namespace dynamy {

class MinimalNorm {
 public:
  /// `Lambda`, `report`: a solution; replaced by the smallest one. They stay as they are where the
  /// smallest one is not found or not smaller. Allocates.
  void apply(const InclusionProblem& problem, InclusionSolver& solver, Vec Lambda,
             SolveReport& report);

 private:
  Delassus G_;
  InclusionProblem problem_;
  Eigen::VectorXd trial_;
};

}  // namespace dynamy
