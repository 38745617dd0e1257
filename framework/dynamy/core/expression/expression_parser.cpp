#include <cmath>
#include <dynamy/core/expression/expression_error.hpp>
#include <dynamy/core/expression/expression_functions.hpp>
#include <dynamy/core/expression/expression_lexer.hpp>
#include <dynamy/core/expression/expression_parser.hpp>
#include <dynamy/core/expression/unit_suffix.hpp>
#include <dynamy/core/other_words.hpp>
#include <dynamy/core/suggestion.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace dynamy {
namespace {

constexpr int kDeepestNesting = 200;
constexpr const char* kConditional = "condition ? a : b";
constexpr std::size_t kMostNamesListed = 12;

std::string quotedWord(std::string_view word) { return "\"" + std::string(word) + "\""; }

[[noreturn]] void refuse(const std::string& message, const Token& token,
                         const std::string& suggestion = "") {
  throw ExpressionError(message, token.offset, token.length, suggestion);
}

bool isRelation(TokenKind kind) { return kind >= TokenKind::less && kind <= TokenKind::notEqual; }

/// The tokens of a text, read one after the other.
class TokenReader {
 public:
  explicit TokenReader(std::string_view text) : text_(text), tokens_(tokenize(text)) {}
  std::size_t at() const { return at_; }
  const Token& operator[](std::size_t i) const { return tokens_[i]; }
  const Token& current() const { return tokens_[at_]; }
  const Token& following() const { return tokens_[std::min(at_ + 1, tokens_.size() - 1)]; }
  const Token& last() const { return tokens_[at_ - 1]; }  ///< the one before the current one
  void advance() { ++at_; }
  bool accept(TokenKind kind) {
    if (current().kind != kind) return false;
    ++at_;
    return true;
  }
  std::string_view word(const Token& token) const {
    return text_.substr(token.offset, token.length);
  }
  /// Length of the text from token `first` to the last one.
  std::size_t lengthFrom(const Token& first) const {
    return last().offset + last().length - first.offset;
  }
  bool isOne() const { return tokens_.size() <= 2; }  ///< beside the end
  std::string found(const Token& token) const { return ", found " + describe(token, text_); }

 private:
  std::string_view text_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
};

/// The first part of finite constants whose value is not finite.
class EndlessPart {
 public:
  using Node = ExpressionGraph::Node;

  explicit EndlessPart(const ExpressionGraph& graph) : graph_(graph) {}
  /// From now on no part is noted. A symbol that is not finite is reported where it is defined, not
  /// again where it is used.
  void ignore() { ignored_ = true; }
  /// Notes `result`, the value of the part from token `first` to the last one.
  void note(Node result, const Token& first, const TokenReader& tokens) {
    if (!part_ && !ignored_ && isEndless(result))
      part_ = Part{first.offset, tokens.lengthFrom(first)};
  }
  /// Throws if `result` needs a part that is not finite. A branch that is never taken does not
  /// count.
  void refuseIn(Node result) const {
    if (!part_) return;
    std::vector<bool> needed(result + 1, false);
    needed[result] = true;
    for (std::size_t i = result + 1; i-- > 0;) {
      if (!needed[i]) continue;
      if (isEndless(static_cast<Node>(i)))
        throw ExpressionError("this part has no finite value", part_->offset, part_->length);
      const Instruction& node = graph_.nodes()[i];
      const int n = operandCount(node.op);
      if (n > 0) needed[node.a] = true;
      if (n > 1) needed[node.b] = true;
      if (n > 2) needed[node.c] = true;
    }
  }

 private:
  struct Part {
    std::size_t offset, length;
  };
  bool isEndless(Node n) const { return graph_.isConstant(n) && !std::isfinite(graph_.value(n)); }

  const ExpressionGraph& graph_;
  std::optional<Part> part_;
  bool ignored_ = false;
};

/// Recursive descent, one function for each rule of the grammar.
class Parser {
 public:
  using Node = ExpressionGraph::Node;

