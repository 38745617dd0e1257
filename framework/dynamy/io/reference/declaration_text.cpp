#include <fmt/format.h>

#include <cmath>
#include <dynamy/io/reference/declaration_text.hpp>

namespace dynamy {

std::string typeText(const Attribute& a) {
  switch (a.type) {
    case AttributeType::number:
      return "number";
    case AttributeType::integer:
      return "integer";
    case AttributeType::flag:
      return "true | false";
    case AttributeType::choice:
      return fmt::format("{}", fmt::join(a.choices, " | "));
    case AttributeType::text:
      return "text";
    case AttributeType::name:
      return "name";
    case AttributeType::reference:
      return "name of a " + a.referenceKind;
    case AttributeType::vector:
      return a.size == 0 ? "numbers" : std::to_string(a.size) + " numbers";
    case AttributeType::names:
      return "names";
    case AttributeType::expression:
      return "formula";
    case AttributeType::expressions:
      return "formulas; …";
  }
  return "text";
}

std::string defaultText(const Attribute& a) {
  if (a.defaultValue) return a.defaultValue->empty() ? "-" : *a.defaultValue;
  return a.optionalValue ? "-" : "required";
}

std::string rangeText(const Attribute& a) {
  const bool low = std::isfinite(a.min), high = std::isfinite(a.max);
  std::string out;
  if (low && high && !a.minOpen && !a.maxOpen) {
    out = numberText(a.min) + " … " + numberText(a.max);
  } else {
    if (low) out = (a.minOpen ? "> " : ">= ") + numberText(a.min);
    if (high) out += (low ? ", " : "") + ((a.maxOpen ? "< " : "<= ") + numberText(a.max));
  }
  if (a.nonZero) out += out.empty() ? "not zero" : ", not zero";
  return out.empty() ? "-" : out;
}

std::string countText(const ChildRule& rule) {
  if (rule.min == rule.max) return std::to_string(rule.min);
  if (rule.max >= 1000)
    return rule.min == 0 ? "any number of" : std::to_string(rule.min) + " or more";
  return fmt::format("{} to {}", rule.min, rule.max);
}

}  // namespace dynamy
