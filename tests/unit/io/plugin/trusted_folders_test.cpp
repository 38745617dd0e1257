#include <unit/io/plugin/compiled_library.hpp>

namespace dynamy {
namespace {

TEST(PluginLoader, LoadsALibraryOfAModelsFolderOnlyIfTheUserTrustsIt) {
  const LibraryFolder folder;
  folder.compile("pendulum", source());
  const std::string file = folder.library("pendulum").string();
  const std::string refusal = "error: the library " + file +
                              " comes with the model; its code runs only if you trust it — add "
                              "--trust";
  // As a name, as a path beside the model, and as a path to anywhere.
  for (const std::string& text : {std::string("pendulum"), std::string("./libpendulum.so"), file}) {
    PluginLoader loader(kNowhere);
    EXPECT_EQ(errorOf(loader, text, folder.path()), refusal) << text;
    EXPECT_TRUE(loader.loaded().empty());
    loader.trust(folder.path().parent_path() / "." / folder.path().filename());
    EXPECT_EQ(errorOf(loader, text, folder.path()), "") << text;
    EXPECT_EQ(loader.loaded().size(), 1u);
  }
  // Trust in another folder is none in this one, though their names begin alike.
  PluginLoader loader(kNowhere);
  loader.trust(folder.path().string().substr(0, folder.path().string().size() - 1));
  loader.trust(folder.path() / "below");
  EXPECT_EQ(errorOf(loader, "pendulum", folder.path()), refusal);
}

TEST(PluginLoader, DoesNotTrustWhatOthersMayWrite) {
  const LibraryFolder folder;
  folder.compile("pendulum", source());
  fs::permissions(folder.path(), fs::perms::all);
  PluginLoader loader(kNowhere);
  loader.trustModels();
  const std::string file = folder.library("pendulum").string();
  EXPECT_EQ(errorOf(loader, "pendulum", folder.path()),
            "error: the library " + file + " comes with the model, and everybody may write into " +
                folder.path().string() +
                ", so that it may be anybody's — if it is yours, name it: "
                "--plugin " +
                file);
  EXPECT_EQ(errorOf(loader, file), "");  // the user's own words
}

TEST(WritableByOthers, LooksAtTheFileAndAllFoldersAboveIt) {
  const LibraryFolder folder;
  const fs::path deep = folder.path() / "a" / "b";
  fs::create_directories(deep);
  std::ofstream(deep / "file") << "x";
  EXPECT_EQ(writableByOthers(deep / "file"), "");
  fs::permissions(folder.path() / "a", fs::perms::all);
  EXPECT_EQ(writableByOthers(deep / "file"),
            "everybody may write into " + (folder.path() / "a").string());
  // In a folder like /tmp nobody may replace the files of others.
  fs::permissions(folder.path() / "a", fs::perms::all | fs::perms::sticky_bit);
  EXPECT_EQ(writableByOthers(deep / "file"), "");
  fs::permissions(deep / "file", fs::perms::all);
  EXPECT_EQ(writableByOthers(deep / "file"), "everybody may write " + (deep / "file").string());
  // A link counts as what it points to.
  fs::create_symlink(deep / "file", folder.path() / "link");
  EXPECT_EQ(writableByOthers(folder.path() / "link"),
            "everybody may write " + (deep / "file").string());
}

TEST(TrustedFolders, AreAbsoluteFoldersALineWithThoseBelow) {
  const LibraryFolder folder;
  fs::create_directories(folder.path() / "models" / "below");
  fs::create_directory_symlink(folder.path() / "models", folder.path() / "link");
  fs::create_directories(folder.path() / "models2");
  const fs::path list = folder.path() / "trusted";
  std::ofstream(list) << "# mine\n\n  " << (folder.path() / "link").string() << "  \r\nmodels\n";
  const TrustedFolders t = TrustedFolders::of(list);
  EXPECT_TRUE(t.holds(folder.path() / "models"));
  EXPECT_TRUE(t.holds(folder.path() / "models" / "below"));
  EXPECT_TRUE(t.holds(folder.path() / "link" / "below" / ".."));
  EXPECT_FALSE(t.holds(folder.path() / "models2"));
  EXPECT_FALSE(t.holds(folder.path()));
  EXPECT_FALSE(t.holds(folder.path() / "models" / ".."));
  ASSERT_EQ(t.notes().size(), 1u);
  EXPECT_EQ(t.notes()[0].place, Place(list.string(), 4));
  EXPECT_EQ(t.notes()[0].text, "\"models\" is no absolute folder and counts for nothing");
  fs::permissions(list, fs::perms::all);
  EXPECT_FALSE(TrustedFolders::of(list).holds(folder.path() / "models"));
  EXPECT_EQ(TrustedFolders::of(list).notes().at(0).text,
            "is not read: everybody may write " + list.string());
  EXPECT_FALSE(TrustedFolders::of(folder.path() / "none").holds("/"));
}

}  // namespace
}  // namespace dynamy
