/// HeldStates: the inclusion where no contact changes its state, as in a stack under a load that
/// changes.                                                                        (theory 9.3)
///
///   held (Λ − ρξ inside of C): ξ_i = 0,   open (Λ − ρξ → 0): Λ_i = 0
///   (G + diag(a)) ΔΛ = −ξ over the held ones,   Λ += ΔΛ,   ξ = GΛ + c;   again, same factors
///
/// One factorisation, and a substitution for every digit that a, and rounding in the factors, have
/// left. The residual of the whole inclusion judges: if a contact does change its state, Newton's
/// method goes on. Rejected: a smaller a in place of repeated substitutions; it loses in rounding
/// what it gains (mass ratio 10 000: 1e-9 left at a = 1e-9, whatever is factored anew).
#pragma once
#include <dynamy/solver/newton/newton_system.hpp>
#include <dynamy/solver/problem/inclusion_solver.hpp>

namespace dynamy {

class HeldStates {
 public:
  /// Goes on from Λ with xi = GΛ + c, whose residuals are in `report`; true: solved. Else Λ is the
  /// best one found. Counts substitutions as Newton steps.
  bool solve(const InclusionProblem& problem, const double* xi, double tolerance, Vec Lambda,
             SolveReport& report);

 private:
  /// a of every contact, infinite where it stays open; false: one of them slips, or opens.
  bool states(const InclusionProblem& problem, const double* xi, ConstVec Lambda);

  NewtonSystemChoice systems_;
  std::vector<double> a_, right_, dLambda_, scratch_;
  Eigen::VectorXd trial_;
};

}  // namespace dynamy
