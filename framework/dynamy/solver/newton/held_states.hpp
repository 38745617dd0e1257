/// HeldStates: solves the inclusion if no contact changes its state, as in a stack under a changing
/// load.                                                                           (theory 9.3)
///
///   held (Λ − ρξ inside of C): ξ_i = 0,   open (Λ − ρξ → 0): Λ_i = 0
///   (G + diag(a)) ΔΛ = −ξ over the held ones,   Λ += ΔΛ,   ξ = GΛ + c;   again, same factors
///
/// One factorisation is made; repeated substitutions remove the error that a, and rounding in the
/// factors, have left. The residual of the whole inclusion decides: if a contact does change its
/// state, Newton's method continues. Rejected: a smaller a in place of repeated substitutions;
/// rounding loses what it gains (mass ratio 10 000: a residual of 1e-9 remains at a = 1e-9,
/// whatever is factored anew).
#pragma once
#include <dynamy/solver/newton/newton_system.hpp>
#include <dynamy/solver/problem/inclusion_solver.hpp>

namespace dynamy {

class HeldStates {
 public:
  /// Continues from Λ with xi = GΛ + c; the residuals of Λ are in `report`. True: solved; otherwise
  /// Λ is the best one found. Counts substitutions as Newton steps.
  bool solve(const InclusionProblem& problem, const double* xi, double tolerance, Vec Lambda,
             SolveReport& report);

 private:
  /// Sets a of every contact, infinite for contacts that stay open; false: a contact slips or
  /// opens.
  bool states(const InclusionProblem& problem, const double* xi, ConstVec Lambda);

  NewtonSystemChoice systems_;
  std::vector<double> a_, right_, dLambda_, scratch_;
  Eigen::VectorXd trial_;
};

}  // namespace dynamy
