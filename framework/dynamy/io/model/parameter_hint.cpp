#include <fmt/format.h>

#include <dynamy/core/declared/unknown_name.hpp>
#include <dynamy/io/model/parameter_hint.hpp>

namespace dynamy {
namespace {

/// The first element below `node` with a number in an attribute `name`; null: there is none.
const XmlNode* holderOf(const XmlNode& node, const std::string& name) {
  const auto isNumber = [](const std::string& text) {
    return !text.empty() && text.find_first_of("0123456789+-.") == 0 &&
           text.find_first_of(" ;{") == std::string::npos;
  };
  if (const XmlAttribute* a = node.attribute(name); a != nullptr && isNumber(a->value))
    return &node;
  for (const XmlNode& child : node.children)
    if (const XmlNode* found = holderOf(child, name)) return found;
  return nullptr;
}

/// The first element below `node` that has this name; null: there is none.
const XmlNode* named(const XmlNode& node, const std::string& name) {
  const XmlAttribute* a = node.attribute("name");
  if (a != nullptr && a->value == name) return &node;
  for (const XmlNode& child : node.children)
    if (const XmlNode* found = named(child, name)) return found;
  return nullptr;
}

}  // namespace

std::string parameterHint(const XmlNode& root, const std::string& asked,
                          const std::vector<std::string>& known) {
  // "box.mass" means the attribute of the element "box".
  const std::size_t dot = asked.rfind('.');
  const std::string name = dot == std::string::npos ? asked : asked.substr(dot + 1);
  const XmlNode* within = dot == std::string::npos ? &root : named(root, asked.substr(0, dot));
  const XmlNode* holder = within == nullptr ? nullptr : holderOf(*within, name);
  if (holder == nullptr) return unknownNameHint(asked, known);
  const XmlAttribute& a = *holder->attribute(name);
  return fmt::format(
      "it is a number of <{}> ({}); to vary it write <parameter name=\"{}\" value=\"{}\"/> and "
      "there {}=\"{{{}}}\"",
      holder->tag, a.valuePlace.format(), name, a.value, name, name);
}

std::string parameterHint(const Model& model, const std::string& name,
                          const std::vector<std::string>& known) {
  if (model.file.text.empty()) return unknownNameHint(name, known);
  const XmlDocument document = XmlDocument::parse(model.file.text, model.file.name);
  return parameterHint(document.root(), name, known);
}

}  // namespace dynamy
