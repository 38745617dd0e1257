/// What a run will need, said before it begins; and numbers on the command line that are none.
#include <gtest/gtest.h>

#include <dynamy/io/files/json_reader.hpp>
#include <program/program_fixture.hpp>

namespace dynamy {
namespace {

std::string ball(const std::string& simulation, const std::string& record) {
  return "<dynamy version=\"1\">\n"
         "  <systems><RigidBody name=\"b\"><Sphere radius=\"0.1\" "
         "mass=\"1\"/></RigidBody></systems>\n"
         "  <forces><Gravity/></forces>\n"
         "  <simulation until=\"2\" " +
         simulation + "/>\n  <record " + record + "/>\n</dynamy>\n";
}

using Sizes = ProgramTest;

TEST_F(Sizes, CheckCountsWhatARunWillWrite) {
  write("m.xml", ball("step=\"1e-3\"", "signals=\"b.z b.vz\" every=\"10ms\" frames=\"50Hz\""));
  ASSERT_EQ(call("check m.xml --json"), 0) << err();
  const JsonValue all = readJson(out(), "out");
  const JsonValue& run = all["run"];
  EXPECT_EQ(run["steps"].value, 2000.0);
  EXPECT_EQ(run["rows"].value, 201.0);      // 0, 10 ms … 2 s
  EXPECT_EQ(run["columns"].value, 3.0);     // t and two signals
  EXPECT_EQ(run["pictures"].value, 101.0);  // 0, 20 ms … 2 s
  EXPECT_EQ(run["poses"].value, 1.0);
  EXPECT_GT(run["memory"].value, 0.0);
  EXPECT_GT(run["evaluation"].value, 0.0);
  // What is announced is what comes out, but for the head of 0.5 kB and texts of 6 to 24 bytes.
  ASSERT_EQ(call("run m.xml --quiet --out r"), 0) << err();
  const auto written = static_cast<double>(std::filesystem::file_size(path("r/signals.csv")) +
                                           std::filesystem::file_size(path("r/frames.bin")));
  EXPECT_GT(run["disk"].value, written / 2.0);
  EXPECT_LT(run["disk"].value, written * 2.0);
}

TEST_F(Sizes, CheckSaysThemInWords) {
  write("m.xml", ball("step=\"1e-3\"", "signals=\"b.z\" every=\"10ms\""));
  ASSERT_EQ(call("check m.xml"), 0) << err();
  EXPECT_NE(out().find(" a run: memory about "), std::string::npos) << out();
  EXPECT_NE(out().find(": 201 rows of 2 numbers, 121 pictures of 1 poses\n"), std::string::npos);
  EXPECT_NE(out().find(": 2000 steps take about "), std::string::npos) << out();
}

TEST_F(Sizes, ARunThatTheDiskCannotTakeIsRefused) {  // before: the disk was filled
  write("m.xml", ball("step=\"1e-3\"", "signals=\"b.z\" every=\"10ms\" frames=\"1e15\""));
  EXPECT_EQ(call("run m.xml --out r"), 2);
  EXPECT_TRUE(err().starts_with("m.xml:5:3: error: <record>: the run would write about ")) << err();
  EXPECT_NE(err().find("2e+15 pictures of 1 poses"), std::string::npos) << err();
  ASSERT_EQ(call("check m.xml"), 0) << err();
  EXPECT_NE(out().find(" left: a run into it is refused\n"), std::string::npos) << out();
  write("m.xml", ball("step=\"1e-3\"", "signals=\"b.z\" every=\"1e-15\""));
  EXPECT_EQ(call("run m.xml --out r"), 2);
}

TEST_F(Sizes, AFolderWithoutANameIsRefused) {  // before: the default folder was taken
  write("m.xml", ball("step=\"1e-3\"", "signals=\"b.z\""));
  EXPECT_EQ(call("run m.xml --out ''"), 64) << err();
  EXPECT_NE(err().find("--out: the name is empty"), std::string::npos) << err();
}

TEST_F(Sizes, AnOptionThatIsNoFiniteNumberIsAWrongCommandLine) {  // before: nan was ignored
  write("m.xml", ball("step=\"1e-3\"", "signals=\"b.z\""));
  for (const char* words :
       {"run m.xml --tolerance nan", "run m.xml --tolerance inf", "run m.xml --tolerance -1",
        "run m.xml --until inf", "run m.xml --step nan", "eigen m.xml --near nan",
        "eigen m.xml --start b.z=inf", "solve m.hdf5 --tolerance nan"})
    EXPECT_EQ(call(words), 64) << words << '\n' << out() << err();
  EXPECT_EQ(call("run m.xml --tolerance nan"), 64);
  EXPECT_TRUE(err().starts_with("dynamy: --tolerance: expects a positive number, is nan\n"))
      << err();
}

}  // namespace
}  // namespace dynamy
