#include <gtest/gtest.h>

#include <unit/io/model/load_text.hpp>

namespace dynamy {
namespace {

using namespace dummy;

TEST(ModelLoaderError, UnknownAttribute) {
  EXPECT_EQ(errors(inSystems("<Ball name=\"b\" mas=\"1\" mass=\"1\"/>")),
            "m.xml:2:25: error: <Ball name=\"b\">: unknown attribute \"mas\" — did you mean "
            "\"mass\"?\n"
            "    2 | <systems><Ball name=\"b\" mas=\"1\" mass=\"1\"/></systems>\n"
            "      |                         ^~~");
}

TEST(ModelLoaderError, UnknownElement) {
  EXPECT_EQ(firstError(inSystems("<Bal mass=\"1\"/>")),
            "m.xml:2:10: error: <systems>: unknown element <Bal> — did you mean <Ball>?");
  EXPECT_EQ(firstError(inSystems("<Ball mass=\"1\"><Disk radius=\"1\"/></Ball>")),
            "m.xml:2:25: error: <Ball>: unknown element <Disk> — did you mean <Disc>?");
  EXPECT_EQ(firstError(inSystems("<Ball mass=\"1\"><Anything/></Ball>")),
            "m.xml:2:25: error: <Ball>: unknown element <Anything> — known here: \"Disc\"");
  EXPECT_EQ(firstError(around("<system/>")),
            "m.xml:2:1: error: <dynamy>: unknown element <system> — did you mean <systems>?");
}

TEST(ModelLoaderError, WrongKindInASection) {
  EXPECT_EQ(firstError(inSystems("<Weight/>")),
            "m.xml:2:10: error: <systems>: <Weight> is a force; put it into <forces>");
  EXPECT_EQ(firstError(inSystems("<Law/>")),
            "m.xml:2:10: error: <systems>: <Law> is a law; it stands inside of <Stop>");
  EXPECT_EQ(firstError(inSystems("<Ball mass=\"1\"><Law/></Ball>")),
            "m.xml:2:25: error: <Ball>: <Law> is a law; <Ball> takes: shape");
  EXPECT_EQ(firstError(around("<Ball mass=\"1\"/>")),
            "m.xml:2:1: error: <dynamy>: <Ball> is a system; put it into <systems>");
}

TEST(ModelLoaderError, MissingAttribute) {
  EXPECT_EQ(firstError(inSystems("<Ball name=\"b\"/>")),
            "m.xml:2:10: error: <Ball name=\"b\">: missing attribute \"mass\" — mass of the ball "
            "[kg]");
}

TEST(ModelLoaderError, WrongValues) {
  const auto ballWith = [](const std::string& attributes) {
    return firstError(inSystems("<Ball name=\"b\" " + attributes + "/>"));
  };
  EXPECT_EQ(ballWith("mass=\"-1\""),
            "m.xml:2:31: error: <Ball name=\"b\">: mass must be > 0, is -1");
  EXPECT_EQ(ballWith("mass=\"1\" orientation=\"0 0 0 0\""),
            "m.xml:2:47: error: <Ball name=\"b\">: orientation must not be zero");
  EXPECT_EQ(ballWith("mass=\"1\" velocity=\"0 0\""),
            "m.xml:2:44: error: <Ball name=\"b\">: velocity expects 3 numbers, has 2 — velocity at "
            "the start [m/s]");
  EXPECT_EQ(ballWith("mass=\"1\" z=\"30deg\""),
            "m.xml:2:37: error: <Ball name=\"b\">: z expects a length [m], has [rad]");
  EXPECT_EQ(firstError(around("<elements><Stop on=\"b\"><Law mu=\"-0.1\"/></Stop></elements>")),
            "m.xml:2:21: error: <Stop>: unknown system \"b\"");
  EXPECT_EQ(firstError(around("<systems><Ball name=\"b\" mass=\"1\"/></systems>"
                              "<elements><Stop on=\"b\"><Law mu=\"-0.1\"/></Stop></elements>")),
            "m.xml:2:77: error: <Law>: mu must be >= 0, is -0.1");
}

TEST(ModelLoaderError, NameUsedTwiceNotesTheFirst) {
  EXPECT_EQ(errors(around("<systems>\n<Ball name=\"b\" mass=\"1\"/>\n<Ball name=\"b\" mass=\"1\"/>"
                          "</systems>")),
            "m.xml:4:13: error: <Ball name=\"b\">: the name \"b\" is used already\n"
            "    4 | <Ball name=\"b\" mass=\"1\"/></systems>\n"
            "      |             ^\n"
            "m.xml:3:13: note: first used here\n"
            "    3 | <Ball name=\"b\" mass=\"1\"/>\n"
            "      |             ^");
}

TEST(ModelLoaderError, UnknownReference) {
  const std::string text = around(
      "<systems><Ball name=\"ball\" mass=\"1\"/></systems>"
      "<elements><Stop on=\"bal\" frames=\"ball.tip wall.x\"><Law/></Stop></elements>");
  const std::string all = errors(text);
  EXPECT_NE(
      all.find("m.xml:2:68: error: <Stop>: unknown system \"bal\" — did you mean \"ball\"?\n"),
      std::string::npos)
      << all;
  EXPECT_NE(all.find("m.xml:2:90: error: <Stop>: unknown system \"wall\" — did you mean "
                     "\"ball\"?\n"),
            std::string::npos)
      << all;
}

TEST(ModelLoaderError, BadExpressionPointsIntoTheValue) {
  EXPECT_EQ(
      errors(around("<parameter name=\"radius\" value=\"1\"/>\n<systems><Ball mass=\"{2*raduis}"
                    "\"/></systems>")),
      "m.xml:3:25: error: <Ball>: unknown symbol \"raduis\", known: radius — did you mean "
      "\"radius\"?\n"
      "    3 | <systems><Ball mass=\"{2*raduis}\"/></systems>\n"
      "      |                         ^~~~~~");
  EXPECT_EQ(firstError(inSystems("<Ball mass=\"{1\"/>")),
            "m.xml:2:22: error: <Ball>: \"{\" without \"}\"");
  EXPECT_EQ(firstError(inSystems("<Ball mass=\"{1/0}\"/>")),
            "m.xml:2:22: error: <Ball>: the expression has no finite value, is inf");
}

TEST(ModelLoaderError, OfAnElementItselfGetsItsPlaceInTheValue) {
  EXPECT_EQ(errors(inSystems("<Ball mass=\"1\" drive=\"{1+1}*t ??\"/>")),
            "m.xml:2:40: error: <Ball>: two question marks — leave them out\n"
            "    2 | <systems><Ball mass=\"1\" drive=\"{1+1}*t ??\"/></systems>\n"
            "      |                                        ^~");
}

TEST(ModelLoaderError, OfAConstructorThatThrowsGetsThePlaceOfItsElement) {
  EXPECT_EQ(firstError(inSystems("<Ball mass=\"1\" drive=\"crash\"/>")),
            "m.xml:2:10: error: <Ball>: its constructor failed: no table of drives");
  EXPECT_EQ(firstError(inSystems("<Ball mass=\"1\" drive=\"misspelt\"/>")),
            "m.xml:2:10: error: <Ball>: its constructor failed: it reads the attribute \"dirve\", "
            "which its declare() does not name — did you mean \"drive\"?");
}

TEST(ModelLoaderError, OfAConnectionGetsTheLineOfItsElement) {
  EXPECT_EQ(
      errors(around("<systems><Ball name=\"b\" mass=\"1\"/></systems>\n"
                    "<elements><Stop name=\"s\" on=\"b\"><Law mu=\"13\"/></Stop></elements>")),
      "m.xml:3:11: error: <Stop name=\"s\">: no contact likes mu = 13 — take another\n"
      "    3 | <elements><Stop name=\"s\" on=\"b\"><Law mu=\"13\"/></Stop></elements>\n"
      "      |           ^~~~~");
}

TEST(ModelLoaderError, NumberOfChildren) {
  EXPECT_EQ(firstError(around("<systems><Ball name=\"b\" mass=\"1\"/></systems>"
                              "<elements><Stop on=\"b\"/></elements>")),
            "m.xml:2:55: error: <Stop>: needs 1 law, has none — law of the contact");
  EXPECT_EQ(firstError(around("<systems><Ball name=\"b\" mass=\"1\"/></systems>"
                              "<elements><Stop on=\"b\"><Law/><Law/></Stop></elements>")),
            "m.xml:2:74: error: <Stop>: takes at most 1 law");
}

TEST(ModelLoaderError, UnknownClassAndFaultsInDefaults) {
  EXPECT_EQ(firstError(around("<defaults><Ball class=\"heavy\" mass=\"9\"/></defaults>"
                              "<systems><Ball class=\"heavi\" mass=\"1\"/></systems>")),
            "m.xml:2:74: error: <Ball>: <defaults> has no <Ball class=\"heavi\"> — did you mean "
            "\"heavy\"?");
  EXPECT_EQ(firstError(around("<defaults><Ball mas=\"9\"/></defaults>")),
            "m.xml:2:17: error: <Ball>: unknown attribute \"mas\" — did you mean \"mass\"?");
  EXPECT_EQ(firstError(around("<defaults><Bal mass=\"9\"/></defaults>")),
            "m.xml:2:11: error: <defaults>: unknown element <Bal> — did you mean <Ball>?");
}

TEST(ModelLoaderError, ParametersThatNeedEachOther) {
  EXPECT_EQ(firstError(around("<parameter name=\"a\" value=\"{b}\"/>"
                              "<parameter name=\"b\" value=\"{a}\"/>")),
            "m.xml:2:61: error: <parameter name=\"b\">: the parameter \"b\" depends on itself: a → "
            "b → a");
  EXPECT_EQ(firstError(around("<parameter name=\"a\" value=\"2\" max=\"1\"/>")),
            "m.xml:2:28: error: <parameter name=\"a\">: must be <= 1, is 2");
}

TEST(ModelLoaderError, TooManyTurnsAreNoHang) {
  EXPECT_EQ(
      firstError(inSystems("<replicate count=\"1000\"><replicate count=\"1000\"/></replicate>")),
      "m.xml:2:52: error: <replicate>: all replicates together make more than 100000 turns — "
      "many equal bodies are better one population");
}

TEST(ModelLoaderError, SettingsAreChecked) {
  EXPECT_EQ(firstError(around("<simulation untill=\"5\"/>")),
            "m.xml:2:13: error: <simulation>: unknown attribute \"untill\" — did you mean "
            "\"until\"?");
  EXPECT_EQ(firstError(around("<simulation><Law/></simulation>")),
            "m.xml:2:13: error: <simulation>: <Law> is a law; it stands inside of <Stop>");
  EXPECT_EQ(firstError(around("<check signal=\"b.z\" value=\"1\"/>")),
            "m.xml:2:1: error: <check>: needs a tolerance beside the value");
  EXPECT_EQ(firstError(around("<check signal=\"b.z\" between=\"2 1\"/>")),
            "m.xml:2:30: error: <check>: between expects the lower bound first");
}

TEST(ModelLoaderError, UnknownSignalsAfterBuilding) {
  EXPECT_EQ(errors(around("<systems><Ball name=\"ball\" mass=\"1\"/></systems>\n"
                          "<record signals=\"ball.z ball.vx\"/>\n"
                          "<check signal=\"bal.z\" value=\"1\" tolerance=\"1\"/>")),
            "m.xml:3:25: error: <record>: no signal \"ball.vx\" — did you mean \"ball.vz\"?\n"
            "    3 | <record signals=\"ball.z ball.vx\"/>\n"
            "      |                         ^~~~~~~\n"
            "m.xml:4:16: error: <check>: no signal \"bal.z\" — did you mean \"ball.z\"?\n"
            "    4 | <check signal=\"bal.z\" value=\"1\" tolerance=\"1\"/>\n"
            "      |                ^~~~~");
}

TEST(ModelLoaderError, RootVersionAndText) {
  EXPECT_EQ(
      firstError("<mujoco/>"),
      "m.xml:1:1: error: <mujoco>: a model begins with <dynamy version=\"1\"> — the file is in "
      "MJCF; dynamy import FILE --out model.xml makes a model of it");
  EXPECT_EQ(firstError("<dynamy version=\"2\"/>"),
            "m.xml:1:18: error: <dynamy>: the format has version 2, this program reads version 1 — "
            "write version=\"1\"");
  EXPECT_EQ(firstError(around("<systems>Hello</systems>")),
            "m.xml:2:10: error: <systems>: text has no meaning here — values are attributes, "
            "name=\"value\"; text for people stands in <doc>");
}

TEST(ModelLoaderError, TenFaultsAreTenMessagesInOneRun) {
  const std::string text =
      "<dynamy version=\"1\">\n"
      "<parameter name=\"p\" value=\"{q}\"/>\n"                       // unknown name
      "<system/>\n"                                                   // unknown section
      "<systems><Ball name=\"a\" mas=\"1\" mass=\"1\"/>\n"            // unknown attribute
      "<Ball name=\"b\" mass=\"-1\"/>\n"                              // range
      "<Ball name=\"b\" mass=\"1\"/>\n"                               // name twice
      "<Ball name=\"c\"/>\n"                                          // missing attribute
      "<Weight/>\n"                                                   // wrong kind
      "<Ball name=\"d\" mass=\"1\" velocity=\"0 0\"/></systems>\n"    // size
      "<elements><Stop on=\"e\"><Law/></Stop>\n"                      // unknown reference
      "<Stop on=\"a\"/></elements>\n"                                 // missing child
      "<systems><Ball name=\"f\" mass=\"{p}\"/></systems></dynamy>";  // uses p: no message
  try {
    load(text);
    FAIL();
  } catch (const ModelError& e) {
    ASSERT_EQ(e.diagnostics().size(), 10u) << e.what();
    for (std::size_t i = 0; i < 10; ++i) {
      EXPECT_EQ(e.diagnostics()[i].place.line, static_cast<int>(i) + 2);
      EXPECT_FALSE(e.diagnostics()[i].sourceLine.empty());
    }
  }
}

}  // namespace
}  // namespace dynamy
