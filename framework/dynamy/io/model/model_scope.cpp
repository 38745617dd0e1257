#include <dynamy/io/model/braces.hpp>
#include <dynamy/io/model/model_scope.hpp>

namespace dynamy {
namespace {

constexpr std::string_view kForbidden = " \t\r\n./[]*\"<>";  // in names of elements

/// The name with "_" in the place of all that names must not contain.
std::string withoutForbidden(std::string name) {
  for (char& c : name)
    if (kForbidden.find(c) != std::string_view::npos) c = '_';
  return name;
}

}  // namespace

// ---- Scope ----

const Scope& Scope::file() const {
  const Scope* s = this;
  while (s->outer != nullptr) s = s->outer;
  return *s;
}

const double* Scope::number(std::string_view name) const {
  for (const Scope* s = this; s != nullptr; s = s->outer)
    if (const auto found = s->numbers.find(name); found != s->numbers.end()) return &found->second;
  return nullptr;
}

bool Scope::isBroken(std::string_view name) const {
  for (const Scope* s = this; s != nullptr; s = s->outer) {
    if (s->broken.contains(name)) return true;
    if (s->numbers.contains(name)) return false;  // an index hides it
  }
  return false;
}

SymbolTable Scope::some(const std::vector<std::string>& wanted) const {
  SymbolTable out;
  for (const std::string& name : wanted)
    if (const double* value = number(name)) out.constant(name, *value);
  return out;
}

SymbolTable Scope::all() const {
  SymbolTable out = outer == nullptr ? SymbolTable() : outer->all();
  for (const auto& [name, value] : numbers) out.constant(name, value);
  return out;
}

std::size_t Scope::symbolCount() const {
  return numbers.size() + broken.size() + (outer == nullptr ? 0 : outer->symbolCount());
}

// ---- Faults ----

void Faults::fillLines(Diagnostic& d) const {
  const auto line = [this](const Place& place) -> std::string {
    const auto it = files_.find(place.file);
    if (it == files_.end() || place.line <= 0) return {};
    return it->second->shownLine(place);
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

std::string elementName(const XmlNode& node, const Scope& scope, const std::string& prefix,
                        Faults& faults) {
  const XmlAttribute* given = node.attribute("name");
  if (given == nullptr) return {};
  const auto resolved = resolveBraces(*given, node, scope, false, faults);
  if (!resolved) return {};
  const std::string& name = resolved->text;
  if (name.empty()) {
    faults.add(scope, given->valuePlace, node, "the name is empty");
    return {};
  }
  if (const std::size_t at = name.find_first_of(kForbidden); at != std::string::npos) {
    const auto [offset, length] = resolved->source(at, 1);
    faults.add(scope, scope.document->at(*given, offset, length), node,
               std::string("a name must not contain \"") + name[at] + '"',
               "write \"" + withoutForbidden(name) + '"');
    return {};
  }
  return prefix + name + scope.suffix;
}

void refuseText(const XmlNode& node, const Scope& scope, Faults& faults) {
  if (node.text.empty()) return;
  const bool tag = node.text.find("/>") != std::string::npos;
  faults.add(scope, node.textPlace, node, "text has no meaning here",
             tag ? "a tag begins with <"
                 : "values are attributes, name=\"value\"; text for people stands in <doc>");
}

}  // namespace dynamy
