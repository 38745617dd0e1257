#include "import/mesh_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <dynamy/io/mesh/mesh_file.hpp>
#include <filesystem>

#include "import/convex_pieces.hpp"
#include "import/mesh_skin.hpp"
#include "import/solids.hpp"

namespace dynamy::app {
namespace {

constexpr double kFriction = 0.5;
constexpr int kPieces = 32;  ///< most convex pieces if nothing else is said

TriangleMesh scaledMesh(const std::string& file, double scale) {
  try {
    TriangleMesh mesh = readMesh(file);
    for (Vec3& p : mesh.points) p *= scale;
    return mesh;
  } catch (const std::runtime_error& e) {
    throw ModelError(file + ": " + e.what());
  }
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
  const ConvexPieces pieces = convexPieces(mesh, options.pieces > 0 ? options.pieces : kPieces);
  body.inertia.mass *= options.density, body.inertia.J *= options.density;
  body.pose.r.z() = -extent.min().z();
  Skin skin;
  skin.kind = Skin::Kind::hull, skin.hulls = pieces.corners, skin.mu = kFriction;
  if (mesh.triangles.size() <= kMostDrawn)
    skin.file = file, skin.scale = Vec3::Constant(options.scale);
  body.skins.push_back(skin);
  say(fmt::format("is {:.3g} m long, with a mass of {:.4g} kg for {:g} kg/m^3", size,
                  body.inertia.mass, options.density));
  say("touches by " + pieces.text(size));
  out.links.push_back(std::move(body));
  Skin floor;
  floor.kind = Skin::Kind::plane, floor.mu = kFriction;
  out.ground.push_back(floor);
  return out;
}

}  // namespace dynamy::app
