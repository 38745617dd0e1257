#include "mutator.hpp"

#include <algorithm>
#include <cctype>
#include <set>

namespace dynamy::fuzz {
namespace {

const std::vector<std::string>& extremes() {
  static const std::vector<std::string> all{
      "0",       "-0",        "1",          "-1",         "0.5",         "1e-9",       "-1e-9",
      "1e9",     "-1e9",      "1e-300",     "1e300",      "-1e300",      "1e308",      "1e-320",
      "1e400",   "nan",       "inf",        "-inf",       "99999",       "100000",     "100001",
      "1000000", "999999999", "2147483647", "2147483648", "-2147483648", "4294967297", "1e18",
      "0.1.2",   "1,5",       "30deg",      "5mm",        "3kg",         "1e3N/m",     "7parsec",
      "",        " ",         "1 2",        "1 2 3",      "0 0 0",       "{1/0}",      "{0/0}",
      "{",       "}",         "{}",         "{{1}}",      "{1}{2}",      "{sqrt(-1)}", "t",
      "sin(t)",  "1/t",       "t*(1/0)",    "{t}",        "1e-3 1e-3",   "true",       "*",
      "µ",       "\xff",      "&lt;",       "&#0;",       "&bogus;",     "a.b",        "[0]"};
  return all;
}

bool isWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

}  // namespace

Mutator::Mutator(const std::vector<std::string>& texts) {
  std::set<std::string> words, tags;
  for (const std::string& text : texts)
    for (std::size_t i = 0; i < text.size();) {
      std::size_t end = i;
      while (end < text.size() && isWord(text[end])) ++end;
      if (end > i) words.insert(text.substr(i, end - i));
      if (end > i && i > 0 && text[i - 1] == '<') tags.insert(text.substr(i, end - i));
      i = std::max(end, i + 1);
    }
  words_.assign(words.begin(), words.end());
  tags_.assign(tags.begin(), tags.end());
}

std::string Mutator::mutate(const std::string& text, std::uint64_t seed, std::uint64_t index) {
  std::seed_seq both{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                     static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(index >> 32)};
  random_.seed(both);
  std::string out = text;
  for (std::size_t i = below(2) * below(3) + 1; i > 0; --i) mutateOnce(out);
  return out;
}

/// Not std::uniform_int_distribution: the mutants are the same with every standard library.
std::size_t Mutator::below(std::size_t n) { return n == 0 ? 0 : random_() % n; }

void Mutator::mutateOnce(std::string& text) {
  if (text.empty()) return;
  const std::size_t kind = below(10);
  if (kind < 2)
    bytes(text);
  else if (kind < 5)
    structure(text);
  else
    values(text);
}

/// What a broken disk or a careless editor does.
void Mutator::bytes(std::string& text) {
  const std::size_t at = below(text.size()), size = std::min(below(60) + 1, text.size() - at);
  const std::string part = text.substr(at, size);
  switch (below(5)) {
    case 0:
      text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
      break;
    case 1:
      text.resize(at);
      break;
    case 2:
      text.erase(at, size);
      break;
    case 3:
      text.insert(below(text.size()), part);
      break;
    default: {
      std::string many;
      for (std::size_t i = below(2000); i > 0; --i) many += part[0];
      text.insert(at, many);
    }
  }
}

/// Elements and attributes lost, doubled, moved, renamed, nested.
void Mutator::structure(std::string& text) {
  const Range a = attribute(text), e = element(text), other = element(text);
  const std::string attributeText = text.substr(a.begin, a.size);
  const std::string elementText = text.substr(e.begin, e.size);
  switch (below(7)) {
    case 0:
      text.erase(a.begin, a.size);
      break;
    case 1:
      text.insert(a.begin, attributeText);
      break;
    case 2:
      text.erase(e.begin, e.size);
      break;
    case 3:
      text.insert(e.begin, elementText);
      break;
    case 4:
      text.insert(other.begin, elementText);
      break;
    case 5: {
      const Range tag = piece(text, "<", " />");
      if (tag.size > 1) text.replace(tag.begin + 1, tag.size - 1, oneOf(tags_));
      break;
    }
    default: {
      const std::string tag = oneOf(tags_);
      std::string open, close;
      for (std::size_t i = below(100) + 1; i > 0; --i)
        open += '<' + tag + '>', close += "</" + tag + '>';
      text.insert(e.begin + e.size, close), text.insert(e.begin, open);
    }
  }
}

/// Numbers become extreme, names others, formulas deep.
void Mutator::values(std::string& text) {
  const Range n = number(text), w = name(text), a = attribute(text);
  const std::size_t quote = std::min(text.find('"', a.begin), text.size());
  const std::size_t end = std::min(text.find('"', quote + 1), text.size());
  switch (below(6)) {
    case 0:
    case 1:
      text.replace(n.begin, n.size, oneOf(extremes()));
      break;
    case 2:
      text.replace(w.begin, w.size, oneOf(words_));
      break;
    case 3:
      if (end > quote) text.replace(quote + 1, end - quote - 1, oneOf(extremes()));
      break;
    case 4:
      if (end > quote) text.replace(quote + 1, end - quote - 1, oneOf(words_));
      break;
    default: {
      const std::size_t deep = below(300);
      if (end <= quote) return;
      text.insert(end, std::string(deep, ')'));
      text.insert(quote + 1, std::string(deep, '('));
    }
  }
}

/// From a byte of `first` on, up to the next byte of `last`.
Mutator::Range Mutator::piece(const std::string& text, const char* first, const char* last) {
  const std::size_t at = text.find_first_of(first, below(text.size()));
  if (at == std::string::npos) return {};
  return {at, std::min(text.find_first_of(last, at + 1), text.size()) - at};
}

Mutator::Range Mutator::number(const std::string& text) {
  const Range r = piece(text, "0123456789", " \"{}()*/+<>");
  return {r.begin, std::min<std::size_t>(r.size, 20)};
}

Mutator::Range Mutator::name(const std::string& text) {
  std::size_t at = below(text.size());
  while (at < text.size() && !isWord(text[at])) ++at;
  std::size_t end = at;
  while (end < text.size() && isWord(text[end])) ++end;
  return {at, end - at};
}

/// ` name="value"`.
Mutator::Range Mutator::attribute(const std::string& text) {
  const std::size_t equals = text.find("=\"", below(text.size()));
  if (equals == std::string::npos) return {};
  const std::size_t begin = text.find_last_of(" \n", equals);
  const std::size_t end = text.find('"', equals + 2);
  if (begin == std::string::npos || end == std::string::npos) return {};
  return {begin, end + 1 - begin};
}

/// `<Tag …/>`, or `<Tag …> … </Tag>` up to the first closing tag of this name.
Mutator::Range Mutator::element(const std::string& text) {
  const std::size_t begin = text.find('<', below(text.size()));
  if (begin == std::string::npos) return {};
  const std::size_t end = text.find('>', begin);
  if (end == std::string::npos) return {};
  if (text[end - 1] == '/') return {begin, end + 1 - begin};
  std::size_t tagEnd = begin + 1;
  while (tagEnd < text.size() && isWord(text[tagEnd])) ++tagEnd;
  const std::string closing = "</" + text.substr(begin + 1, tagEnd - begin - 1) + '>';
  const std::size_t close = text.find(closing, end);
  if (close == std::string::npos) return {begin, end + 1 - begin};
  return {begin, close + closing.size() - begin};
}

}  // namespace dynamy::fuzz
