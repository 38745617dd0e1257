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
  /// Finds the smallest forces that hold every contact, ξ = 0, if there are any; true: Λ is set. With
  /// friction the inclusion may have them beside solutions that move: of a plate between two fingers
  /// all the load may rest on one pair of corners, about which it turns. Contacts that give way, ever
  /// less, choose rest, as those of real bodies do. Else Λ and `report` stay. `tolerance`: residual up
  /// to which Λ is a solution; 0: one that the solver finds from there. Allocates memory.
  bool rest(const InclusionProblem& problem, InclusionSolver& solver, double tolerance, Vec Lambda,
            SolveReport& report);

 private:
  /// Follows the path a → 0 from trial_, which is a solution then: one that the solver finds from the
  /// end of the path, or with `stays` > 0 the end itself, with a residual of `stays`. False: it ends
  /// on the way.
  bool follow(const InclusionProblem& problem, InclusionSolver& solver, double stays,
              SolveReport& report);
  Delassus G_;
  InclusionProblem problem_;
  Eigen::VectorXd trial_;
};

}  // namespace dynamy
