#include "export/needed_libraries.hpp"

#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <array>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/plugin/plugin.hpp>
#include <map>
#include <set>
#include <string_view>

namespace dynamy::app {
namespace {

/// Beginnings of the names of the libraries of the compiler and of the C library.
constexpr std::array<std::string_view, 9> kSystem{"ld-linux",      "libc.so",      "libm.so",
                                                  "libpthread.so", "libdl.so",     "librt.so.",
                                                  "libresolv.so",  "libstdc++.so", "libgcc_s.so"};

/// A loaded library: its own name, and the names of those that it needs.
struct Loaded {
  std::string name, file;
  std::vector<std::string> needs;
};

Loaded read(const link_map& object) {
  Loaded out;
  out.file = object.l_name;
  const char* strings = nullptr;
  for (const auto* d = object.l_ld; d->d_tag != DT_NULL; ++d)
    // The loader has made an address of the offset.
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    if (d->d_tag == DT_STRTAB) strings = reinterpret_cast<const char*>(d->d_un.d_ptr);
  for (const auto* d = object.l_ld; strings != nullptr && d->d_tag != DT_NULL; ++d) {
    if (d->d_tag == DT_NEEDED) out.needs.emplace_back(strings + d->d_un.d_val);
    if (d->d_tag == DT_SONAME) out.name = strings + d->d_un.d_val;
  }
  if (out.name.empty()) out.name = std::filesystem::path(out.file).filename().string();
  return out;
}

/// All loaded libraries by name; the kernel's own, which is no file, is left out.
std::map<std::string, Loaded> allLoaded() {
  std::map<std::string, Loaded> out;
  void* self = ::dlopen(nullptr, RTLD_LAZY);
  link_map* first = nullptr;
  if (self == nullptr || ::dlinfo(self, RTLD_DI_LINKMAP, static_cast<void*>(&first)) != 0)
    throw FileError("libdynamy.so", "the loader does not say which libraries it needs");
  for (const link_map* m = first; m != nullptr; m = m->l_next) {
    if (m->l_name == nullptr || m->l_name[0] != '/') continue;
    Loaded one = read(*m);
    out.emplace(one.name, std::move(one));
  }
  ::dlclose(self);
  return out;
}

std::string frameworkFile() {
  Dl_info info{};
  if (::dladdr(reinterpret_cast<const void*>(&frameworkFingerprint), &info) == 0) return {};
  return std::filesystem::canonical(info.dli_fname).string();
}

NeededLibrary named(const Loaded& l) {
  return {l.name, std::filesystem::canonical(l.file),
          std::any_of(kSystem.begin(), kSystem.end(),
                      [&](std::string_view begin) { return l.name.starts_with(begin); }),
          false};
}

}  // namespace

NeededLibrary frameworkLibrary() {
  const std::string file = frameworkFile();
  for (const auto& [name, loaded] : allLoaded())
    if (std::filesystem::canonical(loaded.file) == file) return named(loaded);
  throw FileError("libdynamy.so", "the program holds the library in itself");
}

std::vector<NeededLibrary> librariesOfFramework() {
  const std::map<std::string, Loaded> all = allLoaded();
  std::set<std::string> found;
  const std::vector<std::string>& direct = all.at(frameworkLibrary().name).needs;
  std::vector<std::string> open = direct;
  while (!open.empty()) {
    const std::string name = open.back();
    open.pop_back();
    const auto at = all.find(name);
    if (at == all.end() || !found.insert(name).second) continue;
    open.insert(open.end(), at->second.needs.begin(), at->second.needs.end());
  }
  std::vector<NeededLibrary> out;
  for (const std::string& name : found) {
    out.push_back(named(all.at(name)));
    out.back().direct = std::find(direct.begin(), direct.end(), name) != direct.end();
  }
  return out;
}

}  // namespace dynamy::app
