/// The coordinates that the program chooses: what it says of them, and that nothing is refused for
/// them.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/io/files/json_reader.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <program/program_fixture.hpp>

namespace dynamy {
namespace {

class Coordinates : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("rod.xml",
          "<dynamy version=\"1\"><parameter name=\"m\" value=\"1\"/>\n"
          "<systems><PlanarBody name=\"rod\" mass=\"{m}\" inertia=\"0.1\" position=\"0.5 0 0\"/>"
          "<Ground name=\"world\"/></systems><forces><Gravity/></forces>\n"
          "<elements><Revolute name=\"hinge\" between=\"world rod\" at=\"0 0 0\"/></elements>\n"
          "<simulation until=\"0.1\" tolerance=\"1e-8\"/></dynamy>\n");
  }
};

TEST_F(Coordinates, AreToldWithTheModel) {
  // A body in a plane has three velocities; a hinge leaves one and had two rows.
  const std::string line =
      "\n joints as coordinates: 1, with 1 instead of 3 velocities and 2 rows fewer to solve for\n";
  ASSERT_EQ(call("run rod.xml --out r"), 0) << err();
  EXPECT_NE(out().find(line), std::string::npos) << out();
  const JsonValue made =
      readJson(readWholeFile(path("r/run.json")), "run.json")["settings"]["coordinates"];
  EXPECT_EQ(made["joints"].value, 1.0);
  EXPECT_EQ(made["of"].value, 1.0);
  EXPECT_EQ(made["velocities"].value, 1.0);
  EXPECT_EQ(made["inBodies"].value, 3.0);
  EXPECT_EQ(made["rowsSaved"].value, 2.0);
  ASSERT_EQ(call("check rod.xml"), 0) << err();
  EXPECT_NE(out().find(line), std::string::npos) << out();
  EXPECT_NE(out().find("in absolute coordinates of the joints: q 3   u 3   unknowns 2"),
            std::string::npos)
      << out();
}

TEST_F(Coordinates, AreExplained) {
  ASSERT_EQ(call("run rod.xml --out r --explain"), 0) << err();
  EXPECT_NE(out().find("\n tree of 1 body on \"world\": q 1, u 1\n"), std::string::npos) << out();
  ASSERT_EQ(call("run rod.xml --out r --explain --step 1e-3 --integrator StaggeredMoreau"), 0)
      << err();
  EXPECT_NE(out().find("\n joints stay constraints: steps have a fixed length"), std::string::npos)
      << out();
}

TEST_F(Coordinates, FollowTheMethodOfTheCommandLine) {
  ASSERT_EQ(call("run rod.xml --out r --step 1e-3 --integrator ThetaMethod"), 0) << err();
  EXPECT_EQ(out().find("joints as coordinates"), std::string::npos) << out();
  ASSERT_EQ(call("run rod.xml --out r --step 1e-3"), 0) << err();
  EXPECT_NE(out().find("joints as coordinates"), std::string::npos) << out();
  ASSERT_EQ(call("run rod.xml --out r --integrator LocatedDormandPrince"), 0) << err();
  EXPECT_NE(out().find("joints as coordinates"), std::string::npos) << out();
}

TEST_F(Coordinates, AreThoseOfBodiesWhereANameNeedsThem) {
  // A coordinate has no force, and the velocity of the body is none of the tree. At the start the
  // hinge carries m g (1 − m r²/J) = m g 0.1/(0.1 + 0.25 m), whose derivative at m = 1 is
  // g 0.01/0.35². After t = 0.05 s, with α = 14.0 rad/s² ~ m/J and φ = α t²/2, m r (ω² sin φ + α sin² φ)
  // is 0.0064 N beside that, and its derivative 1 + 3·0.1/0.35 times as much: 0.012.
  ASSERT_EQ(
      call("gradient rod.xml --of hinge.lambda_T2@0.05 --of rod.x@0.1 --by m rod.omega --json"), 0)
      << err();
  const JsonValue all = readJson(out(), "out");
  ASSERT_EQ(all["values"].items.size(), 2U);
  EXPECT_NEAR(std::abs(all["values"].items[0]["d"]["m"].value), 9.81 * 0.01 / 0.1225 + 0.012, 1e-3);
  EXPECT_NE(all["values"].items[1]["d"]["rod.omega"].value, 0.0);
  EXPECT_EQ(call("gradient rod.xml --of rod.x@0.1 --by rod.omega"), 0) << err();
  EXPECT_EQ(call("gradient rod.xml --of rod.x@0.1 --by rod.omegas"), 2);
  EXPECT_NE(err().find("did you mean \"rod.omega\""), std::string::npos) << err();
  EXPECT_EQ(call("gradient rod.xml --of rod.x@0.1 --by rod.joint.rate"), 0) << err();
}

TEST_F(Coordinates, OfJointsDoNotHideVelocitiesThatTheyForbid) {
  std::string text = readWholeFile(path("rod.xml"));
  text.replace(text.find("position="), 0, "velocity=\"1 0 0\" ");
  write("off.xml", text);
  EXPECT_EQ(call("run off.xml --out r --strict"), 2);
  EXPECT_NE(err().find("joint hinge"), std::string::npos) << err();
  ASSERT_EQ(call("run off.xml --out r"), 0) << err();
  EXPECT_NE(out().find("joint hinge (off.xml:3:"), std::string::npos) << out();
}

}  // namespace
}  // namespace dynamy
