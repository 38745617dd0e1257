#include <array>
#include <charconv>
#include <dynamy/core/expression/expression_error.hpp>
#include <dynamy/core/expression/expression_lexer.hpp>
#include <dynamy/core/other_words.hpp>
#include <dynamy/core/suggestion.hpp>
#include <system_error>

namespace dynamy {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Letters of names; bytes beyond ASCII belong to UTF-8 letters such as φ and μ.
bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c & 0x80) != 0;
}

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::string quoted(std::string_view word) { return "\"" + std::string(word) + "\""; }

struct Symbol {
  std::string_view text;
  TokenKind kind;
};

/// A longer symbol stands before the symbols that it begins with.
constexpr auto kSymbols = std::to_array<Symbol>({
    {"<=", TokenKind::lessEqual},   {">=", TokenKind::greaterEqual}, {"==", TokenKind::equal},
    {"!=", TokenKind::notEqual},    {"&&", TokenKind::logicalAnd},   {"||", TokenKind::logicalOr},
    {"+", TokenKind::plus},         {"-", TokenKind::minus},         {"*", TokenKind::times},
    {"/", TokenKind::over},         {"^", TokenKind::power},         {"<", TokenKind::less},
    {">", TokenKind::greater},      {"!", TokenKind::logicalNot},    {"?", TokenKind::question},
    {":", TokenKind::colon},        {",", TokenKind::comma},         {"(", TokenKind::open},
    {")", TokenKind::close},        {"and", TokenKind::logicalAnd},  {"or", TokenKind::logicalOr},
    {"not", TokenKind::logicalNot},
});

struct Replacement {
  std::string_view wrong;
  std::string_view right;
};

/// Signs of other notations, and the signs to write here.
constexpr auto kReplacements = std::to_array<Replacement>({
    {"**", "^"},
    {"=", "=="},
    {"&", "&&"},
    {"|", "||"},
    {"%", "mod"},
    {"−", "-"},
    {"–", "-"},
    {"×", "*"},
    {"·", "*"},
    {"÷", "/"},
    {"≤", "<="},
    {"≥", ">="},
    {"²", "^2"},
    {"³", "^3"},
    {"[", "("},
    {"]", ")"},
    {"π", "pi"},
    {"√", "sqrt"},
});

