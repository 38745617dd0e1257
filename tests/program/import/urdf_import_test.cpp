/// dynamy import of URDF: models that check, with values derived by hand.
#include <program/import/import_fixture.hpp>

namespace dynamy {
namespace {

std::string link(const std::string& name, const std::string& inertial,
                 const std::string& rest = "") {
  return "<link name=\"" + name + "\"><inertial>" + inertial + "</inertial>" + rest + "</link>\n";
}

/// A bar of 2 kg, 1 m long, below its hinge: J = m l²/12 = 1/6 about the centre.
const std::string kBar =
    "<origin xyz=\"0 0 -0.5\"/><mass value=\"2\"/>"
    "<inertia ixx=\"0.16666666666666666\" iyy=\"0.16666666666666666\" izz=\"0.001\"/>";

std::string joint(const std::string& type, const std::string& rest) {
  return "<joint name=\"hinge\" type=\"" + type +
         "\"><parent link=\"base\"/><child link=\"bar\"/><origin xyz=\"0 0 2\"/>"
         "<axis xyz=\"0 1 0\"/>" +
         rest + "</joint>\n";
}

std::string pendulum(const std::string& type, const std::string& rest, const std::string& on = "") {
  return "<robot name=\"pendulum\"><link name=\"base\"/>" + link("bar", kBar, on) +
         joint(type, rest) + "</robot>\n";
}

using UrdfImport = ImportTest;

TEST_F(UrdfImport, PlacesABodyAtItsCentreOfMass) {
  ASSERT_EQ(import("p.urdf", pendulum("continuous", "")), 0) << notes_;
  expectChecks();
  EXPECT_EQ(line("<RigidBody"),
            "    <RigidBody name=\"bar\" position=\"0 0 1.5\" mass=\"2\" "
            "inertia=\"0.166666666666667 0.166666666666667 0.001 0 0 0\">");
  EXPECT_EQ(line("<Revolute"),
            "    <Revolute name=\"hinge\" between=\"base bar\" at=\"0 0 2\" axis=\"0 1 0\"/>");
  EXPECT_NE(line("<Ground name=\"base\""), "");
}

TEST_F(UrdfImport, TurnsInertiasIntoAxesOfTheLink) {
  // A quarter turn about z exchanges Jxx and Jyy, and Jxy changes its sign.
  ASSERT_EQ(import("p.urdf",
                   "<robot name=\"r\">" +
                       link("brick",
                            "<origin rpy=\"0 0 1.5707963267948966\"/><mass value=\"3\"/>"
                            "<inertia ixx=\"1\" iyy=\"2\" izz=\"2.5\" ixy=\"0.25\"/>") +
                       "</robot>",
                   "--free-base"),
            0);
  expectChecks();
  EXPECT_NE(line("<RigidBody").find("inertia=\"2 1 2.5 -0.25 0 0\""), std::string::npos)
      << line("<RigidBody");
}

TEST_F(UrdfImport, MovesWithDampingFrictionAndArmature) {
  // From rest at 1 rad without weight: none. With weight, J = 1/6 + 2/4 about the hinge, a rotor of
  // 1/3 and no friction the small motion has omega² = m g l/2 / (J + a) = 9.81.
  ASSERT_EQ(import("p.urdf", pendulum("continuous", "<dynamics armature=\"0.3333333333333333\"/>"),
                   "--at hinge=1e-4"),
            0);
  expectChecks();
  const double half = 3.14159265358979 / std::sqrt(9.81);  // half a period
  // The angle counts as in the file: from 1e-4 to −1e-4. Its relative error is φ²/16 and that of
  // the run's tolerance, 1e-6 of the start.
  EXPECT_NEAR(atEnd("hinge.angle", "--until " + std::to_string(half) + " --tolerance 1e-9"), -1e-4,
              1e-8);
  ASSERT_EQ(
      import("p.urdf", pendulum("continuous", "<dynamics damping=\"0.3\" friction=\"0.2\"/>")), 0);
  EXPECT_NE(line("<JointSpring").find("stiffness=\"0\" damping=\"0.3\""), std::string::npos);
  EXPECT_NE(line("<Revolute").find("<GivenFriction force=\"0.2\"/>"), std::string::npos);
  expectChecks();
}

TEST_F(UrdfImport, MakesLimitsOneSidedAndStartsInsideOfThem) {
  ASSERT_EQ(
      import("p.urdf", pendulum("revolute", "<limit lower=\"0.5\" upper=\"1.5\" effort=\"1\"/>")),
      0);
  expectChecks();
  EXPECT_NE(line("<JointStop").find("start=\"1\" lower=\"0.5\" upper=\"1.5\""), std::string::npos);
  // One radian about y moves the centre 0.5 m below the hinge to x = −0.5 sin 1.
  EXPECT_NE(line("<RigidBody").find("position=\"-0.420735492403948 0 1.72984884706593\""),
            std::string::npos)
      << line("<RigidBody");
  EXPECT_NE(notes_.find("p.urdf:2:148: <limit>: attribute effort: limits a drive"),
            std::string::npos)
      << notes_;
  EXPECT_NE(notes_.find("its limits exclude 0: it starts at 1"), std::string::npos) << notes_;
}

TEST_F(UrdfImport, TakesAStartWithinTheLimitsOnly) {
  const std::string robot = pendulum("revolute", "<limit lower=\"0.5\" upper=\"1.5\"/>");
  ASSERT_EQ(import("p.urdf", robot, "--at hinge=1.25"), 0);
  EXPECT_EQ(notes_, "");  // that its limits exclude 0 needs no word any more
  EXPECT_NEAR(atEnd("hinge.angle", "--until 1e-6"), 1.25, 1e-9);  // g/l t²/2
  EXPECT_EQ(import("p.urdf", robot, "--at hinge=2"), 64);
  EXPECT_NE(notes_.find("--at hinge=2: beyond the limits of the joint, 0.5 to 1.5 rad"),
            std::string::npos)
      << notes_;
}

TEST_F(UrdfImport, GivesJointsDrivesWhereTheyAreWanted) {
  const std::string robot = pendulum("continuous", "<limit effort=\"3\"/>");
  ASSERT_EQ(import("p.urdf", robot, "--drives"), 0);
  EXPECT_EQ(notes_, "");
  expectChecks();
  EXPECT_NE(line("<Input").find("name=\"hinge_drive\""), std::string::npos);
  EXPECT_NE(line("<JointForce").find("clamp(1*{hinge_drive.out}, -3, 3)"), std::string::npos);
  ASSERT_EQ(import("p.urdf", robot), 0);
  EXPECT_EQ(line("<Input"), "");
  EXPECT_NE(notes_.find("say --drives"), std::string::npos) << notes_;
}

TEST_F(UrdfImport, DrawsShapesOfContactInTheColourOfThePicture) {
  const std::string box = "<geometry><box size=\"1 1 1\"/></geometry>";
  ASSERT_EQ(
      import("p.urdf", pendulum("continuous", "",
                                "<visual>" + box +
                                    "<material name=\"m\"><color rgba=\"1 0 0 1\"/></material>"
                                    "</visual><collision>" +
                                    box + "</collision>")),
      0);
  EXPECT_NE(line("<Box").find("colour=\"#ff0000\""), std::string::npos) << line("<Box");
}

TEST_F(UrdfImport, JoinsLinksWithoutMassAsFrames) {
  const std::string tool =
      "<link name=\"tool\"/><joint name=\"flange\" type=\"fixed\"><parent link=\"bar\"/>"
      "<child link=\"tool\"/><origin xyz=\"0 0 -1\"/></joint>";
  std::string robot = pendulum("continuous", "");
  robot.insert(robot.find("</robot>"), tool);
  ASSERT_EQ(import("p.urdf", robot), 0);
  expectChecks();
  EXPECT_EQ(line("name=\"tool\""), "      <Frame name=\"tool\" position=\"0 0 -0.5\"/>");
  EXPECT_NE(notes_.find("link tool: has no mass: is a part of \"bar\""), std::string::npos);
}

TEST_F(UrdfImport, RenamesWhatAModelCannotNameAndSaysSo) {
  std::string robot = pendulum("continuous", "");
  for (std::size_t at; (at = robot.find("\"bar\"")) != std::string::npos;)
    robot.replace(at, 5, "\"the bar.1\"");
  ASSERT_EQ(import("p.urdf", robot), 0);
  expectChecks();
  EXPECT_NE(line("<RigidBody name=\"the_bar_1\""), "");
  EXPECT_NE(notes_.find("link the bar.1: is named \"the_bar_1\" in the model"), std::string::npos);
}

TEST_F(UrdfImport, KeepsShapesMaterialsAndColours) {
  ASSERT_EQ(
      import("p.urdf", pendulum("continuous", "",
                                "<collision><origin xyz=\"0 0 -0.5\"/><geometry>"
                                "<cylinder radius=\"0.1\" length=\"1\"/></geometry></collision>")),
      0);
  expectChecks();
  EXPECT_EQ(line("<Cylinder"), "      <Cylinder radius=\"0.1\" length=\"1\" material=\"bar\"/>");
  ASSERT_EQ(
      import("p.urdf", pendulum("continuous", "",
                                "<visual><geometry><box size=\"1 2 3\"/></geometry><material "
                                "name=\"m\"><color rgba=\"1 0.5 0 1\"/></material></visual>")),
      0);
  EXPECT_EQ(line("<Box"), "      <Box size=\"1 2 3\" position=\"0 0 0.5\" colour=\"#ff8000\"/>");
}

TEST_F(UrdfImport, TouchesByTheHullOfAMesh) {
  // A cube as text STL, its corners out of triangles: eight of them remain.
  std::string stl = "solid cube\n";
  const auto facet = [&stl](const char* a, const char* b, const char* c) {
    stl += std::string("facet normal 0 0 0\nouter loop\nvertex ") + a + "\nvertex " + b +
           "\nvertex " + c + "\nendloop\nendfacet\n";
  };
  facet("0 0 0", "1 1 0", "1 0 0"), facet("0 0 0", "0 1 0", "1 1 0");
  facet("0 0 1", "1 0 1", "1 1 1"), facet("0 0 1", "1 1 1", "0 1 1");
  write("cube.stl", stl + "endsolid\n");
  ASSERT_EQ(
      import("p.urdf", pendulum("continuous", "",
                                "<collision><geometry><mesh filename=\"cube.stl\" "
                                "scale=\"0.1 0.1 0.1\"/></geometry></collision>"
                                "<collision><geometry><mesh filename=\"none.stl\"/></geometry>"
                                "</collision>")),
      0);
  expectChecks();
  EXPECT_NE(line("<Polyhedron").find("material=\"bar\" colour=\"transparent\""), std::string::npos)
      << model();
  EXPECT_EQ(line("<Mesh"),
            "      <Mesh file=\"cube.stl\" scale=\"0.1 0.1 0.1\" position=\"0 0 0.5\"/>");
  EXPECT_NE(notes_.find("of 8 points, at most 0 m inside of that of all 8"), std::string::npos)
      << notes_;
  EXPECT_NE(notes_.find("mesh \"none.stl\" is left out: there is no such file"), std::string::npos)
      << notes_;
}

TEST_F(UrdfImport, DrawsAMeshInsteadOfWhatTouches) {
  write("arm.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  ASSERT_EQ(import("p.urdf",
                   pendulum("continuous", "",
                            "<visual><geometry><mesh filename=\"arm.obj\"/></geometry><material "
                            "name=\"m\"><color rgba=\"1 0.5 0 1\"/></material></visual>"
                            "<collision><geometry><box size=\"1 2 3\"/></geometry></collision>")),
            0);
  expectChecks();
  EXPECT_EQ(line("<Mesh"),
            "      <Mesh file=\"arm.obj\" position=\"0 0 0.5\" colour=\"#ff8000\"/>");
  EXPECT_EQ(line("<Box"),
            "      <Box size=\"1 2 3\" position=\"0 0 0.5\" material=\"bar\" "
            "colour=\"transparent\"/>");
}

TEST_F(UrdfImport, NamesMistakesWithTheirPlace) {
  struct {
    std::string file, said;
  } const kMistakes[] = {
      {"<robot><link name=\"a\"/>\n<joint name=\"j\" type=\"revolut\"><parent link=\"a\"/>"
       "<child link=\"a\"/></joint></robot>",
       "bad.urdf:2:23: error: <joint name=\"j\">: unknown type \"revolut\" — did you mean "
       "\"revolute\"?"},
      {"<robot><link name=\"arm\"/>\n<joint name=\"j\" type=\"fixed\"><parent link=\"arn\"/>"
       "<child link=\"arm\"/></joint></robot>",
       "bad.urdf:2:44: error: <parent>: there is no link \"arn\" — did you mean \"arm\"?"},
      {"<robot><link name=\"a\"><inertial><mass value=\"1 kg\"/><inertia ixx=\"1\" iyy=\"1\" "
       "izz=\"1\"/></inertial></link></robot>",
       "bad.urdf:1:48: error: <mass>: value \"kg\" is no number"},
      {"<robot><link name=\"a\"><collision><geometry><sphere raduis=\"1\"/></geometry></collision>"
       "</link></robot>",
       "the attribute \"radius\" is missing — \"raduis\" is given, did you mean that?"},
      {"<sdf/>x", "bad.urdf:1:7: error:"},
      {"<html/>", "is no machine that can be imported"},
  };
  for (const auto& [file, said] : kMistakes) {
    EXPECT_EQ(import("bad.urdf", file), 2) << notes_;
    EXPECT_NE(notes_.find(said), std::string::npos) << said << "\n" << notes_;
  }
}

}  // namespace
}  // namespace dynamy
