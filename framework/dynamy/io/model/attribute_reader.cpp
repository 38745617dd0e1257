#include <algorithm>
#include <dynamy/core/declared/two_names.hpp>
#include <dynamy/core/declared/unknown_name.hpp>
#include <dynamy/core/expression/expression_lexer.hpp>
#include <dynamy/io/model/attribute_reader.hpp>
#include <dynamy/io/model/braces.hpp>
#include <stdexcept>

namespace dynamy {
namespace {

/// "arm.tip" for "tip", where a body of this name has a <Frame> of that name; else "".
std::string frameOfBody(const XmlNode& root, std::string_view name) {
  const auto nameOf = [](const XmlNode& node) {
    const XmlAttribute* a = node.attribute("name");
    return a == nullptr ? std::string() : a->value;
  };
  for (const XmlNode& section : root.children)
    for (const XmlNode& body : section.children)
      for (const XmlNode& part : body.children)
        if (section.tag == "systems" && part.tag == "Frame" && nameOf(part) == name &&
            !nameOf(body).empty())
          return nameOf(body) + '.' + std::string(name);
  return {};
}

/// "a/b/" → "a/" → "".
std::string outerPrefix(const std::string& prefix) {
  const std::size_t cut =
      prefix.size() < 2 ? std::string::npos : prefix.find_last_of('/', prefix.size() - 2);
  return cut == std::string::npos ? std::string() : prefix.substr(0, cut + 1);
}

/// "[1][2]" → "[1]" → "".
std::string outerSuffix(const std::string& suffix) {
  const std::size_t cut = suffix.find_last_of('[');
  return cut == std::string::npos ? std::string() : suffix.substr(0, cut);
}

Place sourcePlace(const XmlDocument& document, const XmlAttribute& written,
                  const ResolvedText& text, std::size_t offset, std::size_t length) {
  const auto [first, size] = text.source(offset, length);
  return document.at(written, first, size);
}

}  // namespace

// ---- NameTable ----

void NameTable::declare(const std::string& name, Kind kind, const XmlNode& node, const Scope& scope,
                        Faults& faults) {
  const XmlAttribute* written = node.attribute("name");
  const Place place = written != nullptr ? written->valuePlace : node.place;
  const auto [it, isNew] = names_.emplace(name, Entry{kind, place});
  if (isNew) return;
  Diagnostic d =
      scope.document->diagnostic(place, node, "the name \"" + name + "\" is used already");
  d.notes.push_back({.place = it->second.place, .text = "first used here"});
  faults.add(std::move(d));
}

bool NameTable::is(const std::string& name, std::string_view kind) const {
  const auto it = names_.find(name);
  if (it == names_.end()) return false;
  if (kind == "system" || kind == "frame") return it->second.kind == Kind::system;
  if (kind == "contact") return it->second.kind == Kind::contact;
  if (kind == "force") return it->second.kind == Kind::force;
  return true;
}

std::string NameTable::resolve(const std::string& name, const Scope& scope,
                               std::string_view kind) const {
  for (std::string prefix = scope.prefix;; prefix = outerPrefix(prefix)) {
    for (std::string suffix = scope.suffix;; suffix = outerSuffix(suffix)) {
      if (is(prefix + name + suffix, kind)) return prefix + name + suffix;
      if (suffix.empty()) break;
    }
    if (prefix.empty()) return {};
  }
}

std::vector<std::string> NameTable::known(const Scope& scope, std::string_view kind) const {
  std::vector<std::string> out;
  for (const auto& entry : names_) {
    if (!is(entry.first, kind)) continue;
    std::string name = entry.first;
    if (!scope.prefix.empty() && name.starts_with(scope.prefix))
      name = name.substr(scope.prefix.size());
    if (!scope.suffix.empty() && name.ends_with(scope.suffix))
      name = name.substr(0, name.size() - scope.suffix.size());
    out.push_back(std::move(name));
  }
  return out;
}

// ---- AttributeReader ----

bool AttributeReader::allDeclared(const XmlNode& node, const Scope& scope,
                                  const Attributes& declared,
                                  std::span<const std::string_view> common) const {
  bool good = true;
  for (const XmlAttribute& written : node.attributes) {
    const bool isCommon = std::find(common.begin(), common.end(), written.name) != common.end();
    if (isCommon || declared.find(written.name) != nullptr) continue;
    std::vector<std::string> known;
    for (const Attribute& a : declared.list()) known.push_back(a.name);
    for (const std::string_view c : common) known.emplace_back(c);
    faults_->add(scope, written.namePlace, node, "unknown attribute \"" + written.name + '"',
                 meantAttribute(written.name, known).hint);
    good = false;
  }
  return good;
}

/// Collects the sources of values: the element itself, its class, the plain default of its type.
bool AttributeReader::sources(const XmlNode& node, const Scope& scope,
                              std::vector<Source>& out) const {
  out.push_back({&node, &scope});
  const DefaultsTable& defaults = scope.file().defaults;
  const auto byTag = defaults.find(node.tag);
  const auto* classes = byTag == defaults.end() ? nullptr : &byTag->second;
  bool good = true;
  if (const XmlAttribute* wanted = node.attribute("class")) {
    if (classes != nullptr && !wanted->value.empty() && classes->contains(wanted->value)) {
      const DefaultEntry& e = classes->at(wanted->value);
      out.push_back({e.node, e.scope});
    } else {
      std::vector<std::string> known;
      if (classes != nullptr)
        for (const auto& entry : *classes)
          if (!entry.first.empty()) known.push_back(entry.first);
      faults_->add(scope, wanted->valuePlace, node,
                   "<defaults> has no <" + node.tag + " class=\"" + wanted->value + "\">",
                   unknownNameHint(wanted->value, known));
      good = false;
    }
  }
  if (classes != nullptr && classes->contains(""))
    out.push_back({classes->at("").node, classes->at("").scope});
  return good;
}

/// Whether some unknown attribute of the element was probably meant to be `name`.
bool AttributeReader::isMisspelt(const std::string& name, const XmlNode& node,
                                 const Attributes& declared,
                                 std::span<const std::string_view> common) {
  std::vector<std::string> known;
  for (const Attribute& a : declared.list()) known.push_back(a.name);
  for (const std::string_view c : common) known.emplace_back(c);
  return std::any_of(node.attributes.begin(), node.attributes.end(), [&](const XmlAttribute& a) {
    return std::find(known.begin(), known.end(), a.name) == known.end() &&
           meantAttribute(a.name, known).name == name;
  });
}

bool AttributeReader::read(const XmlNode& node, const Scope& scope, const Attributes& declared,
                           std::span<const std::string_view> common, Parameters& x) const {
  bool good = allDeclared(node, scope, declared, common);
  std::vector<Source> from;
  good = sources(node, scope, from) && good;

  x.values.clear();
  x.values.reserve(declared.list().size());
  for (const Attribute& a : declared.list()) {
    ParameterValue value;
    value.declaration = &a;
    value.place = node.place;
    const auto source = std::find_if(from.begin(), from.end(), [&](const Source& s) {
      return s.node->attribute(a.name) != nullptr;
    });
    if (source != from.end()) {
      good = readOne(*source, *source->node->attribute(a.name), node, scope, value) && good;
    } else if (a.defaultValue) {
      value.text = *a.defaultValue;
      if (const auto fault = readValue(a, value))
        throw std::logic_error("default of " + x.type + '.' + a.name + ": " + fault->text);
    } else if (!a.optionalValue) {
      good = false;
      // Reported already: an unknown attribute that means this one, or faulty defaults that may
      // hold it.
      const bool told =
          isMisspelt(a.name, node, declared, common) || scope.file().defaultsAreBroken;
      if (!told) {
        std::string more =
            unitText(a.unit) == "-" ? std::string() : " [" + std::string(unitText(a.unit)) + ']';
        for (const std::string& word : a.choices)
          if (a.choices.size() > 1) more += (more.empty() ? ": " : ", ") + word;
        faults_->add(scope, node.place, node, "missing attribute \"" + a.name + '"', a.text + more);
      }
    }
    x.values.push_back(std::move(value));
  }
  return good;
}

bool AttributeReader::readOne(const Source& source, const XmlAttribute& written,
                              const XmlNode& node, const Scope& scope,
                              ParameterValue& value) const {
  const Attribute& a = *value.declaration;
  const bool formula = a.type == AttributeType::expression || a.type == AttributeType::expressions;
  auto text = resolveBraces(written, *source.node, *source.scope, formula, *faults_);
  if (!text) return false;
  if (formula && names_ != nullptr) nameSignals(scope, *text);
  value.text = text->text;
  value.given = true;
  value.place = written.valuePlace;
  value.locate = [document = source.scope->document, &written, text = *text](std::size_t offset,
                                                                             std::size_t length) {
    return sourcePlace(*document, written, text, offset, length);
  };
  if (const auto fault = readValue(a, value)) {
    // A fault in a default is reported once for the element that uses it, at the default's place.
    faults_->add(*source.scope, value.locate(fault->offset, fault->length), *source.node,
                 a.name + ' ' + fault->text, fault->hint);
    return false;
  }
  (void)node;
  if (names_ != nullptr && !a.referenceKind.empty())
    return resolveReferences(source, written, scope, *text, value);
  return true;
}

/// Each signal of an element of this scope gets its full name, in braces: arm.phi → {left/arm.phi}.
void AttributeReader::nameSignals(const Scope& scope, ResolvedText& text) const {
  std::vector<NameInFormula> found = signalNames(text.text);
  for (auto signal = found.rbegin(); signal != found.rend(); ++signal) {
    const std::size_t dot = signal->name.find('.', signal->name.find_last_of("/]") + 1);
    if (dot == std::string::npos) continue;
    const std::string head = signal->name.substr(0, dot);
    const std::string full = names_->resolve(head, scope, "element");
    if (full.empty() || full == head) continue;
    text.replace(signal->offset, signal->offset + signal->length,
                 '{' + full + signal->name.substr(dot) + '}');
  }
}

/// Each word of a reference becomes a full name; "body.frame" is looked up by its body.
bool AttributeReader::resolveReferences(const Source& source, const XmlAttribute& written,
                                        const Scope& scope, const ResolvedText& text,
                                        ParameterValue& value) const {
  const std::string& kind = value.declaration->referenceKind;
  const bool mustExist = kind == "system" || kind == "frame" || kind == "contact" ||
                         kind == "force" || kind == "element";
  bool good = true;
  std::string full;
  for (const XmlWord& word : xmlWords(value.text)) {
    const std::size_t dot = std::min(word.text.find('.'), word.text.size());
    const std::string head(word.text.substr(0, dot));
    const std::string found = kind == "material" ? head : names_->resolve(head, scope, kind);
    if (found.empty() && mustExist) {
      const std::string what = kind == "frame" ? "system" : kind;
      const std::string ofBody =
          kind == "frame" ? frameOfBody(source.scope->document->root(), head) : std::string();
      const std::string withBlanks =
          value.declaration->type == AttributeType::names ? partedNames(word.text) : std::string();
      faults_->add(*source.scope,
                   sourcePlace(*source.scope->document, written, text, word.offset, dot),
                   *source.node, "unknown " + what + " \"" + head + '"',
                   !withBlanks.empty() ? "names stand between blanks: \"" + withBlanks + '"'
                   : !ofBody.empty()   ? didYouMean(ofBody)
                                       : unknownNameHint(head, names_->known(scope, kind)));
      good = false;
    }
    full += (full.empty() ? "" : " ") + (found.empty() ? head : found) +
            std::string(word.text.substr(dot));
  }
  value.text = full;
  return good;
}

}  // namespace dynamy
