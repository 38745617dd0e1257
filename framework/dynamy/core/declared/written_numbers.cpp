#include <algorithm>
#include <dynamy/core/declared/written_numbers.hpp>
#include <dynamy/core/expression/unit_suffix.hpp>
#include <dynamy/core/other_words.hpp>
#include <sstream>

namespace dynamy {
namespace {

constexpr std::string_view kOddSeparators = ",;|";
constexpr std::string_view kOddBrackets = "[]()";

bool isFigure(char c) { return c >= '0' && c <= '9'; }
bool isUnitLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c & 0x80) != 0;
}

std::string withAll(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// The unit that was meant: "m/s^2", "m/s²" → "m/s2", "N*m" → "Nm", words of other programs → our
/// units. "" if the word is no unit.
std::string unitMeant(std::string_view word) {
  std::string unit(word);
  for (const std::string_view sign : {"^", "*", "·"}) unit = withAll(std::move(unit), sign, "");
  unit = withAll(withAll(std::move(unit), "²", "2"), "³", "3");
  if (parseUnitSuffix(unit)) return unit;
  for (const std::string& known : unitSuffixes())  // KG, Kg
    if (std::equal(unit.begin(), unit.end(), known.begin(), known.end(), [](char a, char b) {
          return (a | 0x20) == (b | 0x20) && isUnitLetter(a) == isUnitLetter(b);
        }))
      return known;
  unit = unitOfOthers(unit);
  return parseUnitSuffix(unit) ? unit : std::string();
}

/// A word split into its number and the rest; the number is empty if the word begins with none.
struct NumberAndRest {
  std::string number, rest;
};

NumberAndRest numberAndRest(const std::string& word) {
  std::size_t at = 0;
  const auto digits = [&] {
    while (at < word.size() && (isFigure(word[at]) || word[at] == '.')) ++at;
  };
  if (at < word.size() && (word[at] == '-' || word[at] == '+')) ++at;
  const std::size_t first = at;
  digits();
  if (at == first) return {"", word};
  if (at < word.size() && (word[at] == 'e' || word[at] == 'E')) {
    const std::size_t sign = at + 1 < word.size() && (word[at + 1] == '-' || word[at + 1] == '+');
    if (at + 1 + sign < word.size() && isFigure(word[at + 1 + sign])) at += 1 + sign, digits();
  }
  return {word.substr(0, at), word.substr(at)};
}

/// The words with units right after their numbers. If only the last number has a unit, all numbers
/// get it.
std::string withUnits(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  bool onlyLast = true;  // no number but the last has a unit
  for (std::string word; in >> word;) {
    const NumberAndRest p = numberAndRest(word);
    const std::string unit = unitMeant(p.rest);
    if (p.number.empty() && !unit.empty() && !words.empty()) {
      words.back() += unit;
      continue;
    }
    onlyLast = onlyLast && (words.empty() || numberAndRest(words.back()).rest.empty());
    words.push_back(unit.empty() ? word : p.number + unit);
  }
  std::string out;
  const std::string last = words.empty() ? std::string() : numberAndRest(words.back()).rest;
  for (const std::string& word : words) {
    const bool zero = word.find_first_not_of("-+0.") == std::string::npos;
    out +=
        (out.empty() ? "" : " ") + (onlyLast && !zero ? numberAndRest(word).number + last : word);
  }
  return out;
}

/// The unit vector of an axis "x", "-y", "Z"; "" if the text is no axis.
std::string axisVector(std::string_view text) {
  const bool negative = text.starts_with("-");
  if (negative || text.starts_with("+")) text.remove_prefix(1);
  const std::size_t at = text.size() == 1 ? std::string_view("xyzXYZ").find(text[0]) : 6;
  if (at >= 6) return {};
  std::string out;
  for (std::size_t k = 0; k < 3; ++k) {
    if (k > 0) out += ' ';
    out += k != at % 3 ? "0" : negative ? "-1" : "1";
  }
  return out;
}

}  // namespace

OddWriting oddWriting(std::string_view text) {
  if (const std::size_t at = text.find_first_of(kOddBrackets); at != std::string_view::npos)
    return {"has brackets; numbers stand without", at, 1};
  if (const std::size_t at = text.find_first_of(kOddSeparators); at != std::string_view::npos) {
    const std::string sign(text.substr(at, 1));
    const std::string decimals = sign == "," ? ", decimals have a point" : "";
    return {"has \"" + sign + "\"; numbers stand between blanks" + decimals, at, 1};
  }
  // A unit that stands alone, after a number.
  bool number = false;
  for (std::size_t at = text.find_first_not_of(" \t\r\n"); at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n", at), text.size());
    const std::string word(text.substr(at, end - at));
    if (number && !unitMeant(word).empty())
      return {"has a blank before the unit \"" + word + '"', at, word.size(), true};
    number = !numberAndRest(word).number.empty();
    at = std::min(text.find_first_not_of(" \t\r\n", end), text.size());
  }
  return {};
}

std::vector<std::string> probableNumbers(std::string_view text) {
  std::vector<std::string> out;
  if (std::string unit = axisVector(text); !unit.empty()) out.push_back(std::move(unit));
  const auto add = [&](bool decimalComma) {
    std::string blanks(text);
    for (char& c : blanks) {
      if (decimalComma && c == ',')
        c = '.';
      else if (kOddSeparators.find(c) != std::string_view::npos ||
               kOddBrackets.find(c) != std::string_view::npos)
        c = ' ';
    }
    out.push_back(withUnits(blanks));
  };
  add(false);
  if (text.find(',') != std::string_view::npos) add(true);
  return out;
}

}  // namespace dynamy
