#include <gtest/gtest.h>

#include <dynamy/io/reference/describe.hpp>
#include <dynamy/io/reference/schema.hpp>
#include <dynamy/io/reference/subject.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <unit/io/plugin/dummy_elements.hpp>

namespace dynamy {
namespace {

namespace fs = std::filesystem;

TEST(Describe, ShowsAttributesChildrenAndExample) {
  EXPECT_EQ(describe(dummy::registry(), "Ball"),
            "<Ball>  system of dummies\n"
            "  A ball on a vertical line: m u' = h.\n"
            "\n"
            "  attribute    type       unit  default   range     meaning\n"
            "  mass         number     kg    required  > 0       mass of the ball\n"
            "  z            number     m     1         -         height at the start\n"
            "  velocity     3 numbers  m/s   0 0 0     -         velocity at the start\n"
            "  orientation  4 numbers  -     1 0 0 0   not zero  quaternion\n"
            "  drive        formula    -     0         -         force over t\n"
            "\n"
            "Children\n"
            "  0 to 3 shape: what it looks like (<Disc>)\n"
            "\n"
            "Example\n"
            "  <Ball name=\"b\" mass=\"1kg\"><Disc radius=\"0.1\"/></Ball>\n");
}

TEST(Describe, KnowsTheWordsOfTheFormat) {
  const std::string text = describe(dummy::registry(), "replicate");
  EXPECT_TRUE(text.starts_with("<replicate>  word of the model file\n")) << text;
  EXPECT_NE(text.find("count      integer  -     required  0 … 1e+05  number of turns\n"),
            std::string::npos)
      << text;
}

TEST(Describe, SuggestsTheNearestName) {
  try {
    describe(dummy::registry(), "Bal");
    FAIL();
  } catch (const ModelError& e) {
    EXPECT_STREQ(e.what(), "error: there is no \"Bal\" — did you mean \"Ball\"?");
  }
}

TEST(Describe, UnderstandsANameInAnotherCase) {
  EXPECT_EQ(describe(dummy::registry(), "ball"), describe(dummy::registry(), "Ball"));
}

TEST(Describe, ListsTheTypesOnASubject) {
  const std::string ball =
      "about \"Vertical\":\n\nsystem\n  Ball  A ball on a vertical line [dummies]\n";
  EXPECT_EQ(describe(dummy::registry(), "Vertical"), ball);
  // A section of the model file is described itself.
  EXPECT_TRUE(
      describe(dummy::registry(), "Systems").starts_with("<systems>  word of the model file"));
}

TEST(Describe, ListsTheAttributesForAWordOfOthers) {
  EXPECT_EQ(describe(dummy::registry(), "vel"),
            "attributes for \"vel\":\n  <Ball> velocity: velocity at the start\n");
}

TEST(Describe, EndsTheFirstSentenceAtItsDotOrBeforeAnEquation) {
  EXPECT_EQ(firstSentence("B moves along A. 4 rows. Signals: x."), "B moves along A");
  EXPECT_EQ(firstSentence("B moves along A. Signals: x."), "B moves along A");
  EXPECT_EQ(firstSentence("A law, e.g. Coulomb's, acts. Then"), "A law, e.g. Coulomb's, acts");
  EXPECT_EQ(firstSentence("Free rigid body: m v' = f."), "Free rigid body");
  EXPECT_EQ(firstSentence("Hinge: two frames share a point."), "Hinge: two frames share a point");
  EXPECT_EQ(firstSentence("A number with a dot.\nMore."), "A number with a dot");
}

TEST(Describe, SaysWhereNamesAreIfAWordIsNowhere) {
  try {
    describe(dummy::registry(), "zither");
    FAIL();
  } catch (const ModelError& e) {
    EXPECT_STREQ(e.what(), "error: there is no \"zither\" — dynamy list shows all names");
  }
}

TEST(Describe, ListsTypesByKind) {
  EXPECT_EQ(listTypes(dummy::registry().types()),
            "system\n"
            "  Ball    A ball on a vertical line [dummies]\n"
            "\n"
            "contact\n"
            "  Stop    [dummies]\n"
            "\n"
            "force\n"
            "  Weight  [dummies]\n"
            "\n"
            "law\n"
            "  Law     [dummies]\n"
            "\n"
            "shape\n"
            "  Disc    [dummies]\n");
}

/// Exit status of xmllint for a model; 0: valid.
int validate(const std::string& model) {
  std::string name = (fs::temp_directory_path() / "dynamy_schema_XXXXXX").string();
  const fs::path folder = mkdtemp(name.data());
  std::ofstream(folder / "dynamy.xsd") << schemaText(dummy::registry());
  std::ofstream(folder / "m.xml") << model;
  const std::string command = "xmllint --noout --schema " + (folder / "dynamy.xsd").string() + ' ' +
                              (folder / "m.xml").string() + " > " + (folder / "log").string() +
                              " 2>&1";
  const int status = std::system(command.c_str());
  fs::remove_all(folder);
  return status;
}

TEST(Schema, AcceptsAModelWithEverySection) {
  if (std::system("xmllint --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no xmllint";
  const std::string good =
      "<dynamy version=\"1\" xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
      "xsi:noNamespaceSchemaLocation=\"dynamy.xsd\"><doc>Text.</doc>"
      "<check signal=\"b.z\" value=\"1\" tolerance=\"1\"/>"
      "<parameter name=\"p\" value=\"1\"/><defaults><Ball class=\"x\" mass=\"1\"/></defaults>"
      "<include file=\"a.xml\" prefix=\"a\"><set name=\"h\" value=\"{p}\"/></include>"
      "<systems><doc>Balls.</doc><replicate count=\"2\"><Ball name=\"b\" class=\"x\">"
      "<Disc radius=\"1\"/></Ball></replicate></systems><forces><Weight/></forces>"
      "<elements><Stop on=\"b[0]\"><Law mu=\"0.1\"/></Stop></elements>"
      "<simulation until=\"1\" onNonConvergence=\"{p}\"/><record signals=\"b.z\" view=\"xz\"/>"
      "</dynamy>";
  EXPECT_EQ(validate(good), 0);
}

TEST(Schema, RefusesUnknownAttributesElementsAndWords) {
  if (std::system("xmllint --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no xmllint";
  const auto around = [](const std::string& t) {
    return "<dynamy version=\"1\">" + t + "</dynamy>";
  };
  EXPECT_EQ(validate(around("")), 0);
  EXPECT_NE(validate(around("<systems><Ball mas=\"1\"/></systems>")), 0);
  EXPECT_NE(validate(around("<systems><Weight/></systems>")), 0);
  EXPECT_NE(validate(around("<parameter value=\"1\"/>")), 0);
  EXPECT_NE(validate(around("<record view=\"xx\"/>")), 0);
}

}  // namespace
}  // namespace dynamy
