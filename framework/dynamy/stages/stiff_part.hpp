/// StiffPart: the derivatives K and D of stiff elements at one state, and what a step forms from
/// them: the operator M̂ (ImplicitMass), the forces that the step used, and whether an explicit step
/// would be stable.
#pragma once
#include <dynamy/stages/implicit_mass.hpp>
#include <dynamy/stages/unresolved_forces.hpp>
#include <dynamy/system/state.hpp>
#include <span>

namespace dynamy {

class StiffPart {
 public:
  /// Finds out whether the model has stiff elements.
  void resize(const Topology& topology, const std::vector<const ExternalForce*>& forces);
  bool any() const { return any_; }
  /// K and D at x, whose frames are in `k`.
  void evaluate(const Topology& topology, const std::vector<const ExternalForce*>& forces,
                const Kinematics& k, const State& x);
  /// Finds the forces that a step Δt damps or keeps (UnresolvedForces), and evaluates their K and D at x
  /// together with those of stiff elements. False: there are no such forces, and nothing is evaluated.
  bool evaluateUnresolved(const Topology& topology, const std::vector<const ExternalForce*>& forces,
                          const Kinematics& k, const State& x, const MassMatrix& mass, double dt,
                          Keeping keeping);
  /// What was found last.
  const UnresolvedForces& found() const { return found_; }
  /// Factorises M̂ with these weights of stiff elements.
  void factor(const MassMatrix& mass, double dt, const ImplicitWeights& weights) {
    stiffness_.ofDeclared = weights;
    Mhat_.factor(mass, dt, stiffness_);
  }
  /// out = M̂⁻¹ in; in and out may not overlap.
  void applyInverse(const MassMatrix& mass, const Eigen::VectorXd& in, Eigen::VectorXd& out) const {
    Mhat_.applyInverse(mass, in, out);
  }
  /// See ImplicitMass::work().
  double work() const { return Mhat_.work(); }
  /// True: ωΔt > limit for an oscillation, or Δt d/m > 2, the limit of Euler's explicit rule.
  bool explicitIsUnstable(const MassMatrix& mass, double dt, double limit);
  /// out += Δt² s K v.
  void addStart(double dt, const Eigen::VectorXd& v, Eigen::VectorXd& out) const {
    stiffness_.addStart(dt, v, out);
  }
  /// Gives Ĝ = Wᵀ M̂⁻¹ W to `delassus`.
  void delassus(const ContactSet& contacts, const MassMatrix& mass, Delassus& delassus) {
    Mhat_.delassus(contacts, mass, delassus);
  }
  /// u += M̂⁻¹ W Λ.
  void addVelocity(const ContactSet& contacts, const MassMatrix& mass, const double* Lambda,
                   Eigen::VectorXd& u) {
    Mhat_.addVelocity(contacts, mass, Lambda, u);
  }
  /// h += Δt K (s u^A + a (u^E − u^A)) + b D (u^E − u^A), the last term also to hNonPotential.
  void addUsedForce(double dt, const Eigen::VectorXd& uA, const Eigen::VectorXd& uE,
                    Eigen::VectorXd& h, Eigen::VectorXd& hNonPotential) const {
    stiffness_.addUsedForce(dt, uA, uE, h, hNonPotential);
  }
  /// Work of what the step adds to damped forces by K [J].
  double workOfDamped(double dt, const Eigen::VectorXd& uA, const Eigen::VectorXd& uE) const {
    return stiffness_.workOfDamped(dt, uA, uE);
  }

 private:
  bool any_ = false;
  int nu_ = 0;
  WeightedStiffness stiffness_;
  UnresolvedForces found_;
  ImplicitMass Mhat_;
  std::vector<double> K_, D_;
  Eigen::VectorXd force_, column_, probe_;
};

}  // namespace dynamy
