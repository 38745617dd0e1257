#include "import/urdf_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/core/suggestion.hpp>
#include <functional>
#include <map>

#include "import/colour.hpp"
#include "import/element_reader.hpp"
#include "import/mesh_skin.hpp"

namespace dynamy::app {
namespace {

struct UrdfJoint {
  const XmlNode* node = nullptr;
  std::string name, type, parent, child;
};

class UrdfReader {
 public:
  UrdfReader(const XmlDocument& document, const ImportOptions& options)
      : options_(options), read_(document, machine_), meshes_(read_, options) {}
  Machine machine();

 private:
  Pose origin(const XmlNode& node);
  void materials();
  Link link(const XmlNode& node);
  Inertia inertia(const XmlNode& node, const Pose& pose);
  bool geometry(const XmlNode& node, Skin& skin);
  void skin(const XmlNode& node, Link& out);
  std::string colour(const XmlNode& node);
  void joints();
  void carry(Link& link, const UrdfJoint& joint);
  void limits(const XmlNode& node, const std::string& type, MachineJoint& out);
  void dynamics(const XmlNode& node, MachineJoint& out);
  void drive(const XmlNode& node, const MachineJoint& joint);
  void mimic(const XmlNode& node, const std::string& name);
  void order();

  const ImportOptions& options_;
  Machine machine_;
  ElementReader read_;
  MeshSkins meshes_;
  std::map<std::string, std::string> colours_;
  std::map<std::string, Link> links_;
  std::vector<std::string> linkOrder_;
  std::vector<UrdfJoint> joints_;
};

Pose UrdfReader::origin(const XmlNode& node) {
  const XmlNode* at = childOf(node, "origin");
  if (!at) return {};
  const Vec3 r = read_.vector(*at, "xyz", Vec3::Zero());
  if (const auto p = read_.numbers(*at, "quat_xyzw", 4); !p.empty())
    return {r, fromQuaternion(p[3], p[0], p[1], p[2])};
  return {r, rollPitchYaw(read_.vector(*at, "rpy", Vec3::Zero()))};
}

std::string UrdfReader::colour(const XmlNode& node) {
  const XmlNode* material = childOf(node, "material");
  if (!material) return {};
  if (const XmlNode* own = childOf(*material, "color"))
    if (const auto rgba = read_.numbers(*own, "rgba", 4); !rgba.empty()) return hexColour(rgba);
  const auto found = colours_.find(valueOf(*material, "name", ""));
  return found == colours_.end() ? std::string() : found->second;
}

/// Materials with a name, of the robot and of its links.
void UrdfReader::materials() {
  const std::function<void(const XmlNode&)> collect = [&](const XmlNode& node) {
    for (const XmlNode& c : node.children) {
      if (c.tag != "material") {
        if (c.tag == "link" || c.tag == "visual") collect(c);
        continue;
      }
      if (const XmlNode* own = childOf(c, "color"))
        if (const auto rgba = read_.numbers(*own, "rgba", 4); !rgba.empty())
          colours_.emplace(valueOf(c, "name", ""), hexColour(rgba));
      if (const XmlNode* texture = childOf(c, "texture"))
        read_.note(*texture, "pictures on surfaces are not shown");
    }
  };
  collect(read_.document().root());
}

Inertia UrdfReader::inertia(const XmlNode& node, const Pose& pose) {
  Inertia own, out;
  read_.readOnly(node, {}, {"origin", "mass", "inertia"});
  const XmlNode* mass = childOf(node, "mass");
  const XmlNode* J = childOf(node, "inertia");
  if (!mass || !J) {
    read_.fault(node, std::string("<") + (mass ? "inertia" : "mass") + "> is missing");
    return out;
  }
  own.mass = read_.requiredNumber(*mass, "value");
  if (own.mass < 0.0) read_.fault(*mass, "the mass is negative");
  double v[6];
  const char* const kNames[] = {"ixx", "iyy", "izz", "ixy", "ixz", "iyz"};
  for (int i = 0; i < 6; ++i)
    v[i] = i < 3 ? read_.requiredNumber(*J, kNames[i]) : read_.number(*J, kNames[i], 0.0);
  own.J << v[0], v[3], v[4], v[3], v[1], v[5], v[4], v[5], v[2];
  out.add(own, pose);
  return out;
}

bool UrdfReader::geometry(const XmlNode& node, Skin& skin) {
  using Kind = Skin::Kind;
  if (node.children.empty()) {
    read_.fault(node, "has no shape", "box, cylinder, sphere, capsule or mesh");
    return false;
  }
  const XmlNode& shape = node.children.front();
  const std::string kind =
      read_.word(shape, "shape", shape.tag, {"box", "cylinder", "sphere", "capsule", "mesh"});
  if (kind == "mesh") {
    const Vec3 scale = read_.vector(shape, "scale", Vec3::Ones());
    return meshes_.read(shape, read_.required(shape, "filename"), scale, skin);
  }
  if (kind == "box") {
    skin.kind = Kind::box;
    read_.required(shape, "size");
    skin.size = read_.vector(shape, "size", Vec3::Ones());
  } else if (kind == "sphere") {
    skin.kind = Kind::sphere;
    skin.size.x() = read_.requiredNumber(shape, "radius");
  } else {
    skin.kind = kind == "capsule" ? Kind::capsule : Kind::cylinder;
    skin.size.x() = read_.requiredNumber(shape, "radius");
    skin.size.y() = read_.requiredNumber(shape, "length");
  }
  const int sizes = kind == "box" ? 3 : kind == "sphere" ? 1 : 2;
  if (shape.tag == kind && !(skin.size.head(sizes).minCoeff() > 0.0))
    read_.fault(shape, "its size is not positive");
  return true;
}

void UrdfReader::skin(const XmlNode& node, Link& out) {
  Skin skin;
  skin.touches = node.tag == "collision";
  const XmlNode* shape = childOf(node, "geometry");
  if (!shape) {
    read_.fault(node, "<geometry> is missing");
    return;
  }
  read_.readOnly(node, {"name", "group"}, {"origin", "geometry", "material", "verbose"});
  skin.pose = origin(node);
  skin.colour = colour(node);
  if (geometry(*shape, skin)) out.skins.push_back(skin);
}

Link UrdfReader::link(const XmlNode& node) {
  Link out;
  out.name = read_.required(node, "name");
  out.place = node.place;
  read_.readOnly(node, {"name", "type"}, {"inertial", "visual", "collision"},
                 {{"contact", "friction is that of the pair of materials"},
                  {"self_collision_checking", "say --self-contact"}});
  if (const XmlNode* own = childOf(node, "inertial")) out.inertia = inertia(*own, origin(*own));
  const bool touches = childOf(node, "collision") != nullptr;
  std::string seen;  // colour of the first picture that has one
  for (const XmlNode& c : node.children) {
    if (c.tag == "collision") skin(c, out);
    // A shape of contact is also drawn; two pictures of one body would hide each other.
    if (c.tag == "visual" && !touches) skin(c, out);
    if (c.tag != "visual" || !touches) continue;
    if (seen.empty()) seen = colour(c);
    if (isOfMesh(c)) skin(c, out);
    if (!isOfMesh(c)) read_.note(c, "the shapes of <collision> are drawn instead, in its colour");
  }
  drawMeshes(out.skins, seen);
  return out;
}

void UrdfReader::limits(const XmlNode& node, const std::string& type, MachineJoint& out) {
  const XmlNode* limit = childOf(node, "limit");
  const bool bounded = type == "revolute" || type == "prismatic";
  if (!limit) {
    if (bounded)
      read_.fault(node, "<limit> is missing", "a joint without limits is of type continuous");
    return;
  }
  read_.readOnly(*limit, {"lower", "upper", options_.drives ? "effort" : "lower"}, {},
                 {{"effort", "limits a drive; the model has none: say --drives"},
                  {"velocity", "limits a drive; the model has none"},
                  {"acceleration", "limits a drive; the model has none"}});
  const double lower = read_.number(*limit, "lower", 0.0),
               upper = read_.number(*limit, "upper", 0.0);
  if (!bounded) return;
  if (lower > upper) read_.fault(*limit, "lower is above upper");
  // Without both of them the joint has no limits in use; equal ones say nothing.
  if (lower == upper) {
    read_.note(*limit, "equal bounds are taken as none");
    return;
  }
  if (std::isfinite(lower)) out.lower = lower;
  if (std::isfinite(upper)) out.upper = upper;
}

/// With --drives: an input gives the joint its force, as far as the limit `effort` lets it.
void UrdfReader::drive(const XmlNode& node, const MachineJoint& joint) {
  if (!options_.drives || joint.kind == MachineJoint::Kind::ball || childOf(node, "mimic")) return;
  Drive out;
  out.name = joint.name + "_drive", out.joint = joint.name, out.place = node.place;
  const XmlNode* limit = childOf(node, "limit");
  const double effort = limit ? read_.number(*limit, "effort", 0.0) : 0.0;
  if (effort > 0.0) out.lowForce = -effort, out.highForce = effort;
  machine_.drives.push_back(out);
}

void UrdfReader::dynamics(const XmlNode& node, MachineJoint& out) {
  const XmlNode* own = childOf(node, "dynamics");
  if (!own) return;
  read_.readOnly(*own, {"damping", "friction", "armature"}, {},
                 {{"spring_stiffness", "is no attribute of the format"},
                  {"spring_reference", "is no attribute of the format"}});
  out.damping = read_.number(*own, "damping", 0.0);
  out.friction = read_.number(*own, "friction", 0.0);
  out.inertia = read_.number(*own, "armature", 0.0);
  if (out.damping < 0.0 || out.friction < 0.0 || out.inertia < 0.0)
    read_.fault(*own, "damping, friction and armature are not negative");
}

void UrdfReader::mimic(const XmlNode& node, const std::string& name) {
  const XmlNode* own = childOf(node, "mimic");
  if (!own) return;
  if (read_.number(*own, "offset", 0.0) != 0.0)
    read_.note(*own, "the offset is that of the start: rates are coupled, not positions");
  machine_.couplings.push_back({name + "_mimic", read_.required(*own, "joint"), name,
                                read_.number(*own, "multiplier", 1.0), own->place});
}

/// Gives the link its parent's joint.
void UrdfReader::carry(Link& link, const UrdfJoint& j) {
  const XmlNode& node = *j.node;
  link.pose = origin(node);
  read_.readOnly(node, {"name", "type"},
                 {"origin", "parent", "child", "axis", "limit", "dynamics", "mimic"},
                 {{"calibration", "is for drives; the model has none"},
                  {"safety_controller", "is for drives; the model has none"}});
  if (j.type == "fixed") return;
  if (j.type == "floating") {
    link.free = true;
    read_.note(node, "floats in the world, not on \"" + j.parent + '"');
    return;
  }
  MachineJoint out;
  out.name = j.name, out.place = node.place;
  if (j.type == "spherical") out.kind = MachineJoint::Kind::ball;
  if (j.type == "prismatic") out.kind = MachineJoint::Kind::slide;
  if (const XmlNode* axis = childOf(node, "axis")) {
    read_.required(*axis, "xyz");
    out.axis = read_.vector(*axis, "xyz", Vec3::UnitX());
    if (out.axis.norm() < 1e-9) {
      read_.fault(*axis, "the axis is zero");
      out.axis = Vec3::UnitX();
    }
    out.axis.normalize();
  }
  limits(node, j.type, out);
  dynamics(node, out);
  mimic(node, j.name);
  if (j.type != "planar") drive(node, out);
  if (j.type == "planar") {
    // Two slides in the plane and a turn about its normal.
    MachineJoint slide = out;
    slide.kind = MachineJoint::Kind::slide;
    const Mat3 A = zAlong(out.axis);
    for (int i = 0; i < 2; ++i) {
      slide.name = j.name + (i == 0 ? "_1" : "_2"), slide.axis = A.col(i);
      link.joints.push_back(slide);
    }
  }
  link.joints.push_back(out);
}

/// A file of xacro is a program that writes URDF.
void refuseXacro(const XmlDocument& document) {
  for (const XmlNode& node : document.root().children)
    if (node.tag.starts_with("xacro:"))
      throw ModelError(document.diagnostic(node.place, node,
                                           "the file is xacro, which has to be expanded into URDF",
                                           "xacro FILE > machine.urdf, then import that"));
}

void UrdfReader::joints() {
  std::map<std::string, const XmlNode*> carried;
  for (const XmlNode* node : childrenOf(read_.document().root(), "joint")) {
    UrdfJoint j;
    j.node = node, j.name = read_.required(*node, "name");
    j.type = read_.word(
        *node, "type", read_.required(*node, "type"),
        {"fixed", "revolute", "continuous", "prismatic", "floating", "planar", "spherical"});
    bool whole = true;
    for (const char* end : {"parent", "child"}) {
      const XmlNode* side = childOf(*node, end);
      if (!side) {
        read_.fault(*node, std::string("<") + end + "> is missing");
        whole = false;
        continue;
      }
      const std::string name = read_.required(*side, "link");
      (end[0] == 'p' ? j.parent : j.child) = name;
      if (links_.contains(name)) continue;
      const XmlAttribute* given = side->attribute("link");
      if (given)
        read_.fault(*side, given->valuePlace, "there is no link \"" + name + '"',
                    didYouMean(nearest(name, linkOrder_)));
      whole = false;
    }
    if (!whole) continue;
    if (const auto [at, first] = carried.emplace(j.child, node); !first) {
      read_.fault(*node,
                  "link \"" + j.child + "\" is the child of another joint already, in line " +
                      std::to_string(at->second->place.line),
                  "a robot is a tree");
      continue;
    }
    carry(links_[j.child], j);
    joints_.push_back(j);
  }
}

/// Puts parents before children, in the order of the file.
void UrdfReader::order() {
  std::map<std::string, int> index;
  const auto parentOf = [this](const std::string& child) {
    for (const UrdfJoint& j : joints_)
      if (j.child == child) return j.parent;
    return std::string();
  };
  std::size_t before = linkOrder_.size() + 1;
  while (index.size() < linkOrder_.size() && index.size() != before) {
    before = index.size();
    for (const std::string& name : linkOrder_) {
      const std::string parent = parentOf(name);
      if (index.contains(name) || (!parent.empty() && !index.contains(parent))) continue;
      Link& link = links_[name];
      link.parent = parent.empty() ? -1 : index[parent];
      for (; link.free && link.parent >= 0;) {
        const Link& carrier = machine_.links[static_cast<std::size_t>(link.parent)];
        link.pose = carrier.pose * link.pose, link.parent = carrier.parent;
      }
      if (parent.empty() && options_.freeBase && name != "world") link.free = true;
      if (parent.empty() && !link.free && !link.inertia.none())
        machine_.notes.push_back({link.place, "link " + name,
                                  "is the root and stands still (--free-base lets it move)"});
      index[name] = static_cast<int>(machine_.links.size());
      machine_.links.push_back(link);
    }
    if (index.empty()) break;
  }
  for (const std::string& name : linkOrder_)
    if (!index.contains(name))
      read_.fault(read_.document().root(), links_[name].place,
                  "link \"" + name + "\" hangs on a loop of joints, not on a root");
}

Machine UrdfReader::machine() {
  const XmlNode& root = read_.document().root();
  machine_.name = valueOf(root, "name", "robot");
  machine_.selfContact = options_.selfContact;
  machine_.parentContact = false;
  read_.readOnly(root, {"name", "version"}, {"link", "joint", "material"},
                 {{"transmission", "is for drives; the model has none"},
                  {"gazebo", "is for another program"},
                  {"mujoco", "is for another program"},
                  {"ros2_control", "is for drives; the model has none"},
                  {"drake:joint", "is for another program"}});
  materials();
  for (const XmlNode* node : childrenOf(root, "link")) {
    Link made = link(*node);
    if (links_.contains(made.name)) {
      read_.fault(*node, "there is a link \"" + made.name + "\" already, in line " +
                             std::to_string(links_[made.name].place.line));
      continue;
    }
    linkOrder_.push_back(made.name);
    links_[made.name] = std::move(made);
  }
  if (linkOrder_.empty()) read_.fault(root, "the robot has no <link>");
  joints();
  order();
  read_.throwIfAny();
  return std::move(machine_);
}

}  // namespace

Machine readUrdf(const XmlDocument& document, const ImportOptions& options) {
  refuseXacro(document);
  return UrdfReader(document, options).machine();
}

}  // namespace dynamy::app
