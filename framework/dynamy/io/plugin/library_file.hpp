/// A shared library as a file, before and without running any code of it.
///
/// The dynamic linker maps what the headers of a file promise: from a file that is cut off the
/// process dies by SIGBUS, and a constructor of the library runs before anybody can look at it.
/// Therefore the headers are read here first, with plain reads.
#pragma once
#include <dynamy/core/archive.hpp>
#include <filesystem>
#include <string>
#include <string_view>

namespace dynamy {

/// A file or library that a run was made with, known by what is in it.
struct Fingerprint {
  std::string name;
  std::string fingerprint;  ///< of its bytes
  bool operator==(const Fingerprint&) const = default;
  void archive(Archive& a) { a(name), a(fingerprint); }
};

/// Why the dynamic linker cannot load `file`: "is no shared library", "is cut off: …", "is built
/// for another kind of machine"; "" if the headers are those of a whole library for this machine.
std::string libraryFault(const std::filesystem::path& file);

/// "my_elements" of "../lib/libmy_elements.so": the name under which a library is searched.
std::string nameOfLibrary(const std::string& library);

/// 16 hexadecimal digits, a hash over the bytes: it tells two builds of a library apart, but is no
/// protection against somebody who wants two files to agree.
std::string fingerprintOfBytes(std::string_view bytes);
/// Of all bytes of a file. Throws FileError.
std::string fingerprintOf(const std::filesystem::path& file);

/// Who else than the user and the administrator may replace `file`, e.g. "everybody may write into
/// /srv/models"; "" if nobody may. Looks at the file and at all folders above it; a folder in which
/// each may remove but his own (the sticky bit, as of /tmp) counts for files of others only.
std::string writableByOthers(const std::filesystem::path& file);

}  // namespace dynamy
