/// Registers Coordinates, CoordinateFrame and CoordinateContact.
#pragma once
#include <dynamy/io/plugin/registry.hpp>

namespace dynamy {

void registerCoordinates(Registry& registry);

}  // namespace dynamy
