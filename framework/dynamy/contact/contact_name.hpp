/// Names of contacts in messages.
#pragma once
#include <dynamy/contact/non_smooth_element.hpp>

namespace dynamy {

/// Name of contact `id` of element `e`: "element.contact", or "element/id" if the element gives
/// the contact no name (id 0 is left out). An element without a name appears as its type and
/// `number`, e.g. "Wall#3".
std::string contactName(const NonSmoothElement& e, std::size_t number, std::uint64_t id);

}  // namespace dynamy
