/// Triangles of mesh files: STL, OBJ, PLY and COLLADA (.dae).
#pragma once
#include <Eigen/Geometry>
#include <dynamy/system/convex_hull.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace dynamy {

struct TriangleMesh {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

/// Is the file one of a mesh, by its ending?
bool isMeshFile(const std::filesystem::path& file);

/// \throws std::runtime_error with the reason if the file is missing, of another format or damaged
TriangleMesh readMesh(const std::filesystem::path& file);

/// Mass properties of the solid that closed triangles enclose (system/convex_hull.hpp).
MassProperties enclosed(const TriangleMesh& mesh);

/// The box of all triangles, along the axes. \pre there are some
Eigen::AlignedBox3d extentOf(const TriangleMesh& mesh);

/// Does every edge belong to two triangles that run along it in opposite directions?
bool closed(const TriangleMesh& mesh);

}  // namespace dynamy
