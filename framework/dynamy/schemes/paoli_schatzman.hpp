/// Paoli and Schatzman's scheme (theory (31.5)): a two-step rule with laws on displacement level.
///
///   M (q_{k+1} − 2 q_k + q_{k−1})/Δt = h Δt + WΛ,   ξ_N = (g(q_{k+1}) + ε g(q_{k−1}))/Δt
///   u_k = (q_k − q_{k−1})/Δt is the velocity of the state; M, h, W at q_k
///
/// The method does not define friction; here friction acts on (q_{k+1} − q_k)/Δt. Rejected: q_{k−1}
/// as a second position in the state, since it is q_k moved back by Δt u_k.
#pragma once
#include <dynamy/stages/displacement_level.hpp>
#include <dynamy/stages/one_step.hpp>

namespace dynamy {

class PaoliSchatzman final : public OneStep {
 public:
  PaoliSchatzman() = default;
  explicit PaoliSchatzman(const Parameters& x) : OneStep(x) {}
  static void declare(Attributes& a);
  int order() const override { return 1; }
  int evaluations() const override { return 2; }
  std::string_view lacks(Asked what) const override;
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override;

 private:
  void gapsBefore(MechanicalSystem& s, const InclusionProblem& problem, const State& x, double dt);
  DisplacementLevel level_;
  State before_;
  Eigen::VectorXd a_;
  std::vector<ContactKey> keys_;
  std::vector<double> offset_;  // ε g(q_{k−1})/Δt
};

}  // namespace dynamy
