#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <dynamy/io/files/bytes.hpp>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <fstream>
#include <iterator>
#include <system_error>

namespace dynamy {

namespace {

constexpr std::size_t kPiece = 1 << 16;

std::string because(const char* what, int error) {
  return std::string(what) + ": " + std::strerror(error);
}

/// Brings the entry of `file` in its folder to the disk: it is part of the folder, not of the file.
void syncFolder(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return;  // a file system whose folders cannot be opened: nothing to do
  ::fsync(opened);
  ::close(opened);
}

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& path)
    : path_(path), file_(std::fopen(path.c_str(), "wbe")) {
  if (!file_) throw WriteError(path.string(), because("cannot write", errno));
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);  // the callers collect whole rows and chunks
}

OutputFile::OutputFile(const std::filesystem::path& path, const FilePlace& keep)
    : path_(path), place_(keep) {
  if (const std::string fault = placeFault(path, keep); !fault.empty())
    throw FileError(path.string(), fault);
  std::error_code error;
  std::filesystem::resize_file(path, keep.bytes, error);
  if (error) throw WriteError(path.string(), "cannot go on: " + error.message());
  file_.reset(std::fopen(path.c_str(), "abe"));
  if (!file_) throw WriteError(path.string(), because("cannot write", errno));
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);
}

void OutputFile::write(std::string& bytes) {
  if (bytes.empty()) return;
  const std::size_t taken = std::fwrite(bytes.data(), 1, bytes.size(), file_.get());
  const int error = errno;
  place_.crc = crc32(std::string_view(bytes).substr(0, taken), place_.crc);
  place_.bytes += taken;
  const bool all = taken == bytes.size();
  bytes.erase(0, taken);
  if (all) return;
  std::clearerr(file_.get());
  throw WriteError(path_.string(), because("cannot write", error));
}

void OutputFile::sync() {
  if (::fdatasync(::fileno(file_.get())) != 0 && errno != EINVAL && errno != EROFS)
    throw WriteError(path_.string(), because("cannot write", errno));
}

void writeWholeFile(const std::filesystem::path& path, std::string_view content, bool lasting) {
  std::filesystem::path part = path;
  part += ".part";
  std::error_code error;
  try {
    OutputFile file(part);
    std::string bytes(content);
    file.write(bytes);
    if (lasting) file.sync();
  } catch (const WriteError&) {
    std::filesystem::remove(part, error);  // a partial file is useless, and its space may be needed
    throw;
  }
  std::filesystem::rename(part, path, error);
  if (error) throw WriteError(path.string(), "cannot replace: " + error.message());
  if (lasting) syncFolder(path);
}

void overwriteFile(const std::filesystem::path& path, std::string_view content) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  const auto size = static_cast<ssize_t>(content.size());
  const bool good = file >= 0 && ::pwrite(file, content.data(), content.size(), 0) == size &&
                    ::ftruncate(file, size) == 0;
  const int error = errno;
  if (file >= 0) ::close(file);
  if (!good) throw WriteError(path.string(), because("cannot write", error));
}

std::string placeFault(const std::filesystem::path& path, const FilePlace& place) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return because("cannot read", errno);
  std::string piece(kPiece, '\0');
  FilePlace found;
  while (found.bytes < place.bytes) {
    const auto wanted = std::min<std::uint64_t>(kPiece, place.bytes - found.bytes);
    file.read(piece.data(), static_cast<std::streamsize>(wanted));
    const auto got = static_cast<std::size_t>(file.gcount());
    found.crc = crc32(std::string_view(piece).substr(0, got), found.crc), found.bytes += got;
    if (got < wanted)
      return "is cut off: " + std::to_string(found.bytes) + " of " + std::to_string(place.bytes) +
             " bytes are left";
  }
  return found == place ? ""
                        : "was changed: its first " + std::to_string(place.bytes) +
                              " bytes are not those that the run wrote";
}

std::string readWholeFile(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    throw FileError(path.string(), "is a folder, a file is needed");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(path.string(), std::string("cannot read: ") + std::strerror(errno));
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace dynamy
