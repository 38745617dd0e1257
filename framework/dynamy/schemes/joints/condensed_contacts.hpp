/// Contacts of the implicit midpoint, condensed on the linear model of a Newton step: with
/// K = ∂R/∂(v, Λ_J) and u^E = 2v − u^A,
///
///   γ^E = W_cᵀ(2(v + δ) − u^A) + χ + G (Λ_c − Λ_c^k),   G = 2 W_cᵀ (K⁻¹ [W_c; 0])_v
///
/// is an inclusion problem like any other (Josephy–Newton), with G as joints and the turning of
/// their forces make it, not symmetric. Rejected: contacts first and joints afterwards; each undoes
/// what the other has done.
#pragma once
#include <dynamy/schemes/joints/joint_newton.hpp>

namespace dynamy {

class CondensedContacts {
 public:
  /// Starts a step, slot 0 being evaluated at q^A: no impulses but those remembered in x.
  void begin(const MechanicalSystem& s, const State& x, double dt);
  /// Takes the contacts of slot 0 that are no joints; where most of many stay open, those that the
  /// mean velocity v closes, and all that were taken before in this step.
  void select(const MechanicalSystem& s, const State& xA, const Eigen::VectorXd& v, double dt);
  /// Whether select() with this v would take others.
  bool misses(const MechanicalSystem& s, const State& xA, const Eigen::VectorXd& v);
  /// Solves them on the linear model and corrects the Newton step by it.
  SolveReport solve(const MechanicalSystem& s, InclusionSolver& solver, const State& xA,
                    JointNewton& newton, Effort effort);
  /// Whether friction drove instead of braking in the step with mean velocity v: where slip turns
  /// to stick, Λ_T(γ_T^A + γ_T^E)/2 may be positive. A step from begin(…) on then takes the mean
  /// slip in these contacts, ξ_T = γ_T^E + γ_T^A, until forgetMeanSlip().
  bool frictionDrives(const Eigen::VectorXd& v, const State& xA);
  void forgetMeanSlip() { meanSlip_.clear(); }
  /// W_c Λ_c, nu numbers.
  const Eigen::VectorXd& impulse() const { return impulse_; }
  int size() const { return contacts_.size(); }
  /// Impulses of the contact `key`, or null.
  const double* of(ContactKey key) const;

 private:
  /// What γ_N^E + ε γ_N^A of contact i aims at: the gap in the next step. One that opens with γ^A >
  /// 0 may close again with −γ^A at most, so that its work Λ (γ^A + γ^E)/2 is never positive. One
  /// that is to rebound waits until a step begins with it closed: there it is an impact.
  double aim(int i, double gTol) const;
  void pose(const MechanicalSystem& s);
  void follow(const MechanicalSystem& s, const Eigen::VectorXd& dv);
  void findHeld(const MechanicalSystem& s, const JointNewton& newton);
  BlockRows condensed(const JointNewton& newton);
  bool asks(const MechanicalSystem& s, int i) const;
  double start(ContactKey key, int row) const;
  ContactSet contacts_;
  Delassus delassus_;
  InclusionProblem problem_;
  RememberedImpulses last_;
  std::vector<ContactKey> closed_;  // at q^A
  std::vector<ContactKey> asked_;   // in this step, sorted; of no use if few_
  bool few_ = true;
  std::vector<ContactKey> meanSlip_;
  double dt_ = 0.0;
  std::vector<double> Lambda_, old_, gapSlope_;
  std::vector<ContactResponse> response_;  // of each contact
  std::vector<double> held_;               // of each contact: its free G if joints hold it, or 0
  Eigen::VectorXd impulse_, w_, uE_;
};

}  // namespace dynamy