  Parser(std::string_view text, const SymbolTable& symbols, ExpressionGraph& graph)
      : tokens_(text), symbols_(symbols), graph_(graph), endless_(graph) {}

  Node run(ConstantParts parts) {
    const Node result = expression();
    if (tokens_.current().kind == TokenKind::close)
      refuse("\")\" closes nothing", tokens_.current());
    if (tokens_.current().kind != TokenKind::end) expectedOperator();
    if (parts == ConstantParts::finite) endless_.refuseIn(result);
    return result;
  }

 private:
  /// Counts nested rules, so that a long row of "(" is an error and not a stack overflow.
  class Level {
   public:
    explicit Level(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > kDeepestNesting) {
        refuse(
            "the expression is nested deeper than " + std::to_string(kDeepestNesting) + " levels",
            parser_.tokens_.current());
      }
    }
    ~Level() { --parser_.depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    Parser& parser_;
  };

  [[noreturn]] void expectedOperator() const {
    const Token& here = tokens_.current();
    const std::string word(tokens_.word(here));
    const bool afterNumber = tokens_.at() > 0 && tokens_.last().kind == TokenKind::number;
    if (word == "if") refuse("expected an operator" + tokens_.found(here), here, kConditional);
    if (afterNumber && here.kind == TokenKind::name && isSymbol(word))
      refuse("expected an operator" + tokens_.found(here), here,
             std::string(tokens_.word(tokens_.last())) + '*' + word);
    if (afterNumber && here.kind == TokenKind::name && parseUnitSuffix(word))
      refuse("a blank stands before the unit " + quotedWord(word), here,
             std::string(tokens_.word(tokens_.last())) + word);
    const bool isFactor = here.kind == TokenKind::name || here.kind == TokenKind::open ||
                          here.kind == TokenKind::number;
    refuse("expected an operator" + tokens_.found(here), here, isFactor ? "*" : "");
  }

  Node expression() {
    const Level level(*this);
    const Node condition = either();
    const Token question = tokens_.current();
    if (!tokens_.accept(TokenKind::question)) return condition;
    const Node a = expression();
    if (!tokens_.accept(TokenKind::colon)) refuse("\"?\" without \":\"", question);
    const Node b = expression();
    return graph_.select(condition, a, b);
  }

  /// Notes `result` if it is not finite; its part begins at token `first`.
  Node noted(Node result, std::size_t first) {
    endless_.note(result, tokens_[first], tokens_);
    return result;
  }

  Node either() {
    Node result = both();
    while (tokens_.accept(TokenKind::logicalOr))
      result = graph_.binary(Op::logicalOr, result, both());
    return result;
  }

  Node both() {
    Node result = relation();
    while (tokens_.accept(TokenKind::logicalAnd)) {
      result = graph_.binary(Op::logicalAnd, result, relation());
    }
    return result;
  }

  Node relation() {
    const Node a = sum();
    const TokenKind kind = tokens_.current().kind;
    if (!isRelation(kind)) return a;
    tokens_.advance();
    const Node b = sum();
    if (isRelation(tokens_.current().kind)) {
      refuse("comparisons cannot be chained, join two with \"and\"", tokens_.current());
    }
    switch (kind) {
      case TokenKind::less:
        return graph_.binary(Op::less, a, b);
      case TokenKind::lessEqual:
        return graph_.binary(Op::lessEqual, a, b);
      case TokenKind::greater:
        return graph_.binary(Op::less, b, a);
      case TokenKind::greaterEqual:
        return graph_.binary(Op::lessEqual, b, a);
      case TokenKind::equal:
        return graph_.binary(Op::equal, a, b);
      default:
        return graph_.binary(Op::notEqual, a, b);
    }
  }

  Node sum() {
    const std::size_t first = tokens_.at();
    Node result = product();
    while (true) {
      if (tokens_.accept(TokenKind::plus)) {
        result = noted(graph_.binary(Op::add, result, product()), first);
      } else if (tokens_.accept(TokenKind::minus)) {
        result = noted(graph_.binary(Op::subtract, result, product()), first);
      } else {
        return result;
      }
    }
  }

