/// EnergyGuard: computes the energy that each impact adds, and finds the largest coefficients of
/// restitution at which none does.
///
///   ΔT^A = ½ Λᵀ(γ⁻ + γ⁺)             against the velocities at the beginning of the step
///   ΔT^f = ½ Λᵀ(γ_free + γ⁺)         against those that the forces of the step leave
///
/// A group of contacts (linked through bodies) gains energy if both ΔT^A and ΔT^f are positive
/// beyond what the solver's tolerance leaves. If only one is positive, the step's forces did that
/// work. With ε = 0, ΔT^f ≤ 0 for every law whose set contains 0 (theory 32.3). So a factor
/// f ∈ [0, 1] of ε without gain exists; it is found by bracketing. Rejected: one f for all contacts
/// of the step, with which one impact would reduce the rebound of another, unrelated one.
#pragma once
#include <dynamy/solver/problem/inclusion_solver.hpp>
#include <vector>

namespace dynamy {

/// Groups of contacts that are coupled through bodies, and the group number of each contact.
class ContactGroups {
 public:
  void find(InclusionProblem& problem);
  int size() const { return size_; }
  int of(int contact) const { return group_[static_cast<std::size_t>(contact)]; }

 private:
  std::vector<int> group_, queue_, near_;
  int size_ = 0;
};

class EnergyGuard {
 public:
  /// Factors of ε, all 1, for the contacts of this problem; next() changes them.
  std::vector<double>& factor(const InclusionProblem& problem);
  /// Forms the groups and computes their gains for the percussions of the unchanged law.
  void begin(InclusionProblem& problem, ConstVec Lambda);
  /// Sum of the gains of all groups that gain [J], and their number.
  double gain() const { return gain_; }
  int gaining() const { return gaining_; }
  /// Sets the factors of the next trial; false: all groups accept the last trial.
  bool next();
  /// Computes the gains of a trial and narrows the brackets of the factors.
  void judge(InclusionProblem& problem, ConstVec Lambda);
  /// For percussions that solve nothing, and may therefore add any energy. In each group with
  ///
  ///   ΔT(s) = s Λᵀγ_free + ½ s² ΛᵀGΛ,   ½ ΛᵀGΛ > 2 |Λᵀγ_free|
  ///
  /// Λ ← s Λ with the largest s at which ΔT = 0 (elastic impacts have s = 1); true: some were
  /// reduced.
  bool bound(InclusionProblem& problem, Vec Lambda);

 private:
  struct Search {
    double low = 0.0, high = 1.0;  // no gain at low, gain at high
    double gainLow = 0.0, gainHigh = 0.0;
    double trial = 1.0;
    bool active = false;
  };
  void gains(InclusionProblem& problem, ConstVec Lambda);
  ContactGroups groups_;
  std::vector<double> factor_, gammaE_, gainA_, gainFree_, scale_;
  std::vector<Search> search_;
  double gain_ = 0.0;
  int gaining_ = 0, trials_ = 0;
};

}  // namespace dynamy
