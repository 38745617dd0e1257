#include <gtest/gtest.h>

#include <dynamy/io/plugin_loader.hpp>

#include <cstdlib>
#include <fstream>

namespace dynamy {
namespace {

namespace fs = std::filesystem;

const std::vector<fs::path> kNowhere;  // no folders but the model's

/// A folder of its own for one test, removed at its end.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "dynamy_plugin_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const fs::path& path() const { return path_; }

  /// Compiles a library of plain C; `entry` are the fields of the plug-in's fingerprint.
  void compile(const std::string& name, const std::string& source) const {
    std::ofstream(path_ / "source.c") << source;
    const std::string command = "cc -shared -fPIC -o " + (path_ / ("lib" + name + ".so")).string() +
                                " " + (path_ / "source.c").string();
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
  }

 private:
  fs::path path_;
};

/// Source of a plug-in in plain C that registers nothing.
std::string source(const PluginInfo& p) {
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

std::string errorOf(PluginLoader& loader, const std::string& library, const fs::path& folder) {
  Registry registry;
  try {
    loader.load(library, folder, registry);
  } catch (const ModelError& e) {
    return e.what();
  }
  return {};
}

TEST(PluginMismatch, IsNoneBetweenAProgramAndItself) {
  PluginInfo p = frameworkFingerprint();
  p.registerElements = [](Registry&) {};
  EXPECT_EQ(pluginMismatch(p, frameworkFingerprint()), "");
}

TEST(PluginMismatch, SaysBothSides) {
  PluginInfo host = frameworkFingerprint();
  host.abi = 1;
  host.frameworkVersion = "0.1.0";
  host.eigenWorld = 3, host.eigenMajor = 4, host.eigenMinor = 0;
  host.eigenMaxAlignBytes = 16;
  host.compiler = "gcc 12.2.0";
  host.standardLibrary = "libstdc++, cxx11 abi";
  const auto mismatch = [&](auto change) {
    PluginInfo p = host;
    p.registerElements = [](Registry&) {};
    change(p);
    return pluginMismatch(p, host);
  };
  EXPECT_EQ(mismatch([](PluginInfo& p) { p.abi = 2; }),
            "built with plug-in interface 2, dynamy uses 1 — rebuild it against this dynamy");
  EXPECT_EQ(mismatch([](PluginInfo& p) { p.frameworkVersion = "0.2.1"; }),
            "built with dynamy 0.2.1, dynamy uses 0.1.0 — rebuild it against this dynamy");
  EXPECT_EQ(mismatch([](PluginInfo& p) { p.frameworkVersion = "0.1.7"; }), "");
  EXPECT_EQ(mismatch([](PluginInfo& p) { p.eigenMinor = 90; }),
            "built with Eigen 3.4.90, dynamy uses 3.4.0 — compile both with the same Eigen");
  EXPECT_EQ(mismatch([](PluginInfo& p) { p.eigenMaxAlignBytes = 32; }),
            "built with Eigen alignment 32 bytes, dynamy uses 16 — compile both with the same "
            "-march");
  EXPECT_EQ(
      mismatch([](PluginInfo& p) { p.standardLibrary = "libc++", p.compiler = "clang 16.0.6"; }),
      "built with libc++ (clang 16.0.6), dynamy uses libstdc++, cxx11 abi (gcc 12.2.0) — "
      "compile both with the same standard library");
  EXPECT_EQ(mismatch([](PluginInfo& p) { p.compiler = "clang 16.0.6"; }), "");
  EXPECT_EQ(mismatch([](PluginInfo& p) { p.registerElements = nullptr; }),
            "its plug-in entry is incomplete — use the macro DYNAMY_PLUGIN");
}

TEST(PluginLoader, LoadsALibraryBesideTheModelOnce) {
  const Folder folder;
  folder.compile("pendulum", source(frameworkFingerprint()));
  PluginLoader loader(kNowhere);
  Registry registry;
  loader.load("pendulum", folder.path(), registry);
  loader.load("libpendulum.so", folder.path(), registry);
  ASSERT_EQ(loader.loaded().size(), 1u);
  EXPECT_EQ(loader.loaded()[0].name, "pendulum");
  EXPECT_EQ(loader.loaded()[0].version, "1.2.0");
}

TEST(PluginLoader, RefusesALibraryWithAnotherAlignment) {
  const Folder folder;
  PluginInfo p = frameworkFingerprint();
  const std::string ours = std::to_string(p.eigenMaxAlignBytes);
  p.eigenMaxAlignBytes = 64;
  folder.compile("pendulum", source(p));
  PluginLoader loader({folder.path()});
  EXPECT_EQ(errorOf(loader, "pendulum", "."),
            "error: libpendulum.so: built with Eigen alignment 64 bytes, dynamy uses " + ours +
                " — compile both with the same -march");
}

TEST(PluginLoader, ListsThePathsTriedAndTheNearestName) {
  const Folder folder;
  std::ofstream(folder.path() / "libpendulum.so") << "no library";
  PluginLoader loader({folder.path(), "/nowhere"});
  EXPECT_EQ(errorOf(loader, "pendulm", "models"),
            "error: no library \"pendulm\" — did you mean \"pendulum\"?\n"
            "note: looked for " +
                (std::filesystem::current_path() / "models").string() +
                "/libpendulm.so\nnote: looked for " + (folder.path() / "libpendulm.so").string() +
                "\nnote: looked for /nowhere/libpendulm.so");
}

TEST(PluginLoader, SaysThatALibraryIsNoPlugin) {
  const Folder folder;
  folder.compile("other", "int one(void) { return 1; }\n");
  PluginLoader loader(kNowhere);
  EXPECT_EQ(errorOf(loader, "other", folder.path()),
            "error: libother.so: is no plug-in of dynamy — its source needs the line "
            "DYNAMY_PLUGIN(name, version, registerElements)");
}

TEST(PluginLoader, SaysWhyAFileCannotBeLoaded) {
  const Folder folder;
  std::ofstream(folder.path() / "libbroken.so") << "no library";
  PluginLoader loader(kNowhere);
  const std::string error = errorOf(loader, "broken", folder.path());
  EXPECT_TRUE(error.starts_with("error: libbroken.so: cannot be loaded: ")) << error;
  EXPECT_TRUE(error.ends_with(" — was it built against dynamy " + versionString() + "?")) << error;
}

struct Dummy final : Element {
  static constexpr Kind kKind = Kind::law;
  static void declare(Attributes&) {}
  explicit Dummy(const Parameters& x) : Element(x) {}
};

TEST(Registry, NamesBothLibrariesOfATypeThatExistsTwice) {
  Registry registry;
  registry.library("a");
  registry.add<Dummy>("Pendulum");
  registry.library("b");
  try {
    registry.add<Dummy>("Pendulum");
    FAIL();
  } catch (const ModelError& e) {
    EXPECT_STREQ(e.what(),
                 "error: the type \"Pendulum\" of the library \"b\" exists already in the library "
                 "\"a\" — rename one of them, or load one of the libraries only");
  }
  EXPECT_EQ(registry.find("Pendulum")->library, "a");
}

struct Twice final : Element {
  static constexpr Kind kKind = Kind::law;
  static void declare(Attributes& a) {
    a.required("mu", Unit::none, "first");
    a.optional("mu", Unit::none, 0.3, "second");
  }
  explicit Twice(const Parameters& x) : Element(x) {}
};
struct Spaced final : Element {
  static constexpr Kind kKind = Kind::law;
  static void declare(Attributes& a) { a.required("my mu", Unit::none, "with a space"); }
  explicit Spaced(const Parameters& x) : Element(x) {}
};

TEST(Registry, RefusesNamesThatNoModelCanWriteAndAttributesThatAreDeclaredTwice) {
  Registry registry;
  registry.library("a");
  const auto said = [&](auto&& add) {
    try {
      add();
    } catch (const ModelError& e) {
      return std::string(e.what());
    }
    return std::string("nothing");
  };
  const std::string hint = " — a name is made of letters, digits and _ and begins with a letter";
  EXPECT_EQ(
      said([&] { registry.add<Dummy>("My Law"); }),
      "error: the library \"a\" registers a type \"My Law\", which no model can write" + hint);
  for (const char* name : {"", "2Laws", "a<b"})
    EXPECT_TRUE(said([&] { registry.add<Dummy>(name); }).ends_with("no model can write" + hint));
  EXPECT_EQ(said([&] { registry.add<Spaced>("Spaced"); }),
            "error: the library \"a\" declares the attribute \"my mu\" of <Spaced>, which no model "
            "can write" +
                hint);
  EXPECT_EQ(said([&] { registry.add<Twice>("Twice"); }),
            "error: the library \"a\" declares the attribute \"mu\" of <Twice> twice — "
            "declareCommon of its base may have declared it");
  EXPECT_TRUE(registry.types().empty());
}

}  // namespace
}  // namespace dynamy
