/// Reads `<defaults>`: attributes that elements of a type, or of a class of it, have in common.
#pragma once
#include <dynamy/io/model/model_scope.hpp>
#include <dynamy/io/plugin/registry.hpp>
#include <dynamy/io/xml/vocabulary.hpp>

namespace dynamy {

/// Adds the `<defaults>` of a file to its scope; errors go to `faults`.
void readDefaults(const XmlNode& root, Scope& scope, const Registry& registry,
                  const Vocabulary& vocabulary, Faults& faults);

}  // namespace dynamy
