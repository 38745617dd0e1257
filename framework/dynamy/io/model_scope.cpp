#include <cmath>
#include <dynamy/core/attributes.hpp>
#include <dynamy/core/expression.hpp>
#include <dynamy/io/model_scope.hpp>

namespace dynamy {
namespace {

/// End of the braces that begin at `begin`: index behind '}', npos if they never end.
std::size_t closing(std::string_view value, std::size_t begin) {
  const std::size_t end = value.find_first_of("{}", begin + 1);
  return end == std::string_view::npos || value[end] == '{' ? std::string_view::npos : end + 1;
}

bool nameStart(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c & 0x80) != 0;
}
bool nameContinues(char c) { return nameStart(c) || (c >= '0' && c <= '9'); }

}  // namespace

void Faults::fillLines(Diagnostic& d) const {
  const auto line = [this](const Place& place) -> std::string {
    const auto it = files_.find(place.file);
    if (it == files_.end() || place.line <= 0) return {};
    return std::string(it->second->sourceLine(place.line));
  };
  if (d.sourceLine.empty()) d.sourceLine = line(d.place);
  for (Note& note : d.notes)
    if (note.sourceLine.empty()) note.sourceLine = line(note.place);
}

void Faults::add(Diagnostic diagnostic) {
  fillLines(diagnostic);
  all_.add(std::move(diagnostic));
}

void Faults::add(const Scope& scope, const Place& place, const XmlNode& node, std::string text,
                 std::string hint) {
  all_.add(scope.document->diagnostic(place, node, std::move(text), std::move(hint)));
}

void Faults::add(const ModelError& error, const Scope&, const XmlNode& node) {
  for (Diagnostic d : error.diagnostics()) {
    if (d.place.line <= 0) d.place = node.place;
    if (d.element.empty()) d.element = node.label();
    add(std::move(d));
  }
}

void Faults::add(const ModelError& error) {
  for (Diagnostic d : error.diagnostics()) add(std::move(d));
}

std::pair<std::size_t, std::size_t> ResolvedText::source(std::size_t offset,
                                                         std::size_t length) const {
  // A byte inside of a replaced piece stands for all of its braces.
  const auto map = [this](std::size_t at, bool end) {
    std::ptrdiff_t shift = 0;
    for (const Piece& p : pieces) {
      if (at < p.begin || (end && at == p.begin)) break;
      if (at < p.begin + p.size || (end && at == p.begin + p.size))
        return end ? p.sourceBegin + p.sourceSize : p.sourceBegin;
      shift = static_cast<std::ptrdiff_t>(p.sourceBegin + p.sourceSize) -
              static_cast<std::ptrdiff_t>(p.begin + p.size);
    }
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(at) + shift);
  };
  const std::size_t begin = map(offset, false);
  const std::size_t end = length == 0 ? begin : map(offset + length, true);
  return {begin, end - begin};
}

std::vector<std::string> namesInBraces(std::string_view value) {
  std::vector<std::string> names;
  for (std::size_t at = value.find('{'); at != std::string_view::npos; at = value.find('{', at)) {
    const std::size_t end = std::min(closing(value, at), value.size());
    for (std::size_t i = at + 1; i < end;) {
      if (!nameContinues(value[i])) {
        ++i;
        continue;
      }
      const std::size_t first = i;
      while (i < end && nameContinues(value[i])) ++i;
      if (nameStart(value[first])) names.emplace_back(value.substr(first, i - first));
    }
    at = end;
  }
  return names;
}

std::optional<ResolvedText> resolveBraces(const XmlAttribute& attribute, const XmlNode& node,
                                          const Scope& scope, bool formula, Faults& faults) {
  const std::string& value = attribute.value;
  ResolvedText out;
  bool good = true;
  const auto fault = [&](std::size_t at, std::size_t size, std::string text,
                         std::string hint = {}) {
    faults.add(scope, scope.document->at(attribute, at, size), node, std::move(text),
               std::move(hint));
    good = false;
  };
  for (const std::string& name : namesInBraces(value))
    if (scope.broken.contains(name)) return std::nullopt;

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
      fault(at, 1, "\"{\" without \"}\"");
      return std::nullopt;
    }
    // The expression between the braces becomes a number.
    const std::string_view inner = std::string_view(value).substr(at + 1, end - at - 2);
    try {
      const double x = evaluateConstant(inner, scope.symbols);
      if (!std::isfinite(x))
        fault(at, end - at, "the expression has no finite value, is " + numberText(x));
      const std::string number = formula ? '(' + numberText(x) + ')' : numberText(x);
      out.pieces.push_back({out.text.size(), number.size(), at, end - at});
      out.text += number;
    } catch (const ExpressionError& e) {
      fault(at + 1 + e.offset(), e.length(), e.message(),
            e.suggestion().empty() ? std::string() : didYouMean(e.suggestion()));
    }
    at = end;
  }
  if (!good) return std::nullopt;
  return out;
}

std::string elementName(const XmlNode& node, const Scope& scope, const std::string& prefix,
                        Faults& faults) {
  const XmlAttribute* given = node.attribute("name");
  if (given == nullptr) return {};
  const auto resolved = resolveBraces(*given, node, scope, false, faults);
  if (!resolved) return {};
  const std::string& name = resolved->text;
  constexpr std::string_view kForbidden = " \t\r\n./[]*\"<>";
  if (name.empty()) {
    faults.add(scope, given->valuePlace, node, "the name is empty");
    return {};
  }
  if (const std::size_t at = name.find_first_of(kForbidden); at != std::string::npos) {
    const auto [offset, length] = resolved->source(at, 1);
    faults.add(scope, scope.document->at(*given, offset, length), node,
               std::string("a name must not contain \"") + name[at] + '"');
    return {};
  }
  return prefix + name + scope.suffix;
}

}  // namespace dynamy
