/// JointNewton: the equations of the energy-conserving midpoint rule with joints (theory 34.4), and
/// Newton's iteration for them.
///
///   q^M = q^A ⊕ Δt/2 v,   q^E = q^A ⊕ Δt v,   u^E = 2v − u^A
///   R_v = 2M(v − u^A) − Δt (h(q^M, v) + h_d(v)) − W̃ Λ − W_c Λ_c = 0      h_d: DampedForces
///   R_g = g_J(q^E)/Δt = 0
///   W̃ = W − M v ω/(vᵀMv),   ω = Wᵀv + χ − (g(q^E) − g(q^A))/Δt    per joint, over its bodies
///
/// W̃ is the discrete gradient of [gonzalez1996] in the metric of the mass, Δt(W̃ᵀv + χ) = g(q^E) −
/// g(q^A): joints that hold do no work, whatever Δt. ω is of third order in v, so that W̃ is smooth
/// where the motion turns back; without the difference of g it would not be. W, M, h at (t^M, q^M).
///
/// K = ∂R/∂(v, Λ) must contain the turning of W with v; without it heavy chains diverge. Bodies and
/// joints may offer these terms in closed form (moveTangent, frameStiffness, jointForces). If one
/// does not, K is taken by differences, so that elements need not provide second derivatives. All
/// bodies of one colour are then moved at once, as no two of them share a neighbour. Rows and
/// columns follow a walk along the mechanism, and K is a band matrix.
#pragma once
#include <algorithm>
#include <dynamy/schemes/joints/banded_lu.hpp>
#include <dynamy/schemes/joints/damped_forces.hpp>
#include <dynamy/schemes/joints/joint_tangent.hpp>
#include <dynamy/schemes/joints/mechanism_walk.hpp>
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
  /// Starts a step from x: v = u^A, Λ from the last step. False: there are no joints, and no masses
  /// that depend on q.
  bool begin(MechanicalSystem& s, const State& x, double dt);
  /// Ends the step: forces are no longer withheld, and h of slot 0 is what the step used.
  void finish(MechanicalSystem& s);
  enum class Search { all, joints };
  /// Evaluates R at v, Λ and the impulses of contacts, W_c Λ_c (nu numbers). Slot 0 then has all
  /// contacts or, by `search`, the joints alone.
  void residual(MechanicalSystem& s, const Eigen::VectorXd& contactImpulse,
                Search search = Search::all);
  /// How K is found: in closed form where all bodies and joints offer it, else by differences.
  enum class Tangent { closedForm, differences };
  /// Computes and factorises K at the last residual; false: K is singular.
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
  int unknowns() const { return walk_.unknowns(); }
  /// x ← K⁻¹ x, unknowns() numbers in the order of the walk.
  void solve(double* x) const { K_.solve(x); }
  /// (dv, dΛ) += factor · (response to row r).
  void add(const ContactResponse& response, int r, double factor);
  /// wᵀ of row r of contact i times the velocities of the response to row `column`.
  double along(const ContactSet& c, int i, int r, const ContactResponse& response,
               int column) const;
  /// v += dv, Λ += dΛ.
  void take();

  Eigen::VectorXd v, dv;
  std::vector<double> Lambda, dLambda;
  /// q^M, v and q^E, u^E of the last residual.
  State midpoint, end;
  const std::vector<int>& joints() const { return joints_; }  ///< contacts of slot 0
  int rows() const { return static_cast<int>(Lambda.size()); }

 private:
  void connect(const MechanicalSystem& s, const ContactSet& c);
  void add(const MechanismWalk::Node& n, const double* x, int stride, double factor);
  void colour();
  void addJointColumns(const Evaluation& e);
  void differences(MechanicalSystem& s, const Eigen::VectorXd& contactImpulse);
  bool closedForm(const MechanicalSystem& s);
  void checkPositions(const MechanicalSystem& s);
  void addColumn(int node, int column, const Eigen::VectorXd& force, double perturbation);
  void jointForces(const Evaluation& e, Eigen::VectorXd& out);
  void findJoints(const ContactSet& c, std::vector<int>& out) const;

  const State* xA_ = nullptr;
  double dt_ = 0.0;
  std::vector<int> joints_, endJoints_;
  std::vector<char> elements_;  // per element: 1 if it has joints
  std::vector<ContactKey> keys_;
  MechanismWalk walk_;
  std::vector<int> jointRow_, colour_, blockU0_, blockNu_;
  std::vector<std::vector<int>> nearBlocks_, nearJoints_;  // neighbours of a block, with itself
  int colours_ = 0, mostNu_ = 0;
  Eigen::VectorXd Rv_, force_, force0_, momentum_, uE_, base_, h_, hNonPotential_;
  std::vector<double> Rg_, g0_, gA_, gRate_, gRate0_, work_;
  BandedLu K_;
  Tangent tangent_ = Tangent::differences;
  std::string fault_;
  bool offered_ = true;  // until an element refuses the closed form
  JointTangent parts_;
  DampedForces damped_;
};

}  // namespace dynamy
