/// Half-explicit Euler step of Stiegelmeyr, Funk, Foerg and Pfeiffer (theory (3.7)): W and the law
/// at the END position.
///
///   q^E = q^A + Δt (F u^A + β)
///   M(u^E − u^A) − hΔt − WΛ = 0,   ξ = γ^E + ε γ^A,   −ξ_i ∈ N_{C_i}(Λ_i)
///   M, W, χ at (t^E, q^E); h at (t^E, q^E, u^A)
#pragma once
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class HalfExplicitEuler final : public OneStep {
 public:
  HalfExplicitEuler() = default;
  explicit HalfExplicitEuler(const Parameters& x) : OneStep(x) {}
  static void declare(Attributes& a);
  int order() const override { return 1; }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override;
};

}  // namespace dynamy
