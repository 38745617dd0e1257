/// HeldProjection: removes errors of held rows in the metric of the mass,
///
///   δ = M⁻¹W Λ,   e + Wᵀδ = 0   in the kept rows     ⇒     (Sᵀ G S) Λ = −Sᵀe
///
/// for e = g, the positions, or e = γ, the velocities. Redundant rows share Λ.
#pragma once
#include <dynamy/located/phase/block_pseudo_inverse.hpp>
#include <dynamy/located/phase/held_rows.hpp>

namespace dynamy {

class HeldProjection {
 public:
  /// δ [m, rad] for the positions g of all held rows; `rows`: those of `held` in `e`. False: all g
  /// are zero.
  bool positions(const std::vector<Held>& held, const HeldRows& rows, const Evaluation& e,
                 Eigen::VectorXd& delta);
  /// δ [m/s, rad/s] for the velocities γ of all held rows; slips move freely. False: all γ are
  /// zero.
  bool velocities(const std::vector<Held>& held, const HeldRows& rows, const Evaluation& e,
                  Eigen::VectorXd& delta);

 private:
  bool solve(const HeldRows& rows, const Eigen::VectorXd& error, Eigen::VectorXd& delta);
  std::vector<int> kept_;  // S
  RowsOfBlocks touching_;
  Eigen::MatrixXd G_;
  Eigen::VectorXd rhs_, Lambda_;
  BlockPseudoInverse inverse_{1e-10};  // pivots below this share belong to redundant rows
};

}  // namespace dynamy
