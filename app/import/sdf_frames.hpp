/// Poses of links, joints and frames of a model of SDF, each given relative to another one.
#pragma once
#include <map>
#include <string>

#include "import/element_reader.hpp"

namespace dynamy::app {

/// Pose of `<pose>` in `node`: "x y z roll pitch yaw", in degrees or with a quaternion if it says so.
Pose sdfPose(const XmlNode& node, ElementReader& read);

class SdfFrames {
 public:
  explicit SdfFrames(ElementReader& read) : read_(read) {}
  /// Declares the frame of a link, joint or `<frame>`; `usual` is what its pose refers to if the
  /// file does not say; "" the model.
  void add(const XmlNode& node, const std::string& name, const std::string& usual);
  bool has(const std::string& name) const { return frames_.contains(name); }
  /// Pose in the model. "" and "__model__" are the model itself.
  Pose inModel(const XmlNode& node, const std::string& name) { return inModel(node, name, 0); }
  std::vector<std::string> names() const;

 private:
  struct Given {
    Pose pose;
    std::string relativeTo;
  };
  Pose inModel(const XmlNode& node, const std::string& name, int depth);
  ElementReader& read_;
  std::map<std::string, Given> frames_;
};

}  // namespace dynamy::app
