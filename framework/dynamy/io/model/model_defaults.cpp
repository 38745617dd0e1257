#include <array>
#include <dynamy/core/suggestion.hpp>
#include <dynamy/io/model/attribute_reader.hpp>
#include <dynamy/io/model/model_defaults.hpp>
#include <dynamy/io/model/unknown_element.hpp>

namespace dynamy {
namespace {

constexpr std::array<std::string_view, 2> kNamedClass{"name", "class"};

void readDefault(const XmlNode& node, const XmlNode& section, Scope& scope,
                 const Registry& registry, const Vocabulary& vocabulary, Faults& faults) {
  const RegisteredType* type = registry.find(node.tag);
  if (type == nullptr) {
    std::vector<std::string> known;
    for (const RegisteredType* t : registry.types()) known.push_back(t->name);
    faults.add(scope, node.place, section, "unknown element <" + node.tag + '>',
               meantElement(node.tag, known, registry, vocabulary));
    return;
  }
  AttributeReader(faults, nullptr).allDeclared(node, scope, type->attributes, kNamedClass);
  if (const XmlAttribute* name = node.attribute("name"))
    faults.add(scope, name->namePlace, node, "a default has no name");
  if (!node.children.empty())
    faults.add(scope, node.children[0].place, node, "a default holds attributes only");
  const XmlAttribute* wanted = node.attribute("class");
  DefaultEntry& entry = scope.defaults[node.tag][wanted == nullptr ? "" : wanted->value];
  if (entry.node != nullptr && entry.scope == &scope) {
    Diagnostic d = scope.document->diagnostic(node.place, node, "this default is given twice");
    d.notes.push_back({.place = entry.node->place, .text = "first given here"});
    faults.add(std::move(d));
    return;
  }
  entry = {&node, &scope};
}

}  // namespace

void readDefaults(const XmlNode& root, Scope& scope, const Registry& registry,
                  const Vocabulary& vocabulary, Faults& faults) {
  const std::size_t before = faults.size();
  const std::vector<std::string> defaults{"defaults"};
  for (const XmlNode& section : root.children) {
    if (vocabulary.find(section.tag) == nullptr && !nearest(section.tag, defaults).empty())
      scope.defaultsAreBroken = true;  // reported by walk()
    if (section.tag != "defaults") continue;
    refuseText(section, scope, faults);
    AttributeReader(faults, nullptr).allDeclared(section, scope, {}, {});
    for (const XmlNode& node : section.children)
      if (node.tag != "doc") readDefault(node, section, scope, registry, vocabulary, faults);
  }
  if (faults.size() > before) scope.defaultsAreBroken = true;
}

}  // namespace dynamy
