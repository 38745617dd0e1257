/// Sixty errors that newcomers make, with the words of other programs and in the form of the file: each message names
/// the place, the cause and the remedy. The rows change a small model or call the program; a message has to begin
/// with the place and to hold the decisive words.
#include <gtest/gtest.h>

#include <program/typical_errors.hpp>

namespace dynamy {
namespace {

const std::vector<WrongModel> kWrongModels{
    // Words of other programs.
    {"  </elements>", "<Hinge between=\"floor block\"/></elements>", "12:1", "<Hinge>",
     "<Revolute>"},
    {"  </elements>", "<DistanceJoint between=\"floor block\"/></elements>", "12:1",
     "<DistanceJoint>", "<Distance>"},
    {"  </elements>", "<WeldJoint between=\"floor block\"/></elements>", "12:1", "<WeldJoint>",
     "<Fixed>"},
    {"  </elements>", "<joint type=\"hinge\"/></elements>", "12:1", "<joint>",
     "<Revolute>, <Prismatic>"},
    {"  </elements>", "<Revolute bodyA=\"floor\" bodyB=\"block\"/></elements>", "12:11",
     "\"bodyA\"", "between=\"A B\""},
    {"  </elements>", "<Revolute between=\"floor block\" axis=\"z\"/></elements>", "12:39", "axis",
     "\"0 0 1\""},
    {"  </elements>", "<Revolute between=\"floor block\" limits=\"0 1\"/></elements>", "12:33",
     "\"limits\"", "<JointStop"},
    {"  </elements>", "<Motor joint=\"h\"/></elements>", "12:1", "<Motor>", "<JointMotor>"},
    {"<Box size", "<Cuboid size", "6:7", "<Cuboid>", "<Box>"},
    {"<Box size=\"1 1 1\"", "<BoxCollider size=\"1 1 1\"", "6:7", "<BoxCollider>", "<Box>"},
    {"<Box size=\"1 1 1\"", "<geom type=\"box\"", "6:7", "<geom>", "<Box>, <Sphere>"},
    {"<HalfSpace name", "<Plane name", "4:26", "<Plane>", "<HalfSpace>"},
    {"size=\"1 1 1\"", "halfExtents=\"1 1 1\"", "6:12", "\"halfExtents\"",
     "size=\"…\", whole edges"},
    {"mass=\"2\"", "mass=\"2\" inertia=\"1 1 1\"", "6:34", "\"inertia\"",
     "<RigidBody mass=\"…\" inertia=\"…\">"},
    {"mass=\"2\"", "rho=\"7800\"", "6:25", "\"rho\"", "density="},
    {"mass=\"2\"", "mass=\"2\" color=\"red\"", "6:34", "\"color\"", "colour="},
    {"mass=\"2\"", "mass=\"2\" file=\"a.stl\"", "6:34", "\"file\"", "<Mesh file="},
    {"<RigidBody name=\"block\"", "<Body name=\"block\"", "5:5", "<Body>", "<RigidBody>"},
    {"position=\"0 0 0.5\"", "pos=\"0 0 0.5\"", "5:29", "\"pos\"", "position="},
    {"0.5\">", "0.5\" quaternion=\"1 0 0 0\">", "5:48", "\"quaternion\"", "orientation="},
    {"0.5\">", "0.5\" rpy=\"0 0 1\">", "5:48", "\"rpy\"", "euler="},
    {"0.5\">", "0.5\" euler=\"0 0 90\">", "5:59", "radians", "90deg"},
    {"0.5\">", "0.5\" vel=\"0 0 1\">", "5:48", "\"vel\"", "velocity="},
    {"epsilonN=", "restitution=", "11:55", "\"restitution\"", "epsilonN="},
    {"mu=\"{mu}\"", "friction=\"{mu}\"", "11:68", "\"friction\"", "mu="},
    {"epsilonN=\"0\"", "stiffness=\"1e6\"", "11:55", "\"stiffness\"", "rigid and need none"},
    {"<UnilateralCoulomb epsilonN=\"0\"", "<Coulomb", "11:36", "<Coulomb>", "<UnilateralCoulomb"},
    {"acceleration=\"0 0 -9.81\"", "g=\"9.81\"", "9:20", "\"g\"",
     "acceleration=\"…\", three numbers"},
    {"acceleration=\"0 0 -9.81\"", "value=\"0 0 -9.81\"", "9:20", "\"value\"", "acceleration="},
    {"</forces>", "<Spring between=\"floor block\" k=\"1\"/></forces>", "9:46", "<Spring>",
     "<SpringDamper>"},
    {"step=\"1e-3\"", "timestep=\"1e-3\"", "13:27", "\"timestep\"", "step="},
    {"until=\"0.1\"", "duration=\"0.1\"", "13:15", "\"duration\"", "until="},
    {"step=\"1e-3\"/>", "step=\"1e-3\"><RungeKutta4/></simulation>", "13:39", "<RungeKutta4>",
     "<LocatedDormandPrince>"},
    {"<record ", "<output ", "14:3", "<output>", "<record>"},
    {"<systems>\n", "<worldbody/><systems>\n", "3:3", "<worldbody>",
     "<Ground>; put it into <systems>"},
    {"<dynamy version=\"1\">", "<robot name=\"x\"/><!--", "1:1", "URDF", "dynamy import FILE"},
    // Numbers and units.
    {"size=\"1 1 1\"", "size=\"1m x 1m x 1m\"", "6:21", "\"x\"", "\"1m 1m 1m\""},
    {"size=\"1 1 1\"", "size=\"1/1/1\"", "6:19", "\"/\"", "\"1 1 1\""},
    {"size=\"1 1 1\"", "size=\"1 1\"", "6:18", "3 numbers, has 2", "along x, y, z [m]"},
    {"mass=\"2\"", "mass=\"2 kg\"", "6:33", "blank before the unit", "\"2kg\""},
    {"mass=\"2\"", "mass=\"2,5\"", "6:32", "\",\"", "\"2.5\""},
    {"mass=\"2\"", "mass=\"2e3,5\"", "6:34", "\",\"", "\"2.5e3\""},
    {"mass=\"2\"", "mass=\"2 000\"", "6:31", "1 number, has 2", "\"2000\""},
    {"every=\"10ms\"", "every=\"10msec\"", "14:38", "\"msec\"", "\"10ms\""},
    {"every=\"10ms\"", "every=\"10kg\"", "14:36", "[kg]", "a time [s]"},
    // Form.
    {"<Box size", "<box size", "6:7", "<box>", "<Box>"},
    {"<Box size", "< Box size", "6:7", "\"<\"", "<Box"},
    {"    </RigidBody>\n", "", "7:3", "</systems>", "expected </RigidBody>"},
    {"mass=\"2\"", "mass=2", "6:30", "not in quotes", "mass=\"2\""},
    {"mu=\"{mu}\"", "mu=\"{muh}\"", "11:73", "\"muh\"", "\"mu\""},
    {"</forces>", "<ForceInput on=\"block\" force=\"sin(w*t); 0; 0\"/></forces>", "9:80", "\"w\"",
     "<parameter name=\"w\""},
    {"</forces>", "<ForceInput on=\"block\" force=\"sin(t), 0, 0\"/></forces>", "9:76",
     "3 formulas", "\"sin(t); 0; 0\""},
    {"<systems>", "<defaults mu=\"0.3\"/><systems>", "3:13", "unknown attribute \"mu\"", ""},
    {"between=\"steel steel\"", "between=\"steel,steel\"", "11:28", "\",\"", "\"steel steel\""},
    {"between=\"steel steel\"", "between=\"stel steel\"", "4:26", "\"stel\"",
     "did you mean \"steel\"?"},
    {"</systems>", "<Woodpecker name=\"toy\"/></systems>", "8:3", "\"woodpecker\" is not loaded",
     "<plugin library="},
    {"<systems>\n", "<plugin name=\"woodpecker\"/><systems>\n", "3:11", "\"name\"", "library="},
    {"<systems>\n", "<include file=\"parts.xml\"/><systems>\n", "3:18", "there is no such file",
     "relative to"},
    {"block.z", "block.z,block.x", "14:20", "\"block.z,block.x\"", "\"block.z block.x\""},
    {"<RigidBody name=\"block\"", "<RigidBody", "14:20", "\"block.z\"", "name=\"block\""},
};

using TypicalErrors = TypicalErrorsTest;

TEST_F(TypicalErrors, OfModelsNamePlaceCauseAndRemedy) { expectRefused(kWrongModels); }

TEST_F(TypicalErrors, OfCallsNameCauseAndRemedy) {
  write("m.xml", kTypicalModel);
  write("deep.xml", std::string(kTypicalModel).replace(kTypicalModel.find("0.5\">"), 3, "0.2"));
  write("data.csv", "time,x\n");
  write("picture.png", std::string("\x89PNG\r\n\x1a\n\0\0", 10));
  std::filesystem::create_directory(folder_ / "folder");
  write("folder/model.xml", kTypicalModel);
  expectRefused(std::vector<WrongCall>{
      {"runn m.xml", 64, "\"runn\"", "\"run\""},
      {"m.xml", 64, "no command \"m.xml\"", "dynamy run m.xml"},
      {"simulate m.xml", 64, "\"simulate\"", "\"run\""},
      {"run", 64, "needs MODEL", "XML file"},
      {"run m", 2, "m: error: there is no such file", "\"m.xml\""},
      {"run folder", 2, "folder: error: this is a folder", "folder/model.xml"},
      {"run data.csv", 2, "data.csv:1:1", "<dynamy version=\"1\">"},
      {"run picture.png", 2, "the file is a picture (PNG)", "a text file is needed"},
      {"run m.xml --until", 64, "--until needs a value, TIME", "end time"},
      {"run m.xml --until '5 s'", 64, "blank before the unit", "\"5s\""},
      {"run m.xml --dt 1e-3", 64, "\"--dt\"", "\"--step\""},
      {"run m.xml --duration 5", 64, "\"--duration\"", "\"--until\""},
      {"run m.xml -o r", 64, "\"-o\"", "\"--out\""},
      {"eigen m.xml --until 3", 64, "\"--until\"", "known: \"--set\""},
      {"run m.xml mu=0.3", 64, "\"mu=0.3\"", "--set mu=0.3"},
      {"run m.xml --set mu:0.3", 64, "\"mu:0.3\"", "mu=0.3"},
      {"run m.xml --set mu=0.3 --set mu=0.4", 64, "\"mu\" has a value already by --set mu=0.3",
       "leave one of them out"},
      {"run m.xml --step 1ms --tolerance 1e-6", 64, "--tolerance", "--step"},
      {"run m.xml --set muu=0.3", 2, "\"muu\"", "\"mu\""},
      {"compare m.xml --integrators 'EnergyMomentum MoreauMidpoint'", 2, "two schemes",
       "EnergyMomentum,MoreauMidpoint"},
      {"view m.xml", 2, "is a model", "dynamy run m.xml"},
      {"view none", 2, "there is no such folder", "dynamy run MODEL"},
      {"describe hing", 2, "\"hing\"", "<Revolute>"},
      {"check deep.xml", 1, "begins with a penetration of 0.3 m", "move one of the two"},
  });
}

TEST_F(TypicalErrors, HelpIsAWordOfOtherProgramsThatIsUnderstood) {
  const auto printed = [&](const std::string& words) {
    EXPECT_EQ(call(words), 0) << words;
    return out();
  };
  EXPECT_EQ(printed("help"), printed("--help"));
  EXPECT_EQ(printed("help run"), printed("run --help"));
  EXPECT_EQ(printed("version"), printed("--version"));
}

}  // namespace
}  // namespace dynamy
