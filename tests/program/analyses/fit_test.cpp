// dynamy fit: text, files, messages.
#include <fmt/format.h>

#include <cmath>
#include <program/program_fixture.hpp>

namespace dynamy {
namespace {

using FitCommand = ProgramTest;

const char* const kDroppedBall = R"(<dynamy version="1">
  <parameter name="h" value="1"/>
  <parameter name="e" value="0.5"/>
  <parameter name="m" value="1"/>
  <systems><Coordinates name="ball" q="y" units="m" q0="{h}" M="{m}" h="{-9.81*m}"/></systems>
  <elements><CoordinateContact name="floor" on="ball" gap="y"><Unilateral epsilonN="{e}"/></CoordinateContact></elements>
  <simulation until="1" tolerance="1e-9"/>
</dynamy>
)";

/// Height of a ball that falls from h and bounces once before 1 s [m].
double droppedHeight(double h, double e, double t) {
  const double g = 9.81, impact = std::sqrt(2.0 * h / g);
  if (t <= impact) return h - 0.5 * g * t * t;
  return e * g * impact * (t - impact) - 0.5 * g * (t - impact) * (t - impact);
}

/// Measured in millimetres, with an error of ±1 mm.
std::string droppedBall(double h, double e) {
  std::string out = "# a ball\ntime [ms],ball.y [mm]\n";
  for (int i = 0; i <= 17; ++i)
    out += fmt::format("{},{:.6f}\n", 50 * i,
                       1e3 * droppedHeight(h, e, 0.05 * i) + (i % 2 == 0 ? 1.0 : -1.0));
  return out;
}

TEST_F(FitCommand, PrintsAndWritesTheParameters) {
  write("ball.xml", kDroppedBall);
  write("drop.csv", droppedBall(1.2, 0.6));
  ASSERT_EQ(call("fit ball.xml drop.csv --parameters h,e"), 0) << err() << out();
  for (const char* text : {"ball.xml: 18 measurements in 1 run", "   h ", "   e ", "95 %: ",
                           "gaussian", "ball.y: standard deviation 0.001", "that of the residuals"})
    EXPECT_NE(out().find(text), std::string::npos) << text << '\n' << out();
  const std::string file = readWholeFile(path("runs/ball.fit/fit.json"));
  for (const char* text :
       {"\"parameters\": {", "\"h\": {", "\"interval\": [", "\"identifiable\": true",
        "\"covariance\": [", "\"chi2\": ", "\"runs\": [", "\"name\": \"drop\""})
    EXPECT_NE(file.find(text), std::string::npos) << text << '\n' << file;
  const std::string rest = readWholeFile(path("runs/ball.fit/residuals.csv"));
  EXPECT_EQ(rest.find("run,t,signal,measured,sigma,fitted,residual\ndrop,0,ball.y,"), 0u) << rest;
  const std::string page = readWholeFile(path("runs/ball.fit/fit.html"));
  EXPECT_NE(page.find("<h2>Residuals</h2>"), std::string::npos);
}

TEST_F(FitCommand, NamesWhatIsNotIdentifiable) {
  write("ball.xml", kDroppedBall);
  write("drop.csv", droppedBall(1.2, 0.6));
  EXPECT_EQ(call("fit ball.xml drop.csv --parameters h,e,m --json"), 3) << err();
  EXPECT_NE(out().find("m itself is not identifiable"), std::string::npos) << out();
  EXPECT_NE(out().find("\"interval\": [null, null]"), std::string::npos) << out();
}

TEST_F(FitCommand, TakesRunsWithValuesOfTheirOwn) {
  write("ball.xml", kDroppedBall);
  write("a.csv", droppedBall(1.2, 0.6));
  write("b.csv", droppedBall(0.8, 0.6));
  ASSERT_EQ(call("fit ball.xml a.csv:h=1.2 b.csv:ball.y=0.8 --parameters e --sigma ball.y=1mm"), 0)
      << err();
  EXPECT_NE(out().find("36 measurements in 2 runs"), std::string::npos) << out();
  EXPECT_NE(out().find("χ² = 3"), std::string::npos) << out();  // each residual is one σ
  ASSERT_EQ(call("fit ball.xml a.csv b.csv --parameters e --each h"), 0) << err();
  EXPECT_NE(out().find("h[a]"), std::string::npos) << out();
  EXPECT_NE(out().find("h[b]"), std::string::npos) << out();
}

TEST_F(FitCommand, TakesBoundsAndPriors) {
  write("ball.xml", kDroppedBall);
  write("drop.csv", droppedBall(1.2, 0.6));
  ASSERT_EQ(call("fit ball.xml drop.csv --parameters h,e --bounds e=0:0.55"), 0) << err();
  EXPECT_NE(out().find("at its bound"), std::string::npos) << out();
  ASSERT_EQ(call("fit ball.xml drop.csv --parameters h,e,m --prior m=2+-0.5"), 0) << err();
  EXPECT_NE(out().find("   m            2   95 %: 0.9"), std::string::npos) << out();
}

TEST_F(FitCommand, TellsWhatIsWrong) {
  write("ball.xml", kDroppedBall);
  write("drop.csv", droppedBall(1.2, 0.6));
  const auto expectError = [&](const std::string& options, const std::string& text) {
    EXPECT_EQ(call("fit ball.xml " + options), 2) << options;
    EXPECT_NE(err().find(text), std::string::npos) << options << '\n' << err();
  };
  expectError("drop.csv", "nothing says which parameters to find — --parameters e,h,m");
  expectError("drop.csv --parameters hh", "no parameter \"hh\" — did you mean \"h\"?");
  expectError("drop.csv --parameters h --each h", "is to be found twice");
  expectError("drop.csv:h=1 --parameters h", "\"h\" is to be found for all runs together");
  expectError("drop.csv:ball.x=1 --parameters h", "no coordinate or velocity named \"ball.x\"");
  expectError("drop.csv:h --parameters e", "drop.csv:h");
  expectError("drop.csv --parameters h --bounds e=0:1",
              "\"e\" is no parameter that is to be found");
  expectError("drop.csv --parameters e --bounds e=0.5", "\"0.5\" has no \":\"");
  expectError("drop.csv --parameters e --bounds e=0.6:1", "begins at 0.5, outside of 0.6 … 1");
  expectError("drop.csv --parameters e --prior e=0.5", "\"0.5\" has no \"+-\"");
  expectError("drop.csv --parameters e --sigma ball.z=1", "no signal named \"ball.z\"");
  expectError("drop.csv --parameters e --sigma ball.y=1s", "ball.y=1s");
}

TEST_F(FitCommand, TellsFaultsOfMeasurementsWithTheirPlaces) {
  write("ball.xml", kDroppedBall);
  const auto expectFault = [&](const std::string& text, const std::string& message) {
    write("d.csv", text);
    EXPECT_EQ(call("fit ball.xml d.csv --parameters e"), 2) << text;
    EXPECT_NE(err().find(message), std::string::npos) << text << '\n' << err();
  };
  expectFault("", "d.csv: error: holds nothing");
  expectFault("t,ball.y\n", "d.csv: error: holds no measurements");
  expectFault("t,ball.yy\n0,1\n",
              "d.csv:1:3: error: no signal named \"ball.yy\" — did you mean \"ball.y\"?");
  expectFault("ball.y\n1\n", "d.csv:1:1: error: no column holds the time");
  expectFault("t;ball.y\n0;1\n", "d.csv:1:1: error: the cells are not separated by commas");
  expectFault("t,ball.y,ball.y\n0,1,1\n",
              "d.csv:1:10: error: the column \"ball.y\" is given twice");
  expectFault("t,ball.y [s]\n0,1\n", "d.csv:1:3: error: ");
  expectFault("t,ball.y\n0,1\n0.1, nan\n", "d.csv:3:6: error: \"nan\" is no number");
  expectFault("t,ball.y\n0,1\n0.1,1\n0.1,2\n",
              "d.csv:4:1: error: the time 0.1 s stands in line 3 already");
  expectFault("t,ball.y\n0,1\n1.5,1\n",
              "d.csv:3:1: error: the time 1.5 s is after the run, which goes from 0 to 1 s");
  expectFault("t,ball.y\n0,1,2\n", "d.csv:2:5: error: 3 cells where the head has 2");
  expectFault("t,ball.y\n,1\n", "d.csv:2:1: error: the time is missing");
  expectFault("t,ball.y,sigma(ball.y)\n0,1,0\n", "d.csv:2:5: error: a standard deviation is > 0");
  expectFault("t,ball.y,sigma(ball.y)\n0,1,\n",
              "d.csv:2:5: error: the standard deviation of \"ball.y\" is missing");
  EXPECT_EQ(call("fit ball.xml none.csv --parameters e"), 2);
  EXPECT_NE(err().find("none.csv"), std::string::npos) << err();
}

}  // namespace
}  // namespace dynamy
