/// How numbers are written that could not be read: a better text and what was wrong with the old.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// What is not written as dynamY writes numbers, e.g. `has a blank before the unit "kg"`; "" if
/// nothing of the kind was found. `offset`, `length`: the bytes in the text.
struct OddWriting {
  std::string text;
  std::size_t offset = 0, length = 0;
  bool guess = false;  ///< a word is a unit, or a parameter with its name: "h"
};
OddWriting oddWriting(std::string_view text);

/// Texts that may have been meant, the likeliest first: blanks for other separators and for
/// brackets, decimal points for commas, units right after their numbers and in our words, "0 1 0"
/// for an axis "y". The reader takes the first that reads as its declaration asks.
std::vector<std::string> probableNumbers(std::string_view text);

}  // namespace dynamy
