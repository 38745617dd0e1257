#include "import/mesh_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "import/convex_pieces.hpp"
#include "import/mesh_file.hpp"

namespace dynamy::app {
namespace {

constexpr double kFriction = 0.5;

TriangleMesh scaledMesh(const std::string& file, double scale) {
  try {
    TriangleMesh mesh = readMesh(file);
    for (Vec3& p : mesh.points) p *= scale;
    return mesh;
  } catch (const std::runtime_error& e) {
    throw ModelError(file + ": " + e.what());
  }
}

/// Triangles that face inwards are turned round.
void turnOutwards(TriangleMesh& mesh) {
  if (enclosedInertia(mesh).mass < 0.0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
}

}  // namespace

Machine readMeshBody(const std::string& file, const ImportOptions& options) {
  TriangleMesh mesh = scaledMesh(file, options.scale);
  if (!closed(mesh))
    throw ModelError(
        file + ": the triangles do not enclose a volume: edges have no second triangle",
        "close the mesh in the program that wrote it");
  turnOutwards(mesh);
  Machine out;
  out.name = std::filesystem::path(file).stem().string();
  const auto say = [&](const std::string& text) {
    out.notes.push_back({{}, "mesh " + out.name, text});
  };
  Link body;
  body.name = out.name, body.free = true;
  body.inertia = enclosedInertia(mesh);
  const Eigen::AlignedBox3d extent = extentOf(mesh);
  const double size = extent.sizes().maxCoeff();
  if (!(body.inertia.mass > 1e-9 * size * size * size))
    throw ModelError(file + ": the triangles enclose no volume");
  const ConvexPieces pieces = convexPieces(mesh, options.pieces);
  body.inertia.mass *= options.density, body.inertia.J *= options.density;
  body.pose.r.z() = -extent.min().z();
  for (const std::vector<Vec3>& corners : pieces.corners) {
    Skin skin;
    skin.kind = Skin::Kind::hull, skin.points = corners, skin.mu = kFriction;
    body.skins.push_back(skin);
  }
  say(fmt::format("is {:.3g} m long, with a mass of {:.4g} kg for {:g} kg/m^3", size,
                  body.inertia.mass, options.density));
  const std::size_t n = pieces.corners.size();
  say(fmt::format("touches by {} convex piece{}, together {:.1f} % {} than its volume; {}", n,
                  n == 1 ? "" : "s", 100.0 * std::abs(pieces.excess),
                  pieces.excess < 0.0 ? "smaller" : "larger",
                  pieces.inside > 1e-9 * size
                      ? fmt::format("their faces are at most {:.2g} m inside of it", pieces.inside)
                      : "they contain it"));
  out.links.push_back(std::move(body));
  Skin floor;
  floor.kind = Skin::Kind::plane, floor.mu = kFriction;
  out.ground.push_back(floor);
  return out;
}

}  // namespace dynamy::app
