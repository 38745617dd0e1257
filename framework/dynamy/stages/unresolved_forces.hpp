/// UnresolvedForces: forces that know their derivatives (ExternalForce::addStiffness), do not declare
/// themselves stiff, and change faster than a step Δt resolves. Explicit rules are stable up to
/// ωΔt = 2 and Δt d/m = 2. All such forces at a mass block b use up the share of this limit
///
///   tr_b(−M⁻¹(Δt² K/4 + Δt D/2)),   K = ∂h/∂q F,  D = ∂h/∂u,
///
/// which is ω²Δt²/4 for one spring to the ground, and at least the largest one for several. A force
/// between two blocks counts in both: (x_a − x_b)² ≤ 2 (x_a² + x_b²), so that the share of the
/// whole system is at most twice the largest share of a block. Up to a share of one half explicit
/// rules are certainly stable. Above one half, a force is unresolved if its own part is above a
/// twentieth: schemes take it at the end of the step, by the implicit Euler rule. ωΔt then exceeds
/// 1.4 for a spring to the ground, and 2 for a spring between two equal bodies. Rejected: the
/// largest eigenvalue of all forces together, by which soft forces would count as unresolved, too.
///
/// A force whose own part of D is at least 2 √(its part of K) is overdamped and does not swing: taken at
/// the end of the step it follows what varies slowly, and no shorter step is needed to resolve it.
///
/// Explicit rules keep the energy of an oscillation only while their steps are equal. Where steps
/// are not, and no block is above one half, forces above a share of 0.002 are found for the neutral
/// implicit midpoint rule, which keeps it whatever the steps (theory 37.6).
#pragma once
#include <dynamy/system/external_force.hpp>
#include <dynamy/system/mass_matrix.hpp>
#include <span>

namespace dynamy {

class UnresolvedForces {
 public:
  /// Finds the unresolved forces and their derivatives at `k` and M; false: there are none.
  /// neutral: where there would be none, finds those that a neutral rule is to take.
  bool find(const std::vector<const ExternalForce*>& forces, const Kinematics& k,
            const MassMatrix& mass, double dt, bool neutral = false);
  /// The forces found last are resolved, and a neutral rule is to take them.
  bool neutral() const { return neutral_; }
  /// Derivatives of the unresolved forces.
  const std::vector<StiffEntry>& entries() const { return entries_; }
  /// Per force: 1 if it is unresolved.
  std::span<const char> taken() const { return taken_; }
  /// Largest share of a block, of all its forces; after find(). It grows with Δt² for undamped forces.
  double share() const { return share_; }
  /// The same of the stiffness of forces that swing.
  double swing() const { return swing_; }
  /// Mass block of a velocity; after find().
  int block(int u) const { return blockOf_[static_cast<std::size_t>(u)]; }

 private:
  /// Parts of K and D in a share.
  struct Share {
    double K = 0.0, D = 0.0;
    double sum() const { return K + D; }
  };
  Share shareOf(const StiffEntry& e, const MassMatrix& mass, double dt) const;
  /// Share of the entries from `first` on that belong to the same block; moves `first` behind them.
  Share shareOfBlock(std::size_t& first, std::size_t end, const MassMatrix& mass, double dt) const;
  bool isUnresolved(std::size_t first, std::size_t end, const MassMatrix& mass, double dt) const;
  std::vector<StiffEntry> all_, entries_;
  std::vector<std::size_t> ends_;  // of forces, in all_
  std::vector<char> taken_;
  std::vector<double> shares_, swings_;  // per mass block
  std::vector<int> blockOf_;
  double share_ = 0.0, swing_ = 0.0;
  bool neutral_ = false;
};

}  // namespace dynamy
