/// Files of PLY, text and binary of either order of bytes. The head names elements and their
/// properties; x, y, z of `vertex` and the list of corners of `face` are read, all others passed over.
#pragma once
#include <dynamy/io/mesh/mesh_file.hpp>

namespace dynamy {

/// \throws std::runtime_error with the reason
TriangleMesh readPly(const std::string& bytes);

}  // namespace dynamy
