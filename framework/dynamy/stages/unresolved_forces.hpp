/// UnresolvedForces: forces that know their derivatives (ExternalForce::addStiffness), do not declare
/// themselves stiff, and change faster than a step Δt follows. At a mass block b the share of all of
/// them of what explicit rules bear, ωΔt = 2 and Δt d/m = 2, is
///
///   tr_b(−M⁻¹(Δt² K/4 + Δt D/2)),   K = ∂h/∂q F,  D = ∂h/∂u,
///
/// ω²Δt²/4 of one spring to the ground, and at least the largest one of several. What joins two
/// blocks counts in both: (x_a − x_b)² ≤ 2 (x_a² + x_b²), so that the whole is at most twice the
/// largest share of a block. Up to one half explicit rules are stable for certain; beyond, a force
/// is unresolved, if its own part is beyond a twentieth: schemes take it at the end of the step, by
/// the implicit Euler rule. ωΔt is then beyond 1.4 of a spring to the ground, beyond 2 of one
/// between two equal bodies.
/// Rejected: the largest eigenvalue of all forces together, which would say so of soft ones, too.
#pragma once
#include <dynamy/system/external_force.hpp>
#include <dynamy/system/mass_matrix.hpp>
#include <span>

namespace dynamy {

class UnresolvedForces {
 public:
  /// Finds them and their derivatives at `k` and M; false: there are none.
  bool find(const std::vector<const ExternalForce*>& forces, const Kinematics& k,
            const MassMatrix& mass, double dt);
  /// Their derivatives.
  const std::vector<StiffEntry>& entries() const { return entries_; }
  /// Per force: 1 if it is one of them.
  std::span<const char> taken() const { return taken_; }
  /// Mass block of a velocity; after find().
  int block(int u) const { return blockOf_[static_cast<std::size_t>(u)]; }

 private:
  double shareOf(const StiffEntry& e, const MassMatrix& mass, double dt) const;
  bool isUnresolved(std::size_t first, std::size_t end, const MassMatrix& mass, double dt) const;
  std::vector<StiffEntry> all_, entries_;
  std::vector<std::size_t> ends_;  // of forces, in all_
  std::vector<char> taken_;
  std::vector<double> shares_;  // per mass block
  std::vector<int> blockOf_;
};

}  // namespace dynamy
