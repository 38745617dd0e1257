/// scripts/build-release, with a stand-in for cmake.
#include <build_paths.hpp>
#include <program/program_fixture.hpp>

namespace dynamy {
namespace {
namespace fs = std::filesystem;

class Scripts : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    folder_ = fs::canonical(folder_);
    fs::create_directories(clone() / "scripts");
    fs::create_directories(clone() / "build" / "release" / "CMakeFiles");
    fs::create_directories(folder_ / "bin");
    fs::copy(fs::path(DYNAMY_SOURCE_DIR) / "scripts" / "build-release", clone() / "scripts");
    // Like cmake it refuses a folder that was configured for another one.
    write("bin/cmake",
          "#!/bin/sh\ncache=build/release/CMakeCache.txt\n"
          "[ ! -f $cache ] || grep -qxF \"CMAKE_HOME_DIRECTORY:INTERNAL=$(pwd -P)\" $cache || exit "
          "1\n"
          "echo \"$*\" >> called\n");
    fs::permissions(path("bin/cmake"), fs::perms::owner_all);
  }
  fs::path clone() const { return folder_ / "a clone"; }
  void configuredIn(const fs::path& home) const {
    write("a clone/build/release/CMakeCache.txt",
          "# cache\nCMAKE_HOME_DIRECTORY:INTERNAL=" + home.string() + "\nMORE:STRING=1\n");
  }
  int build() const {
    return WEXITSTATUS(std::system(("cd / && PATH='" + path("bin") + "':\"$PATH\" '" +
                                    (clone() / "scripts" / "build-release").string() +
                                    "' dynamy > '" + path("out") + "' 2> '" + path("err") + "'")
                                       .c_str()));
  }
};

TEST_F(Scripts, AMovedCloneIsConfiguredAnew) {
  configuredIn("/srv/elsewhere");
  EXPECT_EQ(build(), 0) << err();
  EXPECT_EQ(err().find("This folder was /srv/elsewhere when it was built; it is configured and "
                       "built anew ...\n"),
            0u)
      << err();
  EXPECT_FALSE(fs::exists(clone() / "build" / "release" / "CMakeCache.txt"));
  EXPECT_EQ(readWholeFile(clone() / "called"),
            "--preset release\n--build --preset release --target dynamy\n");
}

TEST_F(Scripts, ACloneThatStayedIsNot) {
  configuredIn(clone());
  EXPECT_EQ(build(), 0) << err();
  EXPECT_TRUE(fs::exists(clone() / "build" / "release" / "CMakeCache.txt"));
  EXPECT_EQ(err().find("anew"), std::string::npos) << err();
}

TEST_F(Scripts, SayOnATerminalHowFarABuildIs) {
  write("bin/cmake", "#!/bin/sh\n[ \"$1\" = --build ] || exit 0\necho '[1/8] a'; echo '[2/8] b'\n");
  fs::permissions(path("bin/cmake"), fs::perms::owner_all);
  EXPECT_EQ(build(), 0);
  EXPECT_EQ(readWholeFile(path("err")).find("/8]"), std::string::npos);  // a file is no terminal
  const std::string call = "cd / && PATH='" + path("bin") + "':\"$PATH\" script -qec \"'" +
                           (clone() / "scripts" / "build-release").string() + "' dynamy\" '" +
                           path("seen") + "' > /dev/null < /dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(call.c_str())), 0);
  const std::string seen = readWholeFile(path("seen"));
  EXPECT_NE(seen.find("[1/8]"), std::string::npos) << seen;
  EXPECT_NE(seen.find("[2/8]"), std::string::npos) << seen;
  EXPECT_EQ(readWholeFile((clone() / "build/release/build.log").string()), "[1/8] a\n[2/8] b\n");
}

TEST_F(Scripts, RunBuildsThePlugInsThatAModelNames) {
  fs::copy(fs::path(DYNAMY_SOURCE_DIR) / "scripts" / "run", clone() / "scripts");
  fs::create_directories(clone() / "build/release/bin");
  fs::create_directories(folder_ / "some models" / "parts");
  for (const char* name : {"install-packages", "../build/release/bin/dynamy"}) {
    write("a clone/scripts/" + std::string(name), "#!/bin/sh\n");
    fs::permissions(clone() / "scripts" / name, fs::perms::owner_all);
  }
  for (const char* name : {"lift", "bike", "tyres", "named", "other"})
    fs::create_directories(clone() / "plugins" / name),
        write("a clone/plugins/" + std::string(name) + "/CMakeLists.txt",
              "dynamy_add_plugin(" + std::string(name) + " a.cpp)\n");
  write(
      "some models/model.xml",
      "<model>\n<plugin library='bike'/><plugin\n  library = \"own.so\"/>"
      "<include prefix=\"a\" file=\"parts/lift.xml\"/><include file='parts/lift.xml'/>\n</model>");
  write("some models/parts/lift.xml",
        "<part><plugin\n  library=\"lift\"/><include file=\"../model.xml\"/></part>");
  const std::string call =
      "cd '" + path("some models") + "' && PATH='" + path("bin") + "':\"$PATH\" '" +
      (clone() / "scripts/run").string() +
      "' model.xml --plugin named --plugin=tyres --set mu=1 --out . --trust other > '" +
      path("out") + "' 2> '" + path("err") + "'";
  configuredIn(clone());
  EXPECT_EQ(WEXITSTATUS(std::system(call.c_str())), 0) << err();
  EXPECT_EQ(readWholeFile(clone() / "called"),
            "--preset release\n--build --preset release --target dynamy bike lift named tyres\n");
}

}  // namespace
}  // namespace dynamy
