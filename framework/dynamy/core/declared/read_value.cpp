/// Reads the text of a value as its declaration requires: numbers with suffixes of the right family
/// of units, ranges, words of a list. Each fault says what was expected and what was found.

#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/declared/written_numbers.hpp>
#include <dynamy/core/expression/expression_error.hpp>
#include <dynamy/core/expression/unit_suffix.hpp>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/core/utf8.hpp>
#include <limits>
#include <numbers>

namespace dynamy {
namespace {

struct ReadWord {
  std::string_view text;
  std::size_t offset = 0;
};

std::vector<ReadWord> split(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n";
  std::vector<ReadWord> out;
  for (std::size_t i = text.find_first_not_of(kSpace); i != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kSpace, i), text.size());
    out.push_back({text.substr(i, end - i), i});
    i = text.find_first_not_of(kSpace, end);
  }
  return out;
}

/// The family of suffixes that a declared unit accepts.
UnitFamily family(Unit unit) {
  switch (unit) {
    case Unit::none:
    case Unit::any:
    case Unit::angularImpulse:
      return UnitFamily::none;
    case Unit::length:
      return UnitFamily::length;
    case Unit::angle:
      return UnitFamily::angle;
    case Unit::time:
      return UnitFamily::time;
    case Unit::mass:
      return UnitFamily::mass;
    case Unit::inertia:
      return UnitFamily::inertia;
    case Unit::velocity:
      return UnitFamily::velocity;
    case Unit::angularVelocity:
      return UnitFamily::angularVelocity;
    case Unit::acceleration:
      return UnitFamily::acceleration;
    case Unit::force:
      return UnitFamily::force;
    case Unit::torque:
      return UnitFamily::moment;
    case Unit::stiffness:
      return UnitFamily::stiffness;
    case Unit::damping:
      return UnitFamily::damping;
    case Unit::rotationalStiffness:
      return UnitFamily::angularStiffness;
    case Unit::rotationalDamping:
      return UnitFamily::angularDamping;
    case Unit::density:
      return UnitFamily::density;
    case Unit::frequency:
      return UnitFamily::frequency;
    case Unit::impulse:
      return UnitFamily::impulse;
    case Unit::energy:
      return UnitFamily::energy;
    case Unit::power:
      return UnitFamily::power;
  }
  return UnitFamily::none;
}

std::string expectedNumber(Unit unit) {
  if (unit == Unit::any) return "a number";
  if (unit == Unit::none) return "a number without unit";
  return std::string(unitFamilyText(unit)) + " [" + std::string(unitText(unit)) + ']';
}

/// The range in words: `> 0`, `>= 0`, `between 0 and 1`.
std::string rangeText(const Attribute& a, bool below) {
  if (std::isfinite(a.min) && std::isfinite(a.max) && !a.minOpen && !a.maxOpen)
    return "between " + numberText(a.min) + " and " + numberText(a.max);
  if (below) return (a.minOpen ? "> " : ">= ") + numberText(a.min);
  return (a.maxOpen ? "< " : "<= ") + numberText(a.max);
}

std::optional<std::string> outOfRange(const Attribute& a, double x) {
  const bool below = x < a.min || (a.minOpen && x == a.min);
  const bool above = x > a.max || (a.maxOpen && x == a.max);
  if (!below && !above) return std::nullopt;
  return "must be " + rangeText(a, below) + ", is " + numberText(x);
}

constexpr std::string_view kUnread = "cannot be read: ";

/// True: the attribute accepts a number with a unit of this family.
bool fits(UnitFamily given, const Attribute& a) {
  return given == UnitFamily::none || a.unit == Unit::any || given == family(a.unit);
}

/// "0.3" for the number "30" before a per cent sign; "" if it is none.
std::string shareOf(std::string_view number) {
  try {
    const Quantity percent = parseQuantity(number);
    return percent.family == UnitFamily::none ? numberText(percent.value / 100.0) : std::string();
  } catch (const ExpressionError&) {
    return {};
  }
}

/// "its units are "N/m", "N/mm"": those of a family; "" if it has none.
std::string unitsOf(UnitFamily wanted) {
  std::vector<std::string> names;
  if (wanted == UnitFamily::none) return {};
  for (const std::string& name : unitSuffixes()) {
    const auto unit = parseUnitSuffix(name);
    if (unit && unit->family == wanted) names.push_back(name);
  }
  return names.empty() ? std::string() : "its units are " + quotedList(names);
}

