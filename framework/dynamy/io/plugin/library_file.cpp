#include <elf.h>
#include <fmt/format.h>
#include <link.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>
#include <dynamy/core/hash.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/plugin/library_file.hpp>
#include <fstream>
#include <vector>

namespace dynamy {

namespace fs = std::filesystem;

namespace {

using Header = ElfW(Ehdr);
using LoadSegment = ElfW(Phdr);

/// The header of an ELF file; false if the file holds none.
bool readHeader(std::ifstream& in, Header& h) {
  return in.read(reinterpret_cast<char*>(&h), sizeof h) &&
         std::memcmp(h.e_ident, ELFMAG, SELFMAG) == 0;
}

/// True if `h` is the header of a library for the machine of this program.
bool forThisMachine(const Header& h) {
  std::ifstream in("/proc/self/exe", std::ios::binary);
  Header own{};
  if (!readHeader(in, own)) return true;  // the dynamic linker decides
  return h.e_ident[EI_CLASS] == own.e_ident[EI_CLASS] &&
         h.e_ident[EI_DATA] == own.e_ident[EI_DATA] && h.e_machine == own.e_machine;
}

/// The number of bytes that the file needs so that all of its segments can be mapped; 0: it has
/// none, or its table of segments is not readable.
std::uint64_t bytesOfSegments(std::ifstream& in, const Header& h) {
  if (h.e_phentsize != sizeof(LoadSegment) || h.e_phnum == 0) return 0;
  std::vector<LoadSegment> table(h.e_phnum);
  const auto bytes = static_cast<std::streamsize>(table.size() * sizeof(LoadSegment));
  const std::uint64_t behind = h.e_phoff + static_cast<std::uint64_t>(bytes);
  in.clear();
  in.seekg(static_cast<std::streamoff>(h.e_phoff));
  if (!in.read(reinterpret_cast<char*>(table.data()), bytes)) return behind;
  std::uint64_t most = behind;
  bool dynamic = false;
  for (const LoadSegment& s : table) {
    dynamic = dynamic || s.p_type == PT_DYNAMIC;
    if (s.p_type == PT_LOAD && s.p_filesz > 0)
      most = std::max<std::uint64_t>(most, s.p_offset + s.p_filesz);
  }
  return dynamic ? most : 0;
}

}  // namespace

std::string libraryFault(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return "cannot be read";
  std::error_code error;
  const std::uint64_t size = fs::file_size(file, error);
  Header h{};
  if (size == 0) return "is empty";
  if (!readHeader(in, h)) return "is no shared library";
  if (!forThisMachine(h)) return "is built for another kind of machine";
  if (h.e_type != ET_DYN) return "is no shared library, but another result of a compiler";
  const std::uint64_t needed = bytesOfSegments(in, h);
  if (needed == 0) return "is no shared library";
  if (size < needed) return fmt::format("is cut off: {} of at least {} bytes", size, needed);
  return {};
}

std::string nameOfLibrary(const std::string& library) {
  std::string name = fs::path(library).filename().string();
  if (name.ends_with(".so")) name.resize(name.size() - 3);
  if (name.starts_with("lib")) name.erase(0, 3);
  return name;
}

std::string fingerprintOfBytes(std::string_view bytes) {
  Hash hash;
  for (const char c : bytes) hash.add(std::uint64_t{static_cast<unsigned char>(c)});
  return fmt::format("{:016x}", hash.value());
}

std::string fingerprintOf(const fs::path& file) { return fingerprintOfBytes(readWholeFile(file)); }

std::string writableByOthers(const fs::path& file) {
  std::error_code error;
  fs::path below = fs::canonical(file, error);
  if (error) return {};  // the file is missing: there is nothing to load
  struct stat owned {};
  if (::stat(below.c_str(), &owned) == 0 && (owned.st_mode & S_IWOTH) != 0)
    return "everybody may write " + below.string();
  while (below.has_relative_path()) {
    const fs::path folder = below.parent_path();
    struct stat above {};
    if (::stat(folder.c_str(), &above) != 0) return {};
    const bool ours = owned.st_uid == ::geteuid() || owned.st_uid == 0;
    if ((above.st_mode & S_IWOTH) != 0 && ((above.st_mode & S_ISVTX) == 0 || !ours))
      return "everybody may write into " + folder.string();
    below = folder, owned = above;
  }
  return {};
}

}  // namespace dynamy
