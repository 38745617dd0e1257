/// Nonsmooth generalised-α scheme (theory (31.9), (31.15)): smooth forces by the generalised-α
/// rule, contacts by one inclusion on velocity level.
///
///   M v̇^E = h(q^E, u^E, t^E),   (1−α_m) a^E + α_m a^A = (1−α_f) v̇^E + α_f v̇^A
///   ũ = u^A + Δt ((1−γ) a^A + γ a^E)
///   M w = WΛ,   u^E = ũ + w,   q^E = q^A ⊕ Δt F (u^A + Δt ((½−β) a^A + β a^E) + w/2)
///   ξ = γ^E + ε γ^A,   −ξ_i ∈ N_{C_i}(Λ_i);   M, W at q^E
///
/// α_m = (2ρ−1)/(1+ρ), α_f = ρ/(1+ρ), γ = ½ + α_f − α_m, β = ¼(γ + ½)²: ρ is the share of
/// infinitely fast oscillations that is left after a step. Newton's method uses derivatives of
/// stiff elements only, also in the matrix of the contacts, Wᵀ M̂⁻¹ W, since percussions move the
/// springs.
#pragma once
#include <dynamy/stages/displacement_level.hpp>
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class GeneralizedAlpha final : public OneStep {
 public:
  explicit GeneralizedAlpha(double rho = 0.9) { weights(rho); }
  explicit GeneralizedAlpha(const Parameters& x);
  static void declare(Attributes& a);
  int order() const override { return 2; }
  int evaluations() const override { return 2; }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override;

 private:
  void weights(double rho);
  void start(MechanicalSystem& s, State& x);
  void activeContacts(MechanicalSystem& s, State& x, double dt);
  /// Brings x to the present v̇^E and w, evaluated in slot 0.
  void place(MechanicalSystem& s, State& x, double dt);
  /// One Newton step for v̇^E, w and Λ; returns by how much it changes velocities [m/s].
  double correct(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt,
                 SolveReport& solved);
  double alphaM_ = 0.0, alphaF_ = 0.0, gamma_ = 0.0, beta_ = 0.0;
  State begin_;
  std::vector<ContactKey> keys_;
  Eigen::VectorXd aA_, vdotA_, a_, vdot_, w_, mean_, residual_, change_, uTilde_, uFree_, h_,
      hNonPotential_;
};

}  // namespace dynamy
