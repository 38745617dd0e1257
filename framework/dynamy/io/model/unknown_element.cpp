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

/// The section of `name`, if it is not among `allowed`; else "".
std::string elsewhere(const std::string& name, const std::vector<std::string>& allowed,
                      const Registry& registry) {
  const RegisteredType* type = registry.find(name);
  if (type == nullptr || std::find(allowed.begin(), allowed.end(), name) != allowed.end())
    return {};
  return std::string(sectionOf(type->kind));
}

/// The hint of a word of other programs, with the section of its element; "" if that element is not
/// registered, as in a program without the standard elements.
std::string usableHint(const std::string& hint, const std::vector<std::string>& all,
                       const std::vector<std::string>& allowed, const Registry& registry) {
  const std::string ours = firstElement(hint);
  if (!ours.empty() && std::find(all.begin(), all.end(), ours) == all.end()) return {};
  // Only what replaces the unknown element can be put elsewhere: "a hinge is <Revolute>".
  const bool replaces = hint.find(" is <" + ours) != std::string::npos ||
                        hint.find("kind: <" + ours) != std::string::npos;
  const std::string section = replaces ? elsewhere(ours, allowed, registry) : std::string();
  return section.empty() ? hint : hint + "; put it into <" + section + '>';
}

/// "<set> stands inside of <include>": where a word of the model file that is right in itself belongs; "":
/// it is none, or belongs here.
std::string placeOfWord(std::string_view tag, const std::vector<std::string>& allowed,
                        const Vocabulary& vocabulary) {
  std::string parents;
  for (const Word& word : vocabulary.words())
    if (std::find(word.children.begin(), word.children.end(), tag) != word.children.end())
      parents += (parents.empty() ? "<" : ", <") + word.name + '>';
  if (parents.empty() || std::find(allowed.begin(), allowed.end(), tag) != allowed.end()) return {};
  return '<' + std::string(tag) + "> stands inside of " + parents;
}

}  // namespace

std::string rightPlace(const RegisteredType& type, const Registry& registry) {
  if (const std::string_view section = sectionOf(type.kind); !section.empty())
    return "; put it into <" + std::string(section) + '>';
  std::string parents;
  int count = 0;
  constexpr int kMostParents = 5;
  // A law belongs to two materials before it belongs to a joint.
  for (const bool rules : {true, false})
    for (const RegisteredType* t : registry.types()) {
      const auto& children = t->attributes.children();
      const bool takes = std::any_of(children.begin(), children.end(), [&](const ChildRule& rule) {
        return rule.kind == type.kind && (rule.only.empty() || rule.only == type.name);
      });
      if (!takes || (t->kind == Kind::rule) != rules) continue;
      if (++count <= kMostParents) parents += (parents.empty() ? "<" : ", <") + t->name + '>';
    }
  return "; it stands inside of " + (parents.empty()        ? "another element"
                                     : count > kMostParents ? parents + ", …"
                                                            : parents);
}

std::string meantElement(std::string_view tag, const std::vector<std::string>& allowed,
                         const Registry& registry, const Vocabulary& vocabulary) {
  std::vector<std::string> types, all;
  for (const RegisteredType* t : registry.types()) types.push_back(t->name);
  all = types;
  for (const Word& word : vocabulary.words()) all.push_back(word.name);

  if (std::string place = placeOfWord(tag, allowed, vocabulary); !place.empty()) return place;
  std::string near;
  for (const std::string& word : {std::string(tag), withoutKind(tag)}) {
    if (near.empty()) near = sameInOtherCase(word, allowed);
    if (near.empty())
      if (std::string hint = usableHint(elementOfOthers(word), all, allowed, registry);
          !hint.empty())
        return hint;
    if (near.empty()) near = sameInOtherCase(word, all);
    if (!near.empty()) break;
  }
  if (near.empty()) near = nearest(tag, allowed);
  if (near.empty()) near = nearest(tag, types);
  if (near.empty()) return usableHint(elementByLastWord(tag), all, allowed, registry);
  const std::string section = elsewhere(near, allowed, registry);
  return "did you mean <" + near + '>' +
         (section.empty() ? "?" : ", which stands in <" + section + ">?");
}

std::string meantFormat(const std::string& root) {
  if (!sameInOtherCase(root, {"dynamy"}).empty()) return "did you mean <dynamy>?";
  for (const auto& [tag, format] : {std::pair("mujoco", "MJCF"), {"robot", "URDF"}, {"sdf", "SDF"}})
    if (root == tag)
      return "the file is in " + std::string(format) +
             "; dynamy import FILE --out model.xml makes a model of it";
  return {};
}

}  // namespace dynamy
