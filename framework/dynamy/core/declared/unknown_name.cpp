#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/declared/unknown_name.hpp>
#include <dynamy/core/other_words.hpp>
#include <dynamy/core/suggestion.hpp>

namespace dynamy {

std::string sameInOtherCase(std::string_view name, const std::vector<std::string>& known) {
  for (const std::string& k : known)
    if (k.size() == name.size() && typingDistance(k, name) == 0) return k;
  return {};
}

MeantName meantAttribute(std::string_view name, const std::vector<std::string>& known) {
  if (const std::string same = sameInOtherCase(name, known); !same.empty())
    return {same, didYouMean(same)};
  if (AttributeOfOthers other = attributeOfOthers(name, known); !other.hint.empty())
    return {std::move(other.name), std::move(other.hint)};
  return {nearest(name, known), unknownNameHint(name, known)};
}

}  // namespace dynamy