/// The hint for a word that is no number: the word that was misspelt, a fitting unit without its
/// number, or a parameter or formula without braces ("h" is no position in hours).
std::string whatToWrite(const Attribute& a, std::string_view word, const ExpressionError& e) {
  if (word.ends_with('%'))
    if (const std::string share = shareOf(word.substr(0, word.size() - 1)); !share.empty())
      return "write " + share;
  if (!e.suggestion().empty()) return didYouMean(e.suggestion());
  if (word == "-" || word == "+")
    return "a sign stands before its number without a blank, and a formula in braces: {1 - e}";
  if (e.message().starts_with("malformed number")) return "numbers are 12, -0.5 or 1.2e-3";
  if (word.starts_with("$")) {  // ${x}, whose braces are replaced already, and $x
    const bool number = word.find_first_of("0123456789.-") == 1;
    return "a parameter stands in braces, without \"$\"" +
           (number ? std::string() : ": {" + std::string(word.substr(1)) + '}');
  }
  const std::size_t sign = word.starts_with('-') || word.starts_with('+') ? 1 : 0;
  const bool name = e.offset() <= sign && word.find_first_of("0123456789", sign) != sign;
  const auto unit = parseUnitSuffix(word);
  if (unit && fits(unit->family, a))
    return "a number stands before its unit: 1" + std::string(word);
  if (e.message().starts_with("unknown unit"))
    if (std::string units = unitsOf(family(a.unit)); !units.empty()) return units;
  const bool computes = word.find_first_of("+*/^(") != std::string_view::npos;
  if (!name && !computes) return {};
  return "a parameter or a formula stands in braces: {" + std::string(word) + '}';
}

/// Angles up to here are taken without a unit [rad]: one and a half turns, below all of 10, 15, 20 …
constexpr double kMostRadians = 3.0 * std::numbers::pi;

/// A number of the wrong family of units, or an angle of a file that was probably meant in degrees.
std::optional<ValueFault> unitFault(const Attribute& a, const ReadWord& word, const Quantity& x,
                                    bool ofFile) {
  if (!fits(x.family, a))
    return ValueFault{
        "expects " + expectedNumber(a.unit) + ", has [" + std::string(siUnit(x.family)) + ']',
        a.unit == Unit::none && a.type == AttributeType::vector ? a.text : "", word.offset,
        word.text.size()};
  const bool radians = a.unit == Unit::angle && x.family == UnitFamily::none;
  if (!ofFile || !radians || !(std::abs(x.value) > kMostRadians)) return std::nullopt;
  const std::string text(word.text);
  return ValueFault{"is in radians and turns more than once around",
                    text + "deg is an angle in degrees, " + text + "rad one of several turns",
                    word.offset, word.text.size()};
}

/// Formulas that are one number with a unit each: the unit is that of the attribute, if it has one.
std::optional<ValueFault> readFormulas(const Attribute& a, const ParameterValue& value) {
  if (a.unit == Unit::none) return std::nullopt;
  for (const ValuePart& part : value.parts(';')) {
    // "2t" is no mass where t is the time: compiling it says so.
    const std::size_t last = part.text.find_last_not_of('t');
    if (last != std::string::npos && last + 2 == part.text.size() && part.text[last] >= '0' &&
        part.text[last] <= '9')
      continue;
    try {
      const ReadWord word{part.text, part.offset};
      if (auto fault = unitFault(a, word, parseQuantity(part.text), bool(value.locate)))
        return fault;
    } catch (const ExpressionError&) {
      continue;  // the element compiles it
    }
  }
  return std::nullopt;
}

