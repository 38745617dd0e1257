/// Energy-conserving midpoint for joints, with staggered contacts (theory 34.4):
///
///   q^M = q^A ⊕ Δt/2 v,  q^E = q^A ⊕ Δt v,  u^E = 2v − u^A
///   2M(v − u^A) − Δt (h(q^M, v) + h_d(v)) − W̃ Λ_J − W Λ_c = 0
///   g_J(q^E) = 0                        joints at position level, W̃ their discrete gradient
///   ξ = γ^E + ε γ^A + s,  −ξ ∈ N_C(Λ_c)    contacts at q^M, s = g^M/Δt as in StaggeredMoreau
///
/// The equations are solved by Newton's method with the full tangent. Where it fails the step is
/// halved, and where that fails as well StaggeredMoreau takes it (StepReport::simpler). Joints do
/// no work at any Δt and hold to rounding. Forces that are linear in q do exactly their work;
/// forces that the step does not resolve, h_d, are damped (DampedForces). Without joints the step
/// is that of StaggeredMoreau. RATTLE and joints at velocity level were rejected: with a heavy mass
/// at the end of a light chain they diverge where this scheme conserves the energy.
#pragma once
#include <dynamy/schemes/joints/condensed_contacts.hpp>
#include <dynamy/schemes/staggered_moreau.hpp>

namespace dynamy {

class EnergyMomentum final : public OneStep {
 public:
  EnergyMomentum() = default;
  explicit EnergyMomentum(const Parameters& x);
  static void declare(Attributes& a);
  /// From now on a step fails where Newton's iteration fails: it is neither halved nor taken by a
  /// simpler scheme. For callers that handle the failure themselves.
  void whole() { most_ = 0; }
  /// Finds out whether the model has joints, unless it is known: once for all steps.
  void findJoints(MechanicalSystem& s, const State& x, double dt);
  /// True: the model has joints; known after findJoints(), which the first step calls.
  bool hasJoints() const { return joints_ == Joints::some; }
  int order() const override { return 1; }
  bool stepsSome() const override { return joints_ != Joints::some; }
  int evaluations() const override { return 2; }
  StepReport step(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt) override;
  void interpolate(const MechanicalSystem& s, const State& a, const State& b, double theta,
                   State& out) const override;

 private:
  StepReport halve(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt, int depth);
  StepReport cheap(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt);
  static bool simplerAhead(const State& x);
  StepReport simpler(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt);
  StepReport joined(MechanicalSystem& s, InclusionSolver& solver, State& x, double dt);
  SolveReport solve(MechanicalSystem& s, InclusionSolver& solver, const State& x, double dt);
  void hand(MechanicalSystem& s, State& x, double dt, bool jump);
  void startMean(const State& x, double dt);
  void keepMean(State& x, double dt) const;
  enum class Joints { unknown, none, some } joints_ = Joints::unknown;
  StaggeredMoreau staggered_;
  JointNewton newton_;
  CondensedContacts contacts_;
  static constexpr int kMostHalvings = 3;
  bool halvingHelps_ = true;  // no part of the smallest length has failed in this step
  int most_ = kMostHalvings;
  State start_[kMostHalvings + 1], xA_;
  Eigen::VectorXd vStart_;  // where Newton's iteration starts
  std::vector<double> LambdaStart_;
  bool project_ = false;
  Projection projection_;
  Jump jump_;
};

}  // namespace dynamy
