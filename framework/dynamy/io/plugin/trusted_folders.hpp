/// TrustedFolders: the folders of models whose libraries may be loaded.
///
/// A model names the libraries it needs by `<plugin>`, and the code of a library may do whatever
/// its user may. So a model of unknown origin must not bring its own library. The user decides,
/// either for one command (--trust) or by a line in the file `dynamy/trusted` of the user
/// configuration:
///
///   # folders whose models may bring libraries; folders below them are included
///   /srv/models
///   ~/work
///
/// Rejected: a trust file in the model's folder, because it would come with the model.
#pragma once
#include <dynamy/core/error.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace dynamy {

/// `$XDG_CONFIG_HOME/dynamy/trusted`, else `~/.config/dynamy/trusted`; empty if neither variable
/// names an absolute folder.
std::filesystem::path trustFile();

class TrustedFolders {
 public:
  /// The folders listed in `file`; none if it is missing. Lines that are no absolute folder are
  /// ignored, and so is a file that others may write; notes() report this.
  static TrustedFolders of(const std::filesystem::path& file);
  void add(const std::filesystem::path& folder) { folders_.push_back(folder); }
  /// True if `folder` is a trusted folder or lies below one. Symbolic links are followed on both
  /// sides.
  bool holds(const std::filesystem::path& folder) const;
  const std::vector<Note>& notes() const { return notes_; }

 private:
  std::vector<std::filesystem::path> folders_;
  std::vector<Note> notes_;
};

}  // namespace dynamy
