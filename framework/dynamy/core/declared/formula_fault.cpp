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

/// "0 0 2*sin(t)" → "0; 0; 2*sin(t)": the words of a text without separators, if each of them may be a
/// formula; else the text.
std::string wordsWithSemicolons(std::string_view text) {
  std::vector<std::string> words(1);
  int depth = 0;
  for (const char c : text) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (depth == 0 && (c == ' ' || c == '\t' || c == '\n')) {
      if (!words.back().empty()) words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  if (words.back().empty()) words.pop_back();
  std::string out;
  for (const std::string& word : words) {
    constexpr std::string_view kOperators = "*/^<>=&|?:,;";
    const bool part = kOperators.find(word.front()) != std::string_view::npos ||
                      kOperators.find(word.back()) != std::string_view::npos ||
                      word.back() == '+' || word.back() == '-' || word == "and" || word == "or";
    if (part) return std::string(text);
    out += (out.empty() ? "" : "; ") + word;
  }
  return out;
}

}  // namespace

std::string formulaHint(const ExpressionError& error) {
  if (!error.suggestion().empty()) return didYouMean(error.suggestion());
  const std::string message = error.message();
  if (message.starts_with("unknown function "))
    return "a function given by points is <Table of=\"…\" points=\"…\">, in <forces>; its signal "
           "is "
           "NAME.out";
  constexpr std::string_view kUnknown = "unknown symbol \"";
  if (!message.starts_with(kUnknown)) return {};
  const std::string name =
      message.substr(kUnknown.size(), message.find('"', kUnknown.size()) - kUnknown.size());
  if (name.find_first_of(".{[/") != std::string::npos) return {};  // the name of a signal
  return "add <parameter name=\"" + name + "\" value=\"…\"/>";
}

ModelError formulaFault(const ParameterValue& value, const ValuePart& formula,
                        const ExpressionError& error) {
  std::string hint = formulaHint(error);
  if (hint.starts_with("add <parameter ")) {
    const std::size_t name = hint.find('"') + 1;
    hint +=
        "; a signal of an element is " + hint.substr(name, hint.find('"', name) - name) + ".NAME";
  }
  return value.fault(error.message(), std::move(hint), formula.offset + error.offset(),
                     error.length());
}

std::vector<ValuePart> formulasOf(const ParameterValue& value, int count) {
  std::vector<ValuePart> parts = value.parts(';');
  if (static_cast<int>(parts.size()) == count) return parts;
  ParameterValue better;
  better.text = withSemicolons(value.text);
  bool meant = static_cast<int>(better.parts(';').size()) == count;
  if (!meant) {
    better.text = wordsWithSemicolons(value.text);
    meant = static_cast<int>(better.parts(';').size()) == count;
  }
  std::string zeros = "0";
  for (int i = 1; i < count; ++i) zeros += "; 0";
  throw value.fault(
      count == 1
          ? "one formula is needed, here are " + std::to_string(parts.size())
          : std::to_string(count) + " formulas separated by \";\" are needed, " +
                (parts.size() == 1 ? "here is 1" : "here are " + std::to_string(parts.size())),
      meant           ? "write \"" + better.text + '"'
      : parts.empty() ? "write \"" + zeros + '"'
                      : std::string(),
      0, value.text.size());
}

}  // namespace dynamy
