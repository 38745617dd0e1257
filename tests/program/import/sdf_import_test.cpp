/// dynamy import of SDF: models that check, with values derived by hand.
#include <program/import/import_fixture.hpp>

namespace dynamy {
namespace {

using SdfImport = ImportTest;

std::string sdf(const std::string& inside) {
  return "<sdf version=\"1.9\"><model name=\"m\">\n" + inside + "</model></sdf>\n";
}

/// A bar of `mass` kg, its centre `down` below its origin, J = m/12 about it across.
std::string sdfBar(const std::string& name, const std::string& pose, double mass, double down) {
  const std::string J = std::to_string(mass / 12.0);
  return "<link name=\"" + name + "\"><pose>" + pose + "</pose><inertial><pose>0 0 " +
         std::to_string(-down) + " 0 0 0</pose><mass>" + std::to_string(mass) +
         "</mass><inertia><ixx>" + J + "</ixx><iyy>" + J + "</iyy><izz>" + J +
         "</izz></inertia></inertial></link>\n";
}

std::string sdfJoint(const std::string& name, const std::string& parent, const std::string& child,
                     const std::string& rest = "") {
  return "<joint name=\"" + name + "\" type=\"revolute\"><parent>" + parent + "</parent><child>" +
         child + "</child>" + rest + "<axis><xyz>0 1 0</xyz></axis></joint>\n";
}

TEST_F(SdfImport, SwingsAParallelogramWithAClosedLoop) {
  // Two cranks of 1.5 kg and 1 m, a coupler of 1 kg that does not turn:
  //   omega² = (m g l + M g l)/(2 m l²/3 + M l²) = 2.5 g/2
  ASSERT_EQ(import("m.sdf",
                   sdf(sdfBar("left", "0 0 2 0 0 0", 1.5, 0.5) +
                       sdfBar("right", "1 0 2 0 0 0", 1.5, 0.5) +
                       sdfBar("coupler", "0 0 1 0 0 0", 1.0, 0.0) + sdfJoint("a", "world", "left") +
                       sdfJoint("b", "left", "coupler") + sdfJoint("c", "world", "right") +
                       sdfJoint("d", "right", "coupler", "<pose>1 0 0 0 0 0</pose>")),
                   "--at a=1e-4 --at b=-1e-4 --at c=1e-4"),
            0)
      << notes_;
  EXPECT_EQ(line("<Revolute name=\"d\"").find("between=\"right coupler\""),
            std::string("    <Revolute name=\"d\" ").size());
  expectChecks();
  const double half = 3.14159265358979 / std::sqrt(1.25 * 9.81);
  // From 1e-4 to −1e-4; amplitudes change the period by φ²/16, and masses have six digits, which
  // change the moment of inertia by 1e-6 and the angle, at rest there, by its square.
  EXPECT_NEAR(atEnd("a.angle", "--until " + std::to_string(half) + " --tolerance 1e-9"), -1e-4,
              1e-8);
}

TEST_F(SdfImport, PlacesLinksRelativeToOtherFrames) {
  // "tip" lies 1 m above "base", which is turned by 90 degrees about y: at x = 1.
  ASSERT_EQ(
      import("m.sdf",
             "<sdf version=\"1.9\"><model name=\"m\"><pose>0 0 5 0 0 0</pose>"
             "<link name=\"base\"><pose degrees=\"true\">0 0 0 0 90 0</pose></link>"
             "<frame name=\"mount\" attached_to=\"base\"><pose>0 0 0.5 0 0 0</pose></frame>"
             "<link name=\"tip\"><pose relative_to=\"mount\">0 0 0.5 0 0 0</pose></link>"
             "<joint name=\"j\" type=\"fixed\"><parent>base</parent><child>tip</child></joint>"
             "</model></sdf>"),
      0)
      << notes_;
  expectChecks();
  EXPECT_NE(line("name=\"tip\"").find("position=\"1 0 5\""), std::string::npos) << line("\"tip\"");
  EXPECT_NE(line("name=\"base\"").find("position=\"0 0 5\""), std::string::npos);
  EXPECT_EQ(line("name=\"mount\""), "      <Frame name=\"mount\" position=\"0 0 0.5\"/>");
  EXPECT_NE(line("<Fixed"), "");
}

TEST_F(SdfImport, JoinsLinksByFramesThatTheyCarry) {
  // The joint stands at the frame "hand", which link "a" carries 2 m above itself.
  ASSERT_EQ(import("m.sdf",
                   sdf("<link name=\"a\"><pose>0 0 1 0 0 0</pose></link><link name=\"b\"/>"
                       "<frame name=\"wrist\" attached_to=\"a\"/>"
                       "<frame name=\"hand\" attached_to=\"wrist\"><pose>0 0 2 0 0 0</pose></frame>"
                       "<joint name=\"j\" type=\"revolute\"><parent>b</parent><child>hand</child>"
                       "<axis><xyz>1 0 0</xyz></axis></joint>")),
            0)
      << notes_;
  expectChecks();
  EXPECT_EQ(line("<Revolute"),
            "    <Revolute name=\"j\" between=\"b a\" at=\"0 0 3\" axis=\"1 0 0\"/>");
}

TEST_F(SdfImport, TakesJointsNamedLikeLinksAndEmptyFrames) {
  // An empty relative_to is none: the joint's frame is that of its child, 2 m above it.
  ASSERT_EQ(
      import("m.sdf", sdf("<link name=\"a\"><pose>0 0 1 0 0 0</pose></link>"
                          "<joint name=\"a\" type=\"revolute\"><pose relative_to=\"\">0 0 2 0 0 0"
                          "</pose><parent>world</parent><child>a</child>"
                          "<axis><xyz>1 0 0</xyz></axis></joint>")),
      0)
      << notes_;
  expectChecks();
  EXPECT_NE(line("<Revolute").find("at=\"0 0 3\""), std::string::npos) << line("<Revolute");
  EXPECT_NE(notes_.find("its frame is \"a_joint\""), std::string::npos) << notes_;
}

TEST_F(SdfImport, ExpressesAxesInTheFrameTheyName) {
  const std::string turned =
      "<link name=\"bar\"><pose degrees=\"true\">0 0 0 0 0 90</pose></link>"
      "<joint name=\"j\" type=\"revolute\"><parent>world</parent><child>bar</child><axis><xyz";
  const std::string rest =
      "<limit><lower>-1e16</lower><upper>2</upper></limit><dynamics><damping>3</damping>"
      "<friction>4</friction><spring_stiffness>5</spring_stiffness>"
      "<spring_reference>6</spring_reference></dynamics></axis></joint>";
  ASSERT_EQ(import("m.sdf", sdf(turned + ">1 0 0</xyz>" + rest)), 0) << notes_;
  expectChecks();
  EXPECT_NE(line("<Revolute").find("axis=\"0 1 0\"><GivenFriction force=\"4\""), std::string::npos)
      << line("<Revolute");
  EXPECT_NE(line("<JointSpring").find("stiffness=\"5\" damping=\"3\" rest=\"6\""),
            std::string::npos);
  EXPECT_NE(line("<JointStop").find(" upper=\"2\"/>"), std::string::npos);
  EXPECT_EQ(line("<JointStop").find("lower"), std::string::npos);
  ASSERT_EQ(import("m.sdf", sdf(turned + " expressed_in=\"__model__\">1 0 0</xyz>" + rest)), 0);
  EXPECT_NE(line("<Revolute").find("axis=\"1 0 0\""), std::string::npos) << line("<Revolute");
}

TEST_F(SdfImport, LetsModelsFallOnStaticOnes) {
  const std::string ball =
      "<model name=\"ball\"><pose>0 0 3 0 0 0</pose><link name=\"ball\"><inertial><mass>2</mass>"
      "<inertia><ixx>0.2</ixx><iyy>0.2</iyy><izz>0.2</izz></inertia></inertial>"
      "<collision name=\"c\"><geometry><sphere><radius>0.5</radius></sphere></geometry></collision>"
      "</link></model>";
  const std::string floor =
      "<model name=\"floor\"><static>true</static><link name=\"floor\"><collision name=\"c\">"
      "<geometry><plane><normal>0 0 1</normal></plane></geometry><surface><friction><ode>"
      "<mu>0.6</mu></ode></friction></surface></collision></link></model>";
  ASSERT_EQ(import("m.sdf", "<sdf version=\"1.6\"><world name=\"w\"><gravity>0 0 -5</gravity>" +
                                floor + ball + "</world></sdf>"),
            0)
      << notes_;
  expectChecks();
  EXPECT_NE(line("<Ground name=\"floor\""), "");
  EXPECT_NE(line("<Gravity").find("acceleration=\"0 0 -5\""), std::string::npos);
  EXPECT_NE(line("<Material name=\"floor\"").find("mu=\"0.6\""), std::string::npos) << model();
  // From 3 m it falls 2.5 m in 1 s and stays, 0.5 m high.
  std::string text = model();
  text.replace(text.find("<record"), 7,
               "<check signal=\"ball.z\" at=\"3\" value=\"0.5\" "
               "tolerance=\"1e-6\"/><record");
  write("model.xml", text);
  EXPECT_EQ(call("run model.xml --quiet --out r --until 3"), 0) << out() << err();
}

TEST_F(SdfImport, NamesMistakesWithTheirPlace) {
  const struct {
    std::string file, said;
  } kMistakes[] = {
      {sdf("<link name=\"a\"/><joint name=\"j\" type=\"revolut\"><parent>world</parent>"
           "<child>a</child></joint>"),
       "unknown type \"revolut\" — did you mean \"revolute\"?"},
      {sdf("<link name=\"arm\"/><joint name=\"j\" type=\"fixed\"><parent>world</parent>"
           "<child>arn</child></joint>"),
       "there is no link \"arn\" — did you mean \"arm\"?"},
      {sdf("<link name=\"a\"><pose relative_to=\"b\">0 0 0 0 0 0</pose></link>"),
       "there is no frame \"b\""},
      {sdf("<link name=\"a\"><pose>0 0 0</pose></link>"), "its text has 3 numbers instead of 6"},
      {sdf(""), "the model has no <link>"},
  };
  for (const auto& [file, said] : kMistakes) {
    EXPECT_EQ(import("m.sdf", file), 2) << notes_;
    EXPECT_NE(notes_.find(said), std::string::npos) << said << "\n" << notes_;
  }
}

}  // namespace
}  // namespace dynamy
