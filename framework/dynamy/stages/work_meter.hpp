/// WorkMeter: works of one step whose velocity changes in a single jump, by one inclusion,
///
///   M(u^E − u^A) = hΔt + WΛ   ⇒   ΔT = Δt h·ū + Σ_rows Λ (γ̄ − χ),   ū = (u^A + u^E)/2
///
/// These works are exact, row by row.
#pragma once
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class WorkMeter {
 public:
  /// Works of the step from u^A to u^E whose evaluation is in slot 0 of `s`. The percussions
  /// `Lambda` [N s] count if they have the rows of its closed contacts.
  StepWorks of(const MechanicalSystem& s, const Eigen::VectorXd& uA, const Eigen::VectorXd& uE,
               double dt, ConstVec Lambda);

 private:
  std::vector<double> gammaE_;
};

}  // namespace dynamy
