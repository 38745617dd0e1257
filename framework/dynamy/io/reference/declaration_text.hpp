/// Words for declared attributes, the same in `describe` and in the schema.
#pragma once
#include <dynamy/core/declared/attributes.hpp>
#include <string>

namespace dynamy {

std::string typeText(
    const Attribute& a);  ///< "number", "3 numbers", "stop | warn", "name of a system"
std::string defaultText(const Attribute& a);   ///< value, "required", or "-" for none
std::string rangeText(const Attribute& a);     ///< "> 0", ">= 0", "0 … 1", "not zero", "-"
std::string countText(const ChildRule& rule);  ///< "1", "0 to 3", "any number of"

}  // namespace dynamy
