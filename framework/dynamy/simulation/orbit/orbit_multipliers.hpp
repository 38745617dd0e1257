/// What follows from the derivative DP of a return map: coordinates on which nothing depends,
/// multipliers, exact zeros (theory 54.2, 54.3).
#pragma once
#include <dynamy/simulation/orbit/return_map.hpp>
#include <utility>

namespace dynamy {

/// Changes of the state on which the return or its time depends, and all velocities.
std::vector<Eigen::Index> activeChanges(const Return& r, const ReturnDerivative& d);

/// DP of these changes, each over its scale.
Eigen::MatrixXd scaledMap(const Eigen::MatrixXd& P, const std::vector<Eigen::Index>& active,
                          const Eigen::VectorXd& scale);

/// Eigenvalues by falling modulus. Singular values up to `noise` are zero.
Eigen::VectorXcd multipliersOf(const Eigen::MatrixXd& scaled, double noise);

/// Multipliers of an orbit of `halves` returns.
Eigen::VectorXcd ofOrbit(const Eigen::VectorXcd& ofReturn, int halves);

/// Coordinates and velocities that joints hold: their changes are no motions.
int heldByJoints(Model& model, const State& x);

}  // namespace dynamy