  Node product() {
    const std::size_t first = tokens_.at();
    Node result = unary();
    while (true) {
      if (tokens_.accept(TokenKind::times)) {
        result = noted(graph_.binary(Op::multiply, result, unary()), first);
      } else if (tokens_.accept(TokenKind::over)) {
        result = noted(graph_.binary(Op::divide, result, unary()), first);
      } else {
        return result;
      }
    }
  }

  Node unary() {
    const Level level(*this);
    const std::size_t first = tokens_.at();
    if (tokens_.accept(TokenKind::minus)) return graph_.unary(Op::negate, unary());
    if (tokens_.accept(TokenKind::plus)) return unary();
    if (tokens_.accept(TokenKind::logicalNot)) return graph_.unary(Op::logicalNot, unary());
    const Node base = primary();
    return tokens_.accept(TokenKind::power) ? noted(graph_.power(base, unary()), first) : base;
  }

  Node primary() {
    const Token token = tokens_.current();
    if (tokens_.accept(TokenKind::number)) return number(token);
    if (token.kind == TokenKind::name) {
      return tokens_.following().kind == TokenKind::open ? call() : symbol();
    }
    if (tokens_.accept(TokenKind::open)) {
      const Node inside = expression();
      closeParenthesis(token);
      return inside;
    }
    refuse("expected a number, a name or \"(\"" + tokens_.found(token), token);
  }

  /// A number with the unit t is 1000 kg to a program and twice the time to a reader who wrote 2t.
  Node number(const Token& token) {
    const std::size_t over = token.unit.find('/');
    const bool quotient = over != std::string_view::npos;
    const bool named = !token.unit.empty() &&
                       symbols_.find(token.unit.substr(0, over)) != nullptr &&
                       (!quotient || symbols_.find(token.unit.substr(over + 1)) != nullptr);
    if (named) {
      const std::string_view word = tokens_.word(token);
      refuse(quotedWord(word) + " has the unit " + quotedWord(token.unit) +
                 ", which is also a name here; a value in SI units needs no unit",
             token,
             std::string(word.substr(0, word.size() - token.unit.size())) + '*' +
                 std::string(token.unit));
    }
    return graph_.constant(token.value);
  }

  void closeParenthesis(const Token& open) {
    if (tokens_.accept(TokenKind::close)) return;
    if (tokens_.current().kind == TokenKind::end) refuse("\"(\" is never closed", open);
    expectedOperator();
  }

  [[noreturn]] void notAFunction(const Token& nameToken) const {
    const std::string_view name = tokens_.word(nameToken);
    const std::string_view last = name.substr(name.rfind('.') + 1);  // math.sin
    const bool ofLibrary = last.size() < name.size() && findFunction(last) != nullptr;
    if (isSymbol(name) && !ofLibrary)
      refuse(quotedWord(name) + " is not a function, a product needs \"*\"", nameToken);
    const std::string other = ofLibrary ? std::string(last) : functionOfOthers(name);
    refuse("unknown function " + quotedWord(name), nameToken,
           other.empty() ? nearest(name, functionNames()) : other);
  }

  Node call() {
    const std::size_t first = tokens_.at();
    const Token nameToken = tokens_.current();
    const std::string_view name = tokens_.word(nameToken);
    const ExpressionFunction* function = findFunction(name);
    if (function == nullptr) notAFunction(nameToken);
    tokens_.advance();
    const Token open = tokens_.current();
    tokens_.advance();

    std::vector<Node> arguments;
    if (tokens_.current().kind != TokenKind::close) {
      do {
        arguments.push_back(expression());
      } while (tokens_.accept(TokenKind::comma));
    }
    closeParenthesis(open);
    checkCount(*function, static_cast<int>(arguments.size()), nameToken);
    return noted(function->build(graph_, arguments), first);
  }

