/// A new folder for temporary files, removed with all of them at the end. No other folder may be
/// removed: one with a name that somebody chose may hold files of theirs.
#pragma once
#include <stdlib.h>

#include <dynamy/io/files/file_error.hpp>
#include <filesystem>
#include <string>

namespace dynamy::app {

class TemporaryFolder {
 public:
  /// Its name begins with `name`. Throws WriteError.
  explicit TemporaryFolder(const std::string& name) {
    std::string folder = (std::filesystem::temp_directory_path() / (name + "_XXXXXX")).string();
    if (::mkdtemp(folder.data()) == nullptr) throw WriteError(folder, "cannot create the folder");
    path_ = folder;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace dynamy::app
