/// Stewart and Trinkle's scheme (theory (31.2), (31.3)): the law holds for the linearised gap at
/// the end of the step.
///
///   M(u^E − u^A) − hΔt − WΛ = 0,   ξ_N = γ_N^E + g/Δt,   ξ_T = γ_T^E,   −ξ_i ∈ N_{C_i}(Λ_i)
///   q^E = q^A + Δt (F u^E + β)
///   M, h, W, χ, g at (t^A, q^A); every contact within reach of the step
#pragma once
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class StewartTrinkle final : public OneStep {
 public:
  StewartTrinkle() = default;
  explicit StewartTrinkle(const Parameters& x) : OneStep(x) {}
  static void declare(Attributes& a);
  int order() const override { return 1; }
  std::string_view lacks(Asked what) const override;
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override;
};

}  // namespace dynamy
