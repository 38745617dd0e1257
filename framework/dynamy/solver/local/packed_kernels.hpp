/// Loops over batches of packed contacts, for the widest vectors that the processor has.
///
/// One source is compiled for SSE2, AVX2 and AVX-512; the level is chosen at the first use. No
/// level fuses a product with a sum or changes the order of a sum over lanes, so that all give the
/// same bits.
#pragma once
#include <dynamy/solver/local/packed_contacts.hpp>

namespace dynamy {

struct PackedKernels {
  /// Makes one sweep from Λ + β (Λ − last); returns Σ w (Λ̃ − Λ⁺)·(Λ⁺ − Λ). Without `all`, batches
  /// with Λ = last = 0 in all lanes are passed over.
  double (*sweep)(PackedBatch* batch, int batches, PackedVelocity* v, double beta, bool all);
  /// v' += Aᵀ Λ.
  void (*impulses)(const PackedBatch* batch, int batches, PackedVelocity* v);
  /// Evaluates the natural maps of Coulomb's exact law; `out`: the largest ones.
  void (*measure)(const PackedBatch* batch, int batches, const PackedVelocity* v,
                  PackedMeasure& out);
};

/// Levels that this processor has, the plainest first: the last one is the fastest.
std::span<const PackedKernels> packedLevels();

}  // namespace dynamy
