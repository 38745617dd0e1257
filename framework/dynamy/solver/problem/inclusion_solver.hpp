/// InclusionSolver: finds Λ of an inclusion problem. It never throws; the residuals report how
/// accurate Λ is.
#pragma once
#include <array>
#include <dynamy/solver/problem/inclusion_problem.hpp>
#include <string_view>

namespace dynamy {

enum class SolveStatus : std::uint8_t { solved, maxIterations, stalled, diverged, notFinite };
std::string_view solveStatusText(SolveStatus status);

/// Residuals are scale-free natural maps e_i (theory 4.4) of the contacts with ρ_i = 1/λ_max(G_ii):
///
///   E_u = max_i |e_i|/ρ_i / u_ref,        E_f = max_i |e_i| / max(max|Λ|, max_i ρ_i u_ref),
///   E_energy = Σ |e_i|²/ρ_i / Σ ρ_i |c_i|²
///
/// In E_u and E_f a contact counts only if |e_i|/ρ_i exceeds its rounding error,
/// cNoise_i + 4ε(|G||Λ| + |c|)_i: no solver can do better, and none stalls there. The floor of E_f,
/// max_i ρ_i u_ref, gives E_f ≤ E_u, so that solvers terminate in a scene without forces. A floor
/// of 1e-12 of it was rejected, because E_f of a scene at rest is then rounding over rounding.
/// If Λ is so large that it cannot resolve 1 % of the problem's velocities, ε |Λ_i|/ρ_i counts as
/// the error.
struct Residuals {
  double Ef = 0.0, Eu = 0.0, energy = 0.0;
  int worst = -1;       ///< contact with the largest |e_i|/ρ_i
  double given = -1.0;  ///< the measure of the problem's own rule; negative: it has none
  /// The value that is compared with the tolerance.
  double largest() const { return given == -1.0 ? (Ef > Eu ? Ef : Eu) : given; }
};

/// One method of a chain of solvers, and its result.
struct Attempt {
  std::string_view method;
  int iterations = 0;
  double residual = 0.0;  ///< Residuals::largest() of the best Λ so far
};

struct SolveReport {
  SolveStatus status = SolveStatus::solved;
  int iterations = 0;
  Residuals residuals;
  bool warmAccepted = false;       ///< the start was exact to rounding
  int newton = 0;                  ///< Newton steps among the iterations
  int rejected = 0;                ///< inner problems given up
  bool inVain = false;             ///< a long search has found no solution
  std::string_view method;         ///< method that found the solution, if a solver has several
  std::array<Attempt, 8> attempt;  ///< methods of a chain, in the order of trying
  int attempts = 0;                ///< number of attempts; those that do not fit are not recorded
  /// Energy [J] that impacts would have gained by the unchanged law; the energy guard (theory 32.3)
  /// has repaired `repaired` groups of contacts.
  double energyGain = 0.0;
  int repaired = 0;
  bool ok() const { return status == SolveStatus::solved; }
  /// Records an attempt: method `name`, its iterations since `iterationsBefore`, its residual.
  void note(std::string_view name, int iterationsBefore) {
    if (attempts < static_cast<int>(attempt.size()))
      attempt[static_cast<std::size_t>(attempts++)] = {name, iterations - iterationsBefore,
                                                       residuals.largest()};
  }
};

/// Counts the work of a solution, if the problem wants it counted.
inline void count(const InclusionProblem& p, const SolveReport& report) {
  if (p.work == nullptr) return;
  p.work->visits += static_cast<long>(p.size()) *
                    (report.iterations + 1 + (SolverWork::kNewton - 1) * report.newton);
}

/// A start with E_f and E_u below this is accepted unchanged; a worse one is improved at least
/// once, even if it fulfils the tolerance. Rejected: to accept a start at the tolerance. Its
/// velocity errors would then never be corrected: a resting contact drifts by tolerance · u_ref ·
/// Δt in every step until its gap exceeds g_tol and it opens.
inline constexpr double kExactStart = 1e-14;
/// Fraction of the tolerance up to which a start is accepted if its errors are corrected later.
/// Gaps do not correct creep: with them a start must be better than a solution. After a loosely
/// solved step it must be better still, or a step at rest would never be solved again.
inline double takenStart(Corrected corrected) {
  constexpr double kByGaps = 0.1, kByGapsLoosely = 0.01;
  switch (corrected) {
    case Corrected::never:
      return 0.0;
    case Corrected::inIteration:
      return 1.0;
    case Corrected::byGaps:
      return kByGaps;
    case Corrected::byGapsLoosely:
      return kByGapsLoosely;
  }
  return 0.0;
}
/// Residual up to which a solver with this tolerance accepts the start of `problem` unchanged.
inline double acceptedStart(const InclusionProblem& problem, double tolerance) {
  const double asked = takenStart(problem.corrected) * tolerance;
  return asked > kExactStart ? asked : (kExactStart < tolerance ? kExactStart : tolerance);
}

/// Residuals of Λ, recomputed from scratch; infinite, with its contact as `worst`, if a number in ξ
/// or Λ is not finite. `scratch` is workspace; afterwards its first rows() numbers are ξ.
Residuals residuals(const InclusionProblem& problem, ConstVec Lambda, std::vector<double>& scratch);

/// Bound of the largest eigenvalue of a contact's diagonal block: its largest row sum (exact for
/// one row). 1/λ is the step ρ of the natural map.
double contactLambda(const double* block, int dim);

class InclusionSolver : public Element {
 public:
  static constexpr Kind kKind = Kind::solver;
  using Element::Element;
  /// Λ: start (warm or zero) in, solution out. Stops when E_f ≤ tolerance and E_u ≤ tolerance (or
  /// the measure of the problem's own rule), after at least one iteration unless the start is exact
  /// (kExactStart).
  virtual SolveReport solve(const InclusionProblem& problem, Vec Lambda) = 0;
  /// True: the work on a time step with so many contacts is bounded. The solver then stops at an
  /// engineering accuracy, and the scheme does without exact solves in such a step.
  virtual bool boundsWork(int /*contacts*/) const { return false; }
};

}  // namespace dynamy
