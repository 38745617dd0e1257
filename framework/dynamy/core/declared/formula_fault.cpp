#include <dynamy/core/declared/formula_fault.hpp>
#include <string_view>

namespace dynamy {
namespace {

/// "a, b; c" and "a | b" → "a; b; c": what separates formulas outside of brackets, if it is not ";".
std::string withSemicolons(std::string_view text) {
  std::string out;
  int depth = 0;
  for (const char c : text) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    out += depth == 0 && (c == ',' || c == '|') ? ';' : c;
  }
  return out;
}

}  // namespace

std::string formulaHint(const ExpressionError& error) {
  if (!error.suggestion().empty()) return didYouMean(error.suggestion());
  const std::string message = error.message();
  constexpr std::string_view kUnknown = "unknown symbol \"";
  if (!message.starts_with(kUnknown)) return {};
  const std::string name =
      message.substr(kUnknown.size(), message.find('"', kUnknown.size()) - kUnknown.size());
  if (name.find_first_of(".{[/") != std::string::npos) return {};  // the name of a signal
  return "add <parameter name=\"" + name + "\" value=\"…\"/>";
}

ModelError formulaFault(const ParameterValue& value, const ValuePart& formula,
                        const ExpressionError& error) {
  return value.fault(error.message(), formulaHint(error), formula.offset + error.offset(),
                     error.length());
}

std::vector<ValuePart> formulasOf(const ParameterValue& value, int count) {
  std::vector<ValuePart> parts = value.parts(';');
  if (static_cast<int>(parts.size()) == count) return parts;
  ParameterValue better;
  better.text = withSemicolons(value.text);
  const bool meant = static_cast<int>(better.parts(';').size()) == count;
  throw value.fault(
      count == 1
          ? "one formula is needed, here are " + std::to_string(parts.size())
          : std::to_string(count) + " formulas separated by \";\" are needed, " +
                (parts.size() == 1 ? "here is 1" : "here are " + std::to_string(parts.size())),
      meant ? "write \"" + better.text + '"' : std::string(), 0, value.text.size());
}

}  // namespace dynamy
