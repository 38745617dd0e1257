/// JointNewton: Newton's iteration for the equations of the energy-conserving midpoint rule with
/// joints (JointEquations, theory 34.4), and the response of its linear model to contacts.
///
///   K (δv, δΛ) = −R,   K = ∂R/∂(v, Λ)
///
/// K must contain the turning of W with v; without it heavy chains diverge. Bodies and joints may
/// offer these terms in closed form (moveTangent, frameStiffness, jointForces). If one does not,
/// elements need not provide second derivatives: K consists of masses and W at first, and where that
/// does not converge fast it is taken by differences, which move all bodies of one colour at once.
/// K is a band matrix (MechanismGraph).
#pragma once
#include <algorithm>
#include <dynamy/schemes/joints/banded_lu.hpp>
#include <dynamy/schemes/joints/joint_equations.hpp>
#include <dynamy/schemes/joints/joint_tangent.hpp>
#include <string>
#include <string_view>

namespace dynamy {

/// Change of the unknowns of bodies and joints per unit impulse in each row of a contact.
struct ContactResponse {
  int rows = 0;
  std::vector<int> parts;     ///< parts of the mechanism that move, ascending
  std::vector<double> value;  ///< unknowns × rows, row after row; valid in `parts` alone
  bool moves(int part) const { return std::binary_search(parts.begin(), parts.end(), part); }
};

class JointNewton {
 public:
  /// How K is found: in closed form where all bodies and joints offer it; of masses and W alone; by
  /// differences.
  enum class Tangent { closedForm, masses, differences };
  /// Computes and factorises K at the last residual; false: K is singular. `wanted`: closedForm, or
  /// masses in its place; or differences.
  bool linearise(MechanicalSystem& s, const Eigen::VectorXd& contactImpulse,
                 Tangent wanted = Tangent::closedForm);
  /// Set by linearise(): why positions cannot hold these joints, with the element's name; empty:
  /// they can.
  std::string_view fault() const { return fault_; }
  /// How the last K was found.
  Tangent tangent() const { return tangent_; }
  /// Computes Newton's step −K⁻¹R into dv and dLambda, without taking it.
  void newtonStep();
  /// Response of all unknowns to a unit impulse in each row of contact i of c: K⁻¹ [w; 0].
  void respond(const ContactSet& c, int i, ContactResponse& response) const;
  int unknowns() const { return walk().unknowns(); }
  /// x ← K⁻¹ x, unknowns() numbers in the order of the walk.
  void solve(double* x) const { K_.solve(x), charge(); }
  /// (dv, dΛ) += factor · (response to row r).
  void add(const ContactResponse& response, int r, double factor);
  /// wᵀ of row r of contact i times the velocities of the response to row `column`.
  double along(const ContactSet& c, int i, int r, const ContactResponse& response,
               int column) const;
  /// v += dv, Λ += dΛ.
  void take();

  JointEquations equations;
  Eigen::VectorXd dv;
  std::vector<double> dLambda;

 private:
  const MechanismWalk& walk() const { return equations.graph().walk(); }
  void add(const MechanismWalk::Node& n, const double* x, int stride, double factor);
  void addJointColumns(const Evaluation& e);
  bool closedForm(const MechanicalSystem& s);
  bool masses(const MechanicalSystem& s);
  void addDamped(const MechanicalSystem& s);
  void differences(MechanicalSystem& s, const Eigen::VectorXd& contactImpulse);
  void addColumn(int block, int column, double perturbation);
  std::string rowWithoutPosition(const MechanicalSystem& s);
  void charge() const;

  BandedLu K_;
  SolverWork* counted_ = nullptr;  // borrowed
  mutable double charged_ = 0.0;   // multiplications of K that have been counted there
  Tangent tangent_ = Tangent::differences;
  bool offered_ = true;  // until an element refuses the closed form
  JointTangent parts_;
  std::string fault_;
  Eigen::VectorXd base_, momentum_;
  JointResidual baseR_;  // R at base_, from which differences are taken
  std::vector<double> work_;
};

}  // namespace dynamy
