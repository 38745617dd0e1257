/// WidestForces: of all forces of held contacts that give the same accelerations, those that stay
/// furthest from the bounds of their laws (theory 57.1):
///
///   max s   with   c_i(λ) ≥ s,   λ = λ₀ + P D z,   W P D = 0
///
///   joint −;  normal λ_N − lower;  cone min(λ_N, μ λ_N − |λ_T|);  given upper − |λ|
///
/// Accelerations that the laws permit exist with these statuses if and only if s ≥ 0: what a bound
/// forces to be shared otherwise is seen, as in an arch whose line of thrust just fits. Sets of
/// other shapes (drilling, orthotropic) are taken as ellipsoids of their widths while searching,
/// and with their own shape for the margin, which is then a lower bound. By logarithmic barriers
/// and Newton's method, to a relative gap of 1e-13, over the forces that redundant rows may share.
/// Rejected: linear programming, since cones in space are round; elimination of one contact after
/// the other, whose normal equations lose half of the digits where many bounds are reached.
#pragma once
#include <dynamy/located/phase/frozen_phase.hpp>

namespace dynamy {

class WidestForces {
 public:
  /// For the last acceleration of `phase`, whose velocities are those of its rows.
  explicit WidestForces(const FrozenPhase& phase);
  /// λ of all rows of the phase [N].
  const Eigen::VectorXd& lambda() const { return lambda_; }
  /// As FrozenPhase::margin(), of held[i].
  bool margin(std::size_t i, double& value) const;

 private:
  const FrozenPhase& phase_;
  Eigen::VectorXd lambda_;
};

}  // namespace dynamy
