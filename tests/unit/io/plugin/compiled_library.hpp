/// Libraries that a test compiles, in a folder of its own, and what loading them says.
#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <dynamy/io/plugin/library_file.hpp>
#include <dynamy/io/plugin/plugin_entry.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <fstream>

namespace dynamy {
namespace fs = std::filesystem;

inline const std::vector<fs::path> kNowhere;  // no folders but the model's

/// A folder of its own for one test, removed at its end.
class LibraryFolder {
 public:
  LibraryFolder() {
    std::string name = (fs::temp_directory_path() / "dynamy_plugin_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~LibraryFolder() { fs::remove_all(path_); }
  LibraryFolder(const LibraryFolder&) = delete;
  LibraryFolder& operator=(const LibraryFolder&) = delete;
  const fs::path& path() const { return path_; }

  fs::path library(const std::string& name) const { return path_ / ("lib" + name + ".so"); }
  /// Compiles a library of plain C, or with other words for the compiler.
  void compile(const std::string& name, const std::string& source,
               const std::string& compiler = "cc -xc") const {
    std::ofstream(path_ / "source") << source;
    const std::string command = compiler + " -shared -fPIC -o " + library(name).string() + " " +
                                (path_ / "source").string();
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
  }

 private:
  fs::path path_;
};

/// Source of a plug-in in plain C that registers nothing.
inline std::string source(const PluginInfo& p = frameworkFingerprint()) {
  const auto quoted = [](const char* t) { return '"' + std::string(t) + "\","; };
  const auto number = [](int n) { return std::to_string(n) + ','; };
  return "struct Info { int abi; const char* framework; int world, major, minor, align;\n"
         "  const char *compiler, *library, *name, *version; void (*reg)(void*); };\n"
         "static void reg(void* r) { (void)r; }\n"
         "static const struct Info info = {" +
         number(p.abi) + quoted(p.frameworkVersion) + number(p.eigenWorld) + number(p.eigenMajor) +
         number(p.eigenMinor) + number(p.eigenMaxAlignBytes) + quoted(p.compiler) +
         quoted(p.standardLibrary) +
         "\"pendulum\", \"1.2.0\", reg};\n"
         "const struct Info* dynamy_plugin_info(void) { return &info; }\n";
}

template <class Call>
std::string saidBy(Call&& call) {
  try {
    call();
  } catch (const ModelError& e) {
    return e.what();
  }
  return {};
}

inline std::string errorOf(PluginLoader& loader, const std::string& library,
                           const fs::path& folder) {
  Registry registry;
  return saidBy([&] { loader.load(library, folder, registry); });
}

inline std::string errorOf(PluginLoader& loader, const fs::path& file) {
  Registry registry;
  return saidBy([&] { loader.load(file.string(), registry); });
}

}  // namespace dynamy
