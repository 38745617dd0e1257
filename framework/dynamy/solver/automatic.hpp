/// Automatic: the choice of a solver that users need not think about.                (theory 7.5)
///
///   start good enough → accept it · one contact → closed form · large factors → ADMM
///   · sweeps while they pay → proximal Newton → the same, other ρ → Gauss–Seidel
///   → proximal Newton from other starts → pivoting
///   → problems from files: many more starts
///
/// A user who names no tolerance does not require one at any price: many contacts then get exact
/// forces where few Newton steps find them, and packed sweeps elsewhere to the residual that is
/// enough for the scheme (`bounded`, theory 4.15); the report says so.
///
/// Every stage is judged by the same residuals. The result is the best Λ that any of them had, be
/// it the start; an unconverged one is returned as such.
#pragma once
#include <dynamy/solver/admm.hpp>
#include <dynamy/solver/easy_problems.hpp>
#include <dynamy/solver/lemke_solver.hpp>
#include <dynamy/solver/minimal_norm.hpp>
#include <dynamy/solver/packed_gauss_seidel.hpp>
#include <dynamy/solver/proximal_newton.hpp>

namespace dynamy {

struct AutomaticOptions {
  double tolerance = 1e-10;   ///< of E_f and E_u, or of the problem's own measure
  int maxNewton = 500;        ///< Newton steps, then those with another ρ
  int maxPatient = 2000;      ///< Newton steps of these, then sweeps
  int maxIterations = 10000;  ///< sweeps of the last stage
  bool minimalNorm = false;   ///< of forces that are not unique, the smallest ones
  bool bounded = false;       ///< what many contacts may cost is bounded (theory 4.15)
};

class Automatic final : public InclusionSolver {
 public:
  explicit Automatic(const AutomaticOptions& options = {});
  explicit Automatic(const Parameters& x);
  static void declare(Attributes& a);
  SolveReport solve(const InclusionProblem& problem, Vec Lambda) override;

 private:
  SolveReport chain(const InclusionProblem& problem, Vec Lambda);
  /// The stages one after the other, from a start that is worth improving; its residuals in.
  SolveReport rungs(const InclusionProblem& problem, Vec Lambda, SolveReport report);
  /// Is the work on this problem bounded?
  bool bounds(const InclusionProblem& problem) const;
  /// Is it that of a time step, without bodies: condensed from joints or stiff forces?
  bool condensed(const InclusionProblem& problem) const;
  /// What Newton's method may cost: less where a condensed G is eliminated as a whole, and little
  /// where the step is tried again. `steps`: at many contacts whose work is bounded.
  NewtonLimits limits(const InclusionProblem& problem, int steps) const;
  /// The last stage for many contacts, at a bounded cost.
  SolveReport boundedSweeps(const InclusionProblem& problem, Vec Lambda, SolveReport report);
  /// Its status by what is enough.
  SolveReport judged(SolveReport report) const;
  /// Remembers Λ if it is the best one so far, and more than rounding.
  void keep(const InclusionProblem& problem, ConstVec Lambda, const Residuals& residuals);
  /// Alternating directions for problems with large factors; true: solved, else Λ is the start.
  bool alternate(const InclusionProblem& problem, Vec Lambda, SolveReport& report);
  /// Newton's method from other starts with other steps ρ; true: solved. Λ is the best one so far.
  bool restarts(const InclusionProblem& problem, Vec Lambda, SolveReport& report);

  /// Many short tries from many starts, for small given problems; true: solved. Λ is the best one
  /// so far.
  bool others(const InclusionProblem& problem, Vec Lambda, SolveReport& report);
  /// Newton's method from `trial`; Λ and the residuals in `report` become better or remain.
  bool tryFrom(const InclusionProblem& problem, const NewtonSchedule& schedule,
               Eigen::VectorXd& trial, Vec Lambda, SolveReport& report);
  /// Λ ← normal forces that alone give `velocity` · u_ref, times up to 1e4 in an order that
  /// `spread` numbers; 0: all alike.
  static void press(const InclusionProblem& problem, double velocity, int spread,
                    Eigen::VectorXd& Lambda);
  /// Lemke's method and Newton steps from its polygons; true: solved. Λ is the best one so far.
  bool pivot(const InclusionProblem& problem, Vec Lambda, SolveReport& report);

  AutomaticOptions options_;
  EasyProblems easy_;
  ProximalNewton newton_;
  LemkeSolver lemke_;  // for G_ii = 0, and last
  BlockNewton rescue_;
  MinimalNorm minimalNorm_;
  Admm admm_;
  PackedGaussSeidel packed_;
  ProxGaussSeidel gaussSeidel_;  // starts of restarts
  std::vector<double> r_, scratch_, start_, keptLambda_;
  Residuals kept_;
};

}  // namespace dynamy
