#include "import/mjcf_geoms.hpp"

#include <fmt/format.h>

#include <dynamy/core/suggestion.hpp>
#include <filesystem>

#include "import/colour.hpp"
#include "import/solids.hpp"

namespace dynamy::app {
namespace {

/// The last group of shapes that is shown if nothing else is said.
constexpr double kLastShown = 2.0;
constexpr double kWater = 1000.0;  // default density [kg/m³]

/// Number `i` of an attribute with several; `otherwise` if there are fewer.
double entry(const std::vector<double>& all, std::size_t i, double otherwise) {
  return i < all.size() ? all[i] : otherwise;
}

}  // namespace

void MjcfGeoms::assets(const XmlNode& node) {
  read_.readOnly(node, {}, {"material", "mesh"},
                 {{"texture", "pictures on surfaces are not shown"},
                  {"hfield", "ground of heights: is not taken over"},
                  {"model", "models in models are not taken over"}});
  for (const XmlNode& c : node.children) {
    const XmlNode full = defaults_.resolved(c, "", read_);
    if (c.tag == "mesh") meshAsset(full);
    if (c.tag != "material") continue;
    if (const auto rgba = read_.numbers(full, "rgba", 4); !rgba.empty())
      colours_[valueOf(c, "name", "")] = hexColour(rgba);
  }
}

void MjcfGeoms::meshAsset(const XmlNode& node) {
  const std::string file = valueOf(node, "file", "");
  std::string name = valueOf(node, "name", std::filesystem::path(file).stem().string());
  if (file.empty()) {
    read_.note(node, "a mesh without a file is left out");
    return;
  }
  const std::string place =
      compiler_.stripPath ? std::filesystem::path(file).filename().string() : file;
  Mesh mesh{node,
            (std::filesystem::path(compiler_.meshFolder) / place).string(),
            read_.vector(node, "scale", Vec3::Ones()),
            {}};
  mesh.reference.r = read_.vector(node, "refpos", Vec3::Zero());
  if (const auto p = read_.numbers(node, "refquat", 4); !p.empty())
    mesh.reference.A = fromQuaternion(p[0], p[1], p[2], p[3]);
  read_.readOnly(node, {"name", "class", "file", "scale", "refpos", "refquat"}, {},
                 {{"inertia", "the inertia is that of the closed mesh"}});
  files_[name] = std::move(mesh);
}

std::string MjcfGeoms::colour(const XmlNode& node) {
  if (const auto rgba = read_.numbers(node, "rgba", 4); !rgba.empty()) return hexColour(rgba);
  const auto found = colours_.find(valueOf(node, "material", ""));
  return found == colours_.end() ? std::string() : found->second;
}

/// Half sizes of the file, or two end points, as sizes of the shape.
void MjcfGeoms::sizes(const XmlNode& node, const std::string& type, Skin& skin) {
  using Kind = Skin::Kind;
  std::vector<double> half = read_.numbers(node, "size");
  std::size_t needed = type == "sphere" ? 1 : type == "capsule" || type == "cylinder" ? 2 : 3;
  if (const auto ends = read_.numbers(node, "fromto", 6); !ends.empty()) {
    const Vec3 from(ends[0], ends[1], ends[2]), to(ends[3], ends[4], ends[5]);
    if (half.empty() || (from - to).norm() < 1e-12 || needed < 2) {
      read_.fault(node, "fromto is for capsules, cylinders, boxes and ellipsoids with a size");
      return;
    }
    skin.pose = {0.5 * (from + to), zAlong(from - to)};
    half.resize(1);
    if (needed == 3) half.push_back(half[0]);
    half.push_back(0.5 * (from - to).norm());
  }
  for (std::size_t i = 0; i < needed; ++i)
    if (!(entry(half, i, 0.0) > 0.0)) {
      read_.fault(node, fmt::format("a {} has {} positive sizes", type, needed));
      return;
    }
  if (type == "box" || type == "ellipsoid") {
    skin.kind = type == "box" ? Kind::box : Kind::ellipsoid;
    skin.size = (type == "box" ? 2.0 : 1.0) * Vec3(half[0], half[1], half[2]);
  } else {
    skin.kind = type == "sphere"    ? Kind::sphere
                : type == "capsule" ? Kind::capsule
                                    : Kind::cylinder;
    skin.size = Vec3(half[0], needed > 1 ? 2.0 * half[1] : 0.0, 0.0);
  }
}

void MjcfGeoms::contact(const XmlNode& node, Skin& skin) {
  skin.category = static_cast<unsigned>(read_.number(node, "contype", 1.0));
  skin.collidesWith = static_cast<unsigned>(read_.number(node, "conaffinity", 1.0));
  skin.touches = skin.category != 0 || skin.collidesWith != 0;
  skin.mu = entry(read_.numbers(node, "friction"), 0, 1.0);
  const double rows = read_.number(node, "condim", 3.0);
  if (rows == 1.0) skin.mu = 0.0;
  if (rows > 3.0) read_.note(node, "friction against turning and rolling is not taken over");
}

double MjcfGeoms::mass(const XmlNode& node, double volume) {
  if (node.attribute("mass") != nullptr) return read_.number(node, "mass", 0.0);
  return volume * read_.number(node, "density", kWater);
}

bool MjcfGeoms::mesh(const XmlNode& node, MjcfGeom& out) {
  const std::string name = valueOf(node, "mesh", "");
  const auto found = files_.find(name);
  if (found == files_.end()) {
    std::vector<std::string> known;
    for (const auto& [key, mesh] : files_) known.push_back(key);
    read_.note(node, "there is no mesh \"" + name + "\" of a file: the geom is left out");
    return false;
  }
  const Mesh& asset = found->second;
  const TriangleMesh* mesh = meshes_.mesh(asset.node, asset.path, asset.scale);
  if (!mesh) return false;
  out.skin.pose = out.skin.pose * asset.reference.inverse();
  Inertia own = enclosedInertia(*mesh);
  if (!closed(*mesh))
    read_.note(node, "mesh \"" + name + "\" is not closed: its mass is no volume");
  if (own.mass < 0.0) own.mass = -own.mass, own.J = -own.J;
  const double all = mass(node, own.mass);
  own.J *= all / own.mass, own.mass = all;
  out.inertia = {};
  out.inertia.add(own, out.skin.pose);
  return meshes_.read(asset.node, asset.path, asset.scale, out.skin);
}

MjcfGeom MjcfGeoms::geom(const XmlNode& node) {
  MjcfGeom out;
  const std::string fallback = node.attribute("mesh") != nullptr ? "mesh" : "sphere";
  const std::string type = read_.word(
      node, "type", valueOf(node, "type", fallback),
      {"sphere", "capsule", "box", "cylinder", "ellipsoid", "plane", "mesh", "hfield", "sdf"});
  read_.readOnly(node, {"name",        "class",    "type",   "pos",  "quat",   "axisangle",
                        "euler",       "xyaxes",   "zaxis",  "size", "fromto", "contype",
                        "conaffinity", "friction", "condim", "mass", "rgba",   "mesh",
                        "material",    "density",  "group",  "user"},
                 {},
                 {{"shellinertia", "its mass is taken as filling the shape"},
                  {"solref", "contacts are rigid"},
                  {"solimp", "contacts are rigid"},
                  {"solmix", "contacts are rigid"},
                  {"margin", "contacts act at distance zero"},
                  {"gap", "contacts act at distance zero"},
                  {"priority", "of two coefficients of friction the larger one counts"},
                  {"fluidshape", "there is no fluid"},
                  {"fluidcoef", "there is no fluid"},
                  {"fitscale", "shapes fitted to meshes are not taken over"}});
  out.skin.pose = compiler_.pose(node, read_);
  contact(node, out.skin);
  out.skin.colour = colour(node);
  if (type == "plane") {
    out.skin.kind = Skin::Kind::plane;
    out.shows = true;
    return out;
  }
  if (type == "mesh") {
    out.shows = mesh(node, out);
  } else if (type == "hfield" || type == "sdf") {
    read_.note(node, "shapes of type " + type + " are left out");
    return out;
  } else if (node.attribute("mesh") != nullptr) {
    read_.note(node, "shapes fitted to meshes are left out");
    return out;
  } else {
    sizes(node, type, out.skin);
    out.shows = true;
    out.inertia = solidInertia(out.skin, mass(node, volume(out.skin)));
  }
  const double group = read_.number(node, "group", 0.0);
  out.skin.hidden = group > kLastShown;
  if (group < compiler_.firstGroup || group > compiler_.lastGroup) out.inertia = {};
  return out;
}

}  // namespace dynamy::app
