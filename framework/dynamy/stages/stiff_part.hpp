/// StiffPart: the derivatives of stiff elements, and the operator that takes them implicitly,
///
///   M̂ = M − b Δt D − a Δt² K,   K = ∂h/∂q F,  D = ∂h/∂u
///
/// in the rows of the mass blocks on which stiff elements act; all others keep M⁻¹. With contacts,
/// Ĝ = Wᵀ M̂⁻¹ W replaces G. Blocks that stiff elements couple form a group, and M̂ is dense over
/// each group. Rejected: springs as further rows of the inclusion with a compliance, which every
/// solver would have to handle. Also rejected: a block-diagonal M̂, since a spring between two
/// bodies couples blocks.
#pragma once
#include <algorithm>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/solver/problem/delassus.hpp>
#include <dynamy/stages/unresolved_forces.hpp>
#include <dynamy/system/state.hpp>

namespace dynamy {

/// Weights of the place between beginning and end of a step at which the linear part of h is taken:
/// h + Δt K (s u^A + a (u^E − u^A)) + b D (u^E − u^A).
struct ImplicitWeights {
  double s = 0.0, a = 0.0, b = 0.0;
};
/// Weights of the implicit midpoint rule, which is neither damped nor unstable: h is given at
/// q^A + Δt/2 u^A and required at the mean of the step.
inline constexpr ImplicitWeights kImplicitMidpoint{0.0, 0.25, 0.5};
/// Weights of the implicit Euler rule, which damps stiff motions: h is given at q and required at
/// q + Δt u^E and u^E.
inline constexpr ImplicitWeights kImplicitEnd{1.0, 1.0, 1.0};

class StiffPart {
 public:
  /// Finds out whether the model has stiff elements.
  void resize(const Topology& topology, const std::vector<const ExternalForce*>& forces);
  bool any() const { return any_; }
  /// K and D at x, whose frames are in `k`.
  void evaluate(const Topology& topology, const std::vector<const ExternalForce*>& forces,
                const Kinematics& k, const State& x);
  /// Finds the forces that a step Δt does not resolve, and evaluates their K and D at x together
  /// with those of stiff elements. False: there are no such forces, and nothing is evaluated.
  bool evaluateUnresolved(const Topology& topology, const std::vector<const ExternalForce*>& forces,
                          const Kinematics& k, const State& x, const MassMatrix& mass, double dt);
  /// Number of the forces found last.
  int unresolved() const {
    return static_cast<int>(std::count(found_.taken().begin(), found_.taken().end(), 1));
  }
  /// Factorises M̂ with these weights; unresolved forces have weights of their own.
  void factor(const MassMatrix& mass, double dt, const ImplicitWeights& weights,
              const ImplicitWeights& unresolved = kImplicitEnd);
  /// out = M̂⁻¹ in; in and out may not overlap.
  void applyInverse(const MassMatrix& mass, const Eigen::VectorXd& in, Eigen::VectorXd& out) const;
  /// True: ωΔt > limit for an oscillation, or Δt d/m > 2, the limit of Euler's explicit rule.
  bool explicitIsUnstable(const MassMatrix& mass, double dt, double limit);
  /// out += Δt² s K v.
  void addStart(double dt, const Eigen::VectorXd& v, Eigen::VectorXd& out) const;
  /// Gives Ĝ = Wᵀ M̂⁻¹ W to `delassus`.
  void delassus(const ContactSet& contacts, const MassMatrix& mass, Delassus& delassus);
  /// u += M̂⁻¹ W Λ.
  void addVelocity(const ContactSet& contacts, const MassMatrix& mass, const double* Lambda,
                   Eigen::VectorXd& u);
  /// h += Δt K (s u^A + a (u^E − u^A)) + b D (u^E − u^A), the last term also to hNonPotential.
  void addUsedForce(double dt, const Eigen::VectorXd& uA, const Eigen::VectorXd& uE,
                    Eigen::VectorXd& h, Eigen::VectorXd& hNonPotential) const;

 private:
  /// Mass blocks that stiff elements couple, and M̂ over them.
  struct Group {
    std::vector<int> u;  // its velocities
    Eigen::MatrixXd Mhat;
    Lu lu;
  };
  void mapBlocks(const MassMatrix& mass);
  void touch(const MassMatrix& mass);
  int groupRoot(int block);
  void solveGroup(const Group& g, const Eigen::VectorXd& in, Eigen::VectorXd& out) const;
  void neighbours(const ContactSet& contacts, int blocks);
  void respond(const ContactSet& contacts, const MassMatrix& mass, int j, int row);
  void clearResponse(const ContactSet& contacts, int j);
  const ImplicitWeights& weightsOf(std::size_t entry) const {
    return entry < declared_ ? weights_ : unresolved_;
  }
  int blockOf(int u) const { return blockOf_[static_cast<std::size_t>(u)]; }
  bool any_ = false;
  int nu_ = 0;
  ImplicitWeights weights_, unresolved_;
  std::vector<StiffEntry> entries_;
  std::size_t declared_ = 0;  // number of entries of stiff elements; unresolved ones follow
  UnresolvedForces found_;
  // Per velocity: its index in its group, its mass block. Per mass block: union–find parent, group.
  std::vector<int> local_, blockOf_, parent_, group_;
  std::vector<Group> groups_;
  int used_ = 0;                                  // number of groups in use
  std::vector<std::vector<int>> near_, atBlock_;  // contacts coupled to a contact; of a mass block
  std::vector<std::ptrdiff_t> filled_;            // next block to be filled in each row of blocks
  std::vector<double> K_, D_;
  mutable Eigen::VectorXd part_;
  Eigen::VectorXd force_, column_, probe_;
};

}  // namespace dynamy
