#include <unit/io/plugin/compiled_library.hpp>

namespace dynamy {
namespace {

TEST(PluginLoader, LoadsALibraryBesideTheModelOnce) {
  const LibraryFolder folder;
  folder.compile("pendulum", source(frameworkFingerprint()));
  PluginLoader loader(kNowhere);
  loader.trustModels();
  Registry registry;
  loader.load("pendulum", folder.path(), registry);
  loader.load("libpendulum.so", folder.path(), registry);
  ASSERT_EQ(loader.loaded().size(), 1u);
  EXPECT_EQ(loader.loaded()[0].name, "pendulum");
  EXPECT_EQ(loader.loaded()[0].version, "1.2.0");
}

TEST(PluginLoader, ListsThePathsTriedAndTheNearestName) {
  const LibraryFolder folder;
  std::ofstream(folder.path() / "libpendulum.so") << "no library";
  fs::create_directory(folder.library("pendulm"));
  PluginLoader loader({folder.path(), "/nowhere"});
  EXPECT_EQ(errorOf(loader, "pendulm", "models"),
            "error: no library \"pendulm\" — did you mean \"pendulum\"?\n"
            "note: looked for " +
                folder.library("pendulm").string() +
                ", which is a folder\nnote: looked for /nowhere/libpendulm.so\nnote: looked for " +
                (fs::current_path() / "models").string() + "/libpendulm.so");
}

TEST(PluginLoader, TakesNothingFromTheCurrentFolder) {
  const LibraryFolder folder, elsewhere;
  folder.compile("pendulum", source());
  fs::copy_file(folder.library("pendulum"), folder.library(kStandardElements));
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  PluginLoader loader({elsewhere.path()});
  Registry registry;
  EXPECT_EQ(saidBy([&] { loader.load(kStandardElements, registry); }),
            "error: no library \"dynamy_elements\" — install dynamY again: its own elements are "
            "missing\nnote: looked for " +
                elsewhere.library(kStandardElements).string());
  for (const char* name : {"pendulum", "libpendulum.so"})
    EXPECT_EQ(saidBy([&] { loader.load(name, registry); }),
              "error: no library \"" + std::string(name) +
                  "\" — the one in the current folder is ./libpendulum.so\nnote: looked for " +
                  elsewhere.library("pendulum").string());
  EXPECT_NE(saidBy([&] { loader.load("pendulum", ".", registry); }), "");
  EXPECT_TRUE(loader.loaded().empty());
  loader.load("./libpendulum.so", registry);  // the user's own words
  EXPECT_EQ(loader.loaded().size(), 1u);
  fs::current_path(before);
}

TEST(PluginLoader, PrefersTheInstalledLibraryToTheModels) {
  const LibraryFolder model, installed;
  model.compile("pendulum", source());
  fs::copy_file(model.library("pendulum"), installed.library("pendulum"));
  PluginLoader loader({installed.path()});
  loader.trustModels();
  EXPECT_EQ(errorOf(loader, "pendulum", model.path()), "");
  ASSERT_EQ(loader.loaded().size(), 1u);
  EXPECT_EQ(loader.loaded()[0].file, fs::canonical(installed.library("pendulum")));
  // A path of a model does not climb out of the installed folder.
  PluginLoader climber({installed.path() / "lib"});
  EXPECT_NE(errorOf(climber, "../" + installed.library("pendulum").filename().string(), "/nowhere"),
            "");
}

TEST(PluginLoader, TakesWhatTheUserNamedForTheModelsLibraryOfThatName) {
  const LibraryFolder own, installed;
  own.compile("pendulum", source());
  fs::copy_file(own.library("pendulum"), installed.library("pendulum"));
  PluginLoader loader({installed.path()});
  Registry registry;
  loader.load(own.library("pendulum").string(), registry);
  loader.load("pendulum", "/nowhere", registry);
  ASSERT_EQ(loader.loaded().size(), 1u);
  EXPECT_EQ(loader.loaded()[0].file, fs::canonical(own.library("pendulum")));
}

TEST(PluginLoader, FindsTheLibraryOfAFileOfResultsByNameAndContent) {
  const LibraryFolder first, second, third;
  first.compile("pendulum", source());
  PluginInfo other = frameworkFingerprint();
  second.compile("pendulum", source(other) + "int more(void) { return 3; }\n");
  const std::string one = fingerprintOf(first.library("pendulum"));
  const std::string two = fingerprintOf(second.library("pendulum"));
  EXPECT_EQ(one.size(), 16u);
  EXPECT_NE(one, two);
  {
    PluginLoader loader({first.path(), second.path()});
    Registry registry;
    loader.load(Fingerprint{"pendulum", two}, registry);
    ASSERT_EQ(loader.loaded().size(), 1u);
    EXPECT_EQ(loader.loaded()[0].file, fs::canonical(second.library("pendulum")));
    ASSERT_EQ(loader.fingerprints().size(), 1u);
    EXPECT_EQ(loader.fingerprints()[0].fingerprint, two);
  }
  Registry registry;
  const std::string advice = " — name it: --plugin PATH, or put its folder into DYNAMY_PLUGIN_PATH";
  PluginLoader changed({first.path()});
  EXPECT_EQ(saidBy([&] {
              changed.load(Fingerprint{"pendulum", two}, registry);
            }),
            "error: the library \"pendulum\" that was used had the fingerprint " + two +
                "; there is only " + first.library("pendulum").string() + " (" + one + ")" +
                advice);
  PluginLoader empty({third.path()});
  const std::string missing = "that was used is in none of your folders" + advice;
  EXPECT_EQ(saidBy([&] {
              empty.load(Fingerprint{"pendulum", two}, registry);
            }),
            "error: the library \"pendulum\" " + missing);
  // A path in such a file leads nowhere.
  const std::string path = first.library("pendulum").string();
  EXPECT_EQ(saidBy([&] {
              empty.load(Fingerprint{path, one}, registry);
            }),
            "error: the library \"" + path + "\" " + missing);
  EXPECT_TRUE(empty.loaded().empty());
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
