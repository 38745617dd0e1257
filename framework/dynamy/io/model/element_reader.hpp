/// ElementReader: makes an element and its children from XML.
#pragma once
#include <dynamy/io/model/model_source.hpp>
#include <dynamy/io/plugin/registry.hpp>

namespace dynamy {

class ElementReader {
 public:
  /// `plugins` knows whose code may run.
  ElementReader(const Registry& registry, const NameTable& names, ModelSource& source,
                const PluginLoader& plugins, Faults& faults)
      : registry_(&registry),
        source_(&source),
        plugins_(&plugins),
        faults_(&faults),
        attributes_(faults, &names) {}

  /// The element of `node`, or null if anything in it was wrong. `name`: its full name.
  std::unique_ptr<Element> read(const XmlNode& node, const Scope& scope, const RegisteredType& type,
                                std::string name);
  /// The type of `node` if it may stand in the word `section`; otherwise null, and the error is
  /// reported.
  const RegisteredType* typeIn(const Word& section, const XmlNode& node, const Scope& scope,
                               const XmlNode& parent);

 private:
  bool readChildren(const XmlNode& node, const Scope& scope, const RegisteredType& type,
                    Parameters& x);
  bool readChild(const XmlNode& child, const Scope& scope, const XmlNode& parent,
                 const RegisteredType& type, std::vector<int>& counts, Parameters& x);
  void unknownElement(const XmlNode& node, const Scope& scope, const XmlNode& parent,
                      const std::vector<std::string>& allowed);
  std::string asAttribute(const std::string& tag, const std::string& parent) const;
  const Registry* registry_;
  ModelSource* source_;
  const PluginLoader* plugins_;
  Faults* faults_;
  AttributeReader attributes_;
};

}  // namespace dynamy
