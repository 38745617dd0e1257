/// dynamy import: machines of URDF and MJCF become models that check, with values derived by hand.
#include <cmath>
#include <program/program_fixture.hpp>

namespace dynamy {
namespace {

class Import : public ProgramTest {
 protected:
  /// Imports a file of this content; the model is then model.xml, the notes are in err().
  int import(const std::string& file, const std::string& content, const std::string& options = "") {
    write(file, content);
    const int status = call("import " + file + " -o model.xml " + options);
    notes_ = err();
    return status;
  }
  std::string model() const { return readWholeFile(path("model.xml")); }
  /// The line of the model that holds `text`; "" if there is none.
  std::string line(const std::string& text) const {
    const std::string all = model();
    const std::size_t at = all.find(text);
    if (at == std::string::npos) return {};
    const std::size_t begin = all.rfind('\n', at) + 1;
    return all.substr(begin, all.find('\n', at) - begin);
  }
  void expectChecks() { EXPECT_EQ(call("check model.xml"), 0) << out() << err() << model(); }
  /// Value of a signal at the end of the run.
  double atEnd(const std::string& signal, const std::string& options) {
    EXPECT_EQ(call("run model.xml --quiet --out r " + options), 0) << out() << err();
    const std::string csv = readWholeFile(path("r/signals.csv"));
    const std::string head = csv.substr(0, csv.find('\n'));
    const std::string last = csv.substr(csv.rfind('\n', csv.size() - 2) + 1);
    const auto cell = [](const std::string& row, std::size_t k) {
      std::size_t begin = 0;
      for (; k > 0; --k) begin = row.find(',', begin) + 1;
      return row.substr(begin, row.find(',', begin) - begin);
    };
    for (std::size_t k = 0; k < 100; ++k)
      if (cell(head, k).find(signal) == 0) return std::stod(cell(last, k));
    ADD_FAILURE() << "no signal " << signal << " in " << head;
    return 0.0;
  }
  std::string notes_;
};

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

using UrdfImport = Import;

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
  // The angle counts from the start: from 1e-4 to −1e-4. Its relative error is φ²/16 and that of
  // the run's tolerance, 1e-6 of the start.
  EXPECT_NEAR(atEnd("hinge.angle", "--until " + std::to_string(half) + " --tolerance 1e-9"), -2e-4,
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
  EXPECT_NE(line("<Polyhedron"), "");
  EXPECT_NE(notes_.find("of 8 points, at most 0 m inside of that of all 8"), std::string::npos)
      << notes_;
  EXPECT_NE(notes_.find("mesh \"none.stl\" is left out: there is no such file"), std::string::npos)
      << notes_;
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

// ---- MJCF --------------------------------------------------------------------------------------

using MjcfImport = Import;

std::string mjcf(const std::string& bodies, const std::string& before = "",
                 const std::string& after = "") {
  return "<mujoco model=\"m\">\n" + before + "<worldbody>\n" + bodies + "</worldbody>\n" + after +
         "</mujoco>\n";
}

TEST_F(MjcfImport, TakesMassAndInertiaFromGeoms) {
  // A ball of radius 0.1 at x = ±0.3, each 4/3 π r³ · 1000 = 4.18879 kg: J_x = 2 · 2/5 m r²,
  // J_y = J_x + 2 m 0.09.
  ASSERT_EQ(
      import("m.xml", mjcf("<body name=\"b\" pos=\"0 0 1\"><freejoint/>"
                           "<geom size=\".1\" pos=\".3 0 0\"/><geom size=\".1\" pos=\"-.3 0 0\"/>"
                           "</body>")),
      0)
      << notes_;
  expectChecks();
  EXPECT_NE(line("<RigidBody")
                .find("position=\"0 0 1\" mass=\"8.37758040957278\" "
                      "inertia=\"0.0335103216382911 0.787492558499841 "
                      "0.787492558499841 0 0 0\""),
            std::string::npos)
      << line("<RigidBody");
}

TEST_F(MjcfImport, KnowsTheSolidsInClosedForm) {
  // 1 kg each. Box of edges 2, 4, 6: (b² + c²)/12. Cylinder of radius 1 and length 2: (3 r² + l²)/12,
  // r²/2. Ellipsoid 1, 2, 3: (b² + c²)/5. Capsule of radius 1 and straight part 2: with the shares
  // 2/5 of the half balls and 3/5 of the cylinder, J_z = 2/5·2/5 + 3/5·1/2 = 0.46,
  // J_x = 2/5 (2/5 + 1 + 3/4) + 3/5 (3 + 4)/12 = 1.21.
  const struct {
    const char *geom, *inertia;
  } kSolids[] = {
      {"type=\"box\" size=\"1 2 3\"", "4.33333333333333 3.33333333333333 1.66666666666667 0 0 0"},
      {"type=\"cylinder\" size=\"1 1\"", "0.583333333333333 0.583333333333333 0.5 0 0 0"},
      {"type=\"ellipsoid\" size=\"1 2 3\"", "2.6 2 1 0 0 0"},
      {"type=\"capsule\" size=\"1 1\"", "1.21 1.21 0.46 0 0 0"},
      {"type=\"capsule\" size=\"1\" fromto=\"0 0 -1 0 0 1\"", "1.21 1.21 0.46 0 0 0"},
  };
  for (const auto& [geom, inertia] : kSolids) {
    ASSERT_EQ(
        import("m.xml", mjcf(std::string("<body pos=\"0 0 9\"><freejoint/><geom mass=\"1\" ") +
                             geom + "/></body>")),
        0)
        << notes_;
    EXPECT_NE(line("<RigidBody").find(std::string("inertia=\"") + inertia + '"'), std::string::npos)
        << geom << line("<RigidBody");
    expectChecks();
  }
}

TEST_F(MjcfImport, GivesElementsTheValuesOfTheirClasses) {
  // The main class, one inside of it, the class of a body's content, and one that an element names.
  const std::string classes =
      "<default><joint damping=\"1\"/><default class=\"stiff\"><joint stiffness=\"5\"/>"
      "<default class=\"dry\"><joint frictionloss=\"2\" "
      "damping=\"3\"/></default></default></default>\n";
  const std::string bodies =
      "<body name=\"a\" childclass=\"stiff\"><joint name=\"ja\"/><geom size=\".1\"/>"
      "<body name=\"b\" pos=\"1 0 0\"><joint name=\"jb\" class=\"dry\"/><geom "
      "size=\".1\"/></body></body>"
      "<body name=\"c\" pos=\"0 9 0\"><joint name=\"jc\"/><geom size=\".1\"/></body>\n";
  ASSERT_EQ(import("m.xml", mjcf(bodies, classes)), 0) << notes_;
  expectChecks();
  EXPECT_NE(line("ja_spring").find("stiffness=\"5\" damping=\"1\""), std::string::npos);
  EXPECT_NE(line("jb_spring").find("stiffness=\"5\" damping=\"3\""), std::string::npos);
  EXPECT_NE(line("<Revolute name=\"jb\"").find("force=\"2\""), std::string::npos);
  EXPECT_NE(line("jc_spring").find("stiffness=\"0\" damping=\"1\""), std::string::npos);
}

TEST_F(MjcfImport, ReadsAnglesAsTheCompilerSays) {
  // 90 degrees about x, then about the moved y: z goes to x. The same by capital letters, about fixed
  // axes: y turns z to x, which the turn about x keeps.
  const std::string body =
      "<body name=\"b\" euler=\"90 90 0\"><joint name=\"j\" range=\"-90 45\"/>"
      "<geom size=\".1\" pos=\"0 0 1\"/></body>\n";
  ASSERT_EQ(import("m.xml", mjcf(body)), 0) << notes_;
  expectChecks();
  EXPECT_NE(line("<RigidBody").find("position=\"1 0 0\""), std::string::npos) << line("<RigidBody");
  EXPECT_NE(line("<JointStop").find("lower=\"-1.5707963267949\" upper=\"0.785398163397448\""),
            std::string::npos)
      << line("<JointStop");
  ASSERT_EQ(import("m.xml", mjcf(body, "<compiler eulerseq=\"YXZ\"/>")), 0);
  EXPECT_NE(line("<RigidBody").find("position=\"1 0 0\""), std::string::npos) << line("<RigidBody");
  ASSERT_EQ(
      import("m.xml", mjcf("<body euler=\"0 0 1.5\"><joint range=\"-1 1\"/><geom size=\".1\"/>"
                           "</body>",
                           "<compiler angle=\"radian\" autolimits=\"false\"/>")),
      0);
  EXPECT_EQ(line("<JointStop"), "") << "a range is no limit without autolimits";
}

TEST_F(MjcfImport, PutsBodiesBetweenSeveralJoints) {
  ASSERT_EQ(
      import("m.xml", mjcf("<body name=\"cart\" pos=\"0 0 1\"><joint name=\"x\" type=\"slide\" "
                           "axis=\"1 0 0\"/><joint name=\"turn\" axis=\"0 1 0\" pos=\"0 0 .5\"/>"
                           "<geom size=\".1\" mass=\"2\"/></body>")),
      0)
      << notes_;
  expectChecks();
  EXPECT_NE(line("name=\"cart_x\"").find("mass=\"2e-12\""), std::string::npos);
  EXPECT_EQ(line("<Prismatic"),
            "    <Prismatic name=\"x\" between=\"world cart_x\" at=\"0 0 1\" axis=\"1 0 0\"/>");
  EXPECT_EQ(line("<Revolute"),
            "    <Revolute name=\"turn\" between=\"cart_x cart\" at=\"0 0 1.5\" axis=\"0 1 0\"/>");
}

TEST_F(MjcfImport, KeepsRulesOfContact) {
  // Neighbours never touch, nor what is excluded, nor what the bits keep apart; the floor touches.
  const std::string bodies =
      "<geom type=\"plane\" size=\"1 1 1\" pos=\"0 0 -5\" friction=\"0.7\"/>"
      "<body name=\"a\"><freejoint/><geom size=\".1\"/><body name=\"b\" pos=\"1 0 0\"><joint/>"
      "<geom size=\".1\"/><body name=\"c\" pos=\"1 0 0\"><joint/><geom size=\".1\"/>"
      "<geom size=\".3\" contype=\"0\" conaffinity=\"0\"/></body></body></body>\n"
      "<body name=\"d\" pos=\"0 5 0\"><freejoint/><geom size=\".1\"/></body>\n";
  ASSERT_EQ(
      import("m.xml", mjcf(bodies, "", "<contact><exclude body1=\"d\" body2=\"a\"/></contact>")), 0)
      << notes_;
  expectChecks();
  const std::string all = model();
  for (const char* pair : {"a b", "b c", "a d"})
    EXPECT_NE(all.find(std::string("<NoContact between=\"") + pair + "\"/>"), std::string::npos)
        << pair << all;
  std::size_t rules = 0;
  for (std::size_t at = 0; (at = all.find("<NoContact", at)) != std::string::npos; ++at) ++rules;
  EXPECT_EQ(rules, 3u) << all;
  EXPECT_NE(line("<Material name=\"ground\"").find("mu=\"0.7\""), std::string::npos);
  EXPECT_NE(line("<HalfSpace").find("material=\"ground\""), std::string::npos);
  EXPECT_EQ(line("radius=\"0.3\"").find("material"), std::string::npos);
}

TEST_F(MjcfImport, ClosesLoopsByConnectAndWeld) {
  const std::string bodies =
      "<body name=\"a\"><joint axis=\"0 1 0\"/><geom type=\"capsule\" size=\".05\" fromto=\"0 0 0 "
      "1 0 0\"/>"
      "</body><body name=\"b\" pos=\"2 0 0\"><joint axis=\"0 1 0\"/>"
      "<geom type=\"capsule\" size=\".05\" fromto=\"0 0 0 -1 0 0\"/></body>\n";
  ASSERT_EQ(import("m.xml", mjcf(bodies, "",
                                 "<equality><connect body1=\"a\" body2=\"b\" "
                                 "anchor=\"1 0 0\"/></equality>")),
            0)
      << notes_;
  EXPECT_EQ(line("<Spherical"), "    <Spherical name=\"connect\" between=\"b a\" at=\"1 0 0\"/>");
  EXPECT_NE(call("check model.xml"), 2) << out() << err();
}

TEST_F(MjcfImport, ReadsIncludedFilesAndNamesTheirMistakes) {
  write("arm.xml",
        "<mujoco>\n<body name=\"arm\"><joint name=\"j\" damping=\"x\"/>"
        "<geom size=\".1\"/></body></mujoco>");
  EXPECT_EQ(import("m.xml", mjcf("<include file=\"arm.xml\"/>")), 2);
  EXPECT_NE(notes_.find("arm.xml:2:43: error: <joint name=\"j\">: damping \"x\" is no number"),
            std::string::npos)
      << notes_;
  write("arm.xml", "<mujoco><body name=\"arm\"><joint/><geom size=\".1\"/></body></mujoco>");
  EXPECT_EQ(import("m.xml", mjcf("<include file=\"arm.xml\"/>")), 0) << notes_;
  expectChecks();
}

TEST_F(MjcfImport, ListsWhatHasNoEquivalentOnceWithItsCount) {
  ASSERT_EQ(import("m.xml", mjcf("<body><freejoint/><geom size=\".1\" solref=\"0.01 1\"/>"
                                 "<geom size=\".2\" solref=\"0.01 1\"/></body>",
                                 "", "<actuator><motor joint=\"j\"/></actuator>\n<tendon/>\n")),
            0);
  EXPECT_NE(notes_.find("<geom>: attribute solref: contacts are rigid (and 1 more)"),
            std::string::npos)
      << notes_;
  EXPECT_NE(notes_.find("<tendon>: tendons are not taken over"), std::string::npos) << notes_;
}

TEST_F(MjcfImport, NamesMistakesWithTheirPlace) {
  const struct {
    std::string file, said;
  } kMistakes[] = {
      {mjcf("<body><joint type=\"hinges\"/><geom size=\".1\"/></body>"),
       "unknown type \"hinges\" — did you mean \"hinge\"?"},
      {mjcf("<body><joint class=\"stif\"/></body>",
            "<default><default class=\"stiff\"/></default>"),
       "there is no default class \"stif\" — did you mean \"stiff\"?"},
      {mjcf("<body><freejoint/><geom type=\"box\" size=\"1 1\"/></body>"),
       "a box has 3 positive sizes"},
      {mjcf("<joint/>"), "the world does not move"},
  };
  for (const auto& [file, said] : kMistakes) {
    EXPECT_EQ(import("m.xml", file), 2) << notes_;
    EXPECT_NE(notes_.find(said), std::string::npos) << said << "\n" << notes_;
  }
}

}  // namespace
}  // namespace dynamy
