/// The scenes where methods fail, through the program's own bench: no cell may fail while the run's
/// report says that all is well. The verdicts themselves are tried on scenes with known outcome.
#include <algorithm>
#include <program/program_fixture.hpp>
#include <sstream>

namespace dynamy {
namespace {

struct Cell {
  std::string scene, scheme, solver, step, verdict, figure, passMark;
};

/// The fields of a line; a field in quotes may hold commas.
std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> out(1);
  bool inside = false;
  for (const char c : line) {
    if (c == '"')
      inside = !inside;
    else if (c == ',' && !inside)
      out.emplace_back();
    else
      out.back() += c;
  }
  return out;
}

class StabilityTest : public ProgramTest {
 protected:
  std::vector<Cell> cells() const {
    std::istringstream in(readWholeFile(path("m/stability.csv")));
    std::string line;
    std::getline(in, line);
    EXPECT_EQ(line, "scene,scheme,solver,step,verdict,figure,passmark");
    std::vector<Cell> out;
    while (std::getline(in, line)) {
      const std::vector<std::string> f = fields(line);
      if (f.size() != 7) {
        ADD_FAILURE() << line;
        continue;
      }
      out.push_back({f[0], f[1], f[2], f[3], f[4], f[5], f[6]});
    }
    return out;
  }
  void expectNoSilentCell(const std::vector<Cell>& all) const {
    for (const Cell& c : all)
      EXPECT_NE(c.verdict, "silent") << c.scene << ' ' << c.scheme << ' ' << c.solver << " dt "
                                     << c.step << ": " << c.figure << ", " << c.passMark;
  }
  /// The verdict on a scene of one falling mass whose check expects `z` after 1 s.
  std::string verdictOn(const std::string& z, const std::string& options) const {
    std::filesystem::create_directories(path("own"));
    write("own/catalogue.txt", "fall 1e-2  # a comment\n");
    write("own/fall.xml",
          R"(<dynamy version="1"><parameter name="dt" value="1e-2"/>
  <systems><Coordinates name="m" q="z" q0="1" units="m" M="1" potential="9.81*z"/></systems>
  <elements><CoordinateContact on="m" gap="z + 100"/></elements>
  <simulation until="1" step="{dt}"/>
  <check signal="m.z" value=")" +
              z + R"(" tolerance="1e-9"/></dynamy>)");
    exit_ = call("bench stability --scenes own --out m " + options);
    const std::vector<Cell> all = cells();
    return all.size() == 1 ? all.front().verdict : std::to_string(all.size()) + " cells";
  }
  mutable int exit_ = -1;
};

constexpr const char* kOne = "--scheme MoreauMidpoint --solver Automatic";

TEST_F(StabilityTest, QuickPartHasNoSilentCell) {
  EXPECT_EQ(call("bench stability --quick --out m"), 0) << out() << err();
  const std::vector<Cell> all = cells();
  EXPECT_GT(all.size(), 300u);
  expectNoSilentCell(all);
  const std::string page = readWholeFile(path("m/stability.html"));
  EXPECT_NE(page.find("dynamy run m/scenes/F01_stiff_spring.xml --set dt=0.01"), std::string::npos);
  EXPECT_EQ(page.find("/*DATA*/"), std::string::npos);
  EXPECT_NE(readWholeFile(path("m/stability.svg")).find("</svg>"), std::string::npos);
}

TEST_F(StabilityTest, ACellIsRepeatedByItsCommand) {
  ASSERT_EQ(call("bench stability --scene F08_events --step 1e-2 --out m " + std::string(kOne)), 0);
  const std::string mark = "\"run\":\"dynamy ";
  const std::string page = readWholeFile(path("m/stability.html"));
  const auto begin = page.find(mark) + mark.size();
  ASSERT_LT(begin, page.size());
  // The check holds there as well; at this long step an overlap qualifies the run.
  const std::string command = page.substr(begin, page.find('"', begin) - begin);
  EXPECT_EQ(call(command), 3) << out() << err();
  EXPECT_EQ(call(command + " --accept=overlap"), 0) << out() << err();
}

TEST_F(StabilityTest, AMetPassMarkPasses) {
  EXPECT_EQ(verdictOn("{1 - 9.81/2}", kOne), "pass");  // z = 1 - g t^2/2, exact for this scheme
  EXPECT_EQ(exit_, 0);
}

TEST_F(StabilityTest, AMissedOneIsSilentIfTheRunHasNothingAgainstIt) {
  EXPECT_EQ(verdictOn("-3.5", kOne), "silent");
  EXPECT_EQ(exit_, 1);
  EXPECT_NE(out().find("silent  fall MoreauMidpoint Automatic dt = 0.01"), std::string::npos)
      << out();
}

TEST_F(StabilityTest, TheErrorBarTellsWhatNothingElseDoes) {
  // Symplectic Euler: z is off by g t h/2 = 0.049 m, and its error bar says so.
  EXPECT_EQ(verdictOn("{1 - 9.81/2}", "--scheme HalfExplicitEuler --solver Automatic"), "fail");
  EXPECT_NE(readWholeFile(path("m/stability.html")).find("error bar: m.z = "), std::string::npos);
}

TEST_F(StabilityTest, UnknownScenesAndMethodsAreNamed) {
  EXPECT_EQ(call("bench stability --scene F08_event --out m"), 64);
  EXPECT_NE(err().find("did you mean \"F08_events\"?"), std::string::npos) << err();
  EXPECT_EQ(call("bench stability --scene F08_events --scheme Moreau --out m"), 2);
  EXPECT_NE(err().find("no scheme named \"Moreau\""), std::string::npos) << err();
}

class LongStabilityTest : public StabilityTest {};

TEST_F(LongStabilityTest, WholeMatrixHasNoSilentCell) {
  EXPECT_EQ(call("bench stability -j2 --out m"), 0) << out() << err();
  expectNoSilentCell(cells());
}

}  // namespace
}  // namespace dynamy
