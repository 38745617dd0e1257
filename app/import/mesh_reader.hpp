/// A mesh file as a machine: one body over a floor.
#pragma once
#include "import/import_options.hpp"
#include "import/machine.hpp"

namespace dynamy::app {

/// A body of the density given, that touches by convex pieces of its mesh, and stands with its lowest
/// point on a floor. Throws ModelError with the reason if the mesh cannot be read or encloses nothing.
Machine readMeshBody(const std::string& file, const ImportOptions& options);

}  // namespace dynamy::app
