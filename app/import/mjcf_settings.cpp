#include "import/mjcf_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <dynamy/core/constants.hpp>
#include <dynamy/core/suggestion.hpp>

namespace dynamy::app {

// ---- compiler ----------------------------------------------------------------------------------

double MjcfCompiler::angle(double x) const { return degrees ? x * kPi / 180.0 : x; }

void MjcfCompiler::read(const XmlNode& node, ElementReader& read) {
  const auto flag = [&](const char* name, bool& value) {
    if (const XmlAttribute* a = node.attribute(name))
      value = read.word(node, name, a->value, {"false", "true"}) == "true";
  };
  if (const XmlAttribute* a = node.attribute("angle"))
    degrees = read.word(node, "angle", a->value, {"degree", "radian"}) == "degree";
  if (const XmlAttribute* a = node.attribute("coordinate"))
    if (a->value != "local") read.fault(node, a->valuePlace, "only local coordinates are read");
  flag("autolimits", autolimits), flag("balanceinertia", balance), flag("strippath", stripPath);
  eulerseq = valueOf(node, "eulerseq", eulerseq);
  if (eulerseq.size() != 3 || eulerseq.find_first_not_of("xyzXYZ") != std::string::npos) {
    read.fault(node, "eulerseq has three letters of xyzXYZ");
    eulerseq = "xyz";
  }
  inertiaFromGeom =
      read.word(node, "inertiafromgeom", valueOf(node, "inertiafromgeom", inertiaFromGeom),
                {"auto", "true", "false"});
  assetFolder = valueOf(node, "assetdir", assetFolder);
  meshFolder = valueOf(node, "meshdir", meshFolder.empty() ? assetFolder : meshFolder);
  leastMass = read.number(node, "boundmass", leastMass);
  leastInertia = read.number(node, "boundinertia", leastInertia);
  totalMass = read.number(node, "settotalmass", totalMass);
  if (const auto range = read.numbers(node, "inertiagrouprange", 2); !range.empty())
    firstGroup = static_cast<int>(range[0]), lastGroup = static_cast<int>(range[1]);
  read.readOnly(node,
                {"angle", "coordinate", "autolimits", "balanceinertia", "strippath", "eulerseq",
                 "inertiafromgeom", "assetdir", "meshdir", "texturedir", "boundmass",
                 "boundinertia", "settotalmass", "inertiagrouprange", "discardvisual", "convexhull",
                 "usethread", "fitaabb", "saveinertial"},
                {});
}

Mat3 MjcfCompiler::euler(const XmlNode&, const std::vector<double>& angles, ElementReader&) const {
  Mat3 A = Mat3::Identity();
  for (std::size_t i = 0; i < 3; ++i) {
    const char letter = eulerseq[i];
    const int axis = std::tolower(letter) - 'x';
    const Mat3 turn = turned(Vec3::Unit(axis), angle(angles[i]));
    if (std::islower(static_cast<unsigned char>(letter)) != 0)
      A = A * turn;  // about the moved axis
    else
      A = turn * A;
  }
  return A;
}

Mat3 MjcfCompiler::axes(const XmlNode& node, ElementReader& read) const {
  const auto direction = [&](const Vec3& v) {
    if (v.norm() > 1e-9) return Vec3(v.normalized());
    read.fault(node, "an axis is zero");
    return Vec3(Vec3::UnitZ());
  };
  if (const auto v = read.numbers(node, "axisangle", 4); !v.empty())
    return turned(direction({v[0], v[1], v[2]}), angle(v[3]));
  if (const auto v = read.numbers(node, "euler", 3); !v.empty()) return euler(node, v, read);
  if (const auto v = read.numbers(node, "xyaxes", 6); !v.empty()) {
    Mat3 A;
    A.col(0) = direction({v[0], v[1], v[2]});
    const Vec3 y(v[3], v[4], v[5]);
    A.col(1) = direction(y - A.col(0).dot(y) * A.col(0));
    A.col(2) = A.col(0).cross(A.col(1));
    return A;
  }
  if (const auto v = read.numbers(node, "zaxis", 3); !v.empty())
    return zAlong(direction({v[0], v[1], v[2]}));
  if (const auto v = read.numbers(node, "quat", 4); !v.empty())
    return fromQuaternion(v[0], v[1], v[2], v[3]);
  return Mat3::Identity();
}

Pose MjcfCompiler::pose(const XmlNode& node, ElementReader& read) const {
  return {read.vector(node, "pos", Vec3::Zero()), axes(node, read)};
}

// ---- defaults ----------------------------------------------------------------------------------

namespace {

/// Attributes of `over` in place of those of the same name in `base`.
std::vector<XmlAttribute> merged(std::vector<XmlAttribute> base,
                                 const std::vector<XmlAttribute>& over) {
  // An orientation in one form replaces that of the class in another one.
  const auto kind = [](const std::string& name) -> std::string {
    for (const char* form : {"quat", "axisangle", "euler", "xyaxes", "zaxis"})
      if (name == form) return "orientation";
    return name;
  };
  for (const XmlAttribute& a : over) {
    std::erase_if(base, [&](const XmlAttribute& b) { return kind(b.name) == kind(a.name); });
    base.push_back(a);
  }
  return base;
}

/// Attributes that a class gives to drives of every kind, whatever kind it names them in.
std::vector<XmlAttribute> ofAllDrives(const std::vector<XmlAttribute>& all) {
  std::vector<XmlAttribute> out;
  for (const XmlAttribute& a : all)
    for (const char* name : {"gear", "ctrlrange", "ctrllimited", "forcerange", "forcelimited"})
      if (a.name == name) out.push_back(a);
  return out;
}

}  // namespace

void MjcfDefaults::read(const XmlNode& node, ElementReader& read, const std::string& parent) {
  std::string name = valueOf(node, "class", parent.empty() ? "main" : "");
  if (name.empty()) read.fault(node, "a default class inside of another one has a name");
  if (parent.empty()) {
    if (main_.empty()) main_ = name;
    // Several <default> below the root add to the same class.
    classes_[name];
  } else {
    classes_[name] = classes_[parent];
  }
  const std::vector<std::string> drives = {"general", "motor", "position", "velocity"};
  for (const XmlNode& c : node.children)
    if (c.tag != "default") {
      Values& values = classes_[name];
      values[c.tag] = merged(values[c.tag], c.attributes);
      if (std::find(drives.begin(), drives.end(), c.tag) == drives.end()) continue;
      for (const std::string& kind : drives)
        values[kind] = merged(values[kind], ofAllDrives(c.attributes));
    }
  for (const XmlNode& c : node.children)
    if (c.tag == "default") this->read(c, read, name);
}

XmlNode MjcfDefaults::resolved(const XmlNode& node, const std::string& childclass,
                               ElementReader& read) const {
  XmlNode out = node;
  const std::string own = valueOf(node, "class", childclass);
  const std::string name = own.empty() ? main_ : own;
  const auto found = classes_.find(name);
  if (found == classes_.end()) {
    if (own.empty() || name == "main") return out;
    std::vector<std::string> known;
    for (const auto& [key, values] : classes_) known.push_back(key);
    const XmlAttribute* given = node.attribute("class");
    read.fault(node, given ? given->valuePlace : node.place,
               fmt::format("there is no default class \"{}\"", name),
               didYouMean(nearest(name, known)));
    return out;
  }
  const auto values = found->second.find(node.tag);
  if (values != found->second.end()) out.attributes = merged(values->second, node.attributes);
  return out;
}

}  // namespace dynamy::app
