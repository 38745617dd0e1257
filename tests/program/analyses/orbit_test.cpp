// dynamy orbit: text, file, messages.
#include <program/program_fixture.hpp>
#include <sstream>
#include <vector>

namespace dynamy {
namespace {

using OrbitCommand = ProgramTest;

const char* const kForcedMass = R"x(<dynamy version="1">
  <parameter name="F" value="1"/>
  <systems><Coordinates name="m" q="x" units="m" q0="1" M="1" h="-x - 0.2*x_dot + F*cos(2*t)"/></systems>
  <simulation until="10" tolerance="1e-9"/>
</dynamy>
)x";

TEST_F(OrbitCommand, PrintsAndWritesTheOrbit) {
  write("m.xml", kForcedMass);
  ASSERT_EQ(call("orbit m.xml --period 3.141592653589793 --set F=2"), 0) << err();
  for (const char* text :
       {"period 3.1415926535", "m.x ", "stable: small disturbances shrink to 0.7304"})
    EXPECT_NE(out().find(text), std::string::npos) << text << '\n' << out();
  const std::string file = readWholeFile(path("runs/m.orbit/orbit.json"));
  for (const char* text : {"\"period\": 3.14159", "\"m.x_dot\"", "\"multipliers\": [",
                           "\"zeros\": 0", "\"shift\": {}", "\"newton\": "})
    EXPECT_NE(file.find(text), std::string::npos) << text << '\n' << file;
  ASSERT_EQ(call("orbit m.xml --period 3.141592653589793 --start m.x=3 --json --out o"), 0)
      << err();
  EXPECT_EQ(out().find("{"), 0u) << out();
}

TEST_F(OrbitCommand, TellsWhatIsWrong) {
  write("m.xml", kForcedMass);
  const auto expectError = [&](const std::string& options, const std::string& text) {
    EXPECT_EQ(call("orbit m.xml " + options), 2) << options;
    EXPECT_NE(err().find(text), std::string::npos) << options << '\n' << err();
  };
  expectError("", "nothing says where the orbit begins");
  expectError("--section m.y=0+", "no signal named \"m.y\"");
  expectError("--section m.x", "\"m.x\" is no section");
  expectError("--section m.x=100+",
              "does not pass the section (m.x rises through 100) within 10 s");
  expectError("--period 3 --start m.z=0", "no coordinate or velocity named \"m.z\"");
  // A section of a forced motion: its return depends on the time at which it begins.
  expectError("--period 2", "the model depends on time with another period");
}

TEST_F(OrbitCommand, TakesTheSectionOfTheModelAndTellsItsFaults) {
  const auto model = [&](const std::string& orbit) {
    std::string text = kForcedMass;
    write("m.xml", text.insert(text.rfind("</dynamy>"), "  " + orbit + "\n"));
  };
  model("<orbit period=\"{3.141592653589793}\"/>");
  ASSERT_EQ(call("orbit m.xml"), 0) << err();
  EXPECT_NE(out().find("at the section (every 3.14159265359 s)"), std::string::npos) << out();
  model("<orbit signal=\"m.x\" period=\"1\"/>");
  EXPECT_EQ(call("orbit m.xml"), 2);
  EXPECT_NE(err().find("m.xml:5:3: error: <orbit>: takes either a signal or a period"),
            std::string::npos)
      << err();
  model("<orbit signal=\"m.y\"/>");
  EXPECT_EQ(call("run m.xml"), 2);
  EXPECT_NE(err().find("no signal \"m.y\""), std::string::npos) << err();
}

/// Rows of a CSV file behind its head, as numbers; texts are 0.
std::vector<std::vector<double>> rowsOf(const std::string& file) {
  std::vector<std::vector<double>> out;
  std::istringstream lines(file);
  std::string line, cell;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    out.emplace_back();
    std::istringstream cells(line);
    while (std::getline(cells, cell, ',')) out.back().push_back(std::atof(cell.c_str()));
  }
  return out;
}

TEST_F(OrbitCommand, FollowsAnOrbitAndShowsWherePlainRunsGo) {
  write("m.xml", kForcedMass);
  ASSERT_EQ(call("orbit m.xml --period 3.141592653589793 --over F=0.5:2:4 --brute 3 --out o"), 0)
      << err();
  for (const char* text : {" periodic orbits over F, ", "0.5              end ",
                           "72 passes of the section by plain runs in brute.csv"})
    EXPECT_NE(out().find(text), std::string::npos) << text << '\n' << out();
  // x = F Re 1/(1 − 4 + 0.4 i), at each multiple of the period.
  const double share = -3.0 / (9.0 + 0.16);
  const std::string branch = readWholeFile(path("o/branch.csv"));
  EXPECT_EQ(branch.find("F,period,m.x,m.x_dot,re1,im1,re2,im2,zeros,stable,bifurcation,text\n"), 0u)
      << branch;
  for (const std::vector<double>& row : rowsOf(branch)) {
    EXPECT_NEAR(row[2], share * row[0], 1e-9);  // a hundred tolerances of the runs
    EXPECT_EQ(row[9], 1.0);
  }
  const std::string brute = readWholeFile(path("o/brute.csv"));
  EXPECT_EQ(brute.find("F,m.x,m.x_dot\n"), 0u) << brute;
  const std::vector<std::vector<double>> passes = rowsOf(brute);
  ASSERT_EQ(passes.size(), 72u);  // 24 at each value
  EXPECT_EQ(passes.front()[0], 0.5);
  EXPECT_EQ(passes.back()[0], 2.0);
  for (const std::vector<double>& row : passes)
    EXPECT_NEAR(row[1], share * row[0], 1e-6);  // a hundred tolerances of plain runs
  for (const char* file : {"o/branch.svg", "o/branch.html"})
    EXPECT_NE(readWholeFile(path(file)).find("stroke=\"#6b7785\""), std::string::npos) << file;
  const std::string json = readWholeFile(path("o/branch.json"));
  for (const char* text : {"\"parameter\": \"F\"", "\"brute\": 72", "\"bifurcation\": \"end\""})
    EXPECT_NE(json.find(text), std::string::npos) << text << '\n' << json;
}

TEST_F(OrbitCommand, TellsWhatIsWrongWithABranch) {
  write("m.xml", kForcedMass);
  const auto expectError = [&](const std::string& options, const std::string& text) {
    EXPECT_EQ(call("orbit m.xml --period 3.141592653589793 " + options), 2) << options;
    EXPECT_NE(err().find(text), std::string::npos) << options << '\n' << err();
  };
  expectError("--over F", "\"F\" is no range: no bounds");
  expectError("--over F=1:2:x", "the number of points is a whole number");
  expectError("--over G=1:2", "no parameter \"G\"");
  expectError("--over F=1:1", "there is nothing between 1 and 1");
  expectError("--over F=1:2:3 --show m.y", "nothing named \"m.y\" on the branch");
  EXPECT_EQ(call("orbit m.xml --period 3 --brute 3"), 64);
  EXPECT_NE(err().find("--over"), std::string::npos) << err();
}

}  // namespace
}  // namespace dynamy
