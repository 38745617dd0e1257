/// Nonsmooth RATTLE (theory (31.7), (31.8)): laws for both positions and velocities at the end of
/// the step, order 2 between impacts.
///
///   M^A (u^½ − u^A) − Δt/2 h(q^A, u^½) − W^A Λ₁ = 0,   q^E = q^A + Δt (F u^½ + β)
///        ξ_N = g(q^E)/Δt,  ξ_T = γ_T(u^½),   −ξ ∈ N_C(Λ₁)
///   M^E (u^E − u^½) − Δt/2 h(q^E, u^½) − W^E (Λ − Λ₁) = 0
///        ξ = γ^E + ε γ^A,   −ξ ∈ N_C(Λ)
///
/// The law of the second stage holds for the percussion Λ of the whole step. Rejected: laws for the
/// two halves apart; a contact that presses in one half only would have to pull in the other.
#pragma once
#include <dynamy/stages/displacement_level.hpp>
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class NonsmoothRattle final : public OneStep {
 public:
  NonsmoothRattle() = default;
  explicit NonsmoothRattle(const Parameters& x) : OneStep(x) {}
  static void declare(Attributes& a);
  int order() const override { return 2; }
  int evaluations() const override { return 2; }
  std::string_view lacks(Asked what) const override {
    return what == Asked::stiffForces
               ? "it takes forces explicitly, and Δt is beyond the limit of a stiff element"
               : std::string_view();
  }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override;

 private:
  SolveReport positions(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt);
  SolveReport velocities(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt);
  void closedAtEnd(const MechanicalSystem& s);
  DisplacementLevel level_;
  State begin_, half_;
  RememberedImpulses first_;  // Λ₁
  std::vector<ContactKey> keys_;
  std::vector<double> carried_;
  Eigen::VectorXd h_, hNonPotential_, momentum_, uHalf_, uFree_;
};

}  // namespace dynamy
