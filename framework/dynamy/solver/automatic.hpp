/// Automatic: the choice of a solver that users need not think about.                (theory 7.5)
///
///   start good enough → accept it · one contact → closed form · large factors → ADMM
///   · sweeps while they pay → proximal Newton → the same, other ρ → Gauss–Seidel
///   → proximal Newton from other starts → pivoting
///   → problems from files: many more starts
///   · bodies at rest that the solution moves → forces that keep them at rest, if there are any
///
/// If the user gives no tolerance, the work on many contacts is bounded (`bounded`, theory 4.15): a
/// few Newton steps are tried for exact forces; if they fail, packed sweeps reduce the residual to
/// what is enough for the scheme. The report says so.
///
/// All stages are judged by the same residuals. The result is the best Λ of all stages, the start
/// included; if it has not converged, the status says so.
#pragma once
#include <dynamy/solver/admm.hpp>
#include <dynamy/solver/easy_problems.hpp>
#include <dynamy/solver/lemke_solver.hpp>
#include <dynamy/solver/minimal_norm.hpp>
#include <dynamy/solver/packed_gauss_seidel.hpp>
#include <dynamy/solver/proximal_newton.hpp>

namespace dynamy {

struct AutomaticOptions {
  double tolerance = 1e-10;   ///< bound on E_f and E_u, or on the problem's own measure
  int maxNewton = 500;        ///< Newton steps of the first attempt
  int maxPatient = 2000;      ///< Newton steps with another ρ, before the last sweeps
  int maxIterations = 10000;  ///< sweeps of the last stage
  bool minimalNorm = false;   ///< returns the smallest forces if forces are not unique
  bool bounded = false;       ///< bounds the work on many contacts (theory 4.15)
};

class Automatic final : public InclusionSolver {
 public:
  explicit Automatic(const AutomaticOptions& options = {});
  explicit Automatic(const Parameters& x);
  static void declare(Attributes& a);
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) override;
  bool boundsWork(int contacts) const override;

 private:
  SolveReport chain(const InclusionProblem& problem, Vec Lambda);
  /// Forgets a start from which Newton's method has failed, and solves from Λ = 0.
  SolveReport afresh(const InclusionProblem& problem, Vec Lambda, SolveReport report,
                     const NewtonLimits& most);
  /// Runs the stages one after the other from a start that is worth improving. In: `report` holds
  /// the residuals of the start.
  SolveReport rungs(const InclusionProblem& problem, Vec Lambda, SolveReport report);
  /// Is the work on this problem bounded?
  bool bounds(const InclusionProblem& problem) const;
  /// Is this the problem of a time step, without bodies, condensed from joints or stiff forces?
  bool condensed(const InclusionProblem& problem) const;
  /// Limits of Newton's method: fewer steps if a condensed G is eliminated as a whole, and few if
  /// the time step is tried again. `steps`: limit for many contacts whose work is bounded.
  NewtonLimits limits(const InclusionProblem& problem, int steps) const;
  /// Makes packed sweeps at a bounded cost: the last stage for many contacts.
  SolveReport boundedSweeps(const InclusionProblem& problem, Vec Lambda, SolveReport report);
  /// Is this a problem that the gaps of the next step correct, of bodies with enough contacts that
  /// long searches cost more than they gain?
  bool settles(const InclusionProblem& problem) const;
  /// Makes packed sweeps where Newton's method has failed; solved: what is enough for the scheme is
  /// reached.
  void settle(const InclusionProblem& problem, Vec Lambda, SolveReport& report);
  /// Remembers Λ if it is the best one so far, unless its forces are so large that their sums are
  /// only rounding.
  void keep(const InclusionProblem& problem, ConstVec Lambda, const Residuals& residuals);
  /// Tries alternating directions on problems with large factors; true: solved, otherwise Λ is the
  /// start again.
  bool alternate(const InclusionProblem& problem, Vec Lambda, SolveReport& report);
  /// Tries Newton's method from other starts with other ρ; true: solved. Λ is the best one so far.
  bool restarts(const InclusionProblem& problem, Vec Lambda, SolveReport& report);
  /// Makes short attempts from many starts, for small given problems; true: solved. Λ is the best
  /// one so far.
  bool others(const InclusionProblem& problem, Vec Lambda, SolveReport& report);
  /// Newton's method from `trial`; Λ and the residuals in `report` become better or remain.
  bool tryFrom(const InclusionProblem& problem, const NewtonSchedule& schedule,
               Eigen::VectorXd& trial, Vec Lambda, SolveReport& report);
  /// Tries Lemke's method, then Newton steps from its solution for friction polygons; true: solved.
  /// Λ is the best one so far.
  bool pivot(const InclusionProblem& problem, Vec Lambda, SolveReport& report);

  AutomaticOptions options_;
  EasyProblems easy_;
  ProximalNewton newton_;
  ProximalNewton coarse_;  // stops at the accuracy of sweeps
  LemkeSolver lemke_;      // for contacts with G_ii = 0, and after restarts
  BlockNewton rescue_;
  MinimalNorm minimalNorm_;
  Admm admm_;
  PackedGaussSeidel packed_;
  ProxGaussSeidel gaussSeidel_;  // starts of restarts
  std::vector<double> r_, scratch_, start_, keptLambda_;
  Residuals kept_;
};

}  // namespace dynamy
