#include "import/mesh_skin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/system/convex_hull.hpp>
#include <set>
#include <stdexcept>

namespace dynamy::app {
namespace {
namespace fs = std::filesystem;

/// Unit vectors on a spiral, evenly over the sphere, and the axes.
std::vector<Vec3> directions(int count) {
  constexpr double kGolden = 2.399963229728653;  // angle between neighbours, pi (3 - sqrt 5)
  std::vector<Vec3> out;
  for (int i = 0; i < 3; ++i) out.push_back(Vec3::Unit(i)), out.push_back(-Vec3::Unit(i));
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, r = std::sqrt(1.0 - z * z);
    out.emplace_back(r * std::cos(kGolden * i), r * std::sin(kGolden * i), z);
  }
  return out;
}

std::size_t farthest(const std::vector<Vec3>& points, const Vec3& n) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (n.dot(points[i]) > n.dot(points[best])) best = i;
  return best;
}

bool flat(const std::vector<Vec3>& points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / static_cast<double>(points.size());
  Mat3 C = Mat3::Zero();
  for (const Vec3& p : points) C += (p - mean) * (p - mean).transpose();
  return !(std::abs(C.determinant()) > 1e-18 * std::pow(C.trace() / 3.0, 3));
}

}  // namespace

std::vector<Vec3> outermostPoints(const std::vector<Vec3>& points) {
  static const std::vector<Vec3> all = directions(162);
  std::set<std::size_t> kept;
  for (const Vec3& n : all) kept.insert(farthest(points, n));
  std::vector<Vec3> out;
  for (const std::size_t i : kept) out.push_back(points[i]);
  return out;
}

std::vector<Vec3> extremePoints(const std::vector<Vec3>& points, double& inside) {
  std::vector<Vec3> out = outermostPoints(points);
  inside = 0.0;
  for (const Triangle& f : convexHull(out)) {
    const Vec3 &a = out[at(f[0])], n = (out[at(f[1])] - a).cross(out[at(f[2])] - a).normalized();
    for (const Vec3& p : points) inside = std::max(inside, n.dot(p - a));
  }
  return out;
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

bool MeshSkins::read(const XmlNode& node, const std::string& name, const Vec3& scale, Skin& skin) {
  const TriangleMesh* mesh = name.empty() ? nullptr : this->mesh(node, name, scale);
  if (!mesh) return false;
  double inside = 0.0;
  skin.kind = Skin::Kind::hull;
  skin.points = extremePoints(mesh->points, inside);
  if (flat(skin.points)) {
    read_.note(node, fmt::format("mesh \"{}\" is left out: its points lie in a plane", name));
    return false;
  }
  read_.note(node, fmt::format("mesh \"{}\" {} by its convex hull, of {} points, at most {:.2g} m "
                               "inside of that of all {}",
                               name, skin.touches ? "touches" : "is shown", skin.points.size(),
                               inside, mesh->points.size()));
  return true;
}

}  // namespace dynamy::app
