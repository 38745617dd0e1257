/// Sixty more errors: values that cannot be, joints that hold nothing together, formulas and numbers
/// in the writing of other programs, files that are no models, options of other commands.
#include <gtest/gtest.h>

#include <program/typical_errors.hpp>

namespace dynamy {
namespace {

const std::vector<WrongModel> kImpossibleValues{
    {"mass=\"2\"", "mass=\"-2\"", "6:31", "mass must be >= 0", "is -2"},
    {"mass=\"2\"", "mass=\"nan\"", "6:31", "must be a number", "nan"},
    {"size=\"1 1 1\"", "size=\"1 1 0\"", "6:22", "size must be > 0", "is 0"},
    {"normal=\"0 0 1\"", "normal=\"0 0 0\"", "4:58", "normal", "must not be zero"},
    {"min=\"0\"", "min=\"1\" max=\"0\"", "2:41", "min lies above max", "exchange the two"},
    {"value=\"0.3\" min=\"0\"/>", "value=\"{nu}\"/><parameter name=\"nu\" value=\"{mu}\"/>", "2:66",
     "depends on itself", "mu → nu → mu"},
    {"step=\"1e-3\"", "tolerance=\"1e-30\"", "13:3", "below the rounding of numbers",
     "1e-12 or more"},
    {"step=\"1e-3\"", "tolerance=\"2\"", "13:3", "errors may be as large as the scene",
     "1e-3 or less"},
    {"until=\"0.1\"", "until=\"1e18\"", "13:3", "does not move t", "take a step of"},
    {"every=\"10ms\"", "at=\"0.05 5\"", "14:33", "wants a row at 5 s", "ends at 0.1 s"},
    {"<Box size=\"1 1 1\" mass=\"2\" material=\"steel\"/>",
     "<Circle radius=\"1\" density=\"2500\"/>", "6:7", "<Circle>: has no volume", "<Cylinder>"},
    {"<UnilateralCoulomb epsilonN=\"0\" mu=\"{mu}\"/>", "<GivenFriction force=\"{mu}\"/>", "11:36",
     "has no normal force", "<UnilateralStribeck>"},
    {"<RigidBody name=\"block\"", "<RigidBody name=\"floor\"", "5:22", "is used already",
     "first used here"},
};

const std::vector<WrongModel> kJointsAndForces{
    {"</elements>", "<Revolute between=\"floor block\" axis=\"0 0 0\"/></elements>", "12:3",
     "needs an axis", "axis=\"0 1 0\""},
    {"</elements>", "<Fixed between=\"block\"/></elements>", "12:19", "here are 1",
     "<Ground> and a body"},
    {"</elements>", "<Fixed between=\"floor floor\"/></elements>", "12:3", "names \"floor\" twice",
     "name two bodies"},
    {"</elements>", "<Fixed between=\"floor block.tip\"/></elements>", "12:3",
     "<Fixed>: no frame named \"block.tip\"", "add <Frame name=\"tip\"/> inside of \"block\""},
    {"</elements>",
     "<JointStop between=\"floor block\" axis=\"0 0 1\" lower=\"1\" upper=\"0\"/></elements>",
     "12:3", "lies above the upper one", "exchange lower and upper"},
    {"</elements>",
     "<JointDrive between=\"floor block\" axis=\"0 0 1\" motion=\"sqrt(-1-t)\"/></elements>",
     "12:3", "no finite value at t = 0", "correct the formula of motion"},
    {"</elements>", "<Distance between=\"p[{i}] block\"/></elements>", "12:25",
     "unknown symbol \"i\"", "<parameter name=\"i\""},
    {"</forces>", "<ForceInput on=\"floor\" force=\"1; 0; 0\"/></forces>", "9:46",
     "no effect on \"floor\"", "a body with velocities"},
    {"</forces>", "<ForceInput on=\"block\" force=\"0; 0; log(t - 1)\"/></forces>", "9:46",
     "<ForceInput>", "no finite value at the start"},
    {"</forces>", "<ForceInput on=\"block\" force=\"\"/></forces>", "9:76", "here are 0",
     "\"0; 0; 0\""},
    {"</forces>", "<Table name=\"a\" of=\"t\" file=\"none.csv\"/></forces>", "9:75",
     "there is no such file", "relative to the model"},
    {"</forces>", "<Pid name=\"a\" error=\"t\" period=\"1ms\" lower=\"2\" upper=\"1\"/></forces>",
     "9:46", "above the upper one", "exchange"},
};

const std::vector<WrongModel> kOtherWriting{
    {"</forces>", "<ForceInput on=\"block\" force=\"2t; 0; 0\"/></forces>", "9:76",
     "has the unit \"t\", which is also a name here", "2*t"},
    {"size=\"1 1 1\"", "size=\"{2mu} 1 1\"", "6:20", "unknown unit \"mu\"", "2*mu"},
    {"</forces>", "<ForceInput on=\"block\" force=\"if(t &gt; 1, 1, 0); 0; 0\"/></forces>", "9:76",
     "unknown function \"if\"", "condition ? a : b"},
    {"</forces>", "<ForceInput on=\"block\" force=\"ln(1 + t); 0; 0\"/></forces>", "9:76", "\"ln\"",
     "\"log\""},
    {"mass=\"2\"", "mass=\"${mu}\"", "6:31", "\"$\"", "in braces, without \"$\""},
    {"mass=\"2\"", "mass=\"$mu\"", "6:31", "\"$\"", "{mu}"},
    {"mass=\"2\"", "mass=\"2\u00A0kg\"", "6:32", "no-break space", "write \"2kg\""},
    {"size=\"1 1 1\"", "size=“1 1 1”", "6:17", "typographic quotes", "write size=\"1 1 1\""},
    {"mass=\"2\"", "mass=\"1/3\"", "6:32", "\"/\"", "{1/3}"},
    {"0.5\">", "0.5\" euler=\"0 0 90\">", "5:59", "radians", "90deg"},
    {"<simulation", "<Simulation", "13:3", "<Simulation>", "<simulation>"},
    {"<systems>", "<systems><Box size=\"1 1 1\"/>", "3:12", "<Box> is a shape",
     "inside of <Grains>, <Ground>, <PlanarBody>, <PointMass>, <RigidBody>"},
};

class MoreTypicalErrors : public TypicalErrorsTest {
 protected:
  void SetUp() override {
    TypicalErrorsTest::SetUp();
    write("m.xml", kTypicalModel);
    write("drop.csv", "t,block.z\n0,0.5\n0.05,0.5\n");
  }
};

TEST_F(MoreTypicalErrors, OfValuesThatCannotBe) { expectRefused(kImpossibleValues); }

TEST_F(MoreTypicalErrors, OfJointsAndForces) { expectRefused(kJointsAndForces); }

TEST_F(MoreTypicalErrors, InTheWritingOfOtherPrograms) { expectRefused(kOtherWriting); }

TEST_F(MoreTypicalErrors, OfFilesThatAreNoModels) {
  write("zipped.xml", "\x1F\x8B\x08 and so on");
  write("table.csv", "PK\x03\x04 a sheet");
  write("page.xml", "<!DOCTYPE html>\n<html></html>\n");
  write("empty.xml", "");
  write("numbers.csv", "0,0.5\n0.05,0.5\n");
  write("units.csv", "t,block.z (mm)\n0,500\n");
  write("bytes.csv", std::string("t,block.z\n0,\x80\n"));
  write("machine.urdf", "<robot name=\"x\" xmlns:xacro=\"u\"><xacro:property name=\"w\"/></robot>");
  write("scene.xml", "<mujoco>\n <include file=\"none.xml\"/>\n <worldbody/>\n</mujoco>");
  std::filesystem::create_directory(folder_ / "folder");
  expectRefused(std::vector<WrongCall>{
      {"check zipped.xml", 2, "compressed by gzip", "gunzip"},
      {"check page.xml", 2, "page.xml:1:1", "a page of HTML"},
      {"check empty.xml", 2, "empty.xml", "the file is empty"},
      {"check scene.xml", 2, "MJCF", "dynamy import FILE"},
      {"import machine.urdf", 2, "machine.urdf:1:33", "xacro FILE > machine.urdf"},
      {"import scene.xml", 2, "scene.xml:2:2", "there is no such file"},
      {"fit m.xml table.csv --parameters mu", 2, "a ZIP archive", "as CSV"},
      {"fit m.xml numbers.csv --parameters mu", 2, "numbers.csv:1:1", "the head is missing"},
      {"fit m.xml units.csv --parameters mu", 2, "units.csv:1:3", "\"block.z [mm]\""},
      {"fit m.xml bytes.csv --parameters mu", 2, "bytes.csv", "CSV file in UTF-8"},
      {"fit m.xml folder --parameters mu", 2, "folder", "a file is needed"},
  });
}

TEST_F(MoreTypicalErrors, OfOptions) {
  expectRefused(std::vector<WrongCall>{
      {"check m.xml --until 5", 64, "dynamy check has no option \"--until\"", "belongs to: run"},
      {"check m.xml --out r", 64, "no option \"--out\"", "belongs to: run"},
      {"run m.xml --jobs 4", 64, "no option \"--jobs\"", "belongs to: sweep"},
      {"--set mu=1", 64, "a command is missing", "belongs to: run"},
      {"run m.xml until=5", 64, "\"until=5\"", "--until 5"},
      {"run m.xml -q", 64, "\"-q\"", "did you mean \"--quiet\"?"},
      {"run m.xml --until soon", 64, "\"soon\"", "5ms"},
      {"run m.xml --threads two", 64, "--threads", "a whole number, 1 to 64"},
      {"run m.xml --integrator RK4", 2, "\"RK4\"", "<LocatedDormandPrince>"},
      {"run m.xml --solver MoreauMidpoint", 2, "no solver", "of the kind scheme"},
      {"sweep m.xml --set 'mu=gauss(0,1)'", 64, "mu=gauss(0,1)", "normal(MEAN,DEVIATION)"},
      {"sweep m.xml --set mu=0.1,0.2 --measure block.q", 2, "--measure block.q", "did you mean"},
      {"equilibrium m.xml --range mu=1", 64, "\"mu=1\"", "mu=A:B"},
      {"export fmu", 64, "dynamy export fmu needs MODEL", "XML file"},
      {"watch m.xml", 64, "no command \"watch\"", "run --watch"},
      {"import m.xml --package none", 64, "none", "there is no such folder"},
      {"view r --video x.webm --look vew=side", 64, "the page has no \"vew\"", "view"},
      {"view r --video x.webm --look view=side", 64, "\"side\"", "iso"},
      {"sweep m.xml mu=0:0.1:1", 64, "\"mu=0:0.1:1\" is a word too many", "--set mu=0:0.1:1"},
      {"run m.xml --set epsilonN=0.5", 2, "no parameter \"epsilonN\"",
       "it is a number of <UnilateralCoulomb> (m.xml:11:"},
      {"gradient m.xml --of block.z --by epsilonN", 2, "velocity \"epsilonN\"",
       "write <parameter name=\"epsilonN\" value=\"0\"/>"},
  });
}

/// Calls of the first hour.
TEST_F(MoreTypicalErrors, OfFirstCalls) {
  expectRefused(std::vector<WrongCall>{
      {"m.xml", 64, "no command \"m.xml\"", "dynamy run m.xml"},
      {"runn m.xml", 64, "no command \"runn\"", "\"run\""},
      {"run", 64, "needs MODEL", "XML file"},
      {"run none.xml", 2, "none.xml", "its folder has \"m.xml\""},
      {"run gone/m.xml", 2, "there is no such file", "no folder gone"},
      {"run m.xml n.xml", 64, "\"n.xml\" is a word too many", "dynamy run MODEL"},
      {"run m.xml --unitl 2", 64, "\"--unitl\"", "\"--until\""},
      {"run m.xml --Until 2", 64, "\"--Until\"", "\"--until\""},
      {"run m.xml --until=2 sec", 64, "\"sec\" is a word too many", "without a blank: 5s"},
      {"run m.xml --step 1mm", 64, "expects a time [s]", "has [m]"},
      {"run m.xml --set mu", 64, "\"mu\"", "such as mu=0.3"},
      {"run m.xml --set mue=2", 2, "no parameter \"mue\"", "\"mu\""},
      {"run m.xml -o results", 64, "\"-o\"", "\"--out\""},
      {"run m.xml --gui", 64, "\"--gui\"", "--live"},
      {"run m.xml --plot", 64, "\"--plot\"", "signals.svg"},
      {"run m.xml --verbose", 64, "\"--verbose\"", "--json"},
      {"run m.xml --solver PGS", 2, "no solver named \"PGS\"", "<ProxGaussSeidel>"},
      {"view m.xml", 2, "m.xml: is a model", "dynamy run m.xml"},
      {"sweep m.xml --set mu=0.1:0.5", 64, "\"mu=0.1:0.5\"", "FROM:TO:COUNT"},
      {"export m.xml", 64, "\"export m.xml\"", "\"fmu\""},
  });
}

TEST_F(MoreTypicalErrors, AFormulaThatEndsDuringARunIsNamed) {
  std::string model = kTypicalModel;
  model.replace(model.find("</forces>"), 9,
                "<ForceInput on=\"block\" force=\"0; 0; sqrt(0.05 - t)\"/></forces>");
  write("m.xml", model);
  EXPECT_EQ(call("run m.xml --out r"), 1);
  EXPECT_NE(err().find("the force of <ForceInput> (m.xml:9:46) has no finite value"),
            std::string::npos)
      << err();
}

TEST_F(MoreTypicalErrors, WhatHasNoEffectIsNoted) {
  std::string model = kTypicalModel;
  model.replace(model.find(" material=\"steel\""), 17, "");
  model.replace(model.find("<forces>"), 8, "<forces><Gravity/>");
  model.replace(model.find("1e-3"), 4, "10");
  write("m.xml", model);
  for (const char* command : {"check m.xml", "run m.xml --out r"}) {
    EXPECT_EQ(call(command), 0);
    EXPECT_NE(out().find("note: <Contact> (m.xml:11) never acts"), std::string::npos) << out();
    EXPECT_NE(out().find("note: 2 <Gravity> (m.xml:9, m.xml:9) act together"), std::string::npos);
    EXPECT_NE(out().find("note: the step, 10 s, is longer than the run"), std::string::npos);
  }
}

TEST_F(MoreTypicalErrors, ARuleThatNamesBodiesIsNoted) {
  std::string model = kTypicalModel;
  model.replace(model.find("</elements>"), 11,
                "<Contact between=\"block floor\"><Unilateral/></Contact></elements>");
  write("m.xml", model);
  EXPECT_EQ(call("check m.xml"), 0) << err();
  EXPECT_NE(out().find("never acts: \"block\" is a system; between=\"…\" names the materials"),
            std::string::npos)
      << out();
}

/// What is no error may all the same be otherwise than it is meant.
TEST_F(MoreTypicalErrors, WhatMayBeMeantOtherwiseIsNoted) {
  const auto noteOf = [&](const std::string& from, const std::string& to,
                          const std::string& ground = "<Ground ") {
    std::string model = kTypicalModel;
    model.replace(model.find(from), from.size(), to);
    model.replace(model.find("<Ground "), 8, ground);
    write("m.xml", model);
    EXPECT_EQ(call("check m.xml"), 0) << err();
    const std::size_t at = out().find(" note: ");
    return at == std::string::npos ? std::string() : out().substr(at);
  };
  EXPECT_EQ(noteOf("2\"", "2\""), "");
  const auto expectNote = [](const std::string& note, const std::string& text) {
    EXPECT_NE(note.find(text), std::string::npos) << note;
  };
  expectNote(noteOf("mu=\"{mu}\"", "mu=\"0.3\""),
             "note: the parameter \"mu\" (m.xml:2) is not used: a value refers to it by {mu}");
  expectNote(noteOf("position=\"0 0 0.5\"", "position=\"0 0 0.5\" orientation=\"0 0 0 1\""),
             "note: orientation=\"0 0 0 1\" (m.xml:5) turns by 180° about z");
  expectNote(noteOf("position=\"0 0 0.5\"", "position=\"0 0 0.5\" orientation=\" 0 0 0\t1 \""),
             "(m.xml:5) turns by 180° about z");
  expectNote(noteOf("0 0 -9.81", "0 0 9.81"),
             "note: <Gravity> (m.xml:9) pulls bodies away from <HalfSpace> (m.xml:4)");
  expectNote(noteOf("until=\"0.1\" ", ""), "note: <simulation> (m.xml:13) says no end");
  expectNote(noteOf("<Gravity acceleration=\"0 0 -9.81\"/>", ""), "note: nothing moves");
  EXPECT_EQ(
      noteOf("<Gravity acceleration=\"0 0 -9.81\"/>", "", "<Ground motion=\"0; 0; 0.1*sin(t)\" "),
      "");
  expectNote(
      noteOf("</elements>", "<Contact between=\"steel ice\"><Unilateral/></Contact></elements>"),
      "never acts: no shape has the material \"ice\"");
  expectNote(noteOf("</elements>",
                    "<JointMotor between=\"block floor\" axis=\"0 1 0\" speed=\"1\" "
                    "limit=\"2\"/></elements>"),
             "note: <JointMotor> (m.xml:12) acts between \"block\" and \"floor\", which no joint "
             "connects");
  expectNote(noteOf("10ms", "2s"),
             "note: a row is recorded every 2 s, and the run ends at t = 0.1 s");
}

TEST_F(MoreTypicalErrors, BodiesThatTouchNothingAreNoted) {
  const auto model = [](const std::string& material, const std::string& more) {
    const std::string m = material.empty() ? "" : " material=\"" + material + "\"";
    return "<dynamy version=\"1\"><systems><Ground><HalfSpace" + m +
           "/></Ground><RigidBody name=\"one\" position=\"0 0 1\"><Sphere radius=\"0.1\" "
           "mass=\"1\"" +
           m + "/></RigidBody><RigidBody name=\"two\" position=\"0 0 2\"><Sphere radius=\"0.1\" " +
           "mass=\"1\"/></RigidBody></systems><forces><Gravity/></forces>" + more +
           "<simulation until=\"0.1\" tolerance=\"1e-6\"/></dynamy>";
  };
  write("bare.xml", model("", ""));
  EXPECT_EQ(call("check bare.xml"), 0) << err();
  EXPECT_NE(out().find("note: no shape has a material: bodies pass through each other"),
            std::string::npos)
      << out();
  write("one.xml",
        model("m", "<elements><Contact between=\"m m\"><Unilateral/></Contact></elements>"));
  EXPECT_EQ(call("check one.xml"), 0) << err();
  EXPECT_NE(out().find("note: \"two\" touches nothing: the shapes have no material"),
            std::string::npos)
      << out();
}

TEST_F(MoreTypicalErrors, JointsOfCopiesAreSeenBesideTheirStops) {
  write(
      "chain.xml",
      "<dynamy version=\"1\"><systems><Ground name=\"world\"/><replicate count=\"3\" index=\"i\">"
      "<RigidBody name=\"link\" position=\"{0.5+i} 0 0\" mass=\"1\" inertia=\"1 1 1\"/></replicate>"
      "</systems><forces><Gravity/><JointSpring between=\"world link[0]\" axis=\"0 1 0\" "
      "stiffness=\"5\"/></forces><elements><Revolute between=\"world link[0]\" at=\"0 0 0\" "
      "axis=\"0 1 0\"/><replicate count=\"2\" index=\"i\"><Revolute between=\"link link[{i+1}]\" "
      "at=\"{i+1} 0 0\" axis=\"0 1 0\"/><JointStop between=\"link link[{i+1}]\" at=\"{i+1} 0 0\" "
      "axis=\"0 1 0\" lower=\"-0.5\" upper=\"0.5\"/></replicate></elements>"
      "<simulation until=\"0.1\" tolerance=\"1e-6\"/></dynamy>");
  EXPECT_EQ(call("check chain.xml"), 0) << err();
  EXPECT_EQ(out().find(" note: "), std::string::npos) << out();
}

TEST_F(MoreTypicalErrors, ValuesOfOneRunAreToldFromThoseOfASweep) {
  write("m.xml", kTypicalModel);
  EXPECT_NE(call("run m.xml --set mu=0.3,0.4 --out r"), 0);
  EXPECT_NE(
      err().find("one value is needed, with a point before decimals — dynamy sweep runs a model "
                 "with many: --set NAME=A,B,C or --set NAME=FROM:TO:COUNT"),
      std::string::npos)
      << err();
  EXPECT_NE(call("run m.xml --set block.mass=3 --out r"), 0);
  EXPECT_NE(err().find("to vary it write <parameter name=\"mass\""), std::string::npos) << err();
}

}  // namespace
}  // namespace dynamy
