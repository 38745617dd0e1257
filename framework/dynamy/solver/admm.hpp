/// Alternating directions with De Saxcé's shift: one factorisation for many iterations.
/// (theory 9.5)
///
///   x ← (G + (η + σ) D)⁻¹ (z − s − c + D (σ y + η x)),   D = diag(λ_i)
///   y ← P_C(x − z/(σλ)),   z ← z − σ D (x − y),   s_i = μ_i |z_Ti| e_N [carpentier2024]
///
/// σ = τρ balances the residuals |x − y| and |y − y_old|. Every change of σ costs a factorisation;
/// at most `maxFactorisations` are made. G may have any rank. The residual falls fast to about a
/// thousandth, then slowly: for tight tolerances use ProximalNewton.
#pragma once
#include <dynamy/solver/newton/fischer_burmeister.hpp>
#include <dynamy/solver/newton/newton_system.hpp>
#include <dynamy/solver/problem/inclusion_solver.hpp>

namespace dynamy {

struct AdmmOptions {
  double tolerance = 1e-10;  ///< bound on E_f and E_u
  int maxIterations = 5000;
  int maxFactorisations = 10;
};

class Admm final : public InclusionSolver {
 public:
  explicit Admm(const AdmmOptions& options = {}) : options_(options) {}
  explicit Admm(const Parameters& x);
  static void declare(Attributes& a);
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) override;
  /// True for large problems without bodies in which every contact is coupled with many others:
  /// factors are then large, and a method with one factorisation is better than one with several.
  static bool pays(const InclusionProblem& problem);

 private:
  bool prepare(const InclusionProblem& p, Vec Lambda);
  bool factor(const InclusionProblem& p);
  /// Makes one iteration and sets primal_ and dual_; false: a number is not finite.
  bool iterate(const InclusionProblem& p);
  /// Projects on the set of contact i, without the shift: y_i ← P_C(a_i), a_i in `y`.
  void project(const InclusionProblem& p, int i, double* y) const;
  /// Changes σ and factors again if the residuals differ much; false: the factorisation failed.
  bool balance(const InclusionProblem& p, int iteration);

  AdmmOptions options_;
  NewtonSystemChoice systems_;
  NewtonSystem* system_ = nullptr;
  double sigma_ = 1.0, primal_ = 0.0, dual_ = 0.0;
  int factorisations_ = 0, nextBalance_ = 0;
  std::vector<LawCone> cone_;
  std::vector<double> lambda_, shift_, x_, y_, z_, right_, before_, best_, scratch_;
};

}  // namespace dynamy