/// Reads one number with its suffix; the range applies to `given` values only.
std::optional<ValueFault> readNumber(const Attribute& a, const ReadWord& word,
                                     const ParameterValue& value, double& x) {
  const bool given = value.given;
  const auto fault = [&](std::string text) {
    return ValueFault{std::move(text), {}, word.offset, word.text.size()};
  };
  const std::string plain = inLowerCase(word.text);
  const bool infinite = plain == "inf" || plain == "-inf" || plain == "infinity";
  if (infinite) {
    // Infinity is accepted only if the declaration names the word; else steps would be nonsense.
    const bool admitted = std::find(a.choices.begin(), a.choices.end(), plain) != a.choices.end();
    if (given && !admitted) return fault("must be finite, is " + std::string(word.text));
    if (word.text != "inf" && word.text != "-inf") return fault("infinity is written inf");
    x = word.text == "inf" ? kInfinity : -kInfinity;
  } else if (plain == "nan") {
    if (given) return fault("must be a number, is " + std::string(word.text));
    x = std::numeric_limits<double>::quiet_NaN();
  } else {
    try {
      const Quantity quantity = parseQuantity(word.text);
      x = quantity.value;
      if (!std::isfinite(x))
        return fault("the number " + std::string(word.text) + " is out of range");
      if (auto wrong = unitFault(a, word, quantity, given && value.locate)) return wrong;
    } catch (const ExpressionError& e) {
      return ValueFault{std::string(kUnread) + e.message(), whatToWrite(a, word.text, e),
                        word.offset + e.offset(), e.length()};
    }
  }
  if (given)
    if (auto range = outOfRange(a, x)) return fault(std::move(*range));
  return std::nullopt;
}

/// What the numbers are, as the hint where there are too few or too many.
std::string whatTheyAre(const Attribute& a) {
  const std::string unit(unitText(a.unit));
  return a.text.empty() || unit == "-" ? a.text : a.text + " [" + unit + ']';
}

/// "2 000" → "2000": groups of three figures, where one number is expected; else "".
std::string withoutGroups(const std::vector<ReadWord>& words) {
  std::string out;
  for (const ReadWord& word : words) {
    const bool figures = word.text.find_first_not_of("0123456789") == std::string_view::npos;
    if (!out.empty() && (!figures || word.text.size() != 3)) return {};
    if (out.empty() && (!figures || word.text.size() > 3)) return {};
    out += word.text;
  }
  return words.size() > 1 ? out : std::string();
}

std::string counted(std::size_t n) { return std::to_string(n) + (n == 1 ? " number" : " numbers"); }

std::optional<ValueFault> readWords(const Attribute& a, ParameterValue& value) {
  const std::vector<ReadWord> words = split(value.text);
  const std::size_t expected =
      a.type == AttributeType::vector ? static_cast<std::size_t>(a.size) : 1;
  const ValueFault whole{{}, {}, 0, value.text.size()};

  // Check each word by itself, then the number of words.
  value.numbers.clear();
  for (const ReadWord& word : words) {
    double x = 0.0;
    if (auto fault = readNumber(a, word, value, x)) return fault;
    if (a.type == AttributeType::integer && (x != std::round(x) || std::abs(x) > 2147483647.0))
      return ValueFault{"expects a whole number, is " + std::string(word.text),
                        {},
                        word.offset,
                        word.text.size()};
    value.numbers.push_back(x);
  }
  if (expected != 0 && words.size() != expected) {
    ValueFault fault = whole;
    fault.text = "expects " + (expected == 1 ? std::string("1 number") : counted(expected)) +
                 ", has " + (words.empty() ? "none" : std::to_string(words.size()));
    const std::string joined = expected == 1 ? withoutGroups(words) : std::string();
    fault.hint = joined.empty() ? whatTheyAre(a) : "write \"" + joined + '"';
    return fault;
  }

  // A vector that must not vanish.
  if (a.nonZero && value.given) {
    bool zero = true;
    for (const double x : value.numbers) zero = zero && x == 0.0;
    if (zero) {
      ValueFault fault = whole;
      fault.text = "must not be zero";
      return fault;
    }
  }
  return std::nullopt;
}

/// Reads numbers. If they cannot be read because they are written in another way, the fault says so
/// and how to write them.
/// True: a word, with brackets or without, begins with a letter.
bool hasName(std::string_view text) {
  const std::size_t at = text.find_first_not_of("0123456789.,+-()[] ");
  return at != std::string_view::npos && (at == 0 || text[at - 1] < '0' || text[at - 1] > '9');
}

