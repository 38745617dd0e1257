/// Values with braces: {expression} becomes a number. It is parsed with full error reports the
/// first time, and compiled for values that are used again.
#pragma once
#include <dynamy/core/expression/expression.hpp>
#include <dynamy/io/model/model_scope.hpp>
#include <optional>

namespace dynamy {

/// A value whose braces have been replaced by numbers, with the origin of each byte.
struct ResolvedText {
  struct Piece {
    std::size_t begin, size;              ///< of the number in `text`
    std::size_t sourceBegin, sourceSize;  ///< of the braces in the value
  };
  std::string text;
  std::vector<Piece> pieces;

  /// Appends the number that replaces bytes [begin, end) of the value; in a formula it gets
  /// parentheses.
  void add(double x, bool formula, std::size_t begin, std::size_t end);
  /// Replaces bytes [begin, end) of `text` by a word.
  void replace(std::size_t begin, std::size_t end, const std::string& word);
  /// The bytes of the original value, as offset and length, that the given bytes of `text` come
  /// from.
  std::pair<std::size_t, std::size_t> source(std::size_t offset, std::size_t length) const;
};

/// A value with braces whose expressions are compiled: for values that are used again with other
/// numbers, as in each turn of a replicate.
class CompiledBraces {
 public:
  /// Names with a number in `scope` become variables. Throws ExpressionError.
  CompiledBraces(std::string_view value, const Scope& scope);
  /// The value in `scope`; nothing if there is any error in this scope.
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

/// Replaces every {expression}; in a formula the number gets parentheses, and the name of a signal
/// stays as it is. Returns nothing if an
/// error was reported, or if the value uses a name whose own value is wrong.
std::optional<ResolvedText> resolveBraces(const XmlAttribute& attribute, const XmlNode& node,
                                          const Scope& scope, bool formula, Faults& faults);

/// Names inside the braces of a value, in order, including built-in names and functions.
std::vector<std::string> namesInBraces(std::string_view value);
/// Appends every word of a formula that looks like a name.
void namesIn(std::string_view formula, std::vector<std::string>& names);

}  // namespace dynamy
