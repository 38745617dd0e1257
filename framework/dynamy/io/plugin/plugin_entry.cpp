#include <cxxabi.h>
#include <dlfcn.h>
#include <link.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <dynamy/core/error.hpp>
#include <dynamy/io/plugin/library_file.hpp>
#include <dynamy/io/plugin/plugin_entry.hpp>
#include <memory>

namespace dynamy {

namespace fs = std::filesystem;

PluginInfo frameworkFingerprint() {
  return {kPluginAbi,
          kVersionText,
          EIGEN_WORLD_VERSION,
          EIGEN_MAJOR_VERSION,
          EIGEN_MINOR_VERSION,
          EIGEN_MAX_ALIGN_BYTES,
          DYNAMY_COMPILER_TEXT,
          DYNAMY_STANDARD_LIBRARY_TEXT,
          "",
          "",
          nullptr};
}

namespace {

std::string text(const char* t) { return t == nullptr ? "?" : t; }

/// "0.1" of "0.1.7": the part of a version that must agree before version 1.
std::string series(const std::string& version) {
  return version.substr(0, version.find('.', version.find('.') + 1));
}

std::string eigenVersion(const PluginInfo& p) {
  return std::to_string(p.eigenWorld) + '.' + std::to_string(p.eigenMajor) + '.' +
         std::to_string(p.eigenMinor);
}

constexpr const char* kEntry = "dynamy_plugin_info";

/// The symbol that a message of the loader misses, as the source writes it; "" if it misses none.
std::string missingSymbol(const std::string& why) {
  constexpr std::string_view kMissing = "undefined symbol: ";
  const std::size_t at = why.find(kMissing);
  if (at == std::string::npos) return {};
  const std::size_t begin = at + kMissing.size();
  const std::string symbol = why.substr(begin, why.find_first_of(" ,\n", begin) - begin);
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> readable(
      abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), std::free);
  return readable && status == 0 ? std::string(readable.get()) : symbol + "()";
}

/// Loads a library until the end of the program; undefined symbols are found now, not during a run.
void* linkNow(const fs::path& file, const std::string& name) {
  void* handle = nullptr;
  // The header calls dlopen noexcept, but a constructor of the library may throw through it.
  void* (*volatile open)(const char*, int) = ::dlopen;
  try {
    handle = open(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  } catch (const std::exception& e) {  // thrown by a constructor in it
    throw ModelError(name +
                     ": cannot be loaded: code that runs while it is loaded failed: " + e.what());
  } catch (...) {
    throw ModelError(name +
                     ": cannot be loaded: code that runs while it is loaded threw something that "
                     "is no std::exception");
  }
  if (handle == nullptr) {
    const std::string why = text(::dlerror());
    if (const std::string symbol = missingSymbol(why); !symbol.empty())
      throw ModelError(name + ": cannot be loaded: it needs " + symbol + ", which no library has",
                       "add the source file or the library that holds it to the plug-in, or build "
                       "it against dynamy " +
                           versionString());
    throw ModelError(name + ": cannot be loaded: " + why,
                     "was it built against dynamy " + versionString() + "?");
  }
  return handle;
}

/// A range of bytes [at, at + bytes); `mapped`: it lies in the memory mapped from the library.
struct Range {
  ElfW(Addr) library;
  std::uintptr_t at;
  std::size_t bytes;
  bool mapped;
};
int lookInto(dl_phdr_info* info, std::size_t, void* data) {
  Range& r = *static_cast<Range*>(data);
  if (info->dlpi_addr != r.library) return 0;
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const auto& s = info->dlpi_phdr[i];
    const std::uintptr_t begin = info->dlpi_addr + s.p_vaddr;
    r.mapped = r.mapped || (s.p_type == PT_LOAD && r.at >= begin && r.bytes <= s.p_memsz &&
                            r.at - begin <= s.p_memsz - r.bytes);
  }
  return 0;
}
bool isMapped(const link_map& library, const void* at, std::size_t bytes) {
  Range r{library.l_addr, reinterpret_cast<std::uintptr_t>(at), bytes, false};
  ::dl_iterate_phdr(lookInto, &r);
  return r.mapped;
}

/// The entry function of the library. It must not belong to a library that it depends on, and must
/// not be a variable, because calling that would run data.
void* entryFunction(void* handle, const link_map& library, const std::string& name) {
  void* const at = ::dlsym(handle, kEntry);
  Dl_info where{};
  void* extra = nullptr;
  const bool known = at != nullptr && ::dladdr1(at, &where, &extra, RTLD_DL_SYMENT) != 0;
  const auto* symbol = static_cast<const ElfW(Sym)*>(extra);
  if (!known || symbol == nullptr || std::strcmp(where.dli_fname, library.l_name) != 0)
    throw ModelError(name + ": is no plug-in of dynamy",
                     "its source needs the line DYNAMY_PLUGIN(name, version, registerElements)");
  if ((symbol->st_info & 0xfu) != STT_FUNC || where.dli_saddr != at)
    throw ModelError(name + ": is no plug-in of dynamy: its " + kEntry + " is no function",
                     "use the macro DYNAMY_PLUGIN(name, version, registerElements)");
  return at;
}

}  // namespace

