/// InclusionProblem:  ξ = G Λ + c,   −ξ_i ∈ N_{C_i}(Λ_i),  i = 1 … n.     (theory 4.1)
///
/// Solvers see operators and laws, never elements.
#pragma once
#include <atomic>
#include <dynamy/core/workers.hpp>
#include <dynamy/solver/problem/delassus.hpp>
#include <dynamy/solver/problem/stopping_rule.hpp>

namespace dynamy {

/// How long a search for a solution is worth it.
enum class Effort {
  full,     ///< as long as the solver's settings allow
  retried,  ///< a shorter step follows if this is not solved, or long searches were in vain before:
            ///< they find a solution of one problem in a thousand
  little    ///< posed on a linear model, far from where that holds: any answer is only a direction
};

/// Who corrects the velocities that an answer leaves wrong.
enum class Corrected {
  never,         ///< nobody
  inIteration,   ///< the scheme iterates, and halves the step where that leads nowhere
  byGaps,        ///< the next step, by the gaps it finds, after one that was solved to rounding
  byGapsLoosely  ///< the same after one that was not
};

struct InclusionProblem {
  Delassus* G = nullptr;
  const ContactSet* contacts = nullptr;
  double dt = 0.0;                ///< [s]; 0: pure impact
  std::vector<double> c;          ///< c = (1 + ε)… as the impact law poses it [m/s]
  std::vector<double> gammaFree;  ///< Wᵀ u_free + χ: relative velocity without any percussion
  std::vector<double> gammaA;     ///< Wᵀ u^A + χ
  /// Velocity scale of E_u: the largest change of a relative velocity asked of a contact that is
  /// not leaving; one that leaves at 100 m/s must not loosen a resting stack  [m/s].
  double uRef = 1.0;
  /// Per row: how much of c is rounding; empty: none  [m/s].
  std::vector<double> cNoise;
  Corrected corrected = Corrected::never;
  Effort effort = Effort::full;
  /// Replaces E_f and E_u as the measure that is compared with the tolerance; null: these two.
  const StoppingRule* rule = nullptr;
  Workers* workers = nullptr;  ///< null: the caller's thread alone
  /// Set by another thread or a signal: the answer is of no use any more; null: it always is.
  const std::atomic<bool>* stop = nullptr;
  /// No more work is wanted: the solver returns its best Λ so far. Asked now and then.
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
