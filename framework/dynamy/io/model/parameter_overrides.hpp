/// ParameterOverrides: values of parameters that are set from outside of the model (--set).
#pragma once
#include <dynamy/io/model/parameter_evaluator.hpp>

namespace dynamy {

/// Parameters set from outside: (name, value as text). In an included file the name has its prefix.
using Overrides = std::vector<std::pair<std::string, std::string>>;

class ParameterOverrides {
 public:
  explicit ParameterOverrides(const Overrides& values)
      : values_(values), used_(values.size(), false) {}
  /// Replaces the parameters of one file that are set from outside. A faulty value is reported once
  /// and makes its parameter broken.
  void apply(Scope& scope, ParameterEvaluator& evaluator, Faults& faults);
  /// Reports those whose parameter no file has had.
  void reportUnused(const XmlNode& root, Faults& faults) const;

 private:
  Overrides values_;
  std::vector<bool> used_;
  std::vector<std::string> known_;  // parameters of all files, for hints
};

}  // namespace dynamy
