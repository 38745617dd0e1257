/// ForceBound: one bound of the forces that a status permits (theory 50.1):
///
///   |w ∘ λ_T| ≤ L,   L = factor λ_N + constant;   without rows: 0 ≤ L
///
///   joint −;  normal λ_N ≥ lower;  cone λ_N ≥ 0, |λ_T| ≤ μ λ_N;  disc λ_N ≥ |λ|/μ;  given |λ| ≤ upper
///
/// Sets of other shapes (drilling, orthotropic) are taken as ellipsoids of their widths.
#pragma once
#include <dynamy/located/phase/held_rows.hpp>

namespace dynamy {

struct ForceBound {
  int normal = -1;  ///< row of λ_N; −1: L is constant
  double factor = 0.0, constant = 0.0;
  int first = 0;            ///< first of the rows T
  Eigen::VectorXd weights;  ///< w, one for each of them
};

/// The bounds of the force of held[i], as rows of `rows`.
std::vector<ForceBound> forceBounds(const std::vector<Held>& held, const HeldRows& rows,
                                    std::size_t i);
/// Row of λ_N of the contact that held[i] is a part of.
int normalRow(const std::vector<Held>& held, const HeldRows& rows, std::size_t i);

}  // namespace dynamy
