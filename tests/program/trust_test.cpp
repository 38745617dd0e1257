/// Whose code runs: no library of the current folder, one of a model's folder only by the user's
/// word, one of a sweep or a checkpoint by name and content.
#include <build_paths.hpp>
#include <program/program_fixture.hpp>
#include <sstream>

namespace dynamy {
namespace {
namespace fs = std::filesystem;

const fs::path kInstalled = fs::path(DYNAMY_BINARY_DIR) / "lib" / "dynamy";

/// A plug-in beside a model, and a library whose constructor leaves the file "ran" behind.
class Trust : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    ::setenv("XDG_CONFIG_HOME", path("config").c_str(), 1);
    folder_ = fs::canonical(folder_);
  }
  void TearDown() override {
    ::unsetenv("XDG_CONFIG_HOME");
    ::unsetenv("DYNAMY_PLUGIN_PATH");
    ProgramTest::TearDown();
  }
  void writeSpy(const std::string& name) const {
    write("spy.c",
          "#include <stdio.h>\n__attribute__((constructor)) static void run(void) {\n"
          "  FILE* f = fopen(\"" +
              path("ran") + "\", \"w\");\n  if (f) fclose(f);\n}\n");
    ASSERT_EQ(
        std::system(("cc -shared -fPIC -o '" + path(name) + "' '" + path("spy.c") + "'").c_str()),
        0);
  }
  bool ran() const { return fs::exists(folder_ / "ran"); }
  /// The woodpecker's library under a name that nobody has installed.
  void writePlugin(const std::string& file) const {
    fs::create_directories((folder_ / file).parent_path());
    fs::copy_file(kInstalled / "libwoodpecker.so", folder_ / file);
  }
  void writeModel(const std::string& file, const std::string& library) const {
    fs::create_directories((folder_ / file).parent_path());
    write(file, "<dynamy version=\"1\">\n  <plugin library=\"" + library +
                    "\"/>\n"
                    "  <parameter name=\"v\" value=\"1\"/>\n"
                    "  <systems><PointMass name=\"p\" mass=\"1\" velocity=\"{v} 0 0\"/></systems>\n"
                    "  <simulation until=\"0.1\" step=\"1e-2\"/>\n</dynamy>\n");
  }
};

TEST_F(Trust, NoCommandRunsALibraryOfTheCurrentFolder) {
  writeSpy("libdynamy_elements.so");
  fs::copy_file(path("libdynamy_elements.so"), path("libwoodpecker.so"));
  writeModel("m.xml", "woodpecker");
  for (const char* command :
       {"--version", "list", "list --plugin woodpecker", "describe Woodpecker --plugin woodpecker",
        "schema", "check m.xml", "check m.xml --trust", "run m.xml --trust --out r", "eigen m.xml",
        "compare m.xml", "sweep m.xml --set v=1,2 --out s", "resume r --until 0.2",
        "new-plugin door --kind law", "completion bash", "manual"}) {
    call(command);
    EXPECT_FALSE(ran()) << command;
    fs::remove(folder_ / "ran");
  }
}

TEST_F(Trust, TheLibrariesOfTheProgramItselfAreNotTakenFromTheCurrentFolder) {
  const std::string list = "ldd '" DYNAMY_BINARY_DIR "/bin/dynamy' > '" + path("list") + "'";
  ASSERT_EQ(std::system(list.c_str()), 0);
  writeSpy("spy.so");
  std::istringstream lines(readWholeFile(path("list")));
  int spies = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of(" \t"), end = line.find(" => ");
    if (end == std::string::npos) continue;
    fs::copy_file(path("spy.so"), folder_ / line.substr(begin, end - begin));
    ++spies;
  }
  EXPECT_GE(spies, 5);  // framework, fmt, hdf5, tinyxml2, libraries of the compiler
  EXPECT_EQ(call("--version"), 0) << err();
  EXPECT_EQ(err(), "");
  EXPECT_FALSE(ran());
}

TEST_F(Trust, ALibraryBesideTheModelNeedsTheUsersWord) {
  writeSpy("libspy.so");
  writeModel("m.xml", "spy");
  for (const char* command :
       {"check m.xml", "run m.xml", "sweep m.xml --set v=1,2", "eigen m.xml"}) {
    EXPECT_EQ(call(command), 2) << command;
    EXPECT_FALSE(ran()) << command;
  }
  EXPECT_EQ(call("check m.xml"), 2);
  EXPECT_EQ(err(), "m.xml:2:20: error: <plugin>: the library " + path("libspy.so") +
                       " comes with the model; its code runs only if you trust it — add --trust, "
                       "or the line " +
                       folder_.string() + " to " + path("config") +
                       "/dynamy/trusted\n"
                       "    2 |   <plugin library=\"spy\"/>\n"
                       "      |                    ^~~\n1 error\n");
  call("check m.xml --trust");
  EXPECT_TRUE(ran());
}

