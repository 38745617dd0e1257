/// Forces that hold each other: Λ ≠ 0 with G Λ = 0 inside of the laws' cones.
///
///   x_k = Z Zᵀ y_k,   y_{k+1} = P_K(x_k + p_k),   p_{k+1} = x_k + p_k − y_{k+1}     (Dykstra)
///
/// goes to the nearest point of ker G ∩ K seen from "1 N s in every normal direction": zero exactly
/// if no normal force can be held by others [boyle_dykstra1986]. Rejected: alternating projections
/// without p, which end at some point of the intersection and may miss that it is more than zero.
#pragma once
#include <dynamy/solver/problem/dense_problem.hpp>

namespace dynamy {

/// Λ with GΛ = 0, Λ_i ∈ K_i (recession cone of C_i), largest normal force 1; zero vector: none
/// exists. Only contacts that are closed take part.
Eigen::VectorXd jammedForces(const DenseProblem& dense);

/// z ← nearest point of the recession cone of C_i: any force of a joint, N ≥ 0 and x ∈ N B of a
/// contact, 0 of a bounded force.
void projectOnCone(const DenseProblem& dense, int contact, double* z);

}  // namespace dynamy