std::string pluginMismatch(const PluginInfo& plugin, const PluginInfo& host) {
  const auto differ = [](const std::string& theirs, const std::string& ours,
                         const std::string& hint) {
    return "built with " + theirs + ", dynamy uses " + ours + " — " + hint;
  };
  const std::string rebuild = "rebuild it against this dynamy";
  if (plugin.abi != host.abi)
    return differ("plug-in interface " + std::to_string(plugin.abi), std::to_string(host.abi),
                  rebuild);
  if (series(text(plugin.frameworkVersion)) != series(text(host.frameworkVersion)))
    return differ("dynamy " + text(plugin.frameworkVersion), text(host.frameworkVersion), rebuild);
  if (eigenVersion(plugin) != eigenVersion(host))
    return differ("Eigen " + eigenVersion(plugin), eigenVersion(host),
                  "compile both with the same Eigen");
  if (plugin.eigenMaxAlignBytes != host.eigenMaxAlignBytes)
    return differ("Eigen alignment " + std::to_string(plugin.eigenMaxAlignBytes) + " bytes",
                  std::to_string(host.eigenMaxAlignBytes), "compile both with the same -march");
  if (text(plugin.standardLibrary) != text(host.standardLibrary))
    return differ(text(plugin.standardLibrary) + " (" + text(plugin.compiler) + ')',
                  text(host.standardLibrary) + " (" + text(host.compiler) + ')',
                  "compile both with the same standard library");
  if (plugin.name == nullptr || plugin.version == nullptr || plugin.registerElements == nullptr)
    return "its plug-in entry is incomplete — use the macro DYNAMY_PLUGIN";
  return {};
}

const PluginInfo& openPlugin(const fs::path& file) {
  const std::string name = file.filename().string();
  if (const std::string fault = libraryFault(file); !fault.empty())
    throw ModelError(name + ": " + fault, file.string() + " was to be a shared library");
  void* const handle = linkNow(file, name);
  link_map* library = nullptr;
  if (::dlinfo(handle, RTLD_DI_LINKMAP, static_cast<void*>(&library)) != 0 || library == nullptr)
    throw ModelError(name + ": cannot be loaded: " + text(::dlerror()));
  const auto entry =
      reinterpret_cast<const PluginInfo* (*)()>(entryFunction(handle, *library, name));
  const PluginInfo* const info = entry();
  if (info == nullptr) throw ModelError(name + ": its plug-in entry is empty");
  // The number of the interface determines the size of the struct.
  const PluginInfo host = frameworkFingerprint();
  if (!isMapped(*library, info, sizeof info->abi) ||
      (info->abi == host.abi && !isMapped(*library, info, sizeof *info)))
    throw ModelError(name + ": its plug-in entry points out of the library",
                     "use the macro DYNAMY_PLUGIN(name, version, registerElements)");
  if (const std::string why = pluginMismatch(*info, host); !why.empty())
    throw ModelError(name + ": " + why);
  return *info;
}

}  // namespace dynamy
