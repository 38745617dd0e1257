/// Forces that hold each other: Λ ≠ 0 with G Λ = 0 inside of the laws' cones.
///
///   x_k = Z Zᵀ y_k,   y_{k+1} = P_K(x_k + p_k),   p_{k+1} = x_k + p_k − y_{k+1}     (Dykstra)
///
/// The iteration starts from 1 N s in every normal direction and converges to the nearest point of
/// ker G ∩ K. The limit is zero exactly if no normal force can be held by others
/// [boyle_dykstra1986]. Rejected: alternating projections without p, which end at some point of the
/// intersection and may miss that it holds more than zero.
#pragma once
#include <dynamy/solver/problem/dense_problem.hpp>

namespace dynamy {

/// Returns Λ with GΛ = 0, Λ_i ∈ K_i (recession cone of C_i) and largest normal force 1, or the zero
/// vector if none exists. Only closed contacts take part.
Eigen::VectorXd jammedForces(const DenseProblem& dense);

/// z ← nearest point of the recession cone of C_i. The cone holds all forces for a joint, N ≥ 0
/// with x ∈ N B for a contact, and only 0 for a bounded force.
void projectOnCone(const DenseProblem& dense, int contact, double* z);

}  // namespace dynamy
