/// Automatic: the choice of a solver that users need not think about.                (theory 7.5)
///
///   start good enough → accept it · one contact → closed forms · sweeps while they pay
///   → proximal Newton → the same, gentler → Gauss–Seidel → proximal Newton from other starts
///
/// Every stage starts from the best Λ of the one before and is judged by the same residuals. An
/// unconverged Λ is returned as such.
#pragma once
#include <dynamy/solver/lemke_solver.hpp>
#include <dynamy/solver/minimal_norm.hpp>
#include <dynamy/solver/proximal_newton.hpp>

namespace dynamy {

struct AutomaticOptions {
  double tolerance = 1e-10;   ///< of E_f and E_u, or of the problem's own measure
  int maxNewton = 500;        ///< Newton steps, then the gentle schedule
  int maxGentle = 2000;       ///< Newton steps of that, then sweeps
  int maxIterations = 10000;  ///< sweeps of the last stage
  bool minimalNorm = false;   ///< of forces that are not unique, the smallest ones
};

class Automatic final : public InclusionSolver {
 public:
  explicit Automatic(const AutomaticOptions& options = {});
  explicit Automatic(const Parameters& x);
  static void declare(Attributes& a);
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) override;

 private:
  SolveReport chain(const InclusionProblem& problem, Vec Lambda);
  /// Newton's method from other starts with other steps ρ; true: solved. Λ is the best one so far.
  bool restarts(const InclusionProblem& problem, Vec Lambda, SolveReport& report);
  /// Take-off Λ = 0 and stick Λ = −G⁻¹c of a single contact; true: one of them is the solution.
  bool oneContact(const InclusionProblem& problem, Vec Lambda, SolveReport& report);
  /// Sweeps while the rate promises the solution soon; true: solved.
  bool sweeps(const InclusionProblem& problem, Vec Lambda, SolveReport& report);

  AutomaticOptions options_;
  ProxGaussSeidel gaussSeidel_;
  ProximalNewton newton_;
  LemkeSolver lemke_;  // for G_ii = 0
  BlockNewton rescue_;
  MinimalNorm minimalNorm_;
  std::vector<double> r_, scratch_, best_;
};

}  // namespace dynamy
