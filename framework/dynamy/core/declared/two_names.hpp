/// Names between blanks: the two of an attribute like `between`, and names with other signs between.
#pragma once
#include <dynamy/core/declared/parameters.hpp>

namespace dynamy {

/// Reads two names that stand between blanks. `what` they are, e.g. "two frames", and `hint` are
/// for the error of a text with another number of names.
/// \throws ModelError
std::pair<std::string, std::string> twoNames(const ParameterValue& value, const std::string& what,
                                             const std::string& hint);

/// "world ball" for the word "world,ball" where names stand between blanks; "" for a word without
/// such signs.
std::string partedNames(std::string_view word);

}  // namespace dynamy
