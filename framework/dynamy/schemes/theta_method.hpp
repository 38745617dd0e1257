/// Modified Θ-method (theory (31.6)): implicit in the smooth forces, with Moreau's inclusion:
///
///   q^M = q^A + (1−Θ)Δt (F u^A + β)
///   M(u^E − u^A) − Δt [Θ h(q^E,u^E,t^E) + (1−Θ) h(q^A,u^A,t^A)] − WΛ = 0
///   ξ = γ^E + ε γ^A,   −ξ_i ∈ N_{C_i}(Λ_i),     q^E = q^M + ΘΔt (F u^E + β)
///   M, W, χ at (t^M, q^M); contacts with g(q^M) ≤ g_tol
///
/// Newton's method solves the smooth part with the matrix M̂ = M − ΘΔt ∂h/∂u − Θ²Δt² ∂h/∂q F. It
/// uses derivatives only of elements that declare themselves stiff; others converge without them.
#pragma once
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class ThetaMethod final : public OneStep {
 public:
  explicit ThetaMethod(double theta = 0.5) : theta_(theta) {}
  explicit ThetaMethod(const Parameters& x);
  static void declare(Attributes& a);
  int order() const override { return 1; }
  int evaluations() const override { return 3; }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override;

 private:
  double theta_;
  State begin_, end_;
  Eigen::VectorXd h_, hNonPotential_, residual_, uFree_;
};

}  // namespace dynamy
