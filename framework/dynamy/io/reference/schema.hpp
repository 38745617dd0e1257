/// The schema (XSD) of the model file with all registered types, by which editors complete and
/// check.
#pragma once
#include <dynamy/io/plugin/registry.hpp>
#include <string>

namespace dynamy {

/// Text of dynamy.xsd. Every model that loads is valid, but the schema cannot express all checks of
/// the loader (units, ranges, names). Attributes of elements are optional in it, because
/// `<defaults>` may give them.
std::string schemaText(const Registry& registry);

}  // namespace dynamy
