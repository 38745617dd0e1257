/// Stabilised scheme of Gear, Gupta and Leimkuhler (theory (31.12), (31.13)): laws on velocity
/// level and on position level, each with its own multiplier.
///
///   q^E = q^A + Δt (F u^A + β) + F M⁻¹Wτ,    0 ≤ g(q^E) ⊥ τ ≥ 0      (joints: g(q^E) = 0)
///   M(u^E − u^A) − hΔt − WΛ = 0,   ξ = γ^E + ε γ^A,   −ξ_i ∈ N_{C_i}(Λ_i)
///   τ: M, W at (t^A, q^A);   Λ: M, h, W, χ at (t^E, q^E)
#pragma once
#include <dynamy/stages/displacement_level.hpp>
#include <dynamy/stages/one_step.hpp>
#include <memory>

namespace dynamy {

/// Restricts a law to its normal and joint rows; the other rows carry nothing.
class PositionLaw final : public SetValuedForceLaw {
 public:
  void of(const SetValuedForceLaw& law) { law_ = &law; }
  int dim(int geometric) const override { return law_->dim(geometric); }
  bool unilateral() const override { return law_->unilateral(); }
  RowKind rowKind(int row) const override { return law_->rowKind(row); }
  void prox(const LawInput& in, const double* r, const double* xi, double* Lambda) const override;
  bool proxDerivative(const LawInput& in, double rho, const double* xi, const double* Lambda,
                      double* A, double* B) const override;
  Status status(const LawInput&, const double* argument) const override {
    return argument[0] > 0.0 || !unilateral() ? Status::locked : Status::separating;
  }

 private:
  const SetValuedForceLaw* law_ = nullptr;
};

class Ggl final : public OneStep {
 public:
  Ggl() = default;
  explicit Ggl(const Parameters& x) : OneStep(x) {}
  static void declare(Attributes& a);
  int order() const override { return 1; }
  int evaluations() const override { return 3; }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override;

 private:
  DisplacementLevel level_;
  State begin_;
  std::vector<std::unique_ptr<PositionLaw>> laws_;
};

}  // namespace dynamy
