/// Examines a shared library as a file, without running any of its code.
///
/// The dynamic linker maps what the headers of a file announce: a truncated file ends the process
/// by SIGBUS, and constructors of the library run before it can be checked. Therefore the headers
/// are read here first, as plain data.
#pragma once
#include <dynamy/core/archive.hpp>
#include <filesystem>
#include <string>
#include <string_view>

namespace dynamy {

/// A file or library that a run was made with, identified by its content.
struct Fingerprint {
  std::string name;
  std::string fingerprint;  ///< of its bytes
  bool operator==(const Fingerprint&) const = default;
  void archive(Archive& a) { a(name), a(fingerprint); }
};

/// Why the dynamic linker cannot load `file`: "is no shared library", "is cut off: …", "is built
/// for another kind of machine"; "" if the headers are those of a whole library for this machine.
std::string libraryFault(const std::filesystem::path& file);

/// "my_elements" of "../lib/libmy_elements.so": the name by which a library is searched.
std::string nameOfLibrary(const std::string& library);

/// A hash of the bytes as 16 hexadecimal digits. It distinguishes two builds of a library, but does
/// not protect against deliberately made collisions.
std::string fingerprintOfBytes(std::string_view bytes);
/// Fingerprint of all bytes of a file. Throws FileError.
std::string fingerprintOf(const std::filesystem::path& file);

/// Who other than the user and the administrator may replace `file`, e.g. "everybody may write into
/// /srv/models"; "" if nobody may. Checks the file and all folders above it. A folder with the
/// sticky bit, such as /tmp, where users may remove only their own files, counts only for files of
/// others.
std::string writableByOthers(const std::filesystem::path& file);

}  // namespace dynamy
