/// EasyProblems: what Automatic tries before Newton's method: one contact in closed form,
/// accelerated block sweeps while they pay. (theory 7.5)
///
/// Full residuals are computed after each of the first two sweeps. Later they are computed when the
/// change of Λ promises the solution, at the latest after five more sweeps: for small problems they
/// cost as much as a sweep.
#pragma once
#include <dynamy/solver/block_gauss_seidel.hpp>

namespace dynamy {

class EasyProblems {
 public:
  /// Solves a problem with one contact. In: `report.residuals` of the start. True: solved;
  /// otherwise Λ is the start again.
  bool oneContact(const InclusionProblem& problem, double tolerance, Vec Lambda,
                  SolveReport& report);
  /// Makes sweeps while their rate of convergence promises a solution soon; true: solved. Otherwise
  /// Λ is the result of 15 plain prox sweeps, which may be worse than best().
  bool sweeps(const InclusionProblem& problem, double tolerance, Vec Lambda, SolveReport& report);
  /// The best Λ of the last sweeps(), and its residuals.
  const std::vector<double>& best() const { return best_; }
  const Residuals& bestResiduals() const { return bestResiduals_; }

 private:
  void accelerate(const InclusionProblem& problem, bool first, Vec Lambda);
  /// max_i λ_i |ΔΛ_i| of the last sweep  [m/s].
  double change(ConstVec Lambda) const;
  void rowScales(const InclusionProblem& problem);

  LocalSolutions local_;
  BlockGaussSeidel block_;
  ProxGaussSeidel prox_;
  Anderson anderson_;
  std::vector<double> r_, lambda_, scratch_, start_, best_, before_;
  Residuals bestResiduals_;
};

}  // namespace dynamy
