/// ImpactLaw: how ξ is formed from γ⁺ and γ⁻ and how many inclusions one impact takes, so that no
/// scheme repeats it.
#pragma once
#include <dynamy/solver/inclusion_solver.hpp>

namespace dynamy {

class ImpactLaw : public Element {
 public:
  static constexpr Kind kKind = Kind::impact;
  using Element::Element;
  /// Poses c from γ_free, γ^A and the laws' ε and solves; Λ: start in, percussions out.
  virtual SolveReport solve(InclusionProblem& problem, InclusionSolver& solver,
                            Vec Lambda) const = 0;
};

/// Newton's law in Moreau's inequality form: ξ = γ^E + ε γ^A, so c = γ_free + ε γ^A; one solve.
class NewtonImpact final : public ImpactLaw {
 public:
  NewtonImpact() = default;
  explicit NewtonImpact(const Parameters& x) : ImpactLaw(x) {}
  static void declare(Attributes& a);
  SolveReport solve(InclusionProblem& problem, InclusionSolver& solver, Vec Lambda) const override;
};

}  // namespace dynamy
