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

/// How much of a file is written, and what: a checkpoint knows the files of its run by it.
struct FilePlace {
  std::uint64_t bytes = 0;  ///< from the begin of the file
  std::uint32_t crc = 0;    ///< CRC-32 of these bytes
  bool operator==(const FilePlace&) const = default;
};

class OutputFile {
 public:
  /// Creates or empties the file. \throws WriteError
  explicit OutputFile(const std::filesystem::path& path);
  /// Goes on at `keep` in an existing file; what follows is dropped.
  /// \throws FileError, also if the file does not begin with these bytes
  OutputFile(const std::filesystem::path& path, const FilePlace& keep);
  /// Hands `bytes` to the operating system and removes from them what it took.
  /// \throws WriteError, e.g. when the disk is full: what is left was not written
  void write(std::string& bytes);
  /// Returns when the disk has what was written. \throws WriteError
  void sync();
  const std::filesystem::path& path() const { return path_; }
  const FilePlace& place() const { return place_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
  FilePlace place_;
};

/// Replaces `path` by a file with this content; a reader sees the old or the new one, never a half.
/// With `lasting` the new one is on the disk before the old one goes, so that it outlives a loss of
/// power. \throws WriteError
void writeWholeFile(const std::filesystem::path& path, std::string_view content,
                    bool lasting = false);

/// Writes `content` into the room that the file has already: on a full disk, where no other way is
/// left. \throws WriteError; what the file holds then is open
void overwriteFile(const std::filesystem::path& path, std::string_view content);

/// Does the file begin with these bytes? "" or why not: "is shorter than …". \throws FileError
std::string placeFault(const std::filesystem::path& path, const FilePlace& place);

/// The content of a file. \throws FileError
std::string readWholeFile(const std::filesystem::path& path);

}  // namespace dynamy
