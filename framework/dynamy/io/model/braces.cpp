#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/core/declared/attributes.hpp>
#include <dynamy/core/declared/formula_fault.hpp>
#include <dynamy/core/expression/expression_lexer.hpp>
#include <dynamy/io/model/braces.hpp>

namespace dynamy {
namespace {

/// End of the braces that begin at `begin`: index after '}', npos if they are not closed.
std::size_t closing(std::string_view value, std::size_t begin) {
  const std::size_t end = value.find_first_of("{}", begin + 1);
  return end == std::string_view::npos || value[end] == '{' ? std::string_view::npos : end + 1;
}

bool nameStart(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c & 0x80) != 0;
}
bool isFigure(char c) { return c >= '0' && c <= '9'; }
bool nameContinues(char c) { return nameStart(c) || isFigure(c); }

/// The letters behind the figures of a number and its exponent: 2m may be meant as 2*m, and the
/// parser has to know m.
std::string_view behindNumber(std::string_view word) {
  const auto skipFigures = [&word] {
    while (!word.empty() && isFigure(word.front())) word.remove_prefix(1);
  };
  skipFigures();
  const bool exponent = word.starts_with('e') || word.starts_with('E');
  if (exponent && (word.size() == 1 || isFigure(word[1]))) {
    word.remove_prefix(1);
    skipFigures();
  }
  return word;
}

}  // namespace

std::pair<std::size_t, std::size_t> ResolvedText::source(std::size_t offset,
                                                         std::size_t length) const {
  // A byte inside of a replaced piece maps to the whole braces. The last piece that begins before
  // `at` decides; as the end of a range, `at` belongs to the bytes before it.
  const auto map = [this](std::size_t at, bool end) {
    const auto next = std::upper_bound(
        pieces.begin(), pieces.end(), at,
        [end](std::size_t x, const Piece& p) { return end ? x <= p.begin : x < p.begin; });
    if (next == pieces.begin()) return at;
    const Piece& p = *(next - 1);
    const std::size_t behind = p.begin + p.size, sourceEnd = p.sourceBegin + p.sourceSize;
    if (at < behind || (end && at == behind)) return end ? sourceEnd : p.sourceBegin;
    return sourceEnd + (at - behind);
  };
  const std::size_t begin = map(offset, false);
  const std::size_t end = length == 0 ? begin : map(offset + length, true);
  return {begin, end - begin};
}

void ResolvedText::replace(std::size_t begin, std::size_t end, const std::string& word) {
  const auto [first, size] = source(begin, end - begin);
  text.replace(begin, end - begin, word);
  const auto at = std::find_if(pieces.begin(), pieces.end(),
                               [begin](const Piece& p) { return p.begin >= begin; });
  for (auto p = at; p != pieces.end(); ++p) p->begin += word.size() - (end - begin);
  pieces.insert(at, {begin, word.size(), first, size});
}

void namesIn(std::string_view formula, std::vector<std::string>& names) {
  for (std::size_t i = 0; i < formula.size();) {
    if (!nameContinues(formula[i])) {
      ++i;
      continue;
    }
    const std::size_t first = i;
    while (i < formula.size() && nameContinues(formula[i])) ++i;
    std::string_view word = formula.substr(first, i - first);
    if (!nameStart(word[0])) word = behindNumber(word);
    if (!word.empty()) names.emplace_back(word);
  }
}

std::vector<std::string> namesInBraces(std::string_view value) {
  std::vector<std::string> names;
  for (std::size_t at = value.find('{'); at != std::string_view::npos; at = value.find('{', at)) {
    const std::size_t end = std::min(closing(value, at), value.size());
    namesIn(value.substr(at + 1, end - at - 1), names);
    at = end;
  }
  return names;
}

namespace {

/// The same error, evaluated with all names of the scope, so that it can suggest the one that was
/// meant.
ExpressionError withAllNames(std::string_view text, const Scope& scope, const ExpressionError& e) {
  try {
    evaluateConstant(text, scope.all());
  } catch (const ExpressionError& better) {
    return better;
  }
  return e;
}

}  // namespace

CompiledBraces::CompiledBraces(std::string_view value, const Scope& scope)
    : value_(value),
      set_(compiled(scope)),
      work_(set_),
      x_(names_.size()),
      numbers_(parts_.size()) {}

ExpressionSet CompiledBraces::compiled(const Scope& scope) {
  const std::string_view value = value_;
  SymbolTable symbols;
  for (const std::string& name : namesInBraces(value)) {
    if (scope.number(name) == nullptr || symbols.find(name) != nullptr) continue;
    symbols.variable(name);
    names_.push_back(name);
  }
  ExpressionCompiler compiler(symbols, false);
  for (std::size_t at = value.find_first_of("{}"); at != std::string_view::npos;
       at = value.find_first_of("{}", at)) {
    const std::size_t end = value[at] == '{' ? closing(value, at) : std::string_view::npos;
    if (end == std::string_view::npos) throw ExpressionError("a brace without the other", at, 1);
    compiler.add(value.substr(at + 1, end - at - 2));
    parts_.push_back({at, end});
    at = end;
  }
  return compiler.finish();
}

