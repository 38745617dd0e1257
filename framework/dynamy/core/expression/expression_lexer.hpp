/// Splits the text of an expression into tokens; numbers already carry their unit.
#pragma once

#include <cstddef>
#include <dynamy/core/expression/unit_suffix.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace dynamy {

enum class TokenKind {
  number,
  name,
  plus,
  minus,
  times,
  over,
  power,
  less,
  lessEqual,
  greater,
  greaterEqual,
  equal,
  notEqual,
  logicalAnd,
  logicalOr,
  logicalNot,
  question,
  colon,
  comma,
  open,
  close,
  end
};

struct Token {
  TokenKind kind = TokenKind::end;
  std::size_t offset = 0;                ///< first byte in the text
  std::size_t length = 0;                ///< bytes, 0 for end
  double value = 0.0;                    ///< of a number, in SI units
  UnitFamily family = UnitFamily::none;  ///< of the suffix of a number
  std::string_view unit = "";            ///< its suffix
};

/// All tokens, the last one of kind end. Raises ExpressionError: malformed number, unknown unit,
/// unexpected character, empty text.
std::vector<Token> tokenize(std::string_view text);

/// A name in a formula and its place.
struct NameInFormula {
  std::string name;  ///< without braces
  std::size_t offset = 0, length = 0;
};

/// The name of a token without the braces that may stand around it.
std::string_view bareName(std::string_view word);

/// Names with a dot, and names in braces, in their order: signals of the model. Formulas are
/// separated by ';' or '|'; one that is no row of tokens has none.
std::vector<NameInFormula> signalNames(std::string_view text);

/// True: the text is the name of a signal and no formula of numbers, as cart.x or left/arm[2].phi.
bool isSignalName(std::string_view text);

/// The token as an error message shows it: "x" in quotes, or: the end.
std::string describe(const Token& token, std::string_view text);

}  // namespace dynamy
