/// ImpactLaw: how ξ is formed from γ⁺ and γ⁻ and how many inclusions one impact takes, so that no
/// scheme repeats it; and the energy guard, which no law can go round.
///
///   Newton      ξ = γ⁺ + ε γ⁻, one inclusion
///   Poisson     compression with ε = 0, expansion with Λ_N ≥ ε Λ_N^C
///   energetic   the same, with a share κ of Λ_N^C that returns ε² of the energy of compression
///   sequential  one contact after the other, the fastest first
#pragma once
#include <dynamy/solver/impact/energy_guard.hpp>

namespace dynamy {

class ImpactLaw : public Element {
 public:
  static constexpr Kind kKind = Kind::impact;
  using Element::Element;
  /// Poses c from γ_free, γ^A and the laws' ε and solves; Λ: start in, percussions out. A group of
  /// contacts whose impact gains energy is solved again with smaller ε; the report says so.
  SolveReport solve(InclusionProblem& problem, InclusionSolver& solver, Vec Lambda) const;
  /// True: ξ = γ⁺ + ε γ⁻ says it all, so that a scheme may pose it by itself.
  virtual bool newtons() const { return false; }

 protected:
  /// The law as it is stated, with factor[i] ε_i for contact i.
  virtual SolveReport percussions(InclusionProblem& problem, InclusionSolver& solver,
                                  const std::vector<double>& factor, Vec Lambda) const = 0;

 private:
  // Workspace, so that a step takes no memory; a law serves one run at a time.
  mutable EnergyGuard guard_;
};

/// c = γ_free + factor ε γ^A.
void poseRestitution(InclusionProblem& problem, const std::vector<double>& factor);
/// Adds the effort of another solve of the same step; status and residuals are those of the last
/// one, unless an earlier one failed.
void addSolve(SolveReport& total, const SolveReport& last);
/// True if some contact with ε ≠ 0 closes: ε γ^A beyond rounding.
bool rebounds(const InclusionProblem& problem);

/// Newton's law in Moreau's inequality form: ξ = γ^E + ε γ^A, so c = γ_free + ε γ^A; one solve.
class NewtonImpact final : public ImpactLaw {
 public:
  NewtonImpact() = default;
  explicit NewtonImpact(const Parameters& x) : ImpactLaw(x) {}
  bool newtons() const override { return true; }
  static void declare(Attributes& a);

 protected:
  SolveReport percussions(InclusionProblem& problem, InclusionSolver& solver,
                          const std::vector<double>& factor, Vec Lambda) const override;
};

}  // namespace dynamy
