/// The innermost loop of BlockLu, for the widest vectors that the processor has.
///
///   X_f ← X_f − Y_f K   for all blocks f below a pivot
///
/// A block is B × B pairs of numbers, column by column: of L and of Uᵀ, which are updated alike. One
/// source is compiled for SSE2 and, where a column fills its registers, for AVX2; no level fuses a product with a sum or changes the order of
/// a sum, so that both give the same bits.
#pragma once
#include <span>

namespace dynamy {

/// Y_f: `count` blocks that lie behind each other; X_f: block place[row[f]] of `blocks`.
using SubtractProducts = void (*)(double* blocks, const int* place, const int* row, int count,
                                  const double* Y, const double* K);

/// Levels that this processor has, the plainest first: the last one is the fastest. B: 2, 3 or 6.
template <int B>
std::span<const SubtractProducts> productLevels();

}  // namespace dynamy
