/// PluginLoader: finds shared libraries, checks them, and lets them register their types.
///
/// The fingerprint of a library (a plain C struct) is compared with the program's own before any
/// C++ of the library is called; a mismatch says both sides. Libraries stay loaded to the end of
/// the program, because models and registries hold code of theirs. Rejected: unloading with the
/// loader, which saves nothing and makes the order of destructors a trap.
#pragma once
#include <dynamy/io/plugin.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace dynamy {

/// Name of the library of the standard elements; it is loaded through the same entry as any other.
inline constexpr const char kStandardElements[] = "dynamy_elements";

/// What makes `plugin` unfit for a program with fingerprint `host`, both sides said, with what to
/// do; "" if it fits. Compilers may differ as long as their standard libraries agree.
/// If the numbers of the binary interface differ, nothing else is read.
std::string pluginMismatch(const PluginInfo& plugin, const PluginInfo& host);

class PluginLoader {
 public:
  struct Loaded {
    std::string name, version;   ///< as the library says them
    std::filesystem::path file;  ///< canonical
  };

  /// Searches the folders of the environment variable DYNAMY_PLUGIN_PATH (separated by ':'),
  /// `../lib/dynamy` relative to the program, and `dynamy` beside the framework's own library.
  PluginLoader();
  explicit PluginLoader(std::vector<std::filesystem::path> folders)
      : folders_(std::move(folders)) {}

  /// Loads `library`: a name ("my_elements" is the file libmy_elements.so), or a path. Searches
  /// `modelFolder` first, if it is not empty. A library that is loaded already is registered only
  /// once. Throws ModelError: missing file (with all paths tried), no plug-in, mismatch, duplicate
  /// types.
  void load(const std::string& library, const std::filesystem::path& modelFolder,
            Registry& registry);
  const std::vector<Loaded>& loaded() const { return loaded_; }
  /// The files that `load` looks at, in their order; the first one that exists is taken.
  std::vector<std::filesystem::path> candidates(const std::string& library,
                                                const std::filesystem::path& modelFolder) const;

 private:
  std::filesystem::path find(const std::string& library,
                             const std::filesystem::path& modelFolder) const;
  std::vector<std::filesystem::path> folders_;
  std::vector<Loaded> loaded_;
};

}  // namespace dynamy
