#include <dynamy/core/declared/two_names.hpp>

namespace dynamy {

std::pair<std::string, std::string> twoNames(const ParameterValue& value, const std::string& what,
                                             const std::string& hint) {
  constexpr std::string_view kSeparators = ",;|";
  const std::vector<std::string> names = value.words();
  if (names.size() == 2) return {names[0], names[1]};
  // "wood,floor" may be one name, but not where two are needed.
  const std::string& text = value.text;
  const std::size_t at = text.find_first_of(kSeparators);
  // Messages about values of files do not begin with the attribute by themselves.
  const std::string named = value.locate ? value.declaration->name + ' ' : std::string();
  if (names.size() == 1 && at != std::string::npos &&
      text.find_first_of(kSeparators, at + 1) == std::string::npos)
    throw value.fault(named + "has \"" + text.substr(at, 1) + "\"; names stand between blanks",
                      "write \"" + text.substr(0, at) + ' ' + text.substr(at + 1) + '"', at, 1);
  throw value.fault(what + " are needed, here are " + std::to_string(names.size()), hint, 0,
                    text.size());
}

}  // namespace dynamy