class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) {}

  std::vector<Token> run() {
    std::vector<Token> tokens;
    tokens.reserve(text_.size() / 2 + 2);  // enough for most texts
    while (true) {
      while (at_ < text_.size() && isBlank(text_[at_])) ++at_;
      if (at_ == text_.size()) break;
      tokens.push_back(next());
    }
    if (tokens.empty()) throw ExpressionError("the expression is empty", 0, text_.size());
    tokens.push_back({TokenKind::end, text_.size(), 0});
    return tokens;
  }

 private:
  char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  std::string_view rest() const { return text_.substr(at_); }

  Token next() {
    if (peek() == '{') return bracedName();
    if (isDigit(peek()) || (peek() == '.' && isDigit(peek(1)))) return number();
    for (const Replacement& r : kReplacements) {
      // π is a good name if the model defines it, so the parser decides on letters that can stand
      // in names.
      if (r.wrong.front() != peek() || r.wrong == "π") continue;
      if (r.wrong == "[" && at_ > 0 && (isLetter(text_[at_ - 1]) || isDigit(text_[at_ - 1])))
        refuseIndex();
      if (rest().starts_with(r.wrong) && !rest().starts_with("==") && !rest().starts_with("&&") &&
          !rest().starts_with("||")) {
        throw ExpressionError("unexpected character " + quoted(r.wrong), at_, r.wrong.size(),
                              std::string(r.right));
      }
    }
    if (isLetter(peek())) return name();
    for (const Symbol& s : kSymbols) {
      if (s.text.front() != peek() || !rest().starts_with(s.text)) continue;
      const Token token{s.kind, at_, s.text.size()};
      at_ += s.text.size();
      return token;
    }
    throw ExpressionError("unexpected character " + quoted(rest().substr(0, 1)), at_, 1);
  }

  /// Only names of signals have an index, with a dot behind it: q[0] is none.
  [[noreturn]] void refuseIndex() const {
    const std::string name = inBraces();
    if (!name.empty() && name.find('.') == std::string::npos)
      throw ExpressionError(quoted(name.substr(1, name.size() - 2)) +
                                " is no signal, which has a name such as ball.z or disc[3].z",
                            at_, 1);
    throw ExpressionError("a name with an index stands in braces", at_, 1, name);
  }

  /// "{disc[3].z}": the name around the index that begins here.
  std::string inBraces() const {
    const auto ofName = [&](char c) { return isLetter(c) || isDigit(c) || c == '.'; };
    std::size_t begin = at_, end = text_.find(']', at_);
    while (begin > 0 && ofName(text_[begin - 1])) --begin;
    if (end == std::string_view::npos) return {};
    for (++end; end < text_.size() && ofName(text_[end]);) ++end;
    return '{' + std::string(text_.substr(begin, end - begin)) + '}';
  }

  /// letter (letter | digit)*, parts joined by dots as in toy.phiM; and, or, not are operators.
  Token name() {
    const std::size_t begin = at_;
    while (isLetter(peek()) || isDigit(peek()) || (peek() == '.' && isLetter(peek(1)))) ++at_;
    Token token{TokenKind::name, begin, at_ - begin};
    const std::string_view word = text_.substr(begin, token.length);
    for (const Symbol& s : kSymbols) {
      if (s.text.front() == word.front() && s.text == word) token.kind = s.kind;
    }
    return token;
  }

  /// { name }: a name with / or [ ], which would be operators elsewhere.
  Token bracedName() {
    const std::size_t end = text_.find('}', at_);
    if (end == std::string_view::npos)
      throw ExpressionError("unexpected character " + quoted("{"), at_, 1);
    const Token token{TokenKind::name, at_, end + 1 - at_};
    at_ = end + 1;
    return token;
  }

  /// digits [. digits] [e [sign] digits] [unit]
  Token number() {
    const std::size_t begin = at_;
    while (isDigit(peek())) ++at_;
    if (peek() == '.') ++at_;
    while (isDigit(peek())) ++at_;
    if (peek() == 'e' || peek() == 'E') exponent(begin);
    if (peek() == '.') malformed(begin);

    Token token{TokenKind::number, begin, at_ - begin};
    const char* first = text_.data() + begin;
    const char* last = text_.data() + at_;
    const auto [stop, error] = std::from_chars(first, last, token.value);
    if (error == std::errc::result_out_of_range) {
      throw ExpressionError(
          "the number " + quoted(text_.substr(begin, at_ - begin)) + " is out of range", begin,
          at_ - begin);
    }
    if (error != std::errc() || stop != last) malformed(begin);
    if (isLetter(peek())) unit(token);
    return token;
  }

  void exponent(std::size_t begin) {
    const bool hasSign = peek(1) == '+' || peek(1) == '-';
    if (isDigit(peek(hasSign ? 2 : 1))) {
      at_ += hasSign ? 2 : 1;
      while (isDigit(peek())) ++at_;
    } else if (!isLetter(peek(1))) {
      malformed(begin);
    }
  }

  [[noreturn]] void malformed(std::size_t begin) {
    while (isDigit(peek()) || isLetter(peek()) || peek() == '.') ++at_;
    if (at_ == begin) ++at_;
    throw ExpressionError("malformed number " + quoted(text_.substr(begin, at_ - begin)), begin,
                          at_ - begin);
  }

  /// Length of letters and digits from an offset ahead of here.
  std::size_t wordLength(std::size_t ahead) const {
    std::size_t n = 0;
    if (!isLetter(peek(ahead))) return 0;
    while (isLetter(peek(ahead + n)) || isDigit(peek(ahead + n))) ++n;
    return n;
  }

  /// Reads the longer of "word/word" and "word" that is a unit: 3m/s is a speed, 3m/l a quotient.
  void unit(Token& token) {
    const std::size_t begin = at_;
    const std::size_t first = wordLength(0);
    std::size_t length = first;
    std::optional<UnitSuffix> suffix;
    if (peek(first) == '/') {
      const std::size_t second = wordLength(first + 1);
      const bool isCall = peek(first + 1 + second) == '(';
      if (second > 0 && !isCall) suffix = parseUnitSuffix(text_.substr(begin, first + 1 + second));
      if (suffix) length = first + 1 + second;
    }
    if (!suffix) suffix = parseUnitSuffix(text_.substr(begin, first));
    const std::string_view word = text_.substr(begin, length);
    if (!suffix) {
      std::string ours = unitOfOthers(word);
      if (!parseUnitSuffix(ours)) ours = nearest(word, unitSuffixes());
      const std::string value = unitInOurs(word);
      if (!value.empty()) ours.clear();
      throw ExpressionError(
          "unknown unit " + quoted(word) + " after a number" + (value.empty() ? "" : ", " + value),
          begin, length, std::move(ours));
    }
    at_ += length;
    // 2mm^2 reads as (2mm)^2 to a program and as 2 mm² to an engineer.
    if (peek() == '^') {
      const std::string literal(text_.substr(token.offset, at_ - token.offset));
      throw ExpressionError("a power directly after a unit is ambiguous", at_, 1,
                            "(" + literal + ")^");
    }
    token.value *= suffix->factor;
    token.family = suffix->family;
    token.unit = word;
    token.length = at_ - token.offset;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<Token> tokenize(std::string_view text) { return Lexer(text).run(); }

std::string_view bareName(std::string_view word) {
  if (word.size() < 2 || word.front() != '{') return word;
  word = word.substr(1, word.size() - 2);
  while (!word.empty() && isBlank(word.front())) word.remove_prefix(1);
  while (!word.empty() && isBlank(word.back())) word.remove_suffix(1);
  return word;
}

namespace {

/// Of one formula, which begins at `begin` of the text.
void addSignalNames(std::string_view text, std::size_t begin, std::vector<NameInFormula>& out) {
  std::vector<Token> tokens;
  try {
    tokens = tokenize(text);
  } catch (const ExpressionError&) {
    return;
  }
  for (const Token& token : tokens) {
    if (token.kind != TokenKind::name) continue;
    const std::string_view word = text.substr(token.offset, token.length);
    if (word.front() != '{' && word.find('.') == std::string_view::npos) continue;
    out.push_back({std::string(bareName(word)), begin + token.offset, token.length});
  }
}

}  // namespace

std::vector<NameInFormula> signalNames(std::string_view text) {
  std::vector<NameInFormula> out;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    if (text.substr(i, 2) == "||") {
      ++i;
      continue;
    }
    if (i < text.size() && text[i] != ';' && text[i] != '|') continue;
    addSignalNames(text.substr(begin, i - begin), begin, out);
    begin = i + 1;
  }
  return out;
}

bool isSignalName(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  bool dotted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool starts = i + 1 < text.size() && isLetter(text[i + 1]);
    if (i == 0 ? !isLetter(c) : !isLetter(c) && !isDigit(c) && c != '[' && c != ']' && c != '/')
      if (i == 0 || c != '.' || !starts) return false;
    dotted = dotted || c == '.';
  }
  return dotted;
}

std::string describe(const Token& token, std::string_view text) {
  if (token.kind == TokenKind::end) return "the end";
  return quoted(text.substr(token.offset, token.length));
}

}  // namespace dynamy
