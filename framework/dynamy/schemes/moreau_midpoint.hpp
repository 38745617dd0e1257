/// Moreau's midpoint rule (theory (3.6)), explicit in positions, one inclusion per step:
///
///   q^M = q^A + Δt/2 (F u^A + β)
///   M(u^E − u^A) − hΔt − WΛ = 0,   ξ = γ^E + ε γ^A,   −ξ_i ∈ N_{C_i}(Λ_i)
///   q^E = q^M + Δt/2 (F u^E + β)
///   M, h, W, χ at (t^M, q^M); contacts with g(q^M) ≤ g_tol
#pragma once
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class MoreauMidpoint final : public OneStep {
 public:
  MoreauMidpoint() = default;
  explicit MoreauMidpoint(const Parameters& x) : OneStep(x) {}
  static void declare(Attributes& a);
  int order() const override { return 1; }
  bool stepsSome() const override { return true; }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override;
  void interpolate(const MechanicalSystem& s, const State& a, const State& b, double theta,
                   State& out) const override;
};

}  // namespace dynamy