std::optional<ResolvedText> CompiledBraces::resolved(const Scope& scope, bool formula) {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const double* number = scope.isBroken(names_[i]) ? nullptr : scope.number(names_[i]);
    if (number == nullptr) return std::nullopt;
    x_[i] = *number;
  }
  set_.eval(x_.data(), numbers_.data(), work_);
  ResolvedText out;
  std::size_t at = 0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (!std::isfinite(numbers_[i])) return std::nullopt;
    out.text.append(value_, at, parts_[i].begin - at);
    at = parts_[i].end;
    out.add(numbers_[i], formula, parts_[i].begin, at);
  }
  out.text.append(value_, at);
  return out;
}

void ResolvedText::add(double x, bool formula, std::size_t begin, std::size_t end) {
  const std::string number = formula ? '(' + numberText(x) + ')' : numberText(x);
  pieces.push_back({text.size(), number.size(), begin, end - begin});
  text += number;
}

namespace {

/// The value by its compiled form, if it has braces and was resolved before. Nothing: it has to be
/// parsed step by step.
std::optional<ResolvedText> resolvedAgain(const XmlAttribute& attribute, const Scope& scope,
                                          bool formula) {
  if (attribute.value.find('{') == std::string::npos) return std::nullopt;
  const auto [known, isNew] = scope.file().braces.try_emplace(&attribute);
  if (isNew) return std::nullopt;
  if (!known->second) {
    try {
      known->second = std::make_shared<CompiledBraces>(attribute.value, scope);
    } catch (const ExpressionError&) {
      return std::nullopt;
    }
  }
  return known->second->resolved(scope, formula);
}

/// "past[3].out" for `past[i + 1].out`; nothing: that is no name of a signal. Throws
/// ExpressionError.
std::optional<std::string> withIndices(std::string_view inner, const SymbolTable& symbols) {
  std::string out;
  for (std::size_t at = 0; at < inner.size();) {
    const std::size_t open = inner.find('[', at), close = inner.find(']', open);
    out += inner.substr(at, open - at);
    if (close == std::string_view::npos) break;
    const std::string_view index = inner.substr(open + 1, close - open - 1);
    double x = 0.0;
    try {
      x = evaluateConstant(index, symbols);
    } catch (const ExpressionError& e) {
      throw ExpressionError(e.message(), open + 1 + e.offset(), e.length(), e.suggestion());
    }
    if (!(x >= 0.0 && x == std::floor(x)))
      throw ExpressionError("an index is a whole number from 0 on, not " + numberText(x), open + 1,
                            index.size());
    out += fmt::format("[{:.0f}]", x);
    at = close + 1;
  }
  return isSignalName(out) ? std::optional(out) : std::nullopt;
}

/// Keeps the name of a signal, which is read in each evaluation, not now. False: it is none. Throws
/// ExpressionError.
bool keepSignal(std::string_view inner, const SymbolTable& symbols, std::size_t begin,
                std::size_t end, ResolvedText& out) {
  if (inner.find('[') == std::string_view::npos) {
    if (!isSignalName(inner)) return false;
    out.text += '{' + std::string(inner) + '}';
    return true;
  }
  const std::optional<std::string> name = withIndices(inner, symbols);
  if (!name) return false;
  out.pieces.push_back({out.text.size(), name->size() + 2, begin, end - begin});
  out.text += '{' + *name + '}';
  return true;
}

}  // namespace

std::optional<ResolvedText> resolveBraces(const XmlAttribute& attribute, const XmlNode& node,
                                          const Scope& scope, bool formula, Faults& faults) {
  if (auto again = resolvedAgain(attribute, scope, formula)) return again;
  const std::string& value = attribute.value;
  ResolvedText out;
  bool good = true;
  const auto fault = [&](std::size_t at, std::size_t size, std::string text,
                         std::string hint = {}) {
    faults.add(scope, scope.document->at(attribute, at, size), node, std::move(text),
               std::move(hint));
    good = false;
  };
  const std::vector<std::string> names = namesInBraces(value);
  for (const std::string& name : names)
    if (scope.isBroken(name)) return std::nullopt;
  const SymbolTable symbols = scope.some(names);

  for (std::size_t at = 0; at < value.size();) {
    if (value[at] == '}') {
      fault(at, 1, "\"}\" without \"{\"");
      return std::nullopt;
    }
    if (value[at] != '{') {
      const std::size_t next = std::min(value.find_first_of("{}", at), value.size());
      out.text.append(value, at, next - at);
      at = next;
      continue;
    }
    const std::size_t end = closing(value, at);
    if (end == std::string::npos) {
      const bool twice = value.compare(at, 2, "{{") == 0;
      fault(at, 1,
            twice ? "\"{\" within braces; they stand once, as in {x}" : "\"{\" without \"}\"");
      return std::nullopt;
    }
    const std::string_view inner = std::string_view(value).substr(at + 1, end - at - 2);
    // The expression between the braces becomes a number.
    try {
      if (formula && keepSignal(inner, symbols, at, end, out)) {
        at = end;
        continue;
      }
      if (const std::size_t index = inner.find('['); index != std::string_view::npos && !formula)
        throw ExpressionError("parameters have no index", index, 1);
      const double x = evaluateConstant(inner, symbols);
      if (!std::isfinite(x))
        fault(at, end - at, "the expression has no finite value, is " + numberText(x));
      out.add(x, formula, at, end);
    } catch (const ExpressionError& found) {
      const ExpressionError e =
          inner.find('[') < inner.size() ? found : withAllNames(inner, scope, found);
      fault(at + 1 + e.offset(), e.length(), e.message(), formulaHint(e));
    }
    at = end;
  }
  if (!good) return std::nullopt;
  return out;
}

}  // namespace dynamy
