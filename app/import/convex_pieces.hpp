/// Convex pieces of the solid that closed triangles enclose.
///
/// Contacts between convex bodies are exact, and a body may have many of them. The solid is cut by
/// planes across the axes of its file, again and again the piece whose hull exceeds it most, where the
/// hulls of the two parts exceed them least. Planes go through corners of the mesh, so that a body of
/// blocks along the axes is met exactly, and at quarters. A piece is the hull of the solid within a
/// box: of the triangles that are clipped to it, and of the box's corners inside of the solid.
///
/// Pieces of many corners keep the outermost ones in 168 directions.
///
/// Rejected: hulls of groups of triangles, which need not contain what is inside of the solid.
#pragma once
#include <dynamy/io/mesh/mesh_file.hpp>
#include <string>
#include <vector>

namespace dynamy::app {

struct ConvexPieces {
  std::vector<std::vector<Vec3>> corners;  ///< of each piece [m]
  double volume = 0.0;                     ///< of the solid [m³]
  double excess = 0.0;  ///< volume of all pieces less that of the solid, over the latter
  double inside =
      0.0;  ///< at most by this a piece is inside of the hull of its part of the solid [m]
  /// "4 convex pieces, together 1.2 % larger than its volume; they contain it". `size`: of the mesh.
  std::string text(double size) const;
};

/// Triangles that face inwards are turned round.
void turnOutwards(TriangleMesh& mesh);

/// \pre `mesh` is closed and encloses a volume. At most `most` pieces, fewer where they exceed the
/// solid by less than 1 % together.
ConvexPieces convexPieces(const TriangleMesh& mesh, int most);

}  // namespace dynamy::app
