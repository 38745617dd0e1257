/// Choices of the prox parameter r (theory 4.3), one number per row; rows of one group share it.
///
///   diagonal dominance [studer2009]: 1/|G_ii| if 2|G_ii| ≥ Σ_j|G_ij| for all i, else 1/Σ_j|G_ij|
///   exact:     1/G_ii; rows of one group: 1/λ_max of their block
///   row sums:  1/Σ_j|G_ij|
///   spectral:  one r = 1/λ_max(G), by power iteration
///   optimal:   one r = 2/(λ_min + λ_max), the fastest common one; at most 1.9/λ_max
#pragma once
#include <dynamy/solver/problem/inclusion_problem.hpp>

namespace dynamy {

enum class Relaxation : std::uint8_t { diagonalDominance, exact, rowSums, spectral, optimal };

/// Fills r (rows() entries) and multiplies by `factor`.
void relaxation(const InclusionProblem& problem, Relaxation rule, double factor,
                std::vector<double>& r);

}  // namespace dynamy
