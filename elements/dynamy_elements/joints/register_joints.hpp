/// The joints and what acts in them.
#pragma once
#include <dynamy/io/plugin/registry.hpp>

namespace dynamy {

void registerJoints(Registry& r);

}  // namespace dynamy
