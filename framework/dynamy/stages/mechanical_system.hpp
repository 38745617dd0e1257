/// MechanicalSystem: the stages of a step on flat arrays. Schemes see M, h, F, W, χ and never an
/// element. One whose parts have a subset is a view on these systems, with arrays of its own.
///
/// A slot (Evaluation) holds everything evaluated at one (t, q, u). Data are produced by a stage in
/// fixed order and const afterwards; "is up to date" flags were rejected.
#pragma once
#include <dynamy/stages/impact_problem.hpp>

namespace dynamy {

class MechanicalSystem {
 public:
  /// Set by the caller of a scheme for each step.
  StepLimits limits{};

  explicit MechanicalSystem(const SystemParts& parts, int slots = 1);

  /// q ← q ⊕ Δt (F v + β), t ← t + Δt, with velocities v that need not be x.u.
  void move(State& x, const Eigen::VectorXd& v, double dt) const;
  /// q ← q ⊕ Δt (F u + β), t ← t + Δt.
  void move(State& x, double dt) const { move(x, x.u, dt); }
  /// Evaluates M, h and contacts at (x.t, x.q, x.u), into the slot of the request.
  const Evaluation& evaluate(const State& x, const EvaluationRequest& request = {});
  /// Poses ξ = GΛ + c from slot `slot`, for a step Δt from x: u_free = u^A + M⁻¹hΔt, γ's, G, start of
  /// Λ by contact key. There is one problem at a time.
  ImpactProblem& impactProblem(const State& x, double dt, int slot = 0,
                               const PositionAim* aim = nullptr);
  /// The problem posed last.
  const ImpactProblem& problem() const { return problem_; }
  /// Slot i, as evaluated last.
  const Evaluation& slot(int i) const { return slots_[static_cast<std::size_t>(i)]; }
  /// Slot i, for schemes that change the laws of a stage, or replace h by what the step really used
  /// (the energy ledger reads that of slot 0).
  Evaluation& change(int slot) { return slots_[static_cast<std::size_t>(slot)]; }
  /// Forces that steps take at their end.
  ImplicitForces& implicitForces() { return implicit_; }
  const ImplicitForces& implicitForces() const { return implicit_; }
  const SystemParts& parts() const { return parts_; }

  /// Closed: g ≤ gTol [m]; default 1e-12 of the scene's length.
  void gTol(double value) { gTol_ = value; }
  double gTol() const { return gTol_; }

  /// Lets elements change the memory that they reserved; the time loop calls it after every step.
  void remember(State& x);
  /// V(q,t) of all systems and forces [J].
  double potentialEnergy(const State& x);
  /// The same with the kinematics at x, which are known.
  double potentialEnergy(const Kinematics& k, const State& x) const;

  /// Index of a system whose M is not positive definite in the last evaluation, or −1.
  int indefiniteMass() const { return indefinite_; }
  /// Calls of evaluate() so far: the cost of a run without the solver.
  long evaluations() const { return evaluations_; }
  /// Counts evaluations that a view on some of the systems has made.
  void count(long evaluations) { evaluations_ += evaluations; }

 private:
  void detect(const State& x, const EvaluationRequest& request, Evaluation& e);
  SystemParts parts_;
  std::vector<Evaluation> slots_;
  ImplicitForces implicit_;
  ImpactProblem problem_;
  double gTol_ = 0.0;
  int indefinite_ = -1;
  long evaluations_ = 0;
  Kinematics ownKinematics_;  // for memory and energy
};

/// Largest change of a velocity by the forces of slot 0: max |Δt M⁻¹h| [m/s].
double largestChange(const MechanicalSystem& s, double dt);

/// True: a rule that is explicit in h and stable up to ωΔt = `limit` is not so for the stiff elements
/// at x, which is evaluated in slot `slot`.
inline bool explicitIsUnstable(MechanicalSystem& s, int slot, const State& x, double dt,
                               double limit) {
  return s.implicitForces().explicitIsUnstable(s.parts(), s.slot(slot), x, dt, limit);
}

/// Lets systems remove blocks and add others, after the step that began at tA. True: some did.
bool renewSystems(const Topology& topology, double tA, State& x);

}  // namespace dynamy
