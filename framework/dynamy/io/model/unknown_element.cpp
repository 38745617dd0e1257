#include <algorithm>
#include <dynamy/core/declared/unknown_name.hpp>
#include <dynamy/core/other_words.hpp>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/io/model/unknown_element.hpp>
#include <utility>

namespace dynamy {
namespace {

/// The first <Name> in a hint.
std::string firstElement(const std::string& hint) {
  const std::size_t begin = hint.find('<') + 1;  // 0: there is none
  return begin == 0 ? std::string() : hint.substr(begin, hint.find_first_of(" >", begin) - begin);
}

/// Advice on the section of `name`, if it is not among `allowed`.
std::string elsewhere(const std::string& name, const std::vector<std::string>& allowed,
                      const Registry& registry) {
  const RegisteredType* type = registry.find(name);
  if (type == nullptr || std::find(allowed.begin(), allowed.end(), name) != allowed.end())
    return {};
  const std::string_view section = sectionOf(type->kind);
  return section.empty() ? std::string() : "; put it into <" + std::string(section) + '>';
}

}  // namespace

std::string meantElement(std::string_view tag, const std::vector<std::string>& allowed,
                         const Registry& registry, const Vocabulary& vocabulary) {
  std::vector<std::string> types, all;
  for (const RegisteredType* t : registry.types()) types.push_back(t->name);
  all = types;
  for (const Word& word : vocabulary.words()) all.push_back(word.name);

  std::string near;
  for (const std::string& word : {std::string(tag), withoutKind(tag)}) {
    if (near.empty()) near = sameInOtherCase(word, allowed);
    if (near.empty()) near = sameInOtherCase(word, all);
    if (!near.empty()) break;
    // A hint helps only if its element is registered; a program without the standard elements has
    // few.
    const std::string other = elementOfOthers(word), ours = firstElement(other);
    if (!other.empty() && (ours.empty() || std::find(all.begin(), all.end(), ours) != all.end()))
      return other + elsewhere(ours, allowed, registry);
  }
  if (near.empty()) near = nearest(tag, allowed);
  if (near.empty()) near = nearest(tag, types);
  if (near.empty()) return {};
  return "did you mean <" + near + ">?" + elsewhere(near, allowed, registry);
}

std::string meantFormat(const std::string& root) {
  if (!sameInOtherCase(root, {"dynamy"}).empty()) return "did you mean <dynamy>?";
  for (const auto& [tag, format] : {std::pair("mujoco", "MJCF"), {"robot", "URDF"}, {"sdf", "SDF"}})
    if (root == tag)
      return "the file is in " + std::string(format) +
             ", which dynamY does not read; dynamy describe dynamy shows a small model";
  return {};
}

}  // namespace dynamy
