/// Registers the joints and the elements that act in joint coordinates.
#pragma once
#include <dynamy/io/plugin/registry.hpp>

namespace dynamy {

void registerJoints(Registry& r);

}  // namespace dynamy
