/// Drives of MJCF on joints, and the keyframe that a machine starts from.
#pragma once
#include "import/import_options.hpp"
#include "import/mjcf_settings.hpp"

namespace dynamy::app {

class MjcfDrives {
 public:
  MjcfDrives(ElementReader& read, Machine& machine, const MjcfCompiler& compiler,
             const MjcfDefaults& defaults)
      : read_(read), machine_(machine), compiler_(compiler), defaults_(defaults) {}

  /// Drives of an `<actuator>`.
  void actuators(const XmlNode& node);
  /// Starts the machine from the key of this name; after all bodies and drives.
  void start(const std::vector<const XmlNode*>& keys, const std::string& name);

 private:
  void drive(const XmlNode& node);
  void gains(const XmlNode& node, Drive& out);
  /// Bounds of a `…range` attribute that are in use.
  void range(const XmlNode& node, const char* limited, const char* name, double& low, double& high);
  void pose(const XmlNode& node);

  ElementReader& read_;
  Machine& machine_;
  const MjcfCompiler& compiler_;
  const MjcfDefaults& defaults_;
};

}  // namespace dynamy::app
