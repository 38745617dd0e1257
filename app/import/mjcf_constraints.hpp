/// What MJCF says beside the tree of bodies: contacts that are excluded, equalities.
#pragma once
#include <map>
#include <string>

#include "import/mjcf_settings.hpp"

namespace dynamy::app {

/// A body or a site by its name: link and pose in it.
struct MjcfPlace {
  int link = -1;
  Pose pose;
};

class MjcfConstraints {
 public:
  using Places = std::map<std::string, MjcfPlace>;
  MjcfConstraints(ElementReader& read, Machine& machine, const Places& bodies, const Places& sites)
      : read_(read), machine_(machine), bodies_(bodies), sites_(sites) {}

  void contacts(const XmlNode& node);
  void equalities(const XmlNode& node);

 private:
  const MjcfPlace* found(const XmlNode& node, const char* attribute, const Places& among);
  void hold(const XmlNode& node);
  void couple(const XmlNode& node);

  ElementReader& read_;
  Machine& machine_;
  const Places &bodies_, &sites_;
};

}  // namespace dynamy::app
