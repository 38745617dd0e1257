#include "import/sdf_frames.hpp"

#include <fmt/format.h>

#include <dynamy/core/constants.hpp>
#include <dynamy/core/suggestion.hpp>

namespace dynamy::app {

Pose sdfPose(const XmlNode& node, ElementReader& read) {
  const XmlNode* own = childOf(node, "pose");
  if (!own || own->text.empty()) return {};
  const bool quaternion = valueOf(*own, "rotation_format", "") == "quat_xyzw";
  const auto v = read.numbersOf(*own, quaternion ? 7 : 6);
  if (v.empty()) return {};
  const Vec3 r(v[0], v[1], v[2]);
  if (quaternion) return {r, fromQuaternion(v[6], v[3], v[4], v[5])};
  const double unit = valueOf(*own, "degrees", "false") == "true" ? kPi / 180.0 : 1.0;
  return {r, rollPitchYaw(unit * Vec3(v[3], v[4], v[5]))};
}

void SdfFrames::add(const XmlNode& node, const std::string& name, const std::string& usual) {
  const XmlNode* own = childOf(node, "pose");
  std::string to;
  if (own != nullptr) to = valueOf(*own, "relative_to", valueOf(*own, "frame", ""));
  if (to.empty()) to = usual;
  const auto [found, first] = frames_.try_emplace(name, Given{sdfPose(node, read_), to});
  if (!first) read_.fault(node, "the name \"" + name + "\" is taken in its model");
}

Pose SdfFrames::inModel(const XmlNode& node, const std::string& name, int depth) {
  constexpr int kDeepest = 64;
  if (name.empty() || name == "__model__" || name == "world") return {};
  const auto found = frames_.find(name);
  if (found == frames_.end()) {
    read_.fault(node, "there is no frame \"" + name + '"', didYouMean(nearest(name, names())));
    return {};
  }
  if (depth > kDeepest) {
    read_.fault(node, "the pose of \"" + name + "\" refers to itself");
    return {};
  }
  return inModel(node, found->second.relativeTo, depth + 1) * found->second.pose;
}

std::vector<std::string> SdfFrames::names() const {
  std::vector<std::string> out;
  for (const auto& [name, given] : frames_) out.push_back(name);
  return out;
}

}  // namespace dynamy::app
