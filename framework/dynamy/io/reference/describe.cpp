#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <dynamy/core/declared/unknown_name.hpp>
#include <dynamy/core/other_words.hpp>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/core/utf8.hpp>
#include <dynamy/io/reference/declaration_text.hpp>
#include <dynamy/io/reference/describe.hpp>
#include <dynamy/io/reference/subject.hpp>
#include <dynamy/io/xml/vocabulary.hpp>

namespace dynamy {
namespace {

constexpr std::size_t kColumns = 6;
using Row = std::array<std::string, kColumns>;

std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(characterCount(text));
}

/// Formats rows with columns as wide as their widest entry; the last column is not padded.
std::string table(const std::vector<Row>& rows) {
  std::array<std::size_t, kColumns> widths{};
  for (const Row& row : rows)
    for (std::size_t i = 0; i < kColumns; ++i) widths[i] = std::max(widths[i], width(row[i]));
  std::string out;
  for (const Row& row : rows) {
    std::string line = " ";
    for (std::size_t i = 0; i < kColumns; ++i) {
      line += ' ' + row[i];
      if (i + 1 < kColumns) line += std::string(widths[i] - width(row[i]) + 1, ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + '\n';
  }
  return out;
}

std::string describe(const std::string& title, const Attributes& a, const std::string& children) {
  std::string out = title + '\n';
  if (!a.aboutText().empty()) out += "  " + a.aboutText() + '\n';
  if (!a.list().empty()) {
    std::vector<Row> rows{{"attribute", "type", "unit", "default", "range", "meaning"}};
    for (const Attribute& x : a.list())
      rows.push_back({x.name, typeText(x), std::string(unitText(x.unit)), defaultText(x),
                      rangeText(x), x.text});
    out += '\n' + table(rows);
  }
  out += children;
  if (!a.exampleText().empty()) out += "\nExample\n  " + a.exampleText() + '\n';
  return out;
}

std::string childrenText(const RegisteredType& type, const Registry& registry) {
  if (type.attributes.children().empty()) return {};
  std::string out = "\nChildren\n";
  for (const ChildRule& rule : type.attributes.children()) {
    std::vector<std::string> names;
    for (const RegisteredType* t : registry.types())
      if (t->kind == rule.kind && (rule.only.empty() || rule.only == t->name))
        names.push_back('<' + t->name + '>');
    out += fmt::format("  {} {}: {}{}\n", countText(rule), kindText(rule.kind), rule.text,
                       names.empty() ? "" : fmt::format(" ({})", fmt::join(names, " ")));
  }
  return out;
}

/// A hint for a word that names no type: the types whose description contains it.
std::string typesThatTellOf(const Registry& registry, std::string_view word) {
  constexpr std::size_t kShortest = 3, kMost = 6;  // letters; types worth naming
  const auto lower = [](std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(), [](char c) {
      return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return out;
  };
  std::vector<std::string> telling;
  for (const RegisteredType* t : registry.types())
    if (lower(t->attributes.aboutText()).find(lower(word)) != std::string::npos)
      telling.push_back('<' + t->name + '>');
  if (word.size() < kShortest || telling.empty() || telling.size() > kMost)
    return "dynamy list shows all names";
  return fmt::format("the description of {} has this word", fmt::join(telling, ", "));
}

/// What the declarations say about a word that is no name; "" if nothing.
std::string onSubject(const Registry& registry, std::string_view word) {
  constexpr std::size_t kShortest = 2;  // letters
  if (word.size() < kShortest) return {};
  std::string out = elementOfOthers(word);
  if (!out.empty()) out += "\n";
  if (const auto types = typesOnSubject(registry, word); !types.empty())
    return out + fmt::format("about \"{}\":\n\n{}", word, listTypes(types));
  if (const std::string attributes = attributesOnSubject(registry, word); !attributes.empty())
    return out + fmt::format("attributes for \"{}\":\n{}", word, attributes);
  return out;
}

}  // namespace

std::string describe(const Registry& registry, std::string_view name) {
  if (const RegisteredType* type = registry.find(name))
    return describe(fmt::format("<{}>  {} of {}", type->name, kindText(type->kind), type->library),
                    type->attributes, childrenText(*type, registry));
  const Vocabulary vocabulary;
  if (const Word* word = vocabulary.find(name)) {
    std::vector<std::string> inside;
    for (const std::string& child : word->children) inside.push_back('<' + child + '>');
    for (const Kind kind : word->kinds) inside.push_back("every " + std::string(kindText(kind)));
    const std::string children =
        inside.empty() ? "" : fmt::format("\nChildren\n  {}\n", fmt::join(inside, ", "));
    return describe(fmt::format("<{}>  word of the model file", word->name), word->attributes,
                    children);
  }
  std::vector<std::string> known;
  for (const RegisteredType* t : registry.types()) known.push_back(t->name);
  for (const Word& word : vocabulary.words()) known.push_back(word.name);
  if (const std::string same = sameInOtherCase(name, known); !same.empty())
    return describe(registry, same);
  if (std::string found = onSubject(registry, name); !found.empty()) return found;
  const std::string near = nearest(name, known);
  throw ModelError("there is no \"" + std::string(name) + '"',
                   near.empty() ? typesThatTellOf(registry, name) : didYouMean(near));
}

std::string listTypes(const std::vector<const RegisteredType*>& types) {
  std::size_t longest = 0;
  for (const RegisteredType* t : types) longest = std::max(longest, width(t->name));
  std::string out;
  const RegisteredType* before = nullptr;
  for (const RegisteredType* t : types) {
    if (before == nullptr || before->kind != t->kind)
      out += (out.empty() ? "" : "\n") + std::string(kindText(t->kind)) + '\n';
    std::string about = firstSentence(t->attributes.aboutText());
    if (t->library != "dynamy" && t->library != "dynamy_elements")
      about += (about.empty() ? "[" : " [") + t->library + ']';
    std::string line = "  " + t->name + std::string(longest - width(t->name) + 2, ' ') + about;
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + '\n';
    before = t;
  }
  return out;
}

}  // namespace dynamy
