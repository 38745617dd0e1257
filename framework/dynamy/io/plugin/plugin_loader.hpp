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
/// The user's folders are those of DYNAMY_PLUGIN_PATH, then those where dynamY is installed. The
/// current folder is not among them. The fingerprint of a library (a plain C struct) is compared
/// with the program's own before any C++ of the library is called; the error of a mismatch names
/// both. Libraries stay loaded until the end of the program, because models and registries refer to
/// their code. Rejected: unloading with the loader, which saves nothing and makes the order of
/// destructors a trap.
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
    std::string name, version;   ///< as given by the library
    std::filesystem::path file;  ///< canonical
    bool chosen = false;         ///< named by the user
  };

  /// The user's folders are those of the environment variable DYNAMY_PLUGIN_PATH (separated by
  /// ':'), then `dynamy` beside the framework's own library and `../lib/dynamy` relative to the
  /// program; the trusted folders are read from the user's configuration when they are needed.
  PluginLoader();
  /// Uses only these folders; no other folder is trusted.
  explicit PluginLoader(std::vector<std::filesystem::path> folders);

  /// Trusts the folders of all models from now on (--trust).
  void trustModels() { trustsModels_ = true; }
  /// Sets the words by which messages explain how to trust a model, for programs without the option
  /// --trust.
  void howToTrust(std::string words) { howToTrust_ = std::move(words); }
  /// Trusts the libraries of models in `folder` and below.
  void trust(const std::filesystem::path& folder) { trusted_.add(folder); }

  /// Loads a library that the user names: "my_elements" is the file libmy_elements.so in one of the
  /// folders; a text with '/' is a path. A library that is loaded already is not registered again.
  /// Throws ModelError if the file is missing (with all paths tried), is no plug-in or does not
  /// match, or if types are duplicate.
  void load(const std::string& library, Registry& registry);
  /// Loads a library that a model in `modelFolder` names. Throws ModelError, also if the library is
  /// only in a folder that the user has not trusted.
  void load(const std::string& library, const std::filesystem::path& modelFolder,
            Registry& registry);
  /// Loads a library that a file of results names; a library of this name that is loaded already
  /// takes precedence. Throws ModelError, also if all libraries of this name have other
  /// fingerprints.
  void load(const Fingerprint& library, Registry& registry);

  /// Throws ModelError unless the user trusts the folder of this existing file, whose code a model
  /// wants to run. `what` it is in messages: "library"; `ifOwn`: the remedy where others may write.
  void requireTrust(const std::filesystem::path& file, const std::string& what,
                    const std::string& ifOwn) const;

  /// Names of the libraries in the user's folders that are not loaded, sorted.
  std::vector<std::string> available() const;
  /// Name of the library in the user's folders that probably has this type: the type begins with
  /// it, as WoodpeckerContact with woodpecker. "" if there is none, or it is loaded.
  std::string libraryOf(std::string_view type) const;

  const std::vector<Loaded>& loaded() const { return loaded_; }
  /// Fingerprints of all libraries but the standard elements. Throws FileError.
  std::vector<Fingerprint> fingerprints() const;
  /// The files that `load` tries, in this order; it takes the first one that exists.
  std::vector<std::filesystem::path> candidates(const std::string& library) const;
  std::vector<std::filesystem::path> candidates(const std::string& library,
                                                const std::filesystem::path& modelFolder) const;

 private:
  bool isLoaded(const std::filesystem::path& file) const;
  void open(const std::filesystem::path& file, bool chosen, Registry& registry);
  std::vector<std::filesystem::path> own_, installed_;  // of DYNAMY_PLUGIN_PATH; of dynamY
  TrustedFolders trusted_;
  std::string howToTrust_ = "--trust";
  bool readsConfiguration_ = false, trustsModels_ = false;
  std::vector<Loaded> loaded_;
};

}  // namespace dynamy
