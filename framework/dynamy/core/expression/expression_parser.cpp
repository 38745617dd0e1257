#include <cmath>
#include <dynamy/core/expression/expression_error.hpp>
#include <dynamy/core/expression/expression_functions.hpp>
#include <dynamy/core/expression/expression_lexer.hpp>
#include <dynamy/core/expression/expression_parser.hpp>
#include <dynamy/core/expression/unit_suffix.hpp>
#include <dynamy/core/suggestion.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace dynamy {
namespace {

constexpr int kDeepestNesting = 200;
constexpr std::size_t kMostNamesListed = 12;

std::string quotedWord(std::string_view word) { return "\"" + std::string(word) + "\""; }

/// Recursive descent, one function for each rule of the grammar.
class Parser {
 public:
  using Node = ExpressionGraph::Node;

  Parser(std::string_view text, const SymbolTable& symbols, ExpressionGraph& graph)
      : text_(text), tokens_(tokenize(text)), symbols_(symbols), graph_(graph) {}

  Node run(ConstantParts parts) {
    const Node result = expression();
    if (current().kind == TokenKind::close) fail("\")\" closes nothing", current());
    if (current().kind != TokenKind::end) expectedOperator();
    if (parts == ConstantParts::finite && endless_ && needsEndless(result))
      throw ExpressionError("this part has no finite value", endless_->offset, endless_->length);
    return result;
  }

 private:
  /// Counts nested rules, so that a long row of "(" is an error and not a stack overflow.
  class Level {
   public:
    explicit Level(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > kDeepestNesting) {
        parser_.fail("the expression is nested too deeply", parser_.current());
      }
    }
    ~Level() { --parser_.depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    Parser& parser_;
  };

  const Token& current() const { return tokens_[at_]; }
  const Token& following() const { return tokens_[std::min(at_ + 1, tokens_.size() - 1)]; }
  std::string_view word(const Token& token) const {
    return text_.substr(token.offset, token.length);
  }
  bool accept(TokenKind kind) {
    if (current().kind != kind) return false;
    ++at_;
    return true;
  }

  [[noreturn]] void fail(const std::string& message, const Token& token,
                         const std::string& suggestion = "") const {
    throw ExpressionError(message, token.offset, token.length, suggestion);
  }

  [[noreturn]] void expectedOperator() const {
    const bool afterNumber = at_ > 0 && tokens_[at_ - 1].kind == TokenKind::number;
    if (afterNumber && current().kind == TokenKind::name && parseUnitSuffix(word(current())))
      fail("a blank stands before the unit " + quotedWord(word(current())), current(),
           std::string(word(tokens_[at_ - 1])) + std::string(word(current())));
    const bool isFactor = current().kind == TokenKind::name || current().kind == TokenKind::open ||
                          current().kind == TokenKind::number;
    fail("expected an operator, found " + describe(current(), text_), current(),
         isFactor ? "*" : "");
  }

  Node expression() {
    const Level level(*this);
    const Node condition = either();
    const Token question = current();
    if (!accept(TokenKind::question)) return condition;
    const Node a = expression();
    if (!accept(TokenKind::colon)) fail("\"?\" without \":\"", question);
    const Node b = expression();
    return graph_.select(condition, a, b);
  }

  /// Remembers the first part of finite constants whose value is not finite.
  Node noted(Node result, std::size_t firstToken) {
    if (endless_ || brokenSymbol_ || !isEndless(result)) return result;
    const std::size_t begin = tokens_[firstToken].offset;
    const Token& last = tokens_[at_ - 1];
    endless_ = Part{begin, last.offset + last.length - begin};
    return result;
  }

  bool isEndless(Node n) const { return graph_.isConstant(n) && !std::isfinite(graph_.value(n)); }

  /// True: the result needs a part that is not finite. A branch that is never taken does not count.
  bool needsEndless(Node result) const {
    std::vector<bool> needed(result + 1, false);
    needed[result] = true;
    for (std::size_t i = result + 1; i-- > 0;) {
      if (!needed[i]) continue;
      if (isEndless(static_cast<Node>(i))) return true;
      const Instruction& node = graph_.nodes()[i];
      const int n = operandCount(node.op);
      if (n > 0) needed[node.a] = true;
      if (n > 1) needed[node.b] = true;
      if (n > 2) needed[node.c] = true;
    }
    return false;
  }

  Node either() {
    Node result = both();
    while (accept(TokenKind::logicalOr)) result = graph_.binary(Op::logicalOr, result, both());
    return result;
  }

  Node both() {
    Node result = relation();
    while (accept(TokenKind::logicalAnd)) {
      result = graph_.binary(Op::logicalAnd, result, relation());
    }
    return result;
  }

  static bool isRelation(TokenKind kind) {
    return kind >= TokenKind::less && kind <= TokenKind::notEqual;
  }

