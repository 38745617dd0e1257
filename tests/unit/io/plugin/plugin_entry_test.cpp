#include <build_paths.hpp>
#include <unit/io/plugin/compiled_library.hpp>

namespace dynamy {
namespace {

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

TEST(PluginLoader, RefusesALibraryWithAnotherAlignment) {
  const LibraryFolder folder;
  PluginInfo p = frameworkFingerprint();
  const std::string ours = std::to_string(p.eigenMaxAlignBytes);
  p.eigenMaxAlignBytes = 64;
  folder.compile("pendulum", source(p));
  PluginLoader loader({folder.path()});
  EXPECT_EQ(errorOf(loader, "pendulum", "."),
            "error: libpendulum.so: built with Eigen alignment 64 bytes, dynamy uses " + ours +
                " — compile both with the same -march");
}

TEST(PluginLoader, SaysThatALibraryIsNoPlugin) {
  const LibraryFolder folder;
  folder.compile("other", "int one(void) { return 1; }\n");
  PluginLoader loader(kNowhere);
  EXPECT_EQ(errorOf(loader, folder.library("other")),
            "error: libother.so: is no plug-in of dynamy — its source needs the line "
            "DYNAMY_PLUGIN(name, version, registerElements)");
}

TEST(PluginLoader, SaysWhyAFileCannotBeLoaded) {
  const LibraryFolder folder;
  PluginLoader loader(kNowhere);
  folder.compile("missing", "extern int nowhere(void); int one(void) { return nowhere(); }\n");
  const std::string error = errorOf(loader, folder.library("missing"));
  EXPECT_TRUE(error.starts_with("error: libmissing.so: cannot be loaded: ")) << error;
  EXPECT_NE(error.find("it needs nowhere(), which no library has"), std::string::npos) << error;
  EXPECT_TRUE(error.ends_with("or build it against dynamy " + versionString())) << error;
  // Of C++, as its source writes it.
  folder.compile("plus", "extern int _Z4farfd(double); int one(void) { return _Z4farfd(1.0); }\n");
  const std::string plus = errorOf(loader, folder.library("plus"));
  EXPECT_NE(plus.find("it needs farf(double)"), std::string::npos) << plus;
}

TEST(PluginLoader, RefusesFilesThatAreNoWholeLibraryBeforeTheyAreMapped) {
  const LibraryFolder folder;
  PluginLoader loader(kNowhere);
  const auto said = [&](const std::string& name) { return errorOf(loader, folder.library(name)); };
  std::ofstream(folder.library("text")) << "hello";
  std::ofstream(folder.library("empty")).flush();
  EXPECT_TRUE(said("text").starts_with("error: libtext.so: is no shared library")) << said("text");
  EXPECT_TRUE(said("empty").starts_with("error: libempty.so: is empty")) << said("empty");
  folder.compile("whole", source());
  const std::string object =
      "cc -c -xc /dev/null -o " + folder.library("program").string();  // no library yet
  ASSERT_EQ(std::system(object.c_str()), 0);
  EXPECT_NE(said("program").find("is no shared library"), std::string::npos) << said("program");
  // Cut off anywhere: SIGBUS in the dynamic linker otherwise.
  const auto size = fs::file_size(folder.library("whole"));
  int refused = 0;
  for (std::uintmax_t cut = 1; cut < size; cut += size / 97 + 1) {
    fs::copy_file(folder.library("whole"), folder.library("cut"),
                  fs::copy_options::overwrite_existing);
    fs::resize_file(folder.library("cut"), cut);
    const std::string fault = libraryFault(folder.library("cut"));
    if (fault.empty()) continue;  // only the table of sections is missing, which nobody needs
    ++refused;
    EXPECT_TRUE(fault.starts_with("is cut off: ") || fault == "is no shared library") << fault;
    EXPECT_EQ(said("cut").find("error: libcut.so: " + fault), 0u) << said("cut");
  }
  EXPECT_GT(refused, 70);  // of 97; segments reach to about nine tenths of the file
}

TEST(PluginLoader, RefusesAnEntryThatIsNoFunctionOfTheLibrary) {
  const LibraryFolder folder;
  PluginLoader loader(kNowhere);
  const auto said = [&](const std::string& name) { return errorOf(loader, folder.library(name)); };
  const std::string macro = " — use the macro DYNAMY_PLUGIN(name, version, registerElements)";
  folder.compile("variable", "int dynamy_plugin_info = 7;\n");
  EXPECT_EQ(
      said("variable"),
      "error: libvariable.so: is no plug-in of dynamy: its dynamy_plugin_info is no function" +
          macro);
  folder.compile("constant", "const char dynamy_plugin_info[] = \"text in a page of code\";\n",
                 "cc -xc -Wl,-z,noseparate-code");
  EXPECT_NE(said("constant").find("is no function"), std::string::npos);
  folder.compile("null", "void* dynamy_plugin_info(void) { return 0; }\n");
  EXPECT_EQ(said("null"), "error: libnull.so: its plug-in entry is empty");
  folder.compile("wild", "long dynamy_plugin_info(void) { return 0x7fff12345678; }\n");
  EXPECT_EQ(said("wild"), "error: libwild.so: its plug-in entry points out of the library" + macro);
  folder.compile("older",
                 "const int* dynamy_plugin_info(void) { static int a = 99; return &a; }\n");
  EXPECT_NE(said("older").find("built with plug-in interface 99, dynamy uses "), std::string::npos);
  // The entry of a library that it needs is not its own.
  folder.compile("plugin", source());
  folder.compile("user", "int one(void) { return 1; }\n",
                 "cc -xc -Wl,--no-as-needed -L" + folder.path().string() + " -Wl,-rpath," +
                     folder.path().string() + " -lplugin");
  EXPECT_NE(said("user").find("libuser.so: is no plug-in of dynamy — "), std::string::npos)
      << said("user");
}

TEST(PluginLoader, TakesExceptionsOfALibraryForItsFaults) {
  const LibraryFolder folder;
  PluginLoader loader(kNowhere);
  const auto said = [&](const std::string& name) { return errorOf(loader, folder.library(name)); };
  const std::string cxx = std::string(DYNAMY_CXX) + " -xc++";
  folder.compile("thrower",
                 "#include <stdexcept>\nstruct A { A() { throw std::runtime_error("
                 "\"no licence\"); } } a;\n",
                 cxx);
  EXPECT_EQ(said("thrower"),
            "error: libthrower.so: cannot be loaded: code that runs while it is loaded failed: no "
            "licence");
  folder.compile("seven", "struct A { A() { throw 7; } } a;\n", cxx);
  EXPECT_NE(said("seven").find("something that is no std::exception"), std::string::npos);
  const std::string info = source();
  const auto registering = [&](const std::string& what) {
    std::string text = info;
    const std::string reg = "static void reg(void* r) { (void)r; }";
    text.replace(text.find(reg), reg.size(), "static void reg(void*) { throw " + what + "; }");
    text.replace(text.find("const struct Info* dynamy"), 0, "extern \"C\" ");
    return "#include <stdexcept>\n" + text;
  };
  folder.compile("registers", registering("std::runtime_error(\"no table\")"), cxx);
  EXPECT_EQ(said("registers"), "error: libregisters.so: its registration failed: no table");
}

}  // namespace
}  // namespace dynamy
