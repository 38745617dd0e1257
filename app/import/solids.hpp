/// Mass properties of solids, about their centre and in their axes.
#pragma once
#include <dynamy/io/mesh/mesh_file.hpp>

#include "import/machine.hpp"

namespace dynamy::app {

/// Volume of a shape [m³]; 0 for planes.
double volume(const Skin& skin);

/// Mass properties of a shape of given mass [kg] in the axes of its link. A hull has those of
/// `mesh`, whose mass is its volume.
Inertia solidInertia(const Skin& skin, double mass);

/// Mass properties of the solid that closed triangles enclose, of density 1: its mass is the volume.
/// Mass and J are negative if the triangles face inwards.
Inertia enclosedInertia(const TriangleMesh& mesh);

}  // namespace dynamy::app
