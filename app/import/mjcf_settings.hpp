/// What holds for all elements of a file of MJCF: the options of its compiler, and default classes.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "import/element_reader.hpp"

namespace dynamy::app {

/// `<compiler>`: how the numbers of the file are meant.
struct MjcfCompiler {
  bool degrees = true;     ///< angle="degree"
  bool autolimits = true;  ///< a range is a limit
  bool balance = false;    ///< balanceinertia
  bool stripPath = false;
  std::string eulerseq = "xyz";  ///< small letters: about moved axes
  std::string inertiaFromGeom = "auto";
  std::string meshFolder, assetFolder;
  double leastMass = 0.0, leastInertia = 0.0;  ///< [kg], [kg m²]
  double totalMass = -1.0;                     ///< [kg]; negative: as given
  int firstGroup = 0, lastGroup = 5;           ///< of geoms that have mass

  void read(const XmlNode& node, ElementReader& read);
  double angle(double x) const;  ///< in radians
  /// pos with quat, axisangle, euler, xyaxes or zaxis.
  Pose pose(const XmlNode& node, ElementReader& read) const;

 private:
  Mat3 axes(const XmlNode& node, ElementReader& read) const;
  Mat3 euler(const XmlNode& node, const std::vector<double>& angles, ElementReader& read) const;
};

/// Default classes: each holds values of attributes by the element's tag, and inherits those of the
/// class around it.
class MjcfDefaults {
 public:
  /// `node`: a `<default>` below the root.
  void read(const XmlNode& node, ElementReader& read, const std::string& parent = "");
  /// The element with all attributes that its class gives it; `childclass` of the bodies around it
  /// if it names none.
  XmlNode resolved(const XmlNode& node, const std::string& childclass, ElementReader& read) const;

 private:
  using Values = std::map<std::string, std::vector<XmlAttribute>>;  // by tag
  std::map<std::string, Values> classes_;
  std::string main_;
};

}  // namespace dynamy::app
