/// Texts for `dynamy describe NAME` and `dynamy list`, made from the declarations in the registry.
#pragma once
#include <dynamy/io/plugin/registry.hpp>
#include <string>
#include <string_view>

namespace dynamy {

/// Describes `name`, a type or a word of the format such as "simulation": text, table of
/// attributes, children, example. For another word, such as "friction": the types about it, or else
/// the attributes of that name, including names that other programs use. Throws ModelError with the
/// nearest name if there is nothing.
std::string describe(const Registry& registry, std::string_view name);

/// Types by kind, one line each.
std::string listTypes(const std::vector<const RegisteredType*>& types);

}  // namespace dynamy
