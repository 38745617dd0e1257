#include "import/sdf_shapes.hpp"

#include "import/colour.hpp"
#include "import/sdf_frames.hpp"

namespace dynamy::app {

Inertia SdfShapes::inertia(const XmlNode& node) {
  Inertia own, out;
  own.mass = 1.0;
  own.J = Mat3::Identity();
  read_.readOnly(node, {}, {"pose", "mass", "inertia"},
                 {{"fluid_added_mass", "there is no fluid"}});
  if (const XmlNode* mass = childOf(node, "mass")) own.mass = read_.numberOf(*mass);
  if (!(own.mass > 0.0)) read_.fault(node, "the mass is not positive");
  if (const XmlNode* J = childOf(node, "inertia")) {
    double v[6] = {1.0, 1.0, 1.0, 0.0, 0.0, 0.0};
    const char* const kNames[] = {"ixx", "iyy", "izz", "ixy", "ixz", "iyz"};
    for (int i = 0; i < 6; ++i)
      if (const XmlNode* entry = childOf(*J, kNames[i])) v[i] = read_.numberOf(*entry);
    own.J << v[0], v[3], v[4], v[3], v[1], v[5], v[4], v[5], v[2];
  }
  out.add(own, sdfPose(node, read_));
  return out;
}

double SdfShapes::size(const XmlNode& shape, const char* name) {
  const XmlNode* own = childOf(shape, name);
  const double x = own != nullptr ? read_.numberOf(*own) : 0.0;
  if (!(x > 0.0)) read_.fault(shape, std::string("<") + name + "> is missing or not positive");
  return x;
}

Vec3 SdfShapes::sizes(const XmlNode& shape, const char* name) {
  const XmlNode* own = childOf(shape, name);
  const auto v = own != nullptr ? read_.numbersOf(*own, 3) : std::vector<double>();
  Vec3 out = v.empty() ? Vec3(Vec3::Zero()) : Vec3(v[0], v[1], v[2]);
  if (!(out.minCoeff() > 0.0))
    read_.fault(shape, std::string("<") + name + "> is missing or not positive");
  return out;
}

bool SdfShapes::geometry(const XmlNode& shape, Skin& out) {
  using Kind = Skin::Kind;
  if (shape.tag == "box") {
    out.kind = Kind::box, out.size = sizes(shape, "size");
  } else if (shape.tag == "sphere") {
    out.kind = Kind::sphere, out.size.x() = size(shape, "radius");
  } else if (shape.tag == "ellipsoid") {
    out.kind = Kind::ellipsoid, out.size = sizes(shape, "radii");
  } else if (shape.tag == "cylinder" || shape.tag == "capsule") {
    out.kind = shape.tag == "capsule" ? Kind::capsule : Kind::cylinder;
    out.size.x() = size(shape, "radius"), out.size.y() = size(shape, "length");
  } else if (shape.tag == "plane") {
    out.kind = Kind::plane;
    if (const XmlNode* normal = childOf(shape, "normal"))
      if (const auto n = read_.numbersOf(*normal, 3); !n.empty())
        out.pose = out.pose * Pose{Vec3::Zero(), zAlong(Vec3(n[0], n[1], n[2]))};
  } else if (shape.tag == "mesh") {
    const XmlNode* uri = childOf(shape, "uri");
    if (uri == nullptr) {
      read_.fault(shape, "<uri> is missing");
      return false;
    }
    Vec3 scale = Vec3::Ones();
    if (const XmlNode* own = childOf(shape, "scale"))
      if (const auto v = read_.numbersOf(*own, 3); !v.empty()) scale = Vec3(v[0], v[1], v[2]);
    return meshes_.read(shape, uri->text, scale, out);
  } else {
    read_.note(shape, "shapes of this kind are left out");
    return false;
  }
  return true;
}

void SdfShapes::surface(const XmlNode& node, Skin& out) {
  const XmlNode* surface = childOf(node, "surface");
  if (surface == nullptr) return;
  const XmlNode* friction = childOf(*surface, "friction");
  read_.readOnly(*surface, {}, {"friction"},
                 {{"contact", "contacts are rigid"},
                  {"bounce", "restitution belongs to pairs: give it to <Material>"},
                  {"soft_contact", "contacts are rigid"}});
  if (friction == nullptr) return;
  read_.readOnly(*friction, {}, {"ode", "bullet"},
                 {{"torsional", "friction against turning is not taken over"}});
  if (const XmlNode* ode = childOf(*friction, "ode"))
    if (const XmlNode* mu = childOf(*ode, "mu")) out.mu = std::max(read_.numberOf(*mu), 0.0);
  if (const XmlNode* bullet = childOf(*friction, "bullet"))
    if (const XmlNode* mu = childOf(*bullet, "friction"))
      out.mu = std::max(read_.numberOf(*mu), 0.0);
}

std::string SdfShapes::colour(const XmlNode& node) {
  if (const XmlNode* material = childOf(node, "material"))
    if (const XmlNode* diffuse = childOf(*material, "diffuse"))
      if (const auto rgba = read_.numbersOf(*diffuse); rgba.size() >= 3) return hexColour(rgba);
  return {};
}

bool SdfShapes::skin(const XmlNode& node, Skin& out) {
  out.touches = node.tag == "collision";
  out.pose = sdfPose(node, read_);
  read_.readOnly(node, {"name"},
                 {"pose", "geometry", "surface", "material", "cast_shadows", "visibility_flags"},
                 {{"density", "mass and inertia are those of <inertial>"},
                  {"transparency", "pictures are not transparent"}});
  surface(node, out);
  out.colour = colour(node);
  const XmlNode* shape = childOf(node, "geometry");
  if (shape == nullptr || shape->children.empty()) {
    read_.fault(node, "<geometry> is missing");
    return false;
  }
  return geometry(shape->children.front(), out);
}

std::vector<Skin> SdfShapes::skins(const XmlNode& link) {
  std::vector<Skin> out;
  const bool touches = childOf(link, "collision") != nullptr;
  for (const XmlNode* c : childrenOf(link, touches ? "collision" : "visual"))
    if (Skin made; skin(*c, made)) out.push_back(made);
  for (const XmlNode* c : childrenOf(link, "visual"))
    if (Skin made; touches && isOfMesh(*c) && skin(*c, made)) out.push_back(made);
  // Shapes of contact are drawn in the colour of the picture that they stand for.
  std::string seen;
  for (const XmlNode* c : childrenOf(link, "visual"))
    if (touches && seen.empty()) seen = colour(*c);
  drawMeshes(out, seen);
  return out;
}

}  // namespace dynamy::app
