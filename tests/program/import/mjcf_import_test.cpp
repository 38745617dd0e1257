/// dynamy import of MJCF: models that check, with values derived by hand.
#include <program/import/import_fixture.hpp>

namespace dynamy {
namespace {

using MjcfImport = ImportTest;

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

TEST_F(MjcfImport, IntegratesOverClosedMeshes) {
  // A cuboid of 1 x 2 x 3 m with a corner at the origin, as OBJ of squares: 6 m³ of density 2, its
  // centre in the middle, J = m (b² + c²)/12 = 13, 10, 5.
  write("brick.obj",
        "v 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nv 0 0 3\nv 1 0 3\nv 1 2 3\nv 0 2 3\n"
        "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4/1/1 1 5 -1\n");
  ASSERT_EQ(
      import("m.xml", mjcf("<body pos=\"0 0 9\"><freejoint/><geom type=\"mesh\" mesh=\"brick\" "
                           "density=\"2\"/></body>",
                           "<asset><mesh file=\"brick.obj\"/></asset>")),
      0)
      << notes_;
  expectChecks();
  EXPECT_NE(line("<RigidBody")
                .find("position=\"0.5 1 10.5\" mass=\"12\" "
                      "inertia=\"13 10 5 0 0 0\""),
            std::string::npos)
      << line("<RigidBody");
  EXPECT_EQ(notes_.find("is not closed"), std::string::npos) << notes_;
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
