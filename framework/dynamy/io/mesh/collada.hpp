/// Files of COLLADA 1.4: triangles and polygons of all geometries that the scene shows, where its nodes
/// put them, in metres. Axes are those of the file, whatever it says is up: so robots' viewers draw them.
#pragma once
#include <dynamy/io/mesh/mesh_file.hpp>

namespace dynamy {

/// \throws std::runtime_error with the reason
TriangleMesh readCollada(const std::filesystem::path& file);

}  // namespace dynamy
