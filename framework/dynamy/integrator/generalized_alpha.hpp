/// Nonsmooth generalised-α scheme (theory 31.8): smooth forces by the generalised-α rule, contacts
/// by one inclusion on velocity level.
///
///   M v̇^E = h(q^E, u^E, t^E),   (1−α_m) a^E + α_m a^A = (1−α_f) v̇^E + α_f v̇^A
///   ũ = u^A + Δt ((1−γ) a^A + γ a^E)
///   M w = WΛ,   u^E = ũ + w,   q^E = q^A ⊕ Δt F (u^A + Δt ((½−β) a^A + β a^E) + w/2)
///   ξ = γ^E + ε γ^A,   −ξ_i ∈ N_{C_i}(Λ_i);   M, W at q^E
///
/// α_m = (2ρ−1)/(1+ρ), α_f = ρ/(1+ρ), γ = ½ + α_f − α_m, β = ¼(γ + ½)²: ρ is what is left of
/// infinitely fast oscillations after a step. Newton with derivatives of stiff elements only.
#pragma once
#include <dynamy/integrator/displacement_level.hpp>
#include <dynamy/integrator/one_step.hpp>

namespace dynamy {

class GeneralizedAlpha final : public OneStep {
 public:
  explicit GeneralizedAlpha(double rho = 0.9) : rho_(rho) {}
  explicit GeneralizedAlpha(const Parameters& x);
  static void declare(Attributes& a);
  int order() const override { return 2; }
  int evaluations() const override { return 2; }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override;

 private:
  void start(MechanicalSystem& s, State& x);
  double rho_;
  State begin_;
  std::vector<ContactKey> keys_;
  Eigen::VectorXd aA_, vdotA_, a_, vdot_, w_, mean_, residual_, change_, uTilde_;
};

}  // namespace dynamy
