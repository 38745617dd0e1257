/// Contacts of the implicit midpoint rule, condensed onto the linear model of a Newton step: with
/// K = ∂R/∂(v, Λ_J) and u^E = 2v − u^A,
///
///   γ^E = W_cᵀ(2(v + δ) − u^A) + χ + G (Λ_c − Λ_c^k),   G = 2 W_cᵀ (K⁻¹ [W_c; 0])_v
///
/// is an inclusion problem like any other (Josephy–Newton). G contains the joints and the turning
/// of their forces; it is not symmetric. Rejected: contacts first and joints afterwards, since each
/// correction would undo the other.
#pragma once
#include <dynamy/contact/key_index.hpp>
#include <dynamy/schemes/joints/joint_newton.hpp>

namespace dynamy {

/// Which contacts are coupled, since they move common parts of a mechanism.
class CoupledContacts {
 public:
  /// Lists the first n of the contacts with these responses by the parts that they move.
  void list(const std::vector<ContactResponse>& responses, int n);
  /// Contacts that move a part that contact i, with this response, moves, and i itself, ascending.
  const std::vector<int>& with(int i, const ContactResponse& response);

 private:
  std::vector<std::vector<int>> ofPart_;
  std::vector<int> coupled_;
};

class CondensedContacts {
 public:
  /// Starts a step with the impulses remembered in x; slot 0 is evaluated at q^A.
  void begin(const MechanicalSystem& s, const State& x, double dt);
  /// Selects the contacts of slot 0 that are not joints. Where most of many contacts stay open, it
  /// selects only those that the mean velocity v closes, and those selected before in this step.
  void select(const MechanicalSystem& s, const State& xA, const Eigen::VectorXd& v, double dt);
  /// True: v closes contacts that select() has left out.
  bool misses(const MechanicalSystem& s, const State& xA, const Eigen::VectorXd& v);
  /// Solves the contacts on the linear model and corrects the Newton step accordingly.
  SolveReport solve(const MechanicalSystem& s, InclusionSolver& solver, const State& xA,
                    JointNewton& newton, Effort effort);
  /// True: friction drove instead of braking in the step with mean velocity v. Where slip turns to
  /// stick, Λ_T(γ_T^A + γ_T^E)/2 may be positive. A step from begin(…) on then takes the mean slip
  /// in these contacts, ξ_T = γ_T^E + γ_T^A, until forgetMeanSlip().
  bool frictionDrives(const Eigen::VectorXd& v, const State& xA);
  void forgetMeanSlip() { meanSlip_.clear(); }
  /// W_c Λ_c, nu numbers.
  const Eigen::VectorXd& impulse() const { return impulse_; }
  int size() const { return contacts_.size(); }
  /// Impulses of the contact `key`, or null.
  const double* of(ContactKey key) const;

 private:
  /// Term s of contact i in γ_N^E + ε γ_N^A + s, which aims at the gap in the next step. A contact
  /// that opens with γ^A > 0 may close again with −γ^A at most, so that its work Λ (γ^A + γ^E)/2 is
  /// never positive. A contact that will rebound waits for a step that begins with it closed: there
  /// it has an impact.
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
  KeyIndex ofLast_, ofPresent_;     // of last_.key and contacts_.key
  std::vector<ContactKey> closed_;  // contacts closed at q^A, sorted
  std::vector<ContactKey> asked_;   // contacts selected in this step, sorted; not used if few_
  bool few_ = true;
  std::vector<ContactKey> meanSlip_;  // sorted
  double dt_ = 0.0;
  std::vector<double> Lambda_, old_, gapSlope_;
  std::vector<ContactResponse> response_;  // response of each contact
  CoupledContacts coupled_;
  std::vector<double> held_;  // per contact: wᵀM⁻¹w if joints hold its place, else 0
  Eigen::VectorXd impulse_, w_, uE_;
};

}  // namespace dynamy
