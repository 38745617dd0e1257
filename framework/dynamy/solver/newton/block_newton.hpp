/// BlockNewton: the dual proximal-point method with an Alart–Curnier Newton iteration on block rows
/// of G, for problems of any size.                                            (theory 7)
///
///   outer:  Λ_{k+1} = Λ with  ξ = GΛ + c + diag(a)(Λ − Λ_k),  −ξ_i ∈ N_{C_i}(Λ_i),   a_i = a λ_i
///   inner:  F = Λ − prox(Λ − Rξ) = 0,   (A + B (G + diag(a))) ΔΛ = −F
///
/// G need not be symmetric and may have any rank. λ_i = λ_max(sym G_ii), so that a has no unit.
/// Every inner step has full length. A line search on |F| was rejected: forces of contacts that
/// barely slide lie on the boundary of their cone and must turn along a circle. A step along its
/// tangent is right to first order but leaves the cone by the square of the angle. Then |F| rises,
/// and the search shortens the steps to nothing. The next full step repairs the error (the Maratos
/// effect of constrained optimisation). An inner problem that is not solved in a few steps is
/// discarded for a larger a; the parameter that failed is remembered.
#pragma once
#include <dynamy/solver/newton/newton_system.hpp>
#include <dynamy/solver/problem/inclusion_solver.hpp>

namespace dynamy {

/// How the proximal parameter moves.
struct NewtonSchedule {
  double start = 3e-3;          ///< a of the first outer step
  double least = 1e-12;         ///< smallest a; below, the regularisation drowns in rounding
  double inner = 0.8;           ///< an inner problem is solved at this fraction of its first |F|
  int fast = 3;                 ///< inner steps up to which a is multiplied by `shrink`
  double shrink = 0.15;         ///< factor of a after such an inner problem
  int slow = 6;                 ///< inner steps up to which a is multiplied by 0.5
  int maxInner = 8;             ///< inner steps after which the inner problem is given up
  double grow = 2.0;            ///< factor of a after an inner problem was given up
  int maxNewton = 500;          ///< Newton steps in all
  double rho = 2.0;             ///< ρ of the prox parameters r_i = ρ/λ_i
  bool separateNormal = false;  ///< r_N = ρ/G_NN, r_T = ρ/λ_max(G_TT) in place of r_i
  bool lineSearch = false;  ///< t = 1 … 2⁻⁹, until |F| is below the largest of the last five
  /// True: |F| = √Σ (λ_i|F_i|)², a velocity, instead of √Σ λ_i|F_i|², whose square is an energy.
  /// With energies, rounding at contacts of heavy bodies hides the errors at contacts of light
  /// ones.
  bool velocities = false;

  /// Schedule with line search and small changes of a, for problems where full steps stagnate.
  static NewtonSchedule gentle();
};

class BlockNewton {
 public:
  /// Takes G. False: a law has no derivative, a contact has more than 6 rows, some G_ii has no
  /// positive eigenvalue, or there are more than 20 000 contacts.
  bool prepare(const InclusionProblem& problem);
  /// Continues from Λ; Λ becomes the best one found. Adds to the counts of `report` and sets its
  /// residuals and status. \pre prepare() of the same problem; the residuals in `report` are those
  /// of Λ
  void solve(const InclusionProblem& problem, const NewtonSchedule& schedule, double tolerance,
             Vec Lambda, SolveReport& report);
  /// Makes up to three steps from a Λ that is good enough; the result is kept only if it is better.
  void improve(const InclusionProblem& problem, Vec Lambda, SolveReport& report);
  /// True: the factors would exceed their size limit, so that no schedule helps.
  bool tooLarge() const { return system_ && system_->tooLarge(); }
  /// The prepared problem is solved in velocities.
  bool inVelocities() const { return systems_.inVelocities(); }
  /// Numbers in the factors of the last Newton step.
  long entries() const { return system_ ? system_->entries() : 0; }
  long analyses() const { return system_ ? system_->analyses() : 0; }

 private:
  enum class Inner { converged, failed, solved, enough, tooLarge };
  void chooseSteps(const InclusionProblem& p, const NewtonSchedule& s);
  /// Computes F and, if `derivative`, A and B at (Λ, ξ); returns |F| as the schedule defines it.
  double map(const InclusionProblem& p, const double* Lambda, const double* xi, double* F,
             bool derivative);
  void relativeVelocity(const InclusionProblem& p, const double* Lambda, double* xi) const;
  Inner inner(const InclusionProblem& p, const NewtonSchedule& s, double tolerance,
              SolveReport& report, int& steps);
  /// Step length t along ΔΛ.
  double lineSearch(const InclusionProblem& p);
  /// Λ += t ΔΛ, and ξ with it.
  void go(double t);
  bool judge(const InclusionProblem& p, double tolerance, SolveReport& report);

  NewtonSystemChoice systems_;
  NewtonSystem* system_ = nullptr;
  NewtonBlocks blocks_;
  std::vector<double> lambda_, weight_, r_;  // weight_: of |F_i|² in |F|²
  std::vector<double> Lambda_, xi_, dLambda_, dXi_, trialLambda_, trialXi_, trialF_, centre_, best_,
      recent_, scratch_;
};

}  // namespace dynamy
