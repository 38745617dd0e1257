#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <dynamy/core/declared/written_numbers.hpp>
#include <dynamy/core/expression/unit_suffix.hpp>
#include <dynamy/core/other_words.hpp>
#include <sstream>
#include <utility>

namespace dynamy {
namespace {

constexpr std::string_view kOddSeparators = ",;|";
constexpr std::string_view kOddBrackets = "[]()";
constexpr std::string_view kBlanks = " \t\r\n";

/// Blanks that text programs write: no-break, thin, figure space, and others that look like one.
constexpr auto kOddBlanks = std::to_array<std::string_view>(
    {"\u00A0", "\u2002", "\u2003", "\u2007", "\u2009", "\u200A", "\u202F", "\u3000"});

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

/// Our name of the same unit: "m/s^2", "m/s²" → "m/s2", "N*m" → "Nm", words of other programs. "" if
/// there is none.
std::string sameUnit(std::string_view word) {
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

/// A unit that was meant, in ours: "degrees" → "deg", "ft" → 0.3048 "m". `unit` is "" if the word
/// is no unit.
struct UnitMeant {
  std::string unit;
  double factor = 1.0;
};

UnitMeant unitMeant(std::string_view word) {
  if (std::string unit = sameUnit(word); !unit.empty()) return {std::move(unit)};
  const NumberAndRest amount = numberAndRest(amountInOurs(word));
  return {amount.rest, std::strtod(amount.number.c_str(), nullptr)};
}

/// A number with what follows it, in units of dynamY.
struct WordMeant {
  std::string number;
  UnitMeant unit;
  std::string text(const UnitMeant& of) const {
    if (of.unit.empty() || of.factor == 1.0) return number + of.unit;
    return fmt::format("{:.9g}", std::strtod(number.c_str(), nullptr) * of.factor) + of.unit;
  }
};

/// The words with units right after their numbers. If only the last number has a unit, all numbers
/// get it.
std::string withUnits(const std::string& text) {
  std::istringstream in(text);
  std::vector<WordMeant> words;
  bool onlyLast = true;  // no number but the last has a unit
  for (std::string word; in >> word;) {
    NumberAndRest p = numberAndRest(word);
    UnitMeant unit = unitMeant(p.rest);
    if (p.number.empty() && !unit.unit.empty() && !words.empty()) {
      unit.unit.insert(0, words.back().unit.unit);
      words.back().unit = std::move(unit);
      continue;
    }
    onlyLast = onlyLast && (words.empty() || words.back().unit.unit.empty());
    if (unit.unit.empty()) unit.unit = std::move(p.rest);
    words.push_back({std::move(p.number), std::move(unit)});
  }
  std::string out;
  for (const WordMeant& word : words) {
    const bool zero = word.text(word.unit).find_first_not_of("-+0.") == std::string::npos;
    out += (out.empty() ? "" : " ") + word.text(onlyLast && !zero ? words.back().unit : word.unit);
  }
  return out;
}

/// A sign between two numbers, "1m x 1m", "1×1", "2 * 3": its place and its bytes.
struct TimesSign {
  std::size_t offset = std::string_view::npos, length = 0;
};

/// The first "x", "×" or "*" from byte `from` on that follows a number, with its unit or without,
/// and stands before another. It has blanks on both sides or on neither ("1 x2" may name a
/// parameter).
TimesSign timesSign(std::string_view text, std::size_t from) {
  for (std::size_t at = from; at < text.size(); ++at) {
    std::size_t length = 0;
    for (const std::string_view sign : {"x", "X", "*", "×"})
      if (text.substr(at).starts_with(sign)) length = sign.size();
    if (length == 0) continue;
    const std::string_view before = text.substr(0, at), after = text.substr(at + length);
    const std::size_t last = before.find_last_not_of(kBlanks),
                      next = after.find_first_not_of(kBlanks);
    if (last == std::string_view::npos || next == std::string_view::npos) continue;
    if ((last + 1 < at) != (next > 0)) continue;
    const std::size_t blank = before.substr(0, last + 1).find_last_of(kBlanks);
    const std::string word(before.substr(blank + 1, last - blank));
    const std::string following(after.substr(next, after.find_first_of(kBlanks, next) - next));
    if (!numberAndRest(word).number.empty() && !numberAndRest(following).number.empty())
      return {at, length};
  }
  return {};
}

std::string withoutTimesSigns(std::string_view text) {
  std::string out(text);
  for (TimesSign sign = timesSign(out, 0); sign.length > 0; sign = timesSign(out, sign.offset))
    out.replace(sign.offset, sign.length, " ");
  return out;
}

/// The sign before a fraction of an exponent, "2e3,5"; npos if there is none.
std::size_t fractionOfExponent(std::string_view text) {
  for (std::size_t at = text.find_first_of(",."); at != std::string_view::npos;
       at = text.find_first_of(",.", at + 1)) {
    std::size_t begin = at;
    while (begin > 0 && isFigure(text[begin - 1])) --begin;
    if (begin == at || at + 1 == text.size() || !isFigure(text[at + 1])) continue;
    if (begin > 1 && (text[begin - 1] == '-' || text[begin - 1] == '+')) --begin;
    if (begin > 1 && (text[begin - 1] | 0x20) == 'e' && isFigure(text[begin - 2])) return at;
  }
  return std::string_view::npos;
}

/// "2e3,5" → "2.5e3": the fraction behind the figures before the exponent. The text as it is if
/// these have a fraction already.
std::string withWholeExponent(std::string_view text) {
  std::string out(text);
  const std::size_t at = fractionOfExponent(text);
  if (at == std::string_view::npos) return out;
  const std::size_t e = text.substr(0, at).find_last_of("eE");
  std::size_t begin = e, end = at + 1;
  while (begin > 0 && isFigure(text[begin - 1])) --begin;
  while (end < text.size() && isFigure(text[end])) ++end;
  if (begin > 0 && (text[begin - 1] == '.' || text[begin - 1] == ',')) return out;
  out.erase(at, end - at);
  return out.insert(e, "." + std::string(text.substr(at + 1, end - at - 1)));
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

/// "2×10³", "2*10^3", "2x10-3" → "2e3", "2e3", "2e-3"; the text as it is if no power of ten is in it.
std::string withExponents(std::string_view text) {
  std::string out(text);
  constexpr auto kSuperscripts =
      std::to_array<std::pair<std::string_view, std::string_view>>({{"⁰", "0"},
                                                                    {"¹", "1"},
                                                                    {"²", "2"},
                                                                    {"³", "3"},
                                                                    {"⁴", "4"},
                                                                    {"⁵", "5"},
                                                                    {"⁶", "6"},
                                                                    {"⁷", "7"},
                                                                    {"⁸", "8"},
                                                                    {"⁹", "9"},
                                                                    {"⁻", "-"}});
  for (const std::string_view times : {"×", "*", "·", "x"}) {
    const std::size_t at = out.find(std::string(times) + "10");
    if (at == 0 || at == std::string::npos || !isFigure(out[at - 1])) continue;
    std::string power = out.substr(at + times.size() + 2);
    for (const auto& [sign, figure] : kSuperscripts)
      power = withAll(std::move(power), sign, figure);
    const bool caret = power.starts_with('^');
    if (caret) power.erase(0, 1);
    if (!power.empty() && (isFigure(power[0]) || power[0] == '-'))
      return out.substr(0, at) + 'e' + power;
  }
  return out;
}

/// "1_000" and "1,000.5" → "1000" and "1000.5", "½" → "0.5"; else the text as it is.
std::string withPlainFigures(std::string_view text) {
  std::string out(text);
  for (const auto& [sign, number] : {std::pair("½", "0.5"), {"¼", "0.25"}, {"¾", "0.75"}})
    if (text == sign) return number;
  const bool thousands = text.find('.') != std::string_view::npos;
  for (std::size_t at = 1; at + 3 < out.size(); ++at) {
    const bool separates = out[at] == '_' || (out[at] == ',' && thousands);
    const bool figures = isFigure(out[at - 1]) && isFigure(out[at + 1]) && isFigure(out[at + 2]) &&
                         isFigure(out[at + 3]);
    if (separates && figures) out.erase(at, 1);
  }
  return out;
}

}  // namespace

OddWriting oddWriting(std::string_view text) {
  for (const std::string_view blank : kOddBlanks)
    if (const std::size_t at = text.find(blank); at != std::string_view::npos)
      return {"has a blank that is no plain one, such as a no-break space", at, blank.size()};
  if (const std::size_t at = text.find_first_of(kOddBrackets); at != std::string_view::npos)
    return {"has brackets; numbers stand without", at, 1};
  if (const std::size_t at = text.find_first_of(kOddSeparators); at != std::string_view::npos) {
    const std::string sign(text.substr(at, 1));
    const std::string decimals = sign == "," ? ", decimals have a point" : "";
    return {"has \"" + sign + "\"; numbers stand between blanks" + decimals, at, 1};
  }
  if (const TimesSign sign = timesSign(text, 0); sign.length > 0)
    return {"has \"" + std::string(text.substr(sign.offset, sign.length)) +
                "\"; numbers stand between blanks",
            sign.offset, sign.length, true};
  // A unit that stands alone, after a number.
  bool number = false;
  for (std::size_t at = text.find_first_not_of(kBlanks); at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
    const std::string word(text.substr(at, end - at));
    if (number && !unitMeant(word).unit.empty())
      return {"has a blank before the unit \"" + word + '"', at, word.size(), true, true};
    number = !numberAndRest(word).number.empty();
    at = std::min(text.find_first_not_of(kBlanks, end), text.size());
  }
  return {};
}

std::vector<std::string> probableNumbers(std::string_view text) {
  std::vector<std::string> out;
  if (std::string unit = axisVector(text); !unit.empty()) out.push_back(std::move(unit));
  std::string plain(text);
  for (const std::string_view blank : kOddBlanks) plain = withAll(std::move(plain), blank, " ");
  const auto add = [&](bool decimalComma) {
    std::string blanks = withoutTimesSigns(plain);
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
  for (std::string other : {withWholeExponent(text), withExponents(text), withPlainFigures(text)})
    if (other != text) out.push_back(std::move(other));
  return out;
}

}  // namespace dynamy
