/// The exit status of a run, as a script sees it (doc/run_folder.md).
#include "program_fixture.hpp"

namespace dynamy {
namespace {

class ExitStatus : public ProgramTest {
 protected:
  /// A box that slides on a floor. `simulation`: the rest of <simulation …>, `more`: what follows.
  void box(const std::string& simulation, const std::string& more = "") const {
    write("box.xml", R"(<dynamy version="1">
<parameter name="h" value="0.1"/>
<systems>
  <RigidBody name="box" position="0 0 {h}" velocity="1 0.2 0" angularVelocity="0 0 3">
    <Box size="0.3 0.2 0.2" mass="1" material="r"/>
  </RigidBody>
  <Ground><HalfSpace material="f"/></Ground>
</systems>
<forces><Gravity/></forces>
<elements><Contact between="r f"><UnilateralCoulomb mu="0.3" epsilonN="0"/></Contact></elements>
<simulation until="0.2" )" +
                         simulation + "</simulation>\n" + more + "</dynamy>\n");
  }
};

// The four corners of the box depend on each other through its mass: one sweep of Gauss-Seidel
// leaves the inclusion unsolved, and the run reaches its end.
constexpr const char* kPoorSolver =
    R"(step="1e-2"><MoreauMidpoint/><ProxGaussSeidel tolerance="1e-10" maxIterations="1"/>)";

TEST_F(ExitStatus, IsZeroForARunThatIsWhatItsModelAsksFor) {
  box(R"(step="1e-2">)");
  EXPECT_EQ(call("run box.xml --quiet --out r"), 0) << err();
  EXPECT_EQ(err(), "");
}

TEST_F(ExitStatus, IsThreeIfAnInclusionWasNotSolved) {
  box(kPoorSolver);
  EXPECT_EQ(call("run box.xml --quiet --out r"), 3) << err();
  EXPECT_NE(err().find("NOT SOLVED"), std::string::npos) << err();
  EXPECT_EQ(call("run box.xml --out r"), 3);
  EXPECT_NE(out().find("finished, but: unsolved   (exit status 3"), std::string::npos) << out();
  const std::string facts = readWholeFile(path("r/run.json"));
  EXPECT_NE(facts.find("\"kind\": \"unsolved\""), std::string::npos);
  EXPECT_NE(facts.find("\"qualifies\": true"), std::string::npos);
}

TEST_F(ExitStatus, IsZeroIfTheKindIsAccepted) {
  box(kPoorSolver);
  EXPECT_EQ(call("run box.xml --quiet --out r --accept"), 0);
  EXPECT_EQ(call("run box.xml --quiet --out r --accept=overlap,unsolved"), 0);
  EXPECT_EQ(call("run box.xml --quiet --out r --accept=overlap"), 3);
  EXPECT_EQ(call("run --accept box.xml --quiet --out r"), 0) << err();
  EXPECT_EQ(call("run box.xml --out r --accept=unsolve"), 64);
  EXPECT_NE(err().find("did you mean \"unsolved\""), std::string::npos) << err();
}

TEST_F(ExitStatus, OfAFailedCheckWinsOverWarnings) {
  box(kPoorSolver, R"(<check signal="box.z" value="5" tolerance="1"/>)");
  EXPECT_EQ(call("run box.xml --quiet --out r"), 1);
  EXPECT_EQ(call("run box.xml --quiet --out r --accept"), 1);
}

TEST_F(ExitStatus, IsPassedOnByResume) {
  box(kPoorSolver);
  EXPECT_EQ(call("run box.xml --quiet --out r"), 3);
  EXPECT_EQ(call("resume r --until 0.3 --quiet"), 3) << err();
  EXPECT_EQ(call("resume r --until 0.4 --quiet --accept"), 0) << err();
}

TEST_F(ExitStatus, IsPassedOnBySweep) {
  box(kPoorSolver);
  EXPECT_EQ(call("sweep box.xml --set h=0.1,0.1001 --out s --quiet"), 3) << err();
  EXPECT_EQ(call("sweep s --collect"), 3);
  EXPECT_NE(out().find("2 QUALIFIED by warnings"), std::string::npos) << out();
  EXPECT_EQ(call("sweep s --collect --accept=unsolved"), 0);
  EXPECT_NE(readWholeFile(path("s/results.csv")).find(",unsolved,"), std::string::npos);
}

/// A rod on a pin that starts with a velocity which the pin does not allow; `more`: other joints.
std::string rod(const std::string& more = "", const std::string& scheme = "") {
  return R"(<dynamy version="1"><systems><Ground name="world"/>
  <PlanarBody name="rod" position="0.5 0 0" mass="1" inertia="0.0833333333" velocity="0 0 1"/>
</systems><elements>
  <Revolute name="pin" between="world rod" at="0 0 0"/>)" +
         more + "</elements><simulation until=\"0.1\" step=\"1e-3\">" + scheme +
         "</simulation></dynamy>\n";
}