  void checkCount(const ExpressionFunction& function, int count, const Token& nameToken) const {
    const int low = function.minArguments;
    const int high = function.maxArguments;
    if (count >= low && count <= high) return;
    std::string expected = std::to_string(low);
    if (high == kAnyNumber) {
      expected = "at least " + expected;
    } else if (high > low) {
      expected += " or " + std::to_string(high);
    }
    const std::string message = std::string(function.name) + " takes " + expected + " argument" +
                                (high == 1 ? "" : "s") + ", not " + std::to_string(count);
    // STEP of other programs has the same five.
    const bool smooth = function.name == "step" && count == 5;
    throw ExpressionError(message, nameToken.offset, tokens_.lengthFrom(nameToken),
                          smooth ? "smoothstep" : "");
  }

  bool isSymbol(std::string_view name) const {
    return symbols_.find(name) != nullptr || name == "pi" || name == "e";
  }

  Node symbol() {
    const Token token = tokens_.current();
    const std::string_view name = bareName(tokens_.word(token));
    tokens_.advance();
    if (const SymbolTable::Symbol* found = symbols_.find(name)) {
      if (found->hides)
        refuse(quotedWord(name) +
                   " is a parameter of the model, and here a variable; rename the parameter",
               token);
      if (found->isVariable) return graph_.variable(found->slot);
      if (!std::isfinite(found->value)) endless_.ignore();
      return graph_.constant(found->value);
    }
    if (name == "pi") return graph_.constant(std::numbers::pi);
    if (name == "e") {
      if (tokens_.isOne())
        refuse("there is no parameter \"e\"; Euler's number alone is exp(1)", token, "exp(1)");
      return graph_.constant(std::numbers::e);
    }
    unknownSymbol(token);
  }

  [[noreturn]] void unknownSymbol(const Token& token) const {
    const std::string_view name = bareName(tokens_.word(token));
    if (findFunction(name) != nullptr) {
      refuse(quotedWord(name) + " is a function and needs arguments in \"( )\"", token);
    }
    std::vector<std::string> known = symbols_.names();
    std::string message = "unknown symbol " + quotedWord(name);
    if (!known.empty()) message += ", known:";
    for (std::size_t i = 0; i < std::min(known.size(), kMostNamesListed); ++i)
      message += " " + known[i];
    if (known.size() > kMostNamesListed) message += " …";
    if (name.size() <= 2) known.emplace_back("pi");
    std::string near = name == "π" ? "pi" : nearest(name, known);
    if (name == "time" && symbols_.find("t") != nullptr) near = "t";
    // One letter is near to any other.
    if (name.size() == 1 && typingDistance(name, near) > 0) near.clear();
    refuse(message, token, near);
  }

  TokenReader tokens_;
  const SymbolTable& symbols_;
  ExpressionGraph& graph_;
  EndlessPart endless_;
  int depth_ = 0;
};

/// An unknown unit that is a name: 2mu was meant as 2*mu.
[[noreturn]] void refuseMissingTimes(std::string_view text, const SymbolTable& symbols,
                                     const ExpressionError& e) {
  const std::string_view word = text.substr(e.offset(), e.length());
  const bool unit = e.message().starts_with("unknown unit");
  if (!unit || (symbols.find(word) == nullptr && word != "pi")) throw;
  std::size_t begin = e.offset();
  while (begin > 0 &&
         ((text[begin - 1] >= '0' && text[begin - 1] <= '9') || text[begin - 1] == '.'))
    --begin;
  throw ExpressionError(
      e.message(), e.offset(), e.length(),
      std::string(text.substr(begin, e.offset() - begin)) + '*' + std::string(word));
}

}  // namespace

ExpressionGraph::Node parseExpression(std::string_view text, const SymbolTable& symbols,
                                      ExpressionGraph& graph, ConstantParts parts) {
  try {
    return Parser(text, symbols, graph).run(parts);
  } catch (const ExpressionError& e) {
    refuseMissingTimes(text, symbols, e);
  }
}

}  // namespace dynamy
