/// Finds the attribute that was probably meant by a name that an element does not have.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

struct MeantName {
  std::string name;  ///< the known name that was probably meant, "" if none
  std::string hint;  ///< what to print after the dash of the message
};

/// Tries, in this order: the same name in another case, the word of another program
/// (core/other_words), the nearest name, the list of `known`.
MeantName meantAttribute(std::string_view name, const std::vector<std::string>& known);

/// The name of `known` that differs from `name` in case only, "" if there is none.
std::string sameInOtherCase(std::string_view name, const std::vector<std::string>& known);

}  // namespace dynamy
