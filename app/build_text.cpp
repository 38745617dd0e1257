#include "build_text.hpp"

#include <fmt/format.h>
#include <link.h>

#include <algorithm>
#include <cstring>
#include <dynamy/core/version.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/plugin/plugin.hpp>
#include <dynamy/io/run_files/checkpoint.hpp>
#include <filesystem>
#include <vector>

namespace dynamy::app {
namespace {

constexpr std::size_t kRound = 3;  ///< notes and their parts are aligned to four bytes

/// Build identifier of a loaded object, the linker's note "GNU" of type 3, as hexadecimal digits;
/// "" if it has none.
std::string buildId(const dl_phdr_info& object) {
  for (int i = 0; i < object.dlpi_phnum; ++i) {
    const auto& segment = object.dlpi_phdr[i];
    if (segment.p_type != PT_NOTE) continue;
    // The loader provides addresses as integers.
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    const char* at = reinterpret_cast<const char*>(object.dlpi_addr + segment.p_vaddr);
    const char* const end = at + segment.p_memsz;
    while (at + sizeof(ElfW(Nhdr)) <= end) {
      ElfW(Nhdr) note;
      std::memcpy(&note, at, sizeof note);
      const char* const name = at + sizeof note;
      const char* const id = name + ((note.n_namesz + kRound) & ~kRound);
      if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 &&
          std::memcmp(name, "GNU", 4) == 0) {
        std::string out;
        for (std::size_t k = 0; k < note.n_descsz; ++k)
          out += fmt::format("{:02x}", static_cast<unsigned char>(id[k]));
        return out;
      }
      at = id + ((note.n_descsz + kRound) & ~kRound);
    }
  }
  return {};
}

struct Object {
  std::string name;
  std::filesystem::path file;
  std::string id;
};

int note(dl_phdr_info* object, std::size_t, void* out) {
  const std::filesystem::path file = object->dlpi_name[0] == '\0'
                                         ? std::filesystem::path("/proc/self/exe")
                                         : std::filesystem::path(object->dlpi_name);
  const std::string name = file.filename().string();
  const bool program = object->dlpi_name[0] == '\0';
  if (!program && !name.starts_with("libdynamy.so") && !name.starts_with("libdynamy_elements"))
    return 0;
  auto& found = *static_cast<std::vector<Object>*>(out);
  // In the order of loading: the first ones are the program's, others those of an FMU in the model.
  const std::string own = program ? "program" : name;
  if (std::none_of(found.begin(), found.end(), [&](const Object& o) { return o.name == own; }))
    found.push_back({own, file, buildId(*object)});
  return 0;
}

}  // namespace

std::string buildText() {
  std::vector<Object> found;
  ::dl_iterate_phdr(note, &found);
  std::vector<std::string> objects;
  for (const Object& o : found)  // without an identifier: hash of the bytes
    objects.push_back(o.name + ' ' +
                      (o.id.empty() ? fingerprintOfBytes(readWholeFile(o.file)) : o.id));
  std::sort(objects.begin(), objects.end());  // the order of loading does not matter
  return fmt::format("{}, {}, build {}", versionString(), frameworkFingerprint().compiler,
                     fingerprintOfBytes(fmt::format("{}", fmt::join(objects, ", "))));
}

}  // namespace dynamy::app
