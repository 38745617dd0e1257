/// Triangles of mesh files: STL (text and binary) and OBJ.
#pragma once
#include <Eigen/Geometry>
#include <array>
#include <dynamy/core/types.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "import/machine.hpp"

namespace dynamy::app {

struct TriangleMesh {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
};

/// Is the file one of a mesh, by its ending?
bool isMeshFile(const std::filesystem::path& file);

/// \throws std::runtime_error with the reason if the file is missing, of another format or damaged
TriangleMesh readMesh(const std::filesystem::path& file);

/// Mass properties of the solid that closed triangles enclose, of density 1, about its centre of
/// mass; the mass is its volume, negative if the triangles face inwards. With a = r_1 …, s = a + b + c:
///   V = Σ det(a b c)/6,   ∫ r dV = Σ det/24 s,   ∫ r rᵀ dV = Σ det/120 (s sᵀ + a aᵀ + b bᵀ + c cᵀ)
Inertia enclosedInertia(const TriangleMesh& mesh);

/// The box of all triangles, along the axes. \pre there are some
Eigen::AlignedBox3d extentOf(const TriangleMesh& mesh);

/// Does every edge belong to two triangles that run along it in opposite directions?
bool closed(const TriangleMesh& mesh);

}  // namespace dynamy::app
