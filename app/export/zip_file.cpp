#include "export/zip_file.hpp"

#include <zip.h>

#include <ctime>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <memory>

namespace dynamy::app {
namespace {

/// Of 1 to 9: the best takes six times as long for 4 % less.
constexpr zip_uint32_t kEffort = 4;

/// The first day that a zip archive can state, so that the time of writing leaves no trace.
std::time_t noDay() {
  std::tm day{};
  day.tm_year = 80, day.tm_mday = 1, day.tm_isdst = -1;  // in local time, as the library has it
  return std::mktime(&day);
}

struct Discard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};

}  // namespace

void ZipFile::addFile(const std::string& name, const std::filesystem::path& file) {
  add(name, readWholeFile(file));
}

void ZipFile::write(const std::filesystem::path& path) const {
  int code = 0;
  std::unique_ptr<zip_t, Discard> archive(zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code));
  if (!archive) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    const std::string reason = zip_error_strerror(&error);
    zip_error_fini(&error);
    throw WriteError(path.string(), reason);
  }
  const auto fail = [&] { throw WriteError(path.string(), zip_strerror(archive.get())); };
  for (const auto& [name, content] : files_) {
    zip_source_t* source = zip_source_buffer(archive.get(), content.data(), content.size(), 0);
    if (source == nullptr) fail();
    const zip_int64_t at = zip_file_add(archive.get(), name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (at < 0) {
      zip_source_free(source);
      fail();
    }
    const auto index = static_cast<zip_uint64_t>(at);
    constexpr zip_uint32_t kMode = 0100644u << 16u;  // an ordinary file that its owner may change
    if (zip_file_set_mtime(archive.get(), index, noDay(), 0) != 0 ||
        zip_set_file_compression(archive.get(), index, ZIP_CM_DEFLATE, kEffort) != 0 ||
        zip_file_set_external_attributes(archive.get(), index, 0, ZIP_OPSYS_UNIX, kMode) != 0)
      fail();
  }
  if (zip_close(archive.get()) != 0) fail();
  static_cast<void>(archive.release());  // closed is freed
}

}  // namespace dynamy::app
