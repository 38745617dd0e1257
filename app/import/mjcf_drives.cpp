#include "import/mjcf_drives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <dynamy/core/suggestion.hpp>

namespace dynamy::app {
namespace {

MachineJoint* jointOf(Machine& machine, const std::string& name) {
  for (Link& link : machine.links)
    for (MachineJoint& joint : link.joints)
      if (joint.name == name) return &joint;
  return nullptr;
}

}  // namespace

void MjcfDrives::range(const XmlNode& node, const char* limited, const char* name, double& low,
                       double& high) {
  const std::string said = valueOf(node, limited, "auto");
  if (said == "false" || (said == "auto" && !compiler_.autolimits)) return;
  if (const auto v = read_.numbers(node, name, 2); !v.empty()) low = v[0], high = v[1];
}

/// Force of a drive: gain · input + bias0 + bias1 · position + bias2 · rate.
void MjcfDrives::gains(const XmlNode& node, Drive& out) {
  const auto entry = [&](const char* name, std::size_t i, double otherwise) {
    const std::vector<double> all = read_.numbers(node, name);
    return i < all.size() ? all[i] : otherwise;
  };
  if (node.tag == "general") {
    out.gain = entry("gainprm", 0, 1.0);
    if (valueOf(node, "biastype", "none") == "affine")
      for (std::size_t i = 0; i < 3; ++i) out.bias[i] = entry("biasprm", i, 0.0);
  } else if (node.tag == "position") {
    out.gain = read_.number(node, "kp", 1.0);
    out.bias[1] = -out.gain, out.bias[2] = -read_.number(node, "kv", 0.0);
  } else if (node.tag == "velocity") {
    out.gain = read_.number(node, "kv", 1.0);
    out.bias[2] = -out.gain;
  }
}

void MjcfDrives::drive(const XmlNode& given) {
  const XmlNode node = defaults_.resolved(given, "", read_);
  if (node.tag != "motor" && node.tag != "position" && node.tag != "velocity" &&
      node.tag != "general") {
    read_.note(node, "drives of this kind are left out");
    return;
  }
  const std::string joint = valueOf(node, "joint", valueOf(node, "jointinparent", ""));
  const MachineJoint* on = jointOf(machine_, joint);
  if (on == nullptr || on->kind == MachineJoint::Kind::ball) {
    read_.note(node, joint.empty() ? "only drives of joints are taken over"
                                   : "\"" + joint + "\" is no hinge and no slide: is left out");
    return;
  }
  const bool fixedGain = valueOf(node, "gaintype", "fixed") == "fixed";
  const std::string bias = valueOf(node, "biastype", "none");
  if (valueOf(node, "dyntype", "none") != "none" || !fixedGain ||
      (bias != "none" && bias != "affine")) {
    read_.note(node, "drives with a state or gains of their own are left out");
    return;
  }
  read_.readOnly(node,
                 {"name", "class", "joint", "jointinparent", "gear", "kp", "kv", "gainprm",
                  "biasprm", "gaintype", "biastype", "dyntype", "ctrlrange", "ctrllimited",
                  "forcerange", "forcelimited", "group", "user"},
                 {});
  Drive out;
  out.name = valueOf(node, "name", joint + "_drive"), out.joint = joint, out.place = node.place;
  const std::vector<double> gear = read_.numbers(node, "gear");
  out.gear = gear.empty() ? 1.0 : gear[0];
  gains(node, out);
  range(node, "ctrllimited", "ctrlrange", out.lowInput, out.highInput);
  range(node, "forcelimited", "forcerange", out.lowForce, out.highForce);
  machine_.drives.push_back(out);
}

void MjcfDrives::actuators(const XmlNode& node) {
  for (const XmlNode& c : node.children) drive(c);
}

/// Positions in the order of bodies and joints: 7 numbers of a free body, 4 of a ball joint.
void MjcfDrives::pose(const XmlNode& node) {
  const std::vector<double> q = read_.numbers(node, "qpos");
  if (q.empty()) return;
  std::size_t needed = 0, i = 0;
  for (const Link& link : machine_.links) {
    needed += link.free ? 7 : 0;
    for (const MachineJoint& joint : link.joints)
      needed += joint.kind == MachineJoint::Kind::ball ? 4 : 1;
  }
  if (q.size() != needed) {
    read_.fault(node, fmt::format("qpos has {} numbers, the machine {}", q.size(), needed));
    return;
  }
  for (Link& link : machine_.links) {
    if (link.free) {
      link.pose = {Vec3(q[i], q[i + 1], q[i + 2]),
                   fromQuaternion(q[i + 3], q[i + 4], q[i + 5], q[i + 6])};
      i += 7;
    }
    for (MachineJoint& joint : link.joints) {
      if (joint.kind == MachineJoint::Kind::ball) {
        if (q[i] * q[i] < 1.0 - 1e-12)
          read_.note(node, "ball joint " + joint.name + " starts in the pose of the file");
        i += 4;
      } else {
        joint.start = q[i++], joint.startGiven = true;
      }
    }
  }
}

void MjcfDrives::start(const std::vector<const XmlNode*>& keys, const std::string& name) {
  std::vector<std::string> known;
  for (const XmlNode* key : keys) {
    known.push_back(valueOf(*key, "name", ""));
    if (name.empty()) read_.note(*key, "is not the start; it is with --key " + known.back());
    if (name.empty() || known.back() != name) continue;
    pose(*key);
    const std::vector<double> inputs = read_.numbers(*key, "ctrl");
    for (std::size_t i = 0; i < std::min(inputs.size(), machine_.drives.size()); ++i)
      machine_.drives[i].input = inputs[i];
    read_.readOnly(*key, {"name", "qpos", "ctrl", "time"}, {},
                   {{"qvel", "the machine starts at rest"}});
  }
  if (!name.empty() && std::find(known.begin(), known.end(), name) == known.end())
    read_.fault(read_.document().root(), "there is no key \"" + name + '"',
                didYouMean(nearest(name, known)));
}

}  // namespace dynamy::app
