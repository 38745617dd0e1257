// dynamy gradient: table, file, messages.
#include <cmath>
#include <program/program_fixture.hpp>

namespace dynamy {
namespace {

using GradientCommand = ProgramTest;

const char* const kBall = R"(<dynamy version="1">
  <parameter name="h" value="1"/>
  <parameter name="e" value="0.5"/>
  <systems><Coordinates name="ball" q="y" units="m" q0="{h}" M="1" h="-9.81"/></systems>
  <elements><CoordinateContact name="floor" on="ball" gap="y"><Unilateral epsilonN="{e}"/></CoordinateContact></elements>
  <simulation until="0.6" tolerance="1e-9"/>
  <check signal="ball.y" measure="max" over="0.5 0.6" between="0 1"/>
</dynamy>
)";

TEST_F(GradientCommand, PrintsAndWritesTheDerivatives) {
  write("ball.xml", kBall);
  ASSERT_EQ(call("gradient ball.xml --of ball.y ball.y_dot@0.6 --by h e"), 0) << err();
  EXPECT_NE(out().find("by h    -0.006748886"), std::string::npos) << out();
  const std::string file = readWholeFile(path("runs/ball.gradient/gradient.json"));
  for (const char* text : {"\"of\": \"ball.y_dot\"", "\"at\": 0.6", "\"h\": 3.322", "\"dError\""})
    EXPECT_NE(file.find(text), std::string::npos) << text << '\n' << file;
  ASSERT_EQ(call("gradient ball.xml --by h --checks --json --out d"), 0) << err();
  EXPECT_NE(out().find("\"measure\": \"max over 0.5 … 0.6 s\""), std::string::npos) << out();
}

TEST_F(GradientCommand, TellsWhatIsWrong) {
  write("ball.xml", kBall);
  EXPECT_EQ(call("gradient ball.xml --of ball.y --by hh"), 2);
  EXPECT_NE(err().find("no parameter, coordinate or velocity \"hh\" — did you mean \"h\"?"),
            std::string::npos)
      << err();
  EXPECT_EQ(call("gradient ball.xml --of ball.yy --by h"), 2);
  EXPECT_NE(err().find("no signal named \"ball.yy\" — did you mean \"ball.y\"?"), std::string::npos)
      << err();
  EXPECT_EQ(call("gradient ball.xml --of ball.y@0.7 --by h"), 2);
  EXPECT_NE(err().find("wanted at 0.7 s, but the run goes from 0 to 0.6 s"), std::string::npos)
      << err();
  EXPECT_EQ(call("gradient ball.xml --of t:floor=impact#2 --by h"), 2);
  EXPECT_NE(err().find("has 1 of these events, not 2"), std::string::npos) << err();
  EXPECT_EQ(call("gradient ball.xml --of t:flor=impact --by h"), 2);
  EXPECT_NE(err().find("no contact named \"flor\""), std::string::npos) << err();
  EXPECT_EQ(call("gradient ball.xml --of t:floor --by h"), 2);
  EXPECT_NE(err().find("is no event"), std::string::npos) << err();
  EXPECT_EQ(call("gradient ball.xml --of ball.y@x --by h"), 2);
  EXPECT_NE(err().find("\"ball.y@x\""), std::string::npos) << err();
}

TEST_F(GradientCommand, SaysWhereThereIsNoDerivative) {
  write("ball.xml", kBall);
  // The ball meets the floor right at the end: it has bounced, or it has not yet.
  EXPECT_EQ(call("gradient ball.xml --of ball.y_dot@0.4515236409857309 --by h"), 3) << out();
  EXPECT_NE(err().find("by h: at t = 0.45152"), std::string::npos) << err();
}

}  // namespace
}  // namespace dynamy
