/// Mass properties of solids, about their centre and in their axes.
#pragma once
#include "import/machine.hpp"

namespace dynamy::app {

/// Volume of a shape [m³]; 0 for planes.
double volume(const Skin& skin);

/// Mass properties of a shape of given mass [kg] in the axes of its link. A hull has those of
/// `mesh`, whose mass is its volume.
Inertia solidInertia(const Skin& skin, double mass);

}  // namespace dynamy::app
