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
/// Explicit rules keep the energy of an oscillation only while their steps are equal, and let T + V swing by
/// (ωΔt)²/4. Where steps are not equal, and beside damped forces, forces above a share of 0.002 are found for
/// the implicit midpoint rule, which keeps it whatever the steps (theory 37.6).
#pragma once
#include <cstdint>
#include <dynamy/system/external_force.hpp>
#include <dynamy/system/mass_matrix.hpp>
#include <span>

namespace dynamy {

/// Which of the forces that a step resolves are found besides, for a neutral rule.
enum class Keeping : std::uint8_t {
  none,
  besideDamped,  ///< where others are unresolved, and forces are few: a net would couple all its contacts
  all
};

class UnresolvedForces {
 public:
  /// Finds the unresolved forces and those that a neutral rule is to take, with their derivatives at `k` and M; false: there are none.
  bool find(const std::vector<const ExternalForce*>& forces, const Kinematics& k,
            const MassMatrix& mass, double dt, Keeping keeping = Keeping::none);
  /// Derivatives of the unresolved forces, then of those for the neutral rule.
  const std::vector<StiffEntry>& entries() const { return entries_; }
  /// Number of entries of unresolved forces.
  std::size_t dampedEntries() const { return dampedEntries_; }
  /// Per force: 1 if it is unresolved.
  std::span<const char> damped() const { return damped_; }
  /// Largest share of a block, of all its forces; after find(). It grows with Δt² for undamped forces.
  double share() const { return share_; }
  /// The same of the stiffness of forces that swing.
  double swing() const { return swing_; }
  /// Mass block of a velocity; after find().
  int block(int u) const { return blockOf_[static_cast<std::size_t>(u)]; }

 private:
  /// Share of one force in a mass block: its parts of K and D.
  struct Share {
    int block = 0;
    double K = 0.0, D = 0.0;
    double sum() const { return K + D; }
  };
  /// Of a force, behind its last entry and share.
  struct Ends {
    std::size_t entries = 0, shares = 0;
  };
  Share shareOfBlock(std::size_t& first, std::size_t end, const MassMatrix& mass, double dt) const;
  bool keeps(Keeping keeping, std::size_t forces) const;
  bool isAbove(double most, std::size_t first, std::size_t end) const;
  std::vector<StiffEntry> all_, entries_;
  std::vector<Share> own_;
  std::vector<Ends> ends_;
  std::vector<char> damped_;
  std::size_t dampedEntries_ = 0;
  std::vector<double> shares_, swings_;  // per mass block
  std::vector<int> blockOf_;
  double share_ = 0.0, swing_ = 0.0;
};

}  // namespace dynamy
