// dynamy orbit: text, file, messages.
#include <program/program_fixture.hpp>

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

}  // namespace
}  // namespace dynamy
