/// Choices of the prox parameter r, one number per row; rows of one convex set share it.
///
///   diagonal dominance (4.59–4.60):  r_i = 1/|G_ii| if 2|G_ii| ≥ Σ_j|G_ij| for all i, else r_i =
///   1/Σ_j|G_ij| exact scalar steps:              r_i = 1/G_ii                        (rows of one
///   set: 1/λ_max of their block) row sums:                        r_i = 1/Σ_j|G_ij| spectral: one
///   r = 1/λ_max(G), by power iteration
#pragma once
#include <dynamy/solver/inclusion_problem.hpp>

namespace dynamy {

enum class Relaxation : std::uint8_t { diagonalDominance, exact, rowSums, spectral };

/// Fills r (rows() entries) and multiplies by `factor`.
void relaxation(const InclusionProblem& problem, Relaxation rule, double factor,
                std::vector<double>& r);

}  // namespace dynamy
