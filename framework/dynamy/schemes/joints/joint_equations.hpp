/// JointEquations: the equations of the energy-conserving midpoint rule with joints (theory 34.4).
///
///   q^M = q^A ⊕ Δt/2 v,   q^E = q^A ⊕ Δt v,   u^E = 2v − u^A
///   R_v = 2M(v − u^A) − Δt (h(q^M, v) + h_d(v)) − W̃ Λ − W_c Λ_c = 0      h_d: DampedForces
///   R_g = (g_J(q^E) − g*)/Δt = 0,   g* = 0
///   W̃ = W − M v ω/(vᵀMv),   ω = Wᵀv + χ − (g(q^E) − g(q^A))/Δt    per joint, over its bodies
///
/// W̃ is the discrete gradient of [gonzalez1996] in the metric of the mass, Δt(W̃ᵀv + χ) = g(q^E) −
/// g(q^A): joints that hold do no work, whatever Δt. ω is of third order in v, so that W̃ is smooth
/// where the motion turns back; without the difference of g it would not be. W, M, h at (t^M, q^M).
/// At rest v and ω are rounding, and so would be their quotient: vᵀMv is at least (10⁻⁴ Δv)² there, Δv in
/// the metric of the mass what the joint's impulse of the last step changes. Since ω grows as v³, the
/// bound leaves out work of (10⁻⁴ Δv Δt/L)² of the joint's power, which is below rounding.
///
/// Steps that found no solution may leave g(q^A) far from zero. A part of a step then closes the
/// joint by its part only, g* = (1 − Δt/Δt_full) g(q^A): to close it all at once would take the
/// velocity g/Δt, which has no bound where parts end at contacts.
#pragma once
#include <dynamy/schemes/joints/damped_forces.hpp>
#include <dynamy/schemes/joints/mechanism_graph.hpp>

namespace dynamy {

/// R of one iterate.
struct JointResidual {
  Eigen::VectorXd v;             ///< R_v
  std::vector<double> g;         ///< R_g, row after row of the joints
  std::vector<double> meanRate;  ///< (g(q^E) − g(q^A))/Δt
};

class JointEquations {
 public:
  /// Starts a step from x: v = u^A, Λ from the last step. False: there are no joints, and no masses
  /// that depend on q.
  bool begin(MechanicalSystem& s, const State& x, double dt);
  /// Ends the step: forces are no longer withheld, and h of slot 0 is what the step used.
  void finish(MechanicalSystem& s);
  enum class Search { all, joints };
  /// Evaluates R at v, Λ and the impulses of contacts, W_c Λ_c (nu numbers). Slot 0 then has all
  /// contacts or, by `search`, the joints alone.
  void evaluate(MechanicalSystem& s, const Eigen::VectorXd& contactImpulse,
                Search search = Search::all);

  Eigen::VectorXd v;
  std::vector<double> Lambda;
  JointResidual R;
  /// q^M, v and q^E, u^E of the last evaluation.
  State midpoint, end;

  double dt() const { return dt_; }
  const MechanismGraph& graph() const { return graph_; }
  const DampedForces& damped() const { return damped_; }
  const std::vector<int>& joints() const { return joints_; }          ///< contacts of slot 0
  const std::vector<int>& jointsAtEnd() const { return endJoints_; }  ///< contacts of slot 1
  int rows() const { return static_cast<int>(Lambda.size()); }
  /// Least vᵀMv [J] by which ω of joint k is divided.
  double leastTwiceT(int k) const { return least_[k]; }

 private:
  void startFrom(const RememberedImpulses& last, const ContactSet& c);
  void boundQuotients(const Evaluation& e);
  void setAim(const MechanicalSystem& s);
  void setGaps(MechanicalSystem& s);
  void setJointForces(const Evaluation& e);

  const State* xA_ = nullptr;
  double dt_ = 0.0;
  std::vector<int> joints_, endJoints_;
  std::vector<char> elements_;  // per element: 1 if it has joints
  MechanismGraph graph_;
  std::vector<double> gA_;     // g(q^A)
  std::vector<double> aim_;    // g*
  std::vector<double> least_;  // per joint, see leastTwiceT
  Eigen::VectorXd force_, momentum_, change_, h_, hNonPotential_;
  DampedForces damped_;
};

}  // namespace dynamy
