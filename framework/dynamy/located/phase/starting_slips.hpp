/// StartingSlips: directions of slips that start, in two tangents or more.
///
///   t ← −(λ_T − r γ̇_T)/|…|,  r = 1/G_TT;   fixed point: −γ̇_T ∈ N_C(λ_T)
///
/// After kPlain turns the step between two turns is multiplied by Aitken's factor,
///
///   ω ← −ω d⁻·(d − d⁻)/|d − d⁻|²,   d: what the turn would change
///
/// since slips that push each other overshoot: without it a wall of 30 bodies on the floor took
/// 200 turns in one evaluation of ten, to no end.
#pragma once
#include <dynamy/located/phase/held_forces.hpp>

namespace dynamy {

class StartingSlips {
 public:
  void begin() { turns_ = 0, factor_ = 1.0; }
  /// Turns the directions of all slips of `held` that start towards those that the forces require.
  /// False: they have them.
  bool turn(std::vector<Held>& held, const HeldRows& rows, const HeldForces& forces);

 private:
  double require(const Held& h, std::size_t i, const HeldRows& rows, const HeldForces& forces);
  void turnTo(Held& h, std::size_t i, const HeldRows& rows, int first) const;
  int turns_ = 0;
  double factor_ = 1.0;
  Eigen::VectorXd required_, change_, last_;  // row after row of these slips
  int size_ = 0;
};

}  // namespace dynamy
