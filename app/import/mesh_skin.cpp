#include "import/mesh_skin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "import/convex_pieces.hpp"
#include "import/extreme_points.hpp"

namespace dynamy::app {
namespace {
namespace fs = std::filesystem;

bool flat(const std::vector<Vec3>& points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / static_cast<double>(points.size());
  Mat3 C = Mat3::Zero();
  for (const Vec3& p : points) C += (p - mean) * (p - mean).transpose();
  return !(std::abs(C.determinant()) > 1e-18 * std::pow(C.trace() / 3.0, 3));
}

}  // namespace

bool isOfMesh(const XmlNode& node) {
  const XmlNode* shape = childOf(node, "geometry");
  return shape != nullptr && !shape->children.empty() && shape->children.front().tag == "mesh";
}

void drawMeshes(std::vector<Skin>& skins, const std::string& colour) {
  const bool drawn = std::any_of(skins.begin(), skins.end(),
                                 [](const Skin& s) { return s.kind == Skin::Kind::mesh; });
  for (Skin& s : skins) {
    if (s.colour.empty()) s.colour = colour;
    s.hidden = drawn && s.touches;
  }
}

fs::path MeshSkins::found(const std::string& name) const {
  const auto after = [&name](const char* prefix) {
    const std::string p = prefix;
    return name.compare(0, p.size(), p) == 0 ? name.substr(p.size()) : std::string();
  };
  const fs::path folder = fs::path(read_.document().name()).parent_path();
  if (const std::string file = after("file://"); !file.empty()) return file;
  std::string rest = after("package://");
  if (rest.empty()) rest = after("model://");
  if (rest.empty()) return folder / name;
  // Packages lie in the folders given, or around the file; the file's own may be the package.
  std::vector<fs::path> places(options_.packages.begin(), options_.packages.end());
  fs::path up = (fs::current_path() / folder).lexically_normal();
  for (int i = 0; i < 8 && !up.empty(); ++i, up = up.parent_path()) places.push_back(up);
  const std::string own = rest.substr(std::min(rest.find('/'), rest.size() - 1) + 1);
  for (const fs::path& place : places) {
    if (fs::exists(place / rest)) return place / rest;
    if (fs::exists(place / own)) return place / own;
  }
  return {};
}

const TriangleMesh* MeshSkins::mesh(const XmlNode& node, const std::string& name,
                                    const Vec3& scale) {
  const std::string key = fmt::format("{} {} {} {}", name, scale.x(), scale.y(), scale.z());
  if (const auto at = known_.find(key); at != known_.end()) return &at->second;
  try {
    const fs::path file = found(name);
    if (file.empty())
      throw std::runtime_error("its package was not found; --package names a folder that holds it");
    TriangleMesh mesh = readMesh(file);
    for (Vec3& p : mesh.points) p = p.cwiseProduct(scale);
    // A mirror turns the corners of triangles the other way round.
    if (scale.prod() < 0.0)
      for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    return &known_.emplace(key, std::move(mesh)).first->second;
  } catch (const std::exception& e) {
    read_.note(node, fmt::format("mesh \"{}\" is left out: {}", name, e.what()));
    return nullptr;
  }
}

/// Convex pieces of a closed mesh. False with a note for others.
bool MeshSkins::cut(const XmlNode& node, const std::string& name, TriangleMesh mesh, Skin& skin) {
  const double size = extentOf(mesh).sizes().maxCoeff();
  turnOutwards(mesh);
  if (!closed(mesh) || !(enclosed(mesh).volume > 1e-9 * size * size * size)) {
    read_.note(node, fmt::format("mesh \"{}\" is not closed, and has no pieces", name));
    return false;
  }
  const ConvexPieces pieces = convexPieces(mesh, options_.pieces);
  skin.hulls = pieces.corners;
  read_.note(node, fmt::format("mesh \"{}\" touches by {}", name, pieces.text(size)));
  return true;
}

bool MeshSkins::read(const XmlNode& node, const std::string& name, const Vec3& scale, Skin& skin) {
  const TriangleMesh* mesh = name.empty() ? nullptr : this->mesh(node, name, scale);
  if (!mesh) return false;
  if (mesh->triangles.size() <= kMostDrawn) skin.file = found(name), skin.scale = scale;
  if (!skin.touches && !skin.file.empty()) {
    skin.kind = Skin::Kind::mesh;
    return true;
  }
  double inside = 0.0;
  skin.kind = Skin::Kind::hull;
  if (skin.touches && options_.pieces > 1 && cut(node, name, *mesh, skin)) return true;
  skin.hulls = {extremePoints(mesh->points, inside)};
  if (flat(skin.hulls.front())) {
    read_.note(node, fmt::format("mesh \"{}\" is left out: its points lie in a plane", name));
    return false;
  }
  read_.note(node, fmt::format("mesh \"{}\" {} by its convex hull, of {} points, at most {:.2g} m "
                               "inside of that of all {}",
                               name, skin.touches ? "touches" : "is shown",
                               skin.hulls.front().size(), inside, mesh->points.size()));
  return true;
}

}  // namespace dynamy::app
