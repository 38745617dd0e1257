/// Anitescu and Potra's scheme (theory (31.2), (31.4)): contacts that are closed at the beginning
/// of the step, on velocity level. The impact law determines the rebound (theirs is Poisson's).
///
///   M(u^E − u^A) − hΔt − WΛ = 0,   ξ = γ^E + ε γ^A,   −ξ_i ∈ N_{C_i}(Λ_i)
///   q^E = q^A + Δt (F u^E + β)
///   M, h, W, χ at (t^A, q^A); contacts with g(q^A) ≤ g_tol
#pragma once
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class AnitescuPotra final : public OneStep {
 public:
  AnitescuPotra() = default;
  explicit AnitescuPotra(const Parameters& x) : OneStep(x) {}
  static void declare(Attributes& a);
  int order() const override { return 1; }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override;
};

}  // namespace dynamy
