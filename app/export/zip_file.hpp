/// ZipFile: an archive that is written at once; equal contents give equal bytes.
#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace dynamy::app {

class ZipFile {
 public:
  /// Adds a file of this name ("binaries/a.so") and content.
  void add(const std::string& name, std::string content) { files_[name] = std::move(content); }
  /// Adds a copy of `file`. Throws FileError.
  void addFile(const std::string& name, const std::filesystem::path& file);
  const std::map<std::string, std::string>& files() const { return files_; }
  /// Replaces `path` by the archive. Throws WriteError.
  void write(const std::filesystem::path& path) const;

 private:
  std::map<std::string, std::string> files_;
};

}  // namespace dynamy::app
