/// What a file of a machine does not say, and the command line does.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace dynamy::app {

struct ImportOptions {
  bool freeBase = false;     ///< URDF: the root link moves freely instead of standing still
  bool selfContact = false;  ///< URDF: links that are no neighbours may touch
  bool drives = false;       ///< URDF: joints get an input for their force
  std::string key;           ///< MJCF: the keyframe that is the start; "": none
  double density = 1000.0;   ///< meshes: of the body [kg/m³]
  double scale = 1.0;        ///< meshes: metres of a unit of the file
  int pieces = 0;            ///< most convex pieces of a mesh; 0: the default of the kind of file
  std::vector<std::string> packages;  ///< folders in which package:// paths are looked for
};

}  // namespace dynamy::app
