/// PositionAim: aims γ^E at positions instead of velocities.
///
///   unilateral contact     g + Δt γ_N^E ≥ 0: the gap term g/Δt, for g > dead
///   joint                  γ^E + γ^A = 0, or γ^E = −κ g/Δt
#pragma once
#include <dynamy/solver/problem/inclusion_problem.hpp>

namespace dynamy {

/// Unilateral contacts get the gap term g/Δt, for g > dead, and an impact waits until the contact is
/// closed. Joints get γ^E + γ^A = 0 (the mean velocity of the step vanishes), or are stabilised.
struct PositionAim {
  double dead = 0.0;        ///< gaps up to this count as closed [m]
  bool meanJoints = false;  ///< γ^E + γ^A = 0 in the rows of joints
  double kappa = 0.0;       ///< without meanJoints: γ^E = −κ g/Δt in the rows of joints,
  double cap = 0.0;    ///< limited to this speed [m/s], as in overlaps of bodies that met slower
  double noise = 0.0;  ///< rounding of gaps [m]: solvers need not resolve rates below noise/Δt
  std::span<const ContactKey> arrived{};  ///< sorted; these contacts are closed, whatever their gap
  /// Impacts without restitution do not wait: this step closes the gap, the next one does the rest.
  bool divide = false;
};

/// How a step aims: closed contacts have g ≤ gTol [m], and overlaps are pushed out in `pushOut` [s]
/// if the step is shorter.
struct AimedStep {
  const PositionAim& aim;
  double gTol, pushOut;
};

/// Adds the terms of the aim to γ_free of `p`, whose free motion goes from uA to uFree (nu numbers).
/// arriving: contacts whose impact falls into this step and waits, sorted, without those that
/// rebound.
void addAim(const AimedStep& step, const Eigen::VectorXd& uA, const Eigen::VectorXd& uFree,
            InclusionProblem& p, std::vector<ContactKey>& arriving);

}  // namespace dynamy
