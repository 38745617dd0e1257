/// Values with braces: {expression} becomes a number, read step by step the first time, with its
/// errors, and compiled for values that come back.
#pragma once
#include <dynamy/core/expression/expression.hpp>
#include <dynamy/io/model/model_scope.hpp>
#include <optional>

namespace dynamy {

/// A value after its braces were replaced by numbers; knows where each byte came from.
struct ResolvedText {
  struct Piece {
    std::size_t begin, size;              ///< of the number in `text`
    std::size_t sourceBegin, sourceSize;  ///< of the braces in the value
  };
  std::string text;
  std::vector<Piece> pieces;

  /// Appends the number that stands for bytes [begin, end) of the value; in a formula with
  /// parentheses.
  void add(double x, bool formula, std::size_t begin, std::size_t end);
  /// Bytes of the value in the file that bytes of `text` came from.
  std::pair<std::size_t, std::size_t> source(std::size_t offset, std::size_t length) const;
};

/// A value with braces whose expressions are compiled: for values that come back with other
/// numbers, as those of a replicate do in each of its turns.
class CompiledBraces {
 public:
  /// Names with a number in `scope` become variables. Raises ExpressionError.
  CompiledBraces(std::string_view value, const Scope& scope);
  /// Nothing: something is wrong in this scope, whatever it is.
  std::optional<ResolvedText> resolved(const Scope& scope, bool formula);

 private:
  struct Part {
    std::size_t begin, end;  // of the braces in the value
  };
  /// Fills names_ and parts_.
  ExpressionSet compiled(const Scope& scope);

  std::string value_;
  std::vector<std::string> names_;  // of the inputs
  std::vector<Part> parts_;
  ExpressionSet set_;
  ExpressionWorkspace work_;
  std::vector<double> x_, numbers_;
};

/// Replaces every {expression}; in a formula the number gets parentheses. Nothing: an error was
/// reported, or the value uses a name that is wrong itself.
std::optional<ResolvedText> resolveBraces(const XmlAttribute& attribute, const XmlNode& node,
                                          const Scope& scope, bool formula, Faults& faults);

/// Names inside the braces of a value, in order; built-in ones and functions included.
std::vector<std::string> namesInBraces(std::string_view value);
/// Appends every word of a formula that looks like a name.
void namesIn(std::string_view formula, std::vector<std::string>& names);

}  // namespace dynamy
