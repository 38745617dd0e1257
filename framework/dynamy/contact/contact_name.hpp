/// Names of contacts in messages.
#pragma once
#include <dynamy/contact/non_smooth_element.hpp>

namespace dynamy {

/// Name of contact `id` of element `e`, which has this number: its own name, that of the contact
/// behind a dot, else type and number.
std::string contactName(const NonSmoothElement& e, std::size_t number, std::uint64_t id);

}  // namespace dynamy