  Node relation() {
    const Node a = sum();
    const TokenKind kind = current().kind;
    if (!isRelation(kind)) return a;
    ++at_;
    const Node b = sum();
    if (isRelation(current().kind)) {
      fail("comparisons cannot be chained, join two with \"and\"", current());
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
    const std::size_t first = at_;
    Node result = product();
    while (true) {
      if (accept(TokenKind::plus)) {
        result = noted(graph_.binary(Op::add, result, product()), first);
      } else if (accept(TokenKind::minus)) {
        result = noted(graph_.binary(Op::subtract, result, product()), first);
      } else {
        return result;
      }
    }
  }

  Node product() {
    const std::size_t first = at_;
    Node result = unary();
    while (true) {
      if (accept(TokenKind::times)) {
        result = noted(graph_.binary(Op::multiply, result, unary()), first);
      } else if (accept(TokenKind::over)) {
        result = noted(graph_.binary(Op::divide, result, unary()), first);
      } else {
        return result;
      }
    }
  }

  Node unary() {
    const Level level(*this);
    const std::size_t first = at_;
    if (accept(TokenKind::minus)) return graph_.unary(Op::negate, unary());
    if (accept(TokenKind::plus)) return unary();
    if (accept(TokenKind::logicalNot)) return graph_.unary(Op::logicalNot, unary());
    const Node base = primary();
    return accept(TokenKind::power) ? noted(graph_.power(base, unary()), first) : base;
  }

  Node primary() {
    const Token token = current();
    if (accept(TokenKind::number)) return graph_.constant(token.value);
    if (token.kind == TokenKind::name) {
      return following().kind == TokenKind::open ? call() : symbol();
    }
    if (accept(TokenKind::open)) {
      const Node inside = expression();
      closeParenthesis(token);
      return inside;
    }
    fail("expected a number, a name or \"(\", found " + describe(token, text_), token);
  }

  void closeParenthesis(const Token& open) {
    if (accept(TokenKind::close)) return;
    if (current().kind == TokenKind::end) fail("\"(\" is never closed", open);
    expectedOperator();
  }

  Node call() {
    const std::size_t first = at_;
    const Token nameToken = current();
    const std::string_view name = word(nameToken);
    const ExpressionFunction* function = findFunction(name);
    if (function == nullptr && isSymbol(name)) {
      fail(quotedWord(name) + " is not a function, a product needs \"*\"", nameToken);
    }
    if (function == nullptr) {
      fail("unknown function " + quotedWord(name), nameToken, nearest(name, functionNames()));
    }
    ++at_;
    const Token open = current();
    ++at_;

    std::vector<Node> arguments;
    if (current().kind != TokenKind::close) {
      do {
        arguments.push_back(expression());
      } while (accept(TokenKind::comma));
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
    const Token& last = tokens_[at_ - 1];
    throw ExpressionError(message, nameToken.offset, last.offset + last.length - nameToken.offset);
  }

  bool isSymbol(std::string_view name) const {
    return symbols_.find(name) != nullptr || name == "pi" || name == "e";
  }

  Node symbol() {
    const Token token = current();
    const std::string_view name = word(token);
    ++at_;
    if (const SymbolTable::Symbol* found = symbols_.find(name)) {
      if (found->isVariable) return graph_.variable(found->slot);
      // A symbol that is not finite is reported where it is defined, not again where it is used.
      brokenSymbol_ = brokenSymbol_ || !std::isfinite(found->value);
      return graph_.constant(found->value);
    }
    if (name == "pi") return graph_.constant(std::numbers::pi);
    if (name == "e") return graph_.constant(std::numbers::e);
    unknownSymbol(token);
  }

  [[noreturn]] void unknownSymbol(const Token& token) const {
    const std::string_view name = word(token);
    if (findFunction(name) != nullptr) {
      fail(quotedWord(name) + " is a function and needs arguments in \"( )\"", token);
    }
    std::vector<std::string> known = symbols_.names();
    std::string message = "unknown symbol " + quotedWord(name);
    if (!known.empty()) message += ", known:";
    for (std::size_t i = 0; i < std::min(known.size(), kMostNamesListed); ++i)
      message += " " + known[i];
    if (known.size() > kMostNamesListed) message += " …";
    known.emplace_back("pi");
    fail(message, token, name == "π" ? "pi" : nearest(name, known));
  }

  std::string_view text_;
  std::vector<Token> tokens_;
  const SymbolTable& symbols_;
  ExpressionGraph& graph_;
  struct Part {
    std::size_t offset, length;
  };
  std::size_t at_ = 0;
  int depth_ = 0;
  std::optional<Part> endless_;
  bool brokenSymbol_ = false;
};

}  // namespace

ExpressionGraph::Node parseExpression(std::string_view text, const SymbolTable& symbols,
                                      ExpressionGraph& graph, ConstantParts parts) {
  return Parser(text, symbols, graph).run(parts);
}

}  // namespace dynamy
