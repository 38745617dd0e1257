/// dynamy new-plugin: what it writes builds against the installed package, runs, and passes its
/// test as it stands.
#include <build_paths.hpp>
#include <program/program_fixture.hpp>
#include <vector>

namespace dynamy {
namespace {
namespace fs = std::filesystem;

const std::vector<std::string> kKinds = {"system", "contact",  "force", "law",         "scheme",
                                         "solver", "observer", "shape", "smooth_shape"};

class NewPlugin : public ProgramTest {
 protected:
  /// What the program prints as the next three lines, done by a shell with the installed package.
  void expectWorks(const std::string& kind) const {
    ASSERT_EQ(call("new-plugin try-" + kind + " --kind " + kind), 0) << err();
    const std::string said = out();
    std::string script = "set -e\n";
    if (!fs::exists(path("prefix")))
      script += "cmake --install '" DYNAMY_BINARY_DIR "' --prefix \"$PWD/prefix\"\n";
    script += "export PATH=\"$PWD/prefix/bin:$PATH\" CMAKE_PREFIX_PATH=\"$PWD/prefix\"\n";
    script +=
        "export CXX='" DYNAMY_CXX "' CMAKE_GENERATOR=Ninja CXXFLAGS='-Wall -Wextra -Werror'\n";
    script += said.substr(said.find("   cmake"));
    write("try.sh", script);
    const std::string command = "cd '" + folder_.string() + "' && bash try.sh > out 2> err";
    EXPECT_EQ(std::system(command.c_str()), 0) << kind << '\n' << out() << err();
    EXPECT_NE(out().find("100% tests passed"), std::string::npos) << out();
  }
};

TEST_F(NewPlugin, WritesFiveFilesOfWhichTheSourceIsShort) {
  for (const std::string& kind : kKinds) {
    ASSERT_EQ(call("new-plugin SlidingDoor --kind " + kind + " --out " + kind), 0) << err();
    for (const char* file : {"CMakeLists.txt", "sliding_door.cpp", "sliding_door.xml",
                             "sliding_door_test.cpp", "README.md"}) {
      const std::string text = readWholeFile(path(kind + "/" + file));
      EXPECT_EQ(text.find("{{"), std::string::npos) << kind << ' ' << file;
      EXPECT_NE(text.find("sliding_door"), std::string::npos) << kind << ' ' << file;
    }
    const std::string source = readWholeFile(path(kind + "/sliding_door.cpp"));
    // A shape comes with two pairs.
    const int most = kind == "shape" ? 80 : 45;
    EXPECT_LE(std::count(source.begin(), source.end(), '\n'), most) << kind;
    EXPECT_NE(source.find("class SlidingDoor final"), std::string::npos) << source;
  }
}

TEST_F(NewPlugin, MistakesAreNamed) {
  struct {
    const char *arguments, *said;
    int code;
  } const kMistakes[] = {
      {"door --kind contcat", "no kind \"contcat\" — did you mean \"contact\"?", 64},
      {"door", "needs --kind: system, contact", 64},
      {"../door --kind law", "a name has letters, digits, - and _", 64},
      {"3d --kind law", "begins with a letter", 64},
      {"test --kind law", "is a word of cmake or dynamY", 64},
      {"sphere --kind shape", "the type Sphere exists already in the library \"dynamy_elements\"",
       64},
      {"door --kind law --out mine", "exists already; nothing in it was touched", 2},
  };
  fs::create_directories(path("mine"));
  write("mine/note.txt", "keep");
  for (const auto& m : kMistakes) {
    EXPECT_EQ(call(std::string("new-plugin ") + m.arguments), m.code) << m.arguments;
    EXPECT_NE(err().find(m.said), std::string::npos) << m.arguments << '\n' << err();
  }
}

#ifndef DYNAMY_SANITIZED
/// The long test below builds and runs them; this one sees within seconds that an interface has moved on.
TEST_F(NewPlugin, HasSourcesOfEveryKindThatCompile) {
  std::string script = "for f in */try_it.cpp; do '" DYNAMY_CXX
                       "' -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I'" DYNAMY_SOURCE_DIR
                       "/framework' -isystem '" DYNAMY_EIGEN_DIR "' $f || exit; done";
  for (const std::string& kind : kKinds)
    ASSERT_EQ(call("new-plugin try-it --kind " + kind + " --out " + kind), 0) << err();
  write("try.sh", script);
  const std::string command = "cd '" + folder_.string() + "' && bash try.sh > out 2> err";
  EXPECT_EQ(std::system(command.c_str()), 0) << err();
}

TEST_F(NewPlugin, OfALawBuildsRunsAndPassesItsTest) { expectWorks("law"); }

using LongNewPlugin = NewPlugin;
TEST_F(LongNewPlugin, OfEveryKindBuildsRunsAndPassesItsTest) {
  for (const std::string& kind : kKinds) expectWorks(kind);
  // The observer: in rest and bounces the ground carries the weight, m g T = 2 · 9.81 · 2 N s.
  // The mass still moves by rounding at the end, and came to rest within one step of 1e-4 s.
  EXPECT_NEAR(std::stod(readWholeFile(path("try_observer.txt"))), 39.24, 2 * 9.81 * 1e-4);
}
#endif

}  // namespace
}  // namespace dynamy
