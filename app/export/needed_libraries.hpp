/// The shared libraries that an exported package needs, as this program has loaded them.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace dynamy::app {

struct NeededLibrary {
  std::string name;            ///< by which others need it: "libfmt.so.9"
  std::filesystem::path file;  ///< canonical
  bool ofSystem = false;       ///< of the C and C++ libraries, which every system has
  bool direct = false;         ///< the framework's own library names it
};

/// The framework's own library.
NeededLibrary frameworkLibrary();

/// All libraries that the framework's own needs, and those that they need, sorted by name.
std::vector<NeededLibrary> librariesOfFramework();

}  // namespace dynamy::app
