/// The two names of an attribute like `between`.
#pragma once
#include <dynamy/core/declared/parameters.hpp>

namespace dynamy {

/// Reads two names that stand between blanks. `what` they are, e.g. "two frames", and `hint` are
/// for the error of a text with another number of names.
/// \throws ModelError
std::pair<std::string, std::string> twoNames(const ParameterValue& value, const std::string& what,
                                             const std::string& hint);

}  // namespace dynamy
