/// PluginLoader: finds shared libraries, checks them, and lets them register their types.
///
/// Where a library may come from depends on who names it:
///
///   the standard elements      the folder `dynamy` beside the framework's own library
///   the user (--plugin)        a path as it is written; a name in the user's folders
///   a model (`<plugin>`)       what the user named already; a name in the user's folders; the
///                              model's own folder, or a path, only if the user trusts it
///   a checkpoint, a sweep      name and fingerprint, in the user's folders; never a path
///
/// The user's folders are those of DYNAMY_PLUGIN_PATH, then those where dynamY stands. The current
/// folder is none of them. The fingerprint of a library (a plain C struct) is compared with the
/// program's own before any C++ of the library is called; a mismatch says both sides. Libraries
/// stay loaded to the end of the program, because models and registries hold code of theirs.
/// Rejected: unloading with the loader, which saves nothing and makes the order of destructors a
/// trap.
#pragma once
#include <dynamy/io/plugin/library_file.hpp>
#include <dynamy/io/plugin/plugin.hpp>
#include <dynamy/io/plugin/trusted_folders.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace dynamy {

/// Name of the library of the standard elements; it is loaded through the same entry as any other.
inline constexpr const char kStandardElements[] = "dynamy_elements";

class PluginLoader {
 public:
  struct Loaded {
    std::string name, version;   ///< as the library says them
    std::filesystem::path file;  ///< canonical
    bool chosen = false;         ///< named by the user
  };

  /// The user's folders are those of the environment variable DYNAMY_PLUGIN_PATH (separated by
  /// ':'), then `dynamy` beside the framework's own library and `../lib/dynamy` relative to the
  /// program; trust is read from the user's configuration when it is needed.
  PluginLoader();
  /// These folders hold everything, and no other is trusted.
  explicit PluginLoader(std::vector<std::filesystem::path> folders);

  /// Trusts the folders of all models from now on (--trust).
  void trustModels() { trustsModels_ = true; }
  /// How messages say that a model is trusted, for a program that has another way than --trust.
  void howToTrust(std::string words) { howToTrust_ = std::move(words); }
  /// Trusts the libraries of models in `folder` and below.
  void trust(const std::filesystem::path& folder) { trusted_.add(folder); }

  /// Loads what the user names: "my_elements" is the file libmy_elements.so in one of the folders;
  /// a text with '/' is a path. A library that is loaded already is registered only once. Throws
  /// ModelError: missing file (with all paths tried), no plug-in, mismatch, duplicate types.
  void load(const std::string& library, Registry& registry);
  /// Loads what a model in `modelFolder` names. Throws ModelError, also if the library stands only
  /// where the user's trust is needed.
  void load(const std::string& library, const std::filesystem::path& modelFolder,
            Registry& registry);
  /// Loads what a file of results names; a library of this name that the user named counts first.
  /// Throws ModelError, also if all libraries of this name have other fingerprints.
  void load(const Fingerprint& library, Registry& registry);

  const std::vector<Loaded>& loaded() const { return loaded_; }
  /// All but the standard elements. Throws FileError.
  std::vector<Fingerprint> fingerprints() const;
  /// The files that `load` looks at, in their order; the first one that exists is taken.
  std::vector<std::filesystem::path> candidates(const std::string& library) const;
  std::vector<std::filesystem::path> candidates(const std::string& library,
                                                const std::filesystem::path& modelFolder) const;

 private:
  bool isLoaded(const std::filesystem::path& file) const;
  void requireTrust(const std::filesystem::path& file) const;
  void open(const std::filesystem::path& file, bool chosen, Registry& registry);
  std::vector<std::filesystem::path> own_, installed_;  // of DYNAMY_PLUGIN_PATH; of dynamY
  TrustedFolders trusted_;
  std::string howToTrust_ = "--trust";
  bool readsConfiguration_ = false, trustsModels_ = false;
  std::vector<Loaded> loaded_;
};

}  // namespace dynamy
