/// What a user reads about a wrong model, word by word: every tests/data/messages/NAME.xml is
/// checked by the program and has to give NAME.txt on standard error, and exit code 2.
#include <gtest/gtest.h>
#include <build_paths.hpp>

#include <algorithm>
#include <program/program_fixture.hpp>

namespace dynamy {
namespace {
namespace fs = std::filesystem;

const fs::path kMessages = fs::path(DYNAMY_SOURCE_DIR) / "tests" / "data" / "messages";

std::vector<std::string> wrongModels() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kMessages))
    if (entry.path().extension() == ".xml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

class MessageTest : public ProgramTest, public ::testing::WithParamInterface<std::string> {};

TEST_P(MessageTest, IsWordByWord) {
  fs::copy(kMessages, folder_, fs::copy_options::recursive);
  EXPECT_EQ(call("check " + GetParam() + ".xml"), 2);
  EXPECT_EQ(err(), readWholeFile(kMessages / (GetParam() + ".txt")));
  EXPECT_EQ(out(), "");
}

INSTANTIATE_TEST_SUITE_P(Models, MessageTest, ::testing::ValuesIn(wrongModels()),
                         [](const auto& test) { return test.param; });

using Plugins = ProgramTest;

std::string modelWith(const std::string& plugins) {
  return "<dynamy version=\"1\">\n" + plugins +
         "  <systems><PointMass name=\"p\" mass=\"1\"/></systems>\n"
         "  <simulation until=\"1\" step=\"1e-3\"/>\n</dynamy>\n";
}

TEST_F(Plugins, AMissingLibraryListsWhereItWasLookedForAndANearName) {
  write("m.xml", modelWith("  <plugin library=\"woodpeker\"/>\n"));
  EXPECT_EQ(call("check m.xml"), 2);
  EXPECT_EQ(err(),
            "m.xml:2:20: error: <plugin>: no library \"woodpeker\" — did you mean \"woodpecker\"?\n"
            "    2 |   <plugin library=\"woodpeker\"/>\n"
            "      |                    ^~~~~~~~~\n"
            "note: looked for " DYNAMY_BINARY_DIR
            "/lib/dynamy/libwoodpeker.so\n"
            "note: looked for " +
                fs::canonical(folder_).string() +
                "/libwoodpeker.so\n"
                "1 error\n");
}

TEST_F(Plugins, AFileThatIsNoLibraryIsRefused) {
  write("libtext.so", "hello");
  write("m.xml", modelWith("  <plugin library=\"text\"/>\n"));
  EXPECT_EQ(call("check m.xml --trust"), 2);
  EXPECT_EQ(err(), "m.xml:2:20: error: <plugin>: libtext.so: is no shared library — " +
                       fs::canonical(folder_).string() +
                       "/libtext.so was to be a shared library\n"
                       "    2 |   <plugin library=\"text\"/>\n"
                       "      |                    ^~~~\n1 error\n");
}

TEST_F(Plugins, ALibraryThatIsNoPluginIsRefused) {
  fs::copy(fs::path(DYNAMY_BINARY_DIR) / "lib" / "libdynamy.so", folder_ / "libframework.so");
  write("m.xml", modelWith("  <plugin library=\"framework\"/>\n"));
  EXPECT_EQ(call("check m.xml --trust"), 2);
  EXPECT_EQ(err(),
            "m.xml:2:20: error: <plugin>: libframework.so: is no plug-in of dynamy — its source "
            "needs the line DYNAMY_PLUGIN(name, version, registerElements)\n"
            "    2 |   <plugin library=\"framework\"/>\n"
            "      |                    ^~~~~~~~~\n1 error\n");
}

TEST_F(Plugins, TwoLibrariesOfOneNameAreBothNamed) {
  const fs::path first = fs::path(DYNAMY_BINARY_DIR) / "lib" / "dynamy" / "libwoodpecker.so";
  fs::copy(first, folder_ / "libcopy.so");
  write("m.xml", modelWith("  <plugin library=\"woodpecker\"/>\n  <plugin library=\"copy\"/>\n"));
  EXPECT_EQ(call("check m.xml --trust"), 2);
  EXPECT_EQ(err(),
            "m.xml:3:20: error: <plugin>: libcopy.so: a plug-in named \"woodpecker\" is loaded "
            "already, from " +
                fs::canonical(first).string() +
                " — name one of them only, or rename one in its line DYNAMY_PLUGIN\n"
                "    3 |   <plugin library=\"copy\"/>\n"
                "      |                    ^~~~\n1 error\n");
}

}  // namespace
}  // namespace dynamy
