/// Half-explicit Heun scheme (theory (31.10), (31.11)): order 2 with the laws on velocity level and
/// impacts within the step, as in the half-explicit relatives of the scheme D1Minus.
///
///   Q = q^A + Δt F u^A,    M^A (U − u^A) − Δt h^A − W^A Λ₁ = 0,   laws with W(Q)ᵀU + ε γ^A and Λ₁
///   q^E = q^A + Δt/2 F (u^A + U)
///   u^E = (u^A + U)/2 + Δt/2 M(Q)⁻¹ h(Q, U) + M^E⁻¹ W^E (Λ − Λ₁/2),   laws with γ^E + ε γ^A and Λ
///
/// Active in both stages: contacts that are closed at q^A or Q, or pressed in the last step.
/// Rejected: accelerations of closed contacts as unknowns, which are not unique where Coulomb's law
/// is not.
#pragma once
#include <dynamy/stages/displacement_level.hpp>
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class HalfExplicitHeun final : public OneStep {
 public:
  HalfExplicitHeun() = default;
  explicit HalfExplicitHeun(const Parameters& x) : OneStep(x) {}
  static void declare(Attributes& a);
  int order() const override { return 2; }
  int evaluations() const override { return 3; }
  std::string_view lacks(Asked what) const override {
    return what == Asked::stiffForces
               ? "it takes forces explicitly, and Δt is beyond the limit of a stiff element"
               : std::string_view();
  }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override;

 private:
  void activeContacts(MechanicalSystem& s, const State& x, double dt);
  SolveReport predict(MechanicalSystem& s, InclusionSolver& solver, double dt);
  State begin_, stage_;
  RememberedImpulses first_;  // Λ₁
  std::vector<ContactKey> keys_;
  std::vector<double> carried_, gammaA_, gammaQ_, free_;
  Eigen::VectorXd uMean_, momentum_, uFree_, h_, hNonPotential_;
};

}  // namespace dynamy
