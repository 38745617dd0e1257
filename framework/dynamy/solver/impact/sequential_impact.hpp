/// SequentialImpact: multiple impacts as a sequence of single ones,
///
///   k = the contact that closes fastest,  ξ_k = γ_k⁺ + ε_k γ_k⁻,  −ξ_k ∈ N_{C_k}(ΔΛ_k),
///   γ ← γ + G_{·k} ΔΛ_k,   until none closes,
///
/// then one inclusion with ε = 0 for the forces of the step. Equal balls in a row pass the velocity
/// on one by one (Newton's cradle); simultaneous laws share it. Contacts linked to joints or
/// clutches are solved together, by Newton's law, because a hit on one of them would have to solve
/// for all of them.
#pragma once
#include <dynamy/solver/impact/impact_law.hpp>

namespace dynamy {

class SequentialImpact final : public ImpactLaw {
 public:
  SequentialImpact() = default;
  explicit SequentialImpact(const Parameters& x) : ImpactLaw(x) {}
  static void declare(Attributes& a);

 protected:
  SolveReport percussions(InclusionProblem& problem, InclusionSolver& solver,
                          const std::vector<double>& factor, Vec Lambda) const override;

 private:
  /// The contact that closes fastest, or −1.
  int fastest(const InclusionProblem& problem) const;
  void hit(InclusionProblem& problem, int i, double factor) const;
  mutable ContactGroups groups_;
  mutable std::vector<char> together_;  // per group: its contacts are solved together
  mutable std::vector<double> gamma_, Lambda_, block_;
  mutable std::vector<int> near_;
};

}  // namespace dynamy
