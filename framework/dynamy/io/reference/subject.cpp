#include <fmt/format.h>

#include <algorithm>
#include <dynamy/core/declared/unknown_name.hpp>
#include <dynamy/core/other_words.hpp>
#include <dynamy/io/reference/subject.hpp>

namespace dynamy {
namespace {

bool isCapital(char c) { return c >= 'A' && c <= 'Z'; }
bool isWordLetter(char c) { return isCapital(c) || (c >= 'a' && c <= 'z') || (c & 0x80) != 0; }

/// The word in lower case and without the s of a plural.
std::string inSingular(std::string_view word) {
  std::string out;
  for (const char c : word) out += isCapital(c) ? static_cast<char>(c - 'A' + 'a') : c;
  if (out.size() > 3 && out.ends_with('s') && !out.ends_with("ss")) out.pop_back();
  return out;
}

/// The words of a text; "JointSpring" has the words joint and spring.
std::vector<std::string> wordsInside(std::string_view text) {
  std::vector<std::string> out;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const bool ends = i == text.size() || !isWordLetter(text[i]);
    const bool camel = !ends && i > begin && isCapital(text[i]) && !isCapital(text[i - 1]);
    if (!ends && !camel) continue;
    if (i > begin) out.push_back(inSingular(text.substr(begin, i - begin)));
    begin = ends ? i + 1 : i;
  }
  return out;
}

bool hasWord(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

std::string firstSentence(std::string_view about) {
  about = about.substr(0, about.find('\n'));
  // A dot ends a sentence before a capital or a number, but not in "e.g. GivenFriction".
  for (std::size_t at = about.find(". "); at != std::string_view::npos;
       at = about.find(". ", at + 1)) {
    const bool abbreviation = at >= 2 && about[at - 2] == '.';
    const char next = at + 2 < about.size() ? about[at + 2] : '.';
    if (abbreviation || !(isCapital(next) || (next >= '0' && next <= '9'))) continue;
    about = about.substr(0, at);
    break;
  }
  if (about.ends_with('.')) about.remove_suffix(1);
  const std::size_t colon = about.find(": ");
  const std::string_view head = about.substr(0, colon);
  if (colon != std::string_view::npos && std::count(head.begin(), head.end(), ' ') >= 2)
    about = head;
  return std::string(about);
}

std::vector<const RegisteredType*> typesOnSubject(const Registry& registry, std::string_view word) {
  const std::string wanted = inSingular(word);
  std::vector<const RegisteredType*> ofKind, out;
  for (const RegisteredType* t : registry.types()) {
    if (inSingular(kindText(t->kind)) == wanted) ofKind.push_back(t);
    if (hasWord(wordsInside(t->name), wanted) ||
        hasWord(wordsInside(firstSentence(t->attributes.aboutText())), wanted))
      out.push_back(t);
  }
  return ofKind.empty() ? out : ofKind;
}

std::string attributesOnSubject(const Registry& registry, std::string_view word) {
  std::string out;
  for (const RegisteredType* t : registry.types()) {
    std::vector<std::string> names;
    for (const Attribute& a : t->attributes.list()) names.push_back(a.name);
    std::string name = sameInOtherCase(word, names);
    if (name.empty()) name = attributeOfOthers(word, names).name;
    if (name.empty()) continue;
    out += fmt::format("  <{}> {}: {}\n", t->name, name, t->attributes.find(name)->text);
  }
  return out;
}

}  // namespace dynamy
