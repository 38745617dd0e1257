#include "import/mjcf_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <dynamy/core/decompositions.hpp>
#include <filesystem>

#include "import/mjcf_constraints.hpp"
#include "import/mjcf_drives.hpp"
#include "import/mjcf_geoms.hpp"
#include "import/mjcf_settings.hpp"

namespace dynamy::app {
namespace {

class MjcfReader {
 public:
  MjcfReader(const XmlDocument& document, const ImportOptions& options)
      : read_(document, machine_),
        geoms_(read_, compiler_, defaults_, options),
        constraints_(read_, machine_, bodies_, sites_),
        drives_(read_, machine_, compiler_, defaults_),
        key_(options.key) {}
  Machine machine();

 private:
  /// The children of `node`, with those of files that it includes in place of `<include>`.
  std::vector<XmlNode> withIncluded(const XmlNode& node, int depth = 0);
  void sections(const std::vector<XmlNode>& all);
  void option(const XmlNode& node);
  /// Children of a body, or of a `<frame>` in it, whose pose in the body is `pose`.
  void content(const XmlNode& node, int link, const Pose& pose, const std::string& childclass);
  void body(const XmlNode& node, int parent, const Pose& pose, const std::string& childclass);
  void geom(const XmlNode& node, int link, const Pose& pose, const std::string& childclass);
  void joint(const XmlNode& node, Link& link, const Pose& pose);
  void values(const XmlNode& node, MachineJoint& out);
  bool limited(const XmlNode& node);
  Inertia inertial(const XmlNode& node);
  void finishMasses();
  std::string nameOf(const XmlNode& node, const char* kind);

