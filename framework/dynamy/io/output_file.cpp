#include <cerrno>
#include <cstring>
#include <dynamy/io/file_error.hpp>
#include <dynamy/io/output_file.hpp>
#include <fstream>
#include <iterator>
#include <system_error>

namespace dynamy {

OutputFile::OutputFile(const std::filesystem::path& path)
    : path_(path), file_(std::fopen(path.c_str(), "wb")) {
  if (!file_) throw FileError(path.string(), std::string("cannot write: ") + std::strerror(errno));
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);  // the callers collect whole rows and chunks
}

OutputFile::OutputFile(const std::filesystem::path& path, std::uint64_t keep)
    : path_(path), size_(keep) {
  std::error_code error;
  const auto found = std::filesystem::file_size(path, error);
  if (error) throw FileError(path.string(), "cannot go on: " + error.message());
  if (found < keep) throw FileError(path.string(), "is shorter than the checkpoint says");
  std::filesystem::resize_file(path, keep, error);
  if (error) throw FileError(path.string(), "cannot go on: " + error.message());
  file_.reset(std::fopen(path.c_str(), "ab"));
  if (!file_) throw FileError(path.string(), std::string("cannot write: ") + std::strerror(errno));
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);
}

void OutputFile::write(std::string_view bytes) {
  if (bytes.empty()) return;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) {
    throw FileError(path_.string(), std::string("cannot write: ") + std::strerror(errno));
  }
  size_ += bytes.size();
}

void writeWholeFile(const std::filesystem::path& path, std::string_view content) {
  std::filesystem::path part = path;
  part += ".part";
  OutputFile(part).write(content);
  std::error_code error;
  std::filesystem::rename(part, path, error);
  if (error) throw FileError(path.string(), "cannot replace: " + error.message());
}

std::string readWholeFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(path.string(), std::string("cannot read: ") + std::strerror(errno));
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace dynamy
