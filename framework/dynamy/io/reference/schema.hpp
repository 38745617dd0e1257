/// The schema (XSD) of the model file with all registered types: editors complete and check by it.
#pragma once
#include <dynamy/io/plugin/registry.hpp>
#include <string>

namespace dynamy {

/// Text of dynamy.xsd. A model that loads is valid; the schema cannot say all that the loader
/// checks (units, ranges, names): attributes of elements are optional there, because `<defaults>`
/// may give them.
std::string schemaText(const Registry& registry);

}  // namespace dynamy
