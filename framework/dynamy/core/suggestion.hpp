/// Finds the known name that a mistyped word probably meant ("did you mean …?").
///
/// Distance: Damerau–Levenshtein in its restricted form (insert, delete, replace, swap two
/// neighbours; each costs 1), letters compared without case. A name is near if distance ≤
/// ⌊(ℓ+1)/3⌋, ℓ the longer of both lengths, so that short words need an almost exact hit. Rejected:
/// a plain Levenshtein distance, which counts the commonest typing error, the swap of two letters,
/// twice.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace dynamy {

/// Number of typing errors between a and b, case ignored. Cost O(|a| |b|).
int typingDistance(std::string_view a, std::string_view b);

/// The known name nearest to word, "" if nothing is near. Among equally near names one with the
/// right case wins, then the first in `known`. A word of at least three letters that begins exactly
/// one known name counts as near, too.
std::string nearest(std::string_view word, std::span<const std::string> known);

}  // namespace dynamy