std::optional<ValueFault> readNumbers(const Attribute& a, ParameterValue& value) {
  auto fault = readWords(a, value);
  if (!fault) return fault;
  const OddWriting odd = oddWriting(value.text);
  const bool unread = fault->text.starts_with(kUnread);
  if (!unread && odd.text.empty()) return fault;
  std::string hint;
  std::vector<std::string> probable = probableNumbers(value.text);
  if (a.type == AttributeType::vector && a.size > 1) {  // "1/2/3"; a single 1/2 is a formula
    probable.push_back(value.text);
    std::replace(probable.back().begin(), probable.back().end(), '/', ' ');
  }
  for (const std::string& text : probable) {
    ParameterValue better;
    better.text = text, better.given = value.given;
    if (text == value.text || readWords(a, better)) continue;
    hint = "write \"" + text + '"';
    break;
  }
  // A word counts as a unit only if this unit fits: "0 0 h" is no position in hours.
  const bool meant = !odd.text.empty() && !(odd.guess && hint.empty());
  if (meant) fault = ValueFault{odd.text, {}, odd.offset, odd.length};
  if (!meant && odd.unit && a.type != AttributeType::vector) {  // "3 Hz" is no length
    ParameterValue joined;
    joined.text = value.text.substr(0, value.text.find_last_not_of(' ', odd.offset - 1) + 1) +
                  value.text.substr(odd.offset, odd.length);
    joined.given = value.given;
    if (auto other = readWords(a, joined))
      fault = ValueFault{other->text, other->hint, 0, value.text.size()};
  }
  if (!hint.empty()) fault->hint = hint;
  if (fault->hint.empty() && odd.text.starts_with("has brackets") && hasName(value.text))
    fault->hint = "a parameter or a formula stands in braces, such as {h}";
  return fault;
}

/// Names stand between blanks; a name may hold a comma, but not end with one.
std::optional<ValueFault> readNames(const ParameterValue& value) {
  constexpr std::string_view kSeparators = ",;|";
  const std::vector<ReadWord> words = split(value.text);
  const auto wrong = std::find_if(words.begin(), words.end(), [&](const ReadWord& w) {
    return kSeparators.find(w.text.front()) != std::string_view::npos ||
           kSeparators.find(w.text.back()) != std::string_view::npos;
  });
  if (wrong == words.end()) return std::nullopt;
  const std::size_t at = wrong->offset + wrong->text.find_first_of(kSeparators);
  std::string better = value.text;
  for (char& c : better)
    if (kSeparators.find(c) != std::string_view::npos) c = ' ';
  std::string text;
  for (const ReadWord& word : split(better))
    text += (text.empty() ? "" : " ") + std::string(word.text);
  return ValueFault{"has \"" + value.text.substr(at, 1) + "\"; names stand between blanks",
                    "write \"" + text + '"', at, 1};
}

std::optional<ValueFault> readWord(const std::vector<std::string>& words, const std::string& text,
                                   const std::string& expected) {
  for (const std::string& w : words)
    if (w == text) return std::nullopt;
  return ValueFault{"expects " + expected + ", is \"" + text + '"', unknownNameHint(text, words), 0,
                    text.size()};
}

}  // namespace

std::optional<ValueFault> readValue(const Attribute& a, ParameterValue& value) {
  switch (a.type) {
    case AttributeType::number:
    case AttributeType::integer:
    case AttributeType::vector:
      return readNumbers(a, value);
    case AttributeType::flag:
      if (value.text == "true" || value.text == "false") return std::nullopt;
      return ValueFault{"expects true or false, is \"" + value.text + '"',
                        didYouMean(nearest(value.text, std::vector<std::string>{"true", "false"})),
                        0, value.text.size()};
    case AttributeType::choice: {
      auto fault = readWord(a.choices, value.text, "one of " + quotedList(a.choices));
      if (fault && fault->hint.starts_with("known")) fault->hint.clear();  // the text lists them
      return fault;
    }
    case AttributeType::name:
    case AttributeType::reference:
      if (value.given && value.text.empty())
        return ValueFault{"expects a name, is empty", {}, 0, 0};
      return std::nullopt;
    case AttributeType::names:
      return readNames(value);
    case AttributeType::text:
      return std::nullopt;
    case AttributeType::expression:
    case AttributeType::expressions:
      return readFormulas(a, value);
  }
  return std::nullopt;
}

}  // namespace dynamy
