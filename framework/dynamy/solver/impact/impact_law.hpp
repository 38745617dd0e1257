/// ImpactLaw: forms ξ from γ⁺ and γ⁻ and solves the inclusions of an impact, so that no scheme
/// repeats this. The energy guard checks the result of every law.
///
///   Newton      ξ = γ⁺ + ε γ⁻, one inclusion
///   Poisson     compression with ε = 0, expansion with Λ_N ≥ ε Λ_N^C
///   energetic   as Poisson, with a share κ of Λ_N^C that returns ε² of the energy of compression
///   sequential  one contact after the other, the fastest first
#pragma once
#include <dynamy/solver/impact/energy_guard.hpp>

namespace dynamy {

class ImpactLaw : public Element {
 public:
  static constexpr Kind kKind = Kind::impact;
  using Element::Element;
  /// Forms c from γ_free, γ^A and the laws' ε, and solves; Λ: start in, percussions out. A group of
  /// contacts whose impact gains energy is solved again with smaller ε; the report says so.
  /// Percussions that solve nothing are reduced until they add no energy.
  SolveReport solve(InclusionProblem& problem, InclusionSolver& solver, Vec Lambda) const;
  /// True if ξ = γ⁺ + ε γ⁻ is the whole law, so that a scheme may form it by itself.
  virtual bool newtons() const { return false; }

 protected:
  /// Solves for the percussions of the law with factor[i] ε_i for contact i, without energy guard.
  virtual SolveReport percussions(InclusionProblem& problem, InclusionSolver& solver,
                                  const std::vector<double>& factor, Vec Lambda) const = 0;

 private:
  SolveReport guarded(InclusionProblem& problem, InclusionSolver& solver, Vec Lambda) const;
  // Workspace, so that a step allocates no memory; a law therefore serves one run at a time.
  mutable EnergyGuard guard_;
  mutable std::vector<double> scratch_;
};

/// c = γ_free + factor ε γ^A.
void poseRestitution(InclusionProblem& problem, const std::vector<double>& factor);
/// Adds the iterations of another solve of the same step to `total`. The residuals are those of the
/// last solve; so is the status, unless an earlier solve failed.
void addSolve(SolveReport& total, const SolveReport& last);
/// True if γ^A exceeds its rounding in some row with ε ≠ 0.
bool rebounds(const InclusionProblem& problem);

/// Newton's law in Moreau's inequality form: ξ = γ^E + ε γ^A, so c = γ_free + ε γ^A; one solve.
class NewtonImpact final : public ImpactLaw {
 public:
  NewtonImpact() = default;
  explicit NewtonImpact(const Parameters& x) : ImpactLaw(x) {}
  bool newtons() const override { return true; }
  bool isMirrored(const MirrorPlane&) const override { return true; }
  static void declare(Attributes& a);

 protected:
  SolveReport percussions(InclusionProblem& problem, InclusionSolver& solver,
                          const std::vector<double>& factor, Vec Lambda) const override;
};

}  // namespace dynamy
