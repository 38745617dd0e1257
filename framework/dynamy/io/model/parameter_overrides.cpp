#include <dynamy/core/expression/expression.hpp>
#include <dynamy/core/expression/expression_error.hpp>
#include <dynamy/io/model/parameter_hint.hpp>
#include <dynamy/io/model/parameter_overrides.hpp>
#include <optional>

namespace dynamy {
namespace {

constexpr std::string_view kSweepValues = "--set NAME=A,B,C or --set NAME=FROM:TO:COUNT";

/// The value of an override: a number with or without unit, or an expression of numbers in braces.
/// Nothing: an error was reported.
std::optional<double> overrideValue(const std::string& text,
                                    const std::function<void(std::string)>& report) {
  if (text.starts_with('{') && text.ends_with('}')) {
    try {
      return evaluateConstant(std::string_view(text).substr(1, text.size() - 2), SymbolTable());
    } catch (const ExpressionError& e) {
      report(e.message());
      return std::nullopt;
    }
  }
  Attribute number;
  number.unit = Unit::any;
  ParameterValue value;
  value.declaration = &number;
  value.text = text;
  value.given = true;
  if (const auto fault = readValue(number, value)) {
    const bool computes = text.find_first_of("+*/^()") != std::string::npos,
               several = text.find_first_of(",:") != std::string::npos;
    report(several ? "one value is needed, with a point before decimals — dynamy sweep runs a "
                     "model with many: " +
                         std::string(kSweepValues)
           : computes ? fault->text + " — an expression stands in braces: '{" + text + "}'"
                      : fault->text);
    return std::nullopt;
  }
  return value.numbers[0];
}

}  // namespace

void ParameterOverrides::apply(Scope& scope, ParameterEvaluator& evaluator, Faults& faults) {
  for (const std::string& name : evaluator.names()) known_.push_back(scope.prefix + name);
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const auto& [name, text] = values_[i];
    if (!name.starts_with(scope.prefix)) continue;
    const std::string local = name.substr(scope.prefix.size());
    if (!evaluator.has(local)) continue;
    const bool first = !used_[i];
    used_[i] = true;
    const auto report = [&faults, name = name, text = text, first](const std::string& fault) {
      if (first) faults.add({.text = "--set " + name + '=' + text + ": " + fault});
    };
    if (const auto value = overrideValue(text, report))
      evaluator.replace({local, *value, report});
    else
      scope.broken.insert(local);
  }
}

void ParameterOverrides::reportUnused(const XmlNode& root, Faults& faults) const {
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (!used_[i])
      faults.add({.text = "--set " + values_[i].first + '=' + values_[i].second +
                          ": no parameter \"" + values_[i].first + '"',
                  .hint = parameterHint(root, values_[i].first, known_)});
}

}  // namespace dynamy
