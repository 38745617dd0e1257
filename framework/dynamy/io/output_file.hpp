#pragma once
/// \file
/// A file that is written once from front to back, or at once as a whole; every failure is a
/// FileError with path and reason. The bytes leave the process with each call, so that a killed run
/// keeps them; std::ofstream hides the reason of a failure and buffers a second time.

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace dynamy {

class OutputFile {
 public:
  /// Creates or empties the file. \throws FileError
  explicit OutputFile(const std::filesystem::path& path);
  /// Goes on after the first `keep` bytes of an existing file; what follows them is dropped.
  /// \throws FileError, also if the file is shorter
  OutputFile(const std::filesystem::path& path, std::uint64_t keep);
  /// Hands all of `bytes` to the operating system. \throws FileError, e.g. when the disk is full
  void write(std::string_view bytes);
  const std::filesystem::path& path() const { return path_; }
  std::uint64_t size() const { return size_; }  ///< [byte]

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::uint64_t size_ = 0;
};

/// Replaces `path` by a file with this content; a reader sees the old or the new one, never a half.
/// \throws FileError
void writeWholeFile(const std::filesystem::path& path, std::string_view content);

/// The content of a file. \throws FileError
std::string readWholeFile(const std::filesystem::path& path);

}  // namespace dynamy
