/// ImplicitMass: the operator of steps that take stiff forces implicitly,
///
///   M̂ = M − b Δt D − a Δt² K,   K = ∂h/∂q F,  D = ∂h/∂u
///
/// in the rows of the mass blocks on which stiff elements act; all others keep M⁻¹. With contacts,
/// Ĝ = Wᵀ M̂⁻¹ W replaces G. Blocks that stiff elements couple form a group, and M̂ is dense over
/// each group. Rejected: springs as further rows of the inclusion with a compliance, which every
/// solver would have to handle. Also rejected: a block-diagonal M̂, since a spring between two
/// bodies couples blocks.
#pragma once
#include <dynamy/core/decompositions.hpp>
#include <dynamy/solver/problem/delassus.hpp>
#include <dynamy/stages/weighted_stiffness.hpp>

namespace dynamy {

class ImplicitMass {
 public:
  /// Number of velocities of the model.
  void resize(int nu) { nu_ = nu; }
  /// Forms M̂ and factorises it.
  void factor(const MassMatrix& mass, double dt, const WeightedStiffness& stiffness);
  /// out = M̂⁻¹ in; in and out may not overlap. `mass`: that of factor(), also below.
  void applyInverse(const MassMatrix& mass, const Eigen::VectorXd& in, Eigen::VectorXd& out) const;
  /// Gives Ĝ = Wᵀ M̂⁻¹ W to `delassus`.
  void delassus(const ContactSet& contacts, const MassMatrix& mass, Delassus& delassus);
  /// u += M̂⁻¹ W Λ.
  void addVelocity(const ContactSet& contacts, const MassMatrix& mass, const double* Lambda,
                   Eigen::VectorXd& u);
  /// Work of all factorisations and operators Ĝ so far, in evaluations of one velocity (theory 37.7).
  double work() const { return work_; }

 private:
  /// Mass blocks that stiff elements couple, and M̂ over them.
  struct Group {
    std::vector<int> u;  // its velocities
    Eigen::MatrixXd Mhat;
    Lu lu;
  };
  void mapBlocks(const MassMatrix& mass);
  void touch(const MassMatrix& mass, const std::vector<StiffEntry>& entries);
  int groupRoot(int block);
  void solveGroup(const Group& g, const Eigen::VectorXd& in, Eigen::VectorXd& out) const;
  void neighbours(const ContactSet& contacts, int blocks);
  void respond(const ContactSet& contacts, const MassMatrix& mass, int j, int row);
  void clearResponse(const ContactSet& contacts, int j);
  int blockOf(int u) const { return blockOf_[static_cast<std::size_t>(u)]; }
  int nu_ = 0;
  // Per velocity: its index in its group, its mass block. Per mass block: union–find parent, group.
  std::vector<int> local_, blockOf_, parent_, group_;
  std::vector<Group> groups_;
  int used_ = 0;                                  // number of groups in use
  std::vector<std::vector<int>> near_, atBlock_;  // contacts coupled to a contact; of a mass block
  std::vector<std::ptrdiff_t> filled_;            // next block to be filled in each row of blocks
  mutable Eigen::VectorXd part_;
  Eigen::VectorXd force_, column_;
  double work_ = 0.0;    // whole numbers, so that differences are exact
  double solved_ = 0.0;  // work of the columns of one Ĝ
};

}  // namespace dynamy
