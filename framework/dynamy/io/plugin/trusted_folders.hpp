/// TrustedFolders: the folders of models whose libraries may be loaded.
///
/// A model says by `<plugin>` which library it needs, and a library may do whatever its user may: a
/// model from elsewhere must not bring its own. The user decides, either for one command (--trust)
/// or by a line in the file `dynamy/trusted` of the own configuration:
///
///   # folders whose models may bring libraries; folders below them are included
///   /srv/models
///   ~/work
///
/// Rejected: trust that is kept in the model's folder, because it would come with the model.
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
  /// The folders of `file`; nothing if it is not there. A line that is no absolute folder counts
  /// for nothing, neither does a file that others may write: notes() say so.
  static TrustedFolders of(const std::filesystem::path& file);
  void add(const std::filesystem::path& folder) { folders_.push_back(folder); }
  /// Is `folder` one of them, or below one? Symbolic links are followed on both sides.
  bool holds(const std::filesystem::path& folder) const;
  const std::vector<Note>& notes() const { return notes_; }

 private:
  std::vector<std::filesystem::path> folders_;
  std::vector<Note> notes_;
};

}  // namespace dynamy
