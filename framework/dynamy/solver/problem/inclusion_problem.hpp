/// InclusionProblem:  ξ = G Λ + c,   −ξ_i ∈ N_{C_i}(Λ_i),  i = 1 … n.     (theory 4.1)
///
/// Solvers see operators and laws, never elements.
#pragma once
#include <atomic>
#include <dynamy/core/workers.hpp>
#include <dynamy/solver/problem/delassus.hpp>
#include <dynamy/solver/problem/stopping_rule.hpp>

namespace dynamy {

/// How much work a search for a solution is worth.
enum class Effort {
  full,     ///< as long as the solver's settings allow
  retried,  ///< a shorter step follows if this one is not solved, or long searches failed before:
            ///< they solve one problem in a thousand
  little    ///< the linear model is far outside its range: any answer is only a direction
};

/// Who corrects the errors in velocities that a solution leaves.
enum class Corrected {
  never,         ///< nobody
  inIteration,   ///< the scheme iterates, and halves the step if it does not converge
  byGaps,        ///< the next step, by its gaps, after a step that was solved to rounding
  byGapsLoosely  ///< the next step, by its gaps, after a step that was not solved to rounding
};

/// Work of solvers.
struct SolverWork {
  /// Cost of an iteration of Newton over one of sweeps, with its factorisation: 4 … 15 in jointed
  /// random scenes.
  static constexpr long kNewton = 8;
  long visits = 0;  ///< contacts times iterations, those of Newton kNewton times
};

struct InclusionProblem {
  Delassus* G = nullptr;
  const ContactSet* contacts = nullptr;
  double dt = 0.0;                ///< [s]; 0: pure impact
  std::vector<double> c;          ///< γ_free + ε γ_A with Newton's impact law [m/s]
  std::vector<double> gammaFree;  ///< Wᵀ u_free + χ: relative velocity without any percussion
  std::vector<double> gammaA;     ///< Wᵀ u^A + χ
  /// Velocity scale of E_u [m/s]: the largest change of a relative velocity required at a contact
  /// that is not separating. A contact that separates at 100 m/s must not loosen the tolerance of a
  /// resting stack.
  double uRef = 1.0;
  /// Rounding error of c per row [m/s]; empty: none.
  std::vector<double> cNoise;
  Corrected corrected = Corrected::never;
  Effort effort = Effort::full;
  /// Replaces E_f and E_u as the measure that is compared with the tolerance; null: they are used.
  const StoppingRule* rule = nullptr;
  Workers* workers = nullptr;  ///< null: the caller's thread alone
  /// Set by another thread or a signal when the solution is no longer needed; null: never.
  const std::atomic<bool>* stop = nullptr;
  /// Counts how often solvers have visited a contact, in sweeps and Newton steps alike; null:
  /// nobody does. Borrowed.
  SolverWork* work = nullptr;
  /// True if no more work is wanted. Solvers check it at intervals and return their best Λ so far.
  bool enough() const {
    return (stop != nullptr && stop->load(std::memory_order_relaxed)) || (rule && rule->enough());
  }

  int size() const { return contacts->size(); }
  int rows() const { return contacts->rows(); }
  int row0(int i) const { return contacts->row0[static_cast<std::size_t>(i)]; }
  int dim(int i) const { return contacts->dim(i); }
  const SetValuedForceLaw& law(int i) const { return *contacts->law[static_cast<std::size_t>(i)]; }
  LawInput input(int i) const { return contacts->input(i, dt, gammaA.data()); }
};

}  // namespace dynamy
