/// M⁻¹W and G_ii of contacts of three rows between free bodies of diagonal mass, in one pass:
///
///   G_ii = Σ_b W_bᵀ (M_b⁻¹ W_b)   over the one or two bodies b of contact i
///
/// The general loops look up sizes at every block and read W twice; in a stack at rest they took a
/// tenth of the step.
#pragma once
#include <dynamy/solver/problem/diagonal_blocks.hpp>
#include <dynamy/system/mass_matrix.hpp>

namespace dynamy {

/// Fills `minvW` (sized like contacts.W) and the 3 × 3 blocks `diagonal`. False: there are other contacts or bodies, and the results must not be used.
bool freeBodies(const ContactSet& contacts, const MassMatrix& mass, std::vector<double>& minvW,
                DiagonalBlocks& diagonal);

}  // namespace dynamy
