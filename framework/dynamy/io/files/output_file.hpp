#pragma once
/// \file
/// A file that is written once from front to back, or in one call as a whole. Every failure is a
/// FileError with path and reason. Each call hands its bytes to the operating system, so that they
/// survive if the run is killed. Rejected: std::ofstream, which hides the reason of a failure and
/// buffers a second time.

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace dynamy {

/// Number and checksum of the bytes written to a file so far, by which a checkpoint recognises the
/// files of its run.
struct FilePlace {
  std::uint64_t bytes = 0;  ///< from the beginning of the file
  std::uint32_t crc = 0;    ///< CRC-32 of these bytes
  bool operator==(const FilePlace&) const = default;
};

class OutputFile {
 public:
  /// Creates or empties the file. \throws WriteError
  explicit OutputFile(const std::filesystem::path& path);
  /// Continues an existing file after the bytes `keep`; later bytes are removed.
  /// \throws FileError, also if the file does not begin with these bytes
  OutputFile(const std::filesystem::path& path, const FilePlace& keep);
  /// Hands `bytes` to the operating system and removes the written part from `bytes`.
  /// \throws WriteError, e.g. when the disk is full: the bytes left were not written
  void write(std::string& bytes);
  /// Returns when the written bytes are on the disk. \throws WriteError
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

/// Replaces `path` by a file with this content; a reader sees the old or the new file, never a part
/// of one. With `lasting` the new file is on the disk before the old one is removed, so that it
/// survives a loss of power. \throws WriteError
void writeWholeFile(const std::filesystem::path& path, std::string_view content,
                    bool lasting = false);

/// Writes `content` into the disk space that the file already has, the last resort on a full disk.
/// \throws WriteError; the content of the file is then undefined
void overwriteFile(const std::filesystem::path& path, std::string_view content);

/// Why the file does not begin with these bytes, e.g. "is shorter than …"; "" if it does. \throws
/// FileError
std::string placeFault(const std::filesystem::path& path, const FilePlace& place);

/// The content of a file. \throws FileError
std::string readWholeFile(const std::filesystem::path& path);

}  // namespace dynamy
