/// Numbers that cannot be read as they are written: what is wrong with the text, and a better text.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// A difference from the way dynamY writes numbers, e.g. `has a blank before the unit "kg"`; "" if
/// none was found. `offset`, `length`: the bytes in the text.
struct OddWriting {
  std::string text;
  std::size_t offset = 0, length = 0;
  bool guess = false;  ///< true: "h" may be a unit or a parameter, "*" a separator or a product
  bool unit = false;   ///< a blank stands before what may be a unit
};
OddWriting oddWriting(std::string_view text);

/// Texts that may have been meant, the likeliest first: blanks for other separators, for "x"
/// between numbers and for brackets, decimal points for commas, whole exponents, units right after
/// their numbers and in those of dynamY ("3 ft" → "0.9144m"), "0 1 0" for an axis "y". The reader takes the first
/// text that the declaration accepts.
std::vector<std::string> probableNumbers(std::string_view text);

}  // namespace dynamy
