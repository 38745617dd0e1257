// dynamy eigen: table, files, critical values, messages.
#include <build_paths.hpp>
#include <cmath>
#include <dynamy/io/files/csv.hpp>
#include <program/program_fixture.hpp>

namespace dynamy {
namespace {

using EigenCommand = ProgramTest;

/// m x'' + (c − 2) x' + k x = 0: grows below c = 2.
const char* const kOscillator = R"(<dynamy version="1">
  <parameter name="c" value="3"/>
  <systems><Coordinates name="m" q="x" units="m" q0="0.2" M="1" potential="8*x^2" h="(2 - c)*x_dot"/></systems>
  <simulation until="1" step="1e-3"/>
</dynamy>
)";

TEST_F(EigenCommand, PrintsAndWritesTheEigenvalues) {
  write("m.xml", kOscillator);
  ASSERT_EQ(call("eigen m.xml"), 0) << err();
  EXPECT_NE(out().find("-0.5"), std::string::npos) << out();
  EXPECT_NE(out().find("no disturbance grows"), std::string::npos) << out();
  const auto table = readCsv(readWholeFile(path("runs/m.eigen/eigen.csv")));
  ASSERT_EQ(table.size(), 3u);
  EXPECT_EQ(table[0], (std::vector<std::string>{"real", "imaginary"}));
  EXPECT_NEAR(std::stod(table[1][0]), -0.5, 1e-11);  // differences, see reference tests
  EXPECT_NEAR(std::stod(table[1][1]), std::sqrt(16.0 - 0.25), 1e-11);
  EXPECT_NE(readWholeFile(path("runs/m.eigen/eigen.json")).find("\"growing\": 0"),
            std::string::npos);
}

TEST_F(EigenCommand, FindsWhereARealPartChangesItsSign) {
  write("m.xml", kOscillator);
  ASSERT_EQ(call("eigen m.xml --root-of c=1:4 --over c=1:4:7"), 0) << err();
  EXPECT_NE(out().find("c = 2: growing motions 2 below, 0 above; 0.63662 Hz"), std::string::npos)
      << out();
  const auto table = readCsv(readWholeFile(path("runs/m.eigen/locus.csv")));
  ASSERT_EQ(table.size(), 1u + 7u * 2u);
  EXPECT_EQ(table[0][0], "c");
  EXPECT_EQ(table[1][0], "1");
}

TEST_F(EigenCommand, TellsWhatIsWrong) {
  write("m.xml", kOscillator);
  EXPECT_EQ(call("eigen m.xml --as-it-is"), 2);
  EXPECT_NE(err().find("no steady motion found"), std::string::npos) << err();
  EXPECT_EQ(call("eigen m.xml --start m.y=1"), 2);
  EXPECT_NE(err().find("no coordinate or velocity named \"m.y\" — known: \"m.x\", \"m.x_dot\""),
            std::string::npos)
      << err();
  EXPECT_EQ(call("eigen m.xml --as-it-is --start m.x=0"), 0) << err();
  EXPECT_EQ(call("eigen m.xml --root-of c=3:4"), 0) << err();
  EXPECT_NE(err().find("no real part changes its sign in c=3:4"), std::string::npos) << err();
}

TEST_F(EigenCommand, NamesTheForceThatDependsOnTimeAndTheParameterThatSwitchesItOff) {
  const std::string model = "'" DYNAMY_SOURCE_DIR "/models/motorbike.xml'";
  EXPECT_EQ(call("eigen " + model), 2);
  EXPECT_NE(err().find("<ForceInput> in "), std::string::npos) << err();
  EXPECT_NE(err().find("depends on t: --set push=0 switches it off"), std::string::npos) << err();
  EXPECT_EQ(call("eigen --set push=0 " + model), 0) << err();
  EXPECT_NE(out().find("-23.115275125"), std::string::npos)
      << out();  // closed form, in the model's head
}

TEST_F(EigenCommand, FindsTheSteadyMotionOfAVehicleWhoseSpringsAreNotPreloaded) {
  // Bodies, joints and two springs in minimal coordinates; at the start the springs do not carry the
  // weight, and a moving damper could for an instant. Steady is upright straight riding with the springs
  // compressed, by symmetry: the road carries 292 kg, and each wheel what the levers of the bodies'
  // centres give it, without any damper's force.
  ASSERT_EQ(call("eigen '" DYNAMY_SOURCE_DIR "/tests/data/defects/eigen_unpreloaded.xml'"), 0)
      << err();
  double carried = 0.0;
  for (const char* wheel : {"rear-road.rim sticks, force ", "front-road.rim sticks, force "}) {
    const std::size_t at = out().find(wheel);
    ASSERT_NE(at, std::string::npos) << out();
    carried += std::stod(out().substr(at + std::string(wheel).size()));
  }
  EXPECT_NEAR(carried, 292.0 * 9.81, 2e-6);  // accelerations of 1e-8 m/s² at most, digits printed
}

}  // namespace
}  // namespace dynamy