  Machine machine_;
  std::deque<XmlDocument> included_;
  ElementReader read_;
  MjcfCompiler compiler_;
  MjcfDefaults defaults_;
  MjcfGeoms geoms_;
  MjcfConstraints::Places bodies_, sites_;
  MjcfConstraints constraints_;
  MjcfDrives drives_;
  std::string key_;
  std::map<int, Inertia> given_;  ///< of bodies with <inertial>
  int unnamed_ = 0;
  bool contacts_ = true;  ///< false: no geoms touch
};

std::string MjcfReader::nameOf(const XmlNode& node, const char* kind) {
  const std::string name = valueOf(node, "name", "");
  return name.empty() ? kind + std::to_string(++unnamed_) : name;
}

std::vector<XmlNode> MjcfReader::withIncluded(const XmlNode& node, int depth) {
  constexpr int kDeepest = 16;
  std::vector<XmlNode> out;
  for (const XmlNode& c : node.children) {
    if (c.tag != "include") {
      out.push_back(c);
      out.back().children = withIncluded(c, depth);
      continue;
    }
    const std::string file = read_.required(c, "file");
    if (file.empty() || depth >= kDeepest) {
      read_.fault(c, depth >= kDeepest ? "files include each other" : "includes no file");
      continue;
    }
    const auto folder = std::filesystem::path(read_.document().name()).parent_path();
    std::error_code error;
    if (!std::filesystem::is_regular_file(folder / file, error)) {
      read_.fault(c, '"' + file + "\": there is no such file",
                  "a path is relative to the file in which it stands");
      continue;
    }
    included_.push_back(XmlDocument::read(folder / file));
    read_.alsoOf(included_.back());
    for (XmlNode& child : withIncluded(included_.back().root(), depth + 1))
      out.push_back(std::move(child));
  }
  return out;
}

void MjcfReader::option(const XmlNode& node) {
  machine_.gravity = read_.vector(node, "gravity", machine_.gravity);
  read_.readOnly(node,
                 {"gravity", "timestep", "integrator", "solver", "iterations", "tolerance", "cone",
                  "jacobian", "ls_iterations", "ls_tolerance", "noslip_iterations",
                  "noslip_tolerance", "impratio", "mpr_iterations", "ccd_iterations"},
                 {"flag"});
  for (const XmlNode* flag : childrenOf(node, "flag")) {
    if (valueOf(*flag, "gravity", "") == "disable") machine_.gravity.setZero();
    if (valueOf(*flag, "contact", "") == "disable") contacts_ = false;
    read_.readOnly(*flag, {"gravity", "contact", "energy", "warmstart", "filterparent"}, {});
    if (valueOf(*flag, "filterparent", "") == "disable") machine_.parentContact = true;
  }
}

/// MuJoCo's rule: a range is a limit unless it is said otherwise.
bool MjcfReader::limited(const XmlNode& node) {
  const std::string said = valueOf(node, "limited", "auto");
  if (said != "auto") return read_.word(node, "limited", said, {"false", "true"}) == "true";
  return compiler_.autolimits && node.attribute("range") != nullptr;
}

/// Values of a joint; angles in the unit of the file.
void MjcfReader::values(const XmlNode& node, MachineJoint& out) {
  const bool angle = out.kind != MachineJoint::Kind::slide;
  const auto value = [&](double x) { return angle ? compiler_.angle(x) : x; };
  const auto first = [&](const char* name) {
    const std::vector<double> all = read_.numbers(node, name);
    if (all.size() > 1) read_.note(node, std::string(name) + ": its linear term counts");
    return all.empty() ? 0.0 : all[0];
  };
  out.damping = first("damping"), out.stiffness = first("stiffness");
  out.friction = read_.number(node, "frictionloss", 0.0);
  out.inertia = read_.number(node, "armature", 0.0);
  out.reference = value(read_.number(node, "ref", 0.0));
  out.rest = value(read_.number(node, "springref", 0.0));
  if (limited(node)) {
    const auto range = read_.numbers(node, "range", 2);
    if (range.empty()) read_.fault(node, "a limited joint has a range");
    if (out.kind == MachineJoint::Kind::ball)
      read_.note(node, "the limit of a ball joint is left out");
    else if (!range.empty())
      out.lower = value(range[0]), out.upper = value(range[1]);
  }
  if (out.kind != MachineJoint::Kind::ball) return;
  if (out.stiffness > 0.0) read_.note(node, "the spring of a ball joint is left out");
  if (out.inertia > 0.0) read_.note(node, "the armature of a ball joint is left out");
  if (out.friction > 0.0) read_.note(node, "the dry friction of a ball joint is left out");
  out.stiffness = out.inertia = out.friction = 0.0;
}

void MjcfReader::joint(const XmlNode& node, Link& link, const Pose& pose) {
  const bool freejoint = node.tag == "freejoint";
  const std::string type = freejoint ? "free"
                                     : read_.word(node, "type", valueOf(node, "type", "hinge"),
                                                  {"hinge", "slide", "ball", "free"});
  if (type == "free") {
    link.free = true;
    for (const char* name : {"damping", "armature", "frictionloss", "stiffness"})
      if (!freejoint && read_.number(node, name, 0.0) != 0.0)
        read_.note(node, std::string(name) + " of a free body is left out");
    return;
  }
  MachineJoint out;
  out.name = nameOf(node, "joint"), out.place = node.place;
  out.kind = type == "hinge"   ? MachineJoint::Kind::turn
             : type == "slide" ? MachineJoint::Kind::slide
                               : MachineJoint::Kind::ball;
  out.at = pose.point(read_.vector(node, "pos", Vec3::Zero()));
  const Vec3 axis = pose.A * read_.vector(node, "axis", Vec3::UnitZ());
  if (axis.norm() > 1e-9)
    out.axis = axis.normalized();
  else
    read_.fault(node, "the axis is zero");
  values(node, out);
  read_.readOnly(node,
                 {"name", "class", "type", "pos", "axis", "damping", "stiffness", "frictionloss",
                  "armature", "ref", "springref", "range", "limited", "group", "user"},
                 {},
                 {{"solreflimit", "stops are rigid"},
                  {"solimplimit", "stops are rigid"},
                  {"solreffriction", "friction is dry"},
                  {"solimpfriction", "friction is dry"},
                  {"margin", "stops act at distance zero"},
                  {"actuatorfrcrange", "limits a drive; the model has none"},
                  {"actuatorfrclimited", "limits a drive; the model has none"}});
  link.joints.push_back(out);
}

Inertia MjcfReader::inertial(const XmlNode& node) {
  Inertia own, out;
  const Pose pose = compiler_.pose(node, read_);
  read_.required(node, "pos");
  own.mass = read_.requiredNumber(node, "mass");
  if (const auto v = read_.numbers(node, "fullinertia", 6); !v.empty())
    own.J << v[0], v[3], v[4], v[3], v[1], v[5], v[4], v[5], v[2];
  else
    own.J = read_.vector(node, "diaginertia", Vec3::Zero()).asDiagonal();
  read_.readOnly(node,
                 {"pos", "mass", "diaginertia", "fullinertia", "quat", "axisangle", "euler",
                  "xyaxes", "zaxis"},
                 {});
  out.add(own, pose);
  return out;
}

void MjcfReader::geom(const XmlNode& node, int link, const Pose& pose,
                      const std::string& childclass) {
  MjcfGeom out = geoms_.geom(defaults_.resolved(node, childclass, read_));
  out.skin.pose = pose * out.skin.pose;
  out.skin.touches = out.skin.touches && contacts_;
  if (out.shows) (link < 0 ? machine_.ground : machine_.links[at(link)].skins).push_back(out.skin);
  if (link < 0) return;
  Link& of = machine_.links[at(link)];
  if (out.skin.kind == Skin::Kind::plane && out.shows && !of.rigid())
    read_.fault(node, "a plane does not move");
  of.inertia.add(out.inertia, pose);
}

void MjcfReader::body(const XmlNode& node, int parent, const Pose& pose,
                      const std::string& childclass) {
  Link made;
  made.name = nameOf(node, "body"), made.place = node.place, made.parent = parent;
  made.pose = pose * compiler_.pose(node, read_);
  const int link = static_cast<int>(machine_.links.size());
  bodies_[made.name] = {link, {}};
  read_.readOnly(
      node, {"name", "pos", "quat", "axisangle", "euler", "xyaxes", "zaxis", "childclass", "user"},
      {"body", "frame", "geom", "joint", "freejoint", "inertial", "site"},
      {{"gravcomp", "gravity acts on all bodies"},
       {"mocap", "the body stands still"},
       {"camera", "is for pictures of another program"},
       {"light", "is for pictures of another program"},
       {"sleep", "bodies do not sleep"}});
  machine_.links.push_back(std::move(made));
  content(node, link, {}, valueOf(node, "childclass", childclass));
  Link& of = machine_.links[at(link)];
  if (of.free && of.parent >= 0) read_.fault(node, "a body that moves freely is on the world");
  if (of.free) of.joints.clear();
}

void MjcfReader::content(const XmlNode& node, int link, const Pose& pose,
                         const std::string& childclass) {
  for (const XmlNode& c : node.children) {
    const auto of = [&]() -> Link& { return machine_.links[at(link)]; };
    const bool jointed = c.tag == "joint" || c.tag == "freejoint";
    if (link < 0 && (jointed || c.tag == "inertial")) {
      read_.fault(c, "the world does not move");
    } else if (jointed) {
      joint(defaults_.resolved(c, childclass, read_), of(), pose);
    } else if (c.tag == "geom") {
      geom(c, link, pose, childclass);
    } else if (c.tag == "inertial") {
      given_[link] = inertial(c);
    } else if (c.tag == "body") {
      body(c, link, pose, childclass);
    } else if (c.tag == "frame") {
      content(c, link, pose * compiler_.pose(c, read_), valueOf(c, "childclass", childclass));
    } else if (c.tag == "site") {
      const XmlNode full = defaults_.resolved(c, childclass, read_);
      const Pose at = pose * compiler_.pose(full, read_);
      const std::string name = nameOf(c, "site");
      sites_[name] = {link, at};
      if (link >= 0) of().frames.emplace_back(name, at);
    }
  }
}

/// Given masses, and the rules of the compiler for all of them.
void MjcfReader::finishMasses() {
  if (compiler_.inertiaFromGeom != "true")
    for (std::size_t i = 0; i < machine_.links.size(); ++i) {
      const auto found = given_.find(static_cast<int>(i));
      if (found != given_.end())
        machine_.links[i].inertia = found->second;
      else if (compiler_.inertiaFromGeom == "false")
        machine_.links[i].inertia = {};
    }
  double all = 0.0;
  for (Link& link : machine_.links) {
    Inertia& own = link.inertia;
    own.mass = std::max(own.mass, compiler_.leastMass);
    const SymmetricEigenPairs p = symmetricEigenPairs(own.J);
    Vec3 J = p.values;
    if (compiler_.balance && J[2] > J[0] + J[1]) J.setConstant(J.mean());
    J = J.cwiseMax(compiler_.leastInertia);
    if (J != p.values) own.J = p.vectors * J.asDiagonal() * p.vectors.transpose();
    all += own.mass;
  }
  if (compiler_.totalMass > 0.0 && all > 0.0)
    for (Link& link : machine_.links)
      link.inertia.mass *= compiler_.totalMass / all, link.inertia.J *= compiler_.totalMass / all;
}

/// Settings and classes first: they count wherever they stand.
void MjcfReader::sections(const std::vector<XmlNode>& all) {
  const auto each = [&all](const char* tag, const auto& use) {
    for (const XmlNode& c : all)
      if (c.tag == tag) use(c);
  };
  each("compiler", [&](const XmlNode& c) { compiler_.read(c, read_); });
  each("default", [&](const XmlNode& c) { defaults_.read(c, read_); });
  each("option", [&](const XmlNode& c) { option(c); });
  each("asset", [&](const XmlNode& c) { geoms_.assets(c); });
  bool world = false;
  each("worldbody", [&](const XmlNode& c) {
    world = true;
    read_.readOnly(c, {}, {"body", "frame", "geom", "site"},
                   {{"camera", "is for pictures of another program"},
                    {"light", "is for pictures of another program"}});
    content(c, -1, {}, valueOf(c, "childclass", ""));
  });
  if (!world)
    read_.fault(read_.document().root(), "there is no <worldbody>", "bodies stand inside of it");
  finishMasses();
  each("contact", [&](const XmlNode& c) { constraints_.contacts(c); });
  each("equality", [&](const XmlNode& c) { constraints_.equalities(c); });
  each("actuator", [&](const XmlNode& c) { drives_.actuators(c); });
  std::vector<const XmlNode*> keys;
  each("keyframe", [&](const XmlNode& c) {
    for (const XmlNode* key : childrenOf(c, "key")) keys.push_back(key);
  });
  drives_.start(keys, key_);
}

Machine MjcfReader::machine() {
  XmlNode root = read_.document().root();
  root.children = withIncluded(read_.document().root());
  machine_.name = valueOf(root, "model", "machine");
  machine_.parentContact = false;
  machine_.staticContact = true;
  read_.readOnly(root, {"model"},
                 {"compiler", "default", "option", "asset", "worldbody", "contact", "equality",
                  "actuator", "keyframe", "size", "visual", "statistic"},
                 {{"sensor", "signals of the model are those of its bodies and joints"},
                  {"tendon", "tendons are not taken over"},
                  {"custom", "is for another program"},
                  {"deformable", "bodies are rigid"},
                  {"extension", "is for another program"}});
  sections(root.children);
  read_.throwIfAny();
  return std::move(machine_);
}

}  // namespace

Machine readMjcf(const XmlDocument& document, const ImportOptions& options) {
  return MjcfReader(document, options).machine();
}

}  // namespace dynamy::app
