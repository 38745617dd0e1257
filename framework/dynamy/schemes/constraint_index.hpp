/// Constraints of joints on one of three levels (theory 31.11), for comparison:
///
///   index 1   γ̇ = 0:      GΛ = −Δt (Wᵀ M⁻¹ h + bias)          velocities and positions drift
///   index 2   γ^E = 0:    GΛ = −(Wᵀ u^A + Δt Wᵀ M⁻¹ h + χ)    positions drift
///   index 3   g(q^E) = 0                                      no drift
///
///   M(u^E − u^A) − hΔt − WΛ = 0,   q^E = q^A + Δt (F u^E + β);   M, h, W at (t^A, q^A)
///
/// Impacts are not defined on these levels: a step in which a unilateral contact closes is refused.
#pragma once
#include <dynamy/stages/displacement_level.hpp>
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class ConstraintIndex final : public OneStep {
 public:
  explicit ConstraintIndex(int index = 2) : index_(index) {}
  explicit ConstraintIndex(const Parameters& x);
  static void declare(Attributes& a);
  int order() const override { return 1; }
  int evaluations() const override { return 2; }
  std::string_view lacks(Asked what) const override {
    return what == Asked::stiffForces
               ? std::string_view()
               : "a unilateral contact closes, and this level knows no impact";
  }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override;

 private:
  void poseAccelerations(InclusionProblem& problem, double dt) const;
  int index_;
  DisplacementLevel level_;
};

}  // namespace dynamy
