/// FrozenPhase: the motion between two switches, with the status of every contact held
/// (theory 50.1):
///
///   M u̇ = h + W (P π + p₀),   Sᵀ (Wᵀ u̇ + w̄) = 0     ⇒     (Sᵀ G P) π = −Sᵀ (Wᵀ M⁻¹(h + W p₀) + w̄)
///
///   joint, sticking or frictionless closed contact     P = S = I
///   slip of a cone                                     P = e_N − μ t,  S = e_N,  t = γ_T/|γ_T|
///   slip of a reservoir B in several rows              P = e_N − ∇S_B(γ_T),  S = e_N
///   each of several discs over one λ_N                 stick: I;  slip: P = −μ_b t beside e_N
///   slip of a set of given size                        p₀ = −a t, no unknown
///   set on a displacement x: at x = 0; beside it       P = S = I;  p₀ = the force at x
///
/// In one tangent t is a sign that was decided at the switch. It does not flip while stages pass
/// zero, so that the motion continues smoothly past the end of slip, and the path shows the end.
/// Redundant rows share the forces of the last decision, changed as little as possible; the
/// accelerations do not depend on that choice.
#pragma once
#include <dynamy/located/phase/held_forces.hpp>
#include <dynamy/located/phase/held_rows.hpp>
#include <dynamy/located/phase/phase_request.hpp>
#include <dynamy/located/phase/shared_forces.hpp>
#include <dynamy/located/phase/starting_slips.hpp>

namespace dynamy {

class FrozenPhase {
 public:
  /// Joints, then closed contacts and sets of given size, in order of emission.
  std::vector<Held> held;
  /// What evaluations request. The keys are those of `held` only where the owner has updated them.
  PhaseRequest request;
  double cubes = 0.0;  ///< as HeldForces::cubes; the owner resets it

  /// Reads the rows of the held contacts in the evaluation `e`, with the velocities u. False:
  /// fault() says why.
  bool read(const Evaluation& e, const Eigen::VectorXd& u);
  /// Accelerations from the evaluation `e`, with the velocities u. False: fault() says why.
  bool accelerate(const Evaluation& e, const Eigen::VectorXd& u, Eigen::VectorXd& a);
  /// Half-explicit: forces at the evaluation `e`, with u, such that `before` + τ a does not move in
  /// the held rows of `next`, the contacts at the next position. Only slips that start use the
  /// bias. False: fault() says why.
  bool advance(const Evaluation& e, const Eigen::VectorXd& u, const ContactSet& next,
               const Eigen::VectorXd& before, double tau, Eigen::VectorXd& a);
  /// Where rows are redundant, chooses their forces from now on: the smallest ones, those of the
  /// decision, or ones between, whichever stay furthest from all bounds. `same`: a decision has left
  /// all statuses as they were; if one of these forces is near its bound then, the centre of all that
  /// are within their bounds is taken.
  bool share(const Evaluation& e, const Eigen::VectorXd& u, Eigen::VectorXd& a, bool same);
  /// Notes which redundant rows follow from others, so that later accelerations cost less.
  void findImplied() { forces_.findImplied(held, rows_); }
  std::string_view fault() const { return fault_.why; }
  /// The contact of the last fault that has one.
  ContactKey lost() const { return fault_.contact; }

  /// Rows of the held contacts, as they were read last.
  const HeldRows& rows() const { return rows_; }
  /// Forces of the last acceleration, row after row of rows() [N].
  const Eigen::VectorXd& lambda() const { return forces_.lambda(); }
  /// γ̇ of a row in the last acceleration.
  double gammaDot(int row) const { return gammaDot_[row]; }
  /// Powers in the last acceleration: of forces without potential, friction, normal, joints, moving
  /// ground [W].
  const std::array<double, 5>& power() const { return power_; }
  /// `value`: distance of the force of held[i] from its bound, positive as long as the force
  /// permits the status; to be compared with forceScale(). False: the force has no bound.
  bool margin(std::size_t i, double& value) const;
  /// True: rows are redundant, so that those of contacts that stick may contradict others.
  bool mayContradict() const { return forces_.redundant(); }
  /// The force that is missing most to hold a row of a contact that sticks, as a part of the forces
  /// of this contact: above 0 where redundant rows contradict each other, so that no forces hold all.
  double contradiction() const;
  /// The largest force, or bound of a set of given size [N].
  double forceScale() const { return forceScale_; }

 private:
  double leastMargin() const;
  bool nearBound() const;
  bool centre(const Evaluation& e, const Eigen::VectorXd& u, Eigen::VectorXd& a);
  void startDirections(const Evaluation& e);
  void finish(const Evaluation& e, const Eigen::VectorXd& u);
  HeldRows rows_;
  AccelerationRows next_;  // at the next position of a half-explicit sub-step
  HeldForces forces_;
  StartingSlips slips_;
  SharedForces shared_;
  Eigen::VectorXd gammaDot_;
  std::array<double, 5> power_{};
  double forceScale_ = 0.0;
  PhaseFault fault_;
};

}  // namespace dynamy
