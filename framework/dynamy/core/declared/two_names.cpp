#include <dynamy/core/declared/two_names.hpp>

namespace dynamy {
namespace {

constexpr std::string_view kNameSeparators = ",;|";

}  // namespace

std::pair<std::string, std::string> twoNames(const ParameterValue& value, const std::string& what,
                                             const std::string& hint) {
  const std::vector<std::string> names = value.words();
  if (names.size() == 2) return {names[0], names[1]};
  // "wood,floor" may be one name, but not where two are needed.
  const std::string& text = value.text;
  const std::size_t at = text.find_first_of(kNameSeparators);
  // Messages about values of files do not begin with the attribute by themselves.
  const std::string named = value.locate ? value.declaration->name + ' ' : std::string();
  if (names.size() == 1 && at != std::string::npos &&
      text.find_first_of(kNameSeparators, at + 1) == std::string::npos)
    throw value.fault(named + "has \"" + text.substr(at, 1) + "\"; names stand between blanks",
                      "write \"" + text.substr(0, at) + ' ' + text.substr(at + 1) + '"', at, 1);
  throw value.fault(what + " are needed, here are " + std::to_string(names.size()), hint, 0,
                    text.size());
}

std::string partedNames(std::string_view word) {
  if (word.find_first_of(kNameSeparators) == std::string_view::npos) return {};
  std::string out(word);
  for (char& c : out)
    if (kNameSeparators.find(c) != std::string_view::npos) c = ' ';
  return out;
}

}  // namespace dynamy