TEST_F(ExitStatus, AStartThatJointsDoNotAllowIsReportedAndRefusedByStrictAlone) {
  write("rod.xml", rod());
  EXPECT_EQ(call("check rod.xml"), 0);
  EXPECT_NE(out().find("note: start velocities: joint pin (rod.xml:4:"), std::string::npos)
      << out();
  EXPECT_EQ(call("check rod.xml --strict"), 2);
  EXPECT_EQ(call("run rod.xml --quiet --out r"), 0) << err();
  const std::string facts = readWholeFile(path("r/run.json"));
  // A note is no warning.
  const std::size_t warnings = facts.find("\"warnings\""), notes = facts.find("\"notes\"");
  ASSERT_NE(notes, std::string::npos);
  EXPECT_LT(warnings, notes);
  EXPECT_GT(facts.find("\"kind\": \"start velocities\""), notes);
  EXPECT_NE(facts.find("\"kind\": \"start velocities\""), std::string::npos);
  EXPECT_EQ(call("run rod.xml --quiet --out strict --strict"), 2);
  EXPECT_NE(err().find("start velocities: joint pin (rod.xml:4:"), std::string::npos) << err();
  EXPECT_FALSE(std::filesystem::exists(path("strict")));
}

TEST_F(ExitStatus, JointsThatContradictEachOtherAreToldByCheckAndRun) {
  write("rod.xml",
        rod(R"(<Distance name="strut" between="world rod" length="3"/>)", "<MoreauMidpoint/>"));
  EXPECT_EQ(call("check rod.xml"), 3);
  EXPECT_NE(out().find("warning: contradiction: no positions fulfil all joints"), std::string::npos)
      << out();
  EXPECT_EQ(call("run rod.xml --quiet --out r"), 3);
  EXPECT_NE(err().find("contradiction"), std::string::npos) << err();
}

/// A ball of 0.2 m at height z above a floor.
std::string ball(double z) {
  return R"(<dynamy version="1"><systems>
  <RigidBody name="ball" position="0 0 )" +
         std::to_string(z) + R"("><Sphere radius="0.1" mass="1" material="a"/></RigidBody>
  <Ground name="floor"><HalfSpace material="a"/></Ground></systems>
  <elements><Contact between="a a"><Unilateral/></Contact></elements>
  <simulation until="0.01" step="1e-3"/></dynamy>
)";
}

TEST_F(ExitStatus, BodiesInsideEachOtherFailTheCheckAndNotTheRun) {
  // A tenth of the diameter is 0.02 m: 0.019 m pass, 0.021 m do not.
  write("ball.xml", ball(0.081));
  EXPECT_EQ(call("check ball.xml"), 0) << out();
  EXPECT_NE(out().find("ball.xml: ok\n"), std::string::npos) << out();
  write("ball.xml", ball(0.079));
  EXPECT_EQ(call("check ball.xml"), 1) << out();
  EXPECT_NE(out().find("ball.xml: bodies start inside each other\n"), std::string::npos) << out();
  EXPECT_NE(out().find("penetration of 0.021 m, 0.105 of the size of the smaller body (0.2 m)"),
            std::string::npos)
      << out();
  EXPECT_EQ(call("check ball.xml --json"), 1);
  EXPECT_NE(out().find("\"ok\": false"), std::string::npos) << out();
  EXPECT_EQ(call("run ball.xml --quiet --out r --accept"), 0) << err();
  EXPECT_NE(readWholeFile(path("r/run.json")).find("\"kind\": \"start overlap\""),
            std::string::npos);
}

}  // namespace
}  // namespace dynamy
