/// Names that an expression may use: variables (slots of an input array) and constants (values
/// known when compiling).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

/// Name → slot or value. A name defined again gets the new meaning, so that an inner scope can
/// shadow an outer one. A name here shadows the built-in constants pi and e.
class SymbolTable {
 public:
  struct Symbol {
    bool isVariable = false;
    int slot = 0;        ///< index into the array of inputs, variables only
    double value = 0.0;  ///< constants only
    bool hides = false;  ///< a variable with the name of a constant that was defined before
  };

  /// Defines a variable in the next free slot and returns this slot.
  int variable(const std::string& name);

  /// Defines a second name for a slot ≥ 0, or a variable in a slot chosen by the caller.
  void variable(const std::string& name, int slot);

  void constant(const std::string& name, double value);

  /// The symbol, or nullptr; valid until the table changes.
  const Symbol* find(std::string_view name) const;

  /// Length of the array of inputs: highest slot + 1.
  int variableCount() const { return variableCount_; }

  /// All names, sorted.
  std::vector<std::string> names() const;

 private:
  std::map<std::string, Symbol, std::less<>> symbols_;
  int variableCount_ = 0;
};

}  // namespace dynamy