TEST_F(Trust, MayBeALineOfTheUsersConfiguration) {
  writePlugin("models/libtoy.so");
  writeModel("models/m.xml", "toy");
  EXPECT_EQ(call("check models/m.xml"), 2);
  fs::create_directories(folder_ / "config" / "dynamy");
  write("config/dynamy/trusted", "# mine\n" + path("models") + "\n");
  EXPECT_EQ(call("check models/m.xml"), 0) << err();
  write("config/dynamy/trusted", "models\n");  // not absolute
  EXPECT_EQ(call("check models/m.xml"), 2);
  EXPECT_NE(err().find("trusted:1: note: \"models\" is no absolute folder and counts for nothing"),
            std::string::npos)
      << err();
  // A relative folder would be one of the current folder.
  write("config/dynamy/trusted", path("models") + "\n");
  ::setenv("XDG_CONFIG_HOME", "config", 1);
  EXPECT_EQ(call("check models/m.xml"), 2);
}

TEST_F(Trust, TheUsersOwnWordsNeedNone) {
  writePlugin("build/libtoy.so");
  writeModel("m.xml", "toy");
  EXPECT_EQ(call("check m.xml"), 2);
  EXPECT_EQ(call("check m.xml --plugin build/libtoy.so"), 0) << err();
  ::setenv("DYNAMY_PLUGIN_PATH", "build", 1);
  EXPECT_EQ(call("check m.xml"), 0) << err();
  EXPECT_EQ(call("check m.xml --plugin toy"), 0) << err();
}

TEST_F(Trust, IsNeededByAnyPathThatAModelWrites) {
  writePlugin("else where/libtoy.so");
  for (const std::string& library :
       {path("else where/libtoy.so"), std::string("../else where/libtoy.so")}) {
    writeModel("models/m.xml", library);
    EXPECT_EQ(call("check models/m.xml"), 2) << library;
    EXPECT_EQ(call("check models/m.xml --trust"), 0) << err();
  }
}

TEST_F(Trust, ARunGoesOnWithTheLibraryThatItHadAndNoOther) {
  writePlugin("build/libtoy.so");
  writeModel("m.xml", "toy");
  ASSERT_EQ(call("run m.xml --plugin build/libtoy.so --out r --quiet"), 0) << err();
  EXPECT_EQ(call("resume r --until 0.2"), 2);
  EXPECT_NE(err().find("the library \"toy\" that was used is in none of your folders — name it: "
                       "--plugin PATH, or put its folder into DYNAMY_PLUGIN_PATH"),
            std::string::npos)
      << err();
  EXPECT_EQ(call("resume r --until 0.2 --plugin build/libtoy.so --quiet"), 0) << err();
  ::setenv("DYNAMY_PLUGIN_PATH", path("build").c_str(), 1);
  EXPECT_EQ(call("resume r --until 0.3 --quiet"), 0) << err();
  // Another library under the name.
  writeSpy("build/libtoy.so");
  EXPECT_EQ(call("resume r --until 0.4"), 2);
  EXPECT_NE(err().find("that was used had the fingerprint"), std::string::npos) << err();
  EXPECT_FALSE(ran());
}

TEST_F(Trust, ASweepGoesOnWithTheLibraryThatItHadAndNoOther) {
  writePlugin("build/libtoy.so");
  writeModel("m.xml", "toy");
  ASSERT_EQ(call("sweep m.xml --set v=1,2 --plugin build/libtoy.so --out s --emit slurm"), 0)
      << err();
  // The script says again what the user said.
  for (const char* task : {"1", "2"})
    ASSERT_EQ(std::system(
                  ("SLURM_ARRAY_TASK_ID=" + std::string(task) + " sh '" + path("s/slurm.sh") + "'")
                      .c_str()),
              0);
  EXPECT_EQ(call("sweep s --collect"), 0) << err();
  fs::remove(folder_ / "s" / "results" / "2.csv");
  EXPECT_EQ(call("sweep s"), 2);
  EXPECT_NE(err().find("the library \"toy\" that was used is in none of your folders"),
            std::string::npos)
      << err();
  EXPECT_EQ(call("sweep s --plugin build/libtoy.so"), 0) << err();
}

}  // namespace
}  // namespace dynamy
