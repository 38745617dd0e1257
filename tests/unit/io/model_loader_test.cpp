#include <gtest/gtest.h>

#include <dynamy/io/model_loader.hpp>

#include <fstream>
#include <unit/io/dummy_elements.hpp>

namespace dynamy {
namespace {

namespace fs = std::filesystem;

/// Loads `text` as the file m.xml with the dummy elements.
Model load(const std::string& text, const Overrides& set = {}, const fs::path& folder = ".") {
  Registry registry = dummy::registry();
  PluginLoader plugins((std::vector<fs::path>()));
  return loadModelText(text, "m.xml", registry, plugins, {.set = set}, folder);
}

/// All messages, or "".
std::string errors(const std::string& text, const Overrides& set = {},
                   const fs::path& folder = ".") {
  try {
    load(text, set, folder);
  } catch (const ModelError& e) {
    return e.what();
  }
  return {};
}

/// The model around one section; the section stands in line 2.
std::string around(const std::string& inside) {
  return "<dynamy version=\"1\">\n" + inside + "\n</dynamy>";
}
std::string inSystems(const std::string& inside) {
  return around("<systems>" + inside + "</systems>");
}

const dummy::Ball& ball(const Model& m, std::size_t i = 0) {
  return static_cast<const dummy::Ball&>(*m.systems().at(i));
}
const dummy::Stop& stop(const Model& m, std::size_t i = 0) {
  return static_cast<const dummy::Stop&>(*m.contacts().at(i));
}

// ---- What is read ----

TEST(ModelLoader, MakesElementsWithValuesAndPlaces) {
  const Model m = load(around(
      "<doc>A ball.</doc>"
      "<systems><Ball name=\"b\" mass=\"500g\" z=\"5mm\"><Disc radius=\"0.1\"/></Ball></systems>"
      "<forces><Weight/></forces>"
      "<elements><Stop on=\"b\"><Law mu=\"0.3\"/></Stop></elements>"));
  ASSERT_EQ(m.systems().size(), 1u);
  EXPECT_EQ(ball(m).name(), "b");
  EXPECT_EQ(ball(m).type(), "Ball");
  EXPECT_EQ(ball(m).place(), (Place("m.xml", 2, 28, 5)));
  EXPECT_EQ(ball(m).shapes.size(), 1u);
  EXPECT_EQ(m.initialState().q[0], 5 * 1e-3);
  EXPECT_EQ(m.forces().size(), 1u);
  EXPECT_EQ(stop(m).law->mu, 0.3);
  EXPECT_EQ(m.doc, "A ball.");
  EXPECT_EQ(m.title, "m");
  EXPECT_EQ(m.sourceFile, "m.xml");
}

TEST(ModelLoader, TakesSectionsInAnyOrderAndRepeated) {
  const Model m =
      load(around("<elements><Stop on=\"b\"><Law/></Stop></elements>"
                  "<systems><Ball name=\"a\" mass=\"{m}\"/></systems>"
                  "<systems><Ball name=\"b\" mass=\"1\"/></systems>"
                  "<parameter name=\"m\" value=\"{2*n}\"/><parameter name=\"n\" value=\"3g\"/>"));
  EXPECT_EQ(m.systems().size(), 2u);
}

TEST(ModelLoader, EvaluatesExpressionsInNumbersVectorsAndFormulas) {
  const Model m = load(around(
      "<parameter name=\"n\" value=\"2\"/><systems><Ball name=\"b\" mass=\"{n + 1}kg\" z=\"{-n}\" "
      "velocity=\"0 {n} {3 * n}\" drive=\"1 - {0 - n}*t\"/></systems>"));
  EXPECT_EQ(m.initialState().q[0], -2.0);
  EXPECT_EQ(ball(m).drive, "1 - (-2)*t");
}

TEST(ModelLoader, ReadsSimulationRecordAndChecks) {
  const Model m =
      load(around("<systems><Ball name=\"b\" mass=\"1\"/></systems>"
                  "<simulation until=\"5\" step=\"1ms\" gTol=\"1e-9\" onNonConvergence=\"stop\"/>"
                  "<record signals=\"b.z b.*\" every=\"10ms\" frames=\"30Hz\" view=\"xz\"/>"
                  "<check signal=\"b.z\" at=\"4\" value=\"0.5\" tolerance=\"0.25\"/>"
                  "<check signal=\"b.vz\" measure=\"max\" over=\"1 5\" between=\"0.7 0.8\"/>"));
  EXPECT_EQ(m.simulation.until, 5.0);
  EXPECT_EQ(m.simulation.step, 1e-3);
  EXPECT_EQ(m.simulation.gTol, 1e-9);
  EXPECT_EQ(m.simulation.onNonConvergence, NonConvergence::stop);
  EXPECT_EQ(m.record.signals, (std::vector<std::string>{"b.z", "b.*"}));
  EXPECT_EQ(m.record.every, 10 * 1e-3);
  EXPECT_EQ(m.record.framesPerSecond, 30.0);
  EXPECT_EQ(m.view, "xz");
  ASSERT_EQ(m.checks.size(), 2u);
  EXPECT_EQ(m.checks[0].at, 4.0);
  EXPECT_EQ(m.checks[0].low, 0.25);
  EXPECT_EQ(m.checks[0].high, 0.75);
  EXPECT_EQ(m.checks[0].text, "0.5 ± 0.25");
  EXPECT_EQ(m.checks[1].measure, CheckSettings::Measure::max);
  EXPECT_EQ(m.checks[1].from, 1.0);
  EXPECT_EQ(m.checks[1].to, 5.0);
  EXPECT_EQ(m.checks[1].text, "0.7 … 0.8");
}

TEST(ModelLoader, DefaultsFillWhatAnElementLacks) {
  const Model m =
      load(around("<systems><Ball name=\"a\"/><Ball name=\"b\" class=\"high\"/>"
                  "<Ball name=\"c\" class=\"high\" z=\"9\"/></systems>"
                  "<defaults><Ball mass=\"1\" z=\"2\"/><Ball class=\"high\" z=\"{h}\"/></defaults>"
                  "<parameter name=\"h\" value=\"7\"/>"));
  EXPECT_EQ(m.initialState().q, Eigen::Vector3d(2, 7, 9));
}

TEST(ModelLoader, ReplicatesWithIndexAndNamesOfTheSameTurn) {
  const Model m = load(around(
      "<systems><replicate count=\"3\" index=\"k\"><Ball name=\"b\" mass=\"1\" z=\"{k/2}\"/>"
      "</replicate></systems>"
      "<elements><replicate count=\"2\"><Stop on=\"b\" frames=\"b.tip b[{i+1}]\"><Law/></Stop>"
      "</replicate></elements>"));
  ASSERT_EQ(m.systems().size(), 3u);
  EXPECT_EQ(ball(m, 2).name(), "b[2]");
  EXPECT_EQ(m.initialState().q, Eigen::Vector3d(0, 0.5, 1));
  ASSERT_EQ(m.contacts().size(), 2u);
  EXPECT_EQ(stop(m, 1).on, "b[1]");
  EXPECT_EQ(stop(m, 1).frames, "b[1].tip b[2]");
}

TEST(ModelLoader, ReplicatesWholeSectionsAndInsideOfElements) {
  const Model m = load(around(
      "<replicate count=\"2\"><systems><replicate count=\"2\" index=\"j\">"
      "<Ball name=\"b\" mass=\"{1+i+j}\"><replicate count=\"3\"><Disc radius=\"1\"/></replicate>"
      "</Ball></replicate></systems></replicate>"));
  ASSERT_EQ(m.systems().size(), 4u);
  EXPECT_EQ(ball(m, 2).name(), "b[1][0]");
  EXPECT_EQ(ball(m, 2).shapes.size(), 3u);
}

TEST(ModelLoader, OverridesReplaceParameters) {
  const std::string text = around(
      "<parameter name=\"h\" value=\"1\" min=\"0\" max=\"{g}\"/><parameter name=\"g\" value=\"2\"/>"
      "<systems><Ball name=\"b\" mass=\"1\" z=\"{2*h}\"/></systems>");
  EXPECT_EQ(load(text).initialState().q[0], 2.0);
  EXPECT_EQ(load(text, {{"h", "500mm"}}).initialState().q[0], 1.0);
  EXPECT_EQ(errors(text, {{"h", "3"}}), "error: --set h=3: must be between 0 and 2, is 3");
  EXPECT_EQ(errors(text, {{"hh", "3"}}),
            "error: --set hh=3: no parameter \"hh\" — did you mean \"h\"?");
  EXPECT_EQ(errors(text, {{"h", "high"}}),
            "error: --set h=high: expected a number, found \"high\"");
}

// ---- What is refused, word by word ----

TEST(ModelLoaderError, UnknownAttribute) {
  EXPECT_EQ(errors(inSystems("<Ball name=\"b\" mas=\"1\" mass=\"1\"/>")),
            "m.xml:2:25: error: <Ball name=\"b\">: unknown attribute \"mas\" — did you mean "
            "\"mass\"?\n"
            "    2 | <systems><Ball name=\"b\" mas=\"1\" mass=\"1\"/></systems>\n"
            "      |                         ^~~");
}

/// The first line of the first message: place, element, text and hint.
std::string firstLine(const std::string& text, const Overrides& set = {}) {
  const std::string all = errors(text, set);
  return all.substr(0, all.find('\n'));
}

TEST(ModelLoaderError, UnknownElement) {
  EXPECT_EQ(firstLine(inSystems("<Bal mass=\"1\"/>")),
            "m.xml:2:10: error: <systems>: unknown element <Bal> — did you mean <Ball>?");
  EXPECT_EQ(firstLine(inSystems("<Ball mass=\"1\"><Disk radius=\"1\"/></Ball>")),
            "m.xml:2:25: error: <Ball>: unknown element <Disk> — did you mean <Disc>?");
  EXPECT_EQ(firstLine(inSystems("<Ball mass=\"1\"><Anything/></Ball>")),
            "m.xml:2:25: error: <Ball>: unknown element <Anything> — known here: \"Disc\"");
  EXPECT_EQ(firstLine(around("<system/>")),
            "m.xml:2:1: error: <dynamy>: unknown element <system> — did you mean <systems>?");
}

TEST(ModelLoaderError, WrongKindInASection) {
  EXPECT_EQ(firstLine(inSystems("<Weight/>")),
            "m.xml:2:10: error: <systems>: <Weight> is a force; put it into <forces>");
  EXPECT_EQ(firstLine(inSystems("<Law/>")),
            "m.xml:2:10: error: <systems>: <Law> is a law; it stands inside of another element");
  EXPECT_EQ(firstLine(inSystems("<Ball mass=\"1\"><Law/></Ball>")),
            "m.xml:2:25: error: <Ball>: <Law> is a law; <Ball> takes: shape");
  EXPECT_EQ(firstLine(around("<Ball mass=\"1\"/>")),
            "m.xml:2:1: error: <dynamy>: <Ball> is a system; put it into <systems>");
}

TEST(ModelLoaderError, MissingAttribute) {
  EXPECT_EQ(firstLine(inSystems("<Ball name=\"b\"/>")),
            "m.xml:2:10: error: <Ball name=\"b\">: missing attribute \"mass\" — mass of the ball "
            "[kg]");
}

TEST(ModelLoaderError, WrongValues) {
  const auto ballWith = [](const std::string& attributes) {
    return firstLine(inSystems("<Ball name=\"b\" " + attributes + "/>"));
  };
  EXPECT_EQ(ballWith("mass=\"-1\""),
            "m.xml:2:31: error: <Ball name=\"b\">: mass must be > 0, is -1");
  EXPECT_EQ(ballWith("mass=\"1\" orientation=\"0 0 0 0\""),
            "m.xml:2:47: error: <Ball name=\"b\">: orientation must not be zero");
  EXPECT_EQ(ballWith("mass=\"1\" velocity=\"0 0\""),
            "m.xml:2:44: error: <Ball name=\"b\">: velocity expects 3 numbers, has 2");
  EXPECT_EQ(ballWith("mass=\"1\" z=\"30deg\""),
            "m.xml:2:37: error: <Ball name=\"b\">: z expects a length [m], has [rad]");
  EXPECT_EQ(firstLine(around("<elements><Stop on=\"b\"><Law mu=\"-0.1\"/></Stop></elements>")),
            "m.xml:2:21: error: <Stop>: unknown system \"b\"");
  EXPECT_EQ(firstLine(around("<systems><Ball name=\"b\" mass=\"1\"/></systems>"
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
  EXPECT_EQ(firstLine(inSystems("<Ball mass=\"{1\"/>")),
            "m.xml:2:22: error: <Ball>: \"{\" without \"}\"");
  EXPECT_EQ(firstLine(inSystems("<Ball mass=\"{1/0}\"/>")),
            "m.xml:2:22: error: <Ball>: the expression has no finite value, is inf");
}

TEST(ModelLoaderError, OfAnElementItselfGetsItsPlaceInTheValue) {
  EXPECT_EQ(errors(inSystems("<Ball mass=\"1\" drive=\"{1+1}*t ??\"/>")),
            "m.xml:2:40: error: <Ball>: two question marks — leave them out\n"
            "    2 | <systems><Ball mass=\"1\" drive=\"{1+1}*t ??\"/></systems>\n"
            "      |                                        ^~");
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
  EXPECT_EQ(firstLine(around("<systems><Ball name=\"b\" mass=\"1\"/></systems>"
                             "<elements><Stop on=\"b\"/></elements>")),
            "m.xml:2:55: error: <Stop>: needs 1 law, has none — law of the contact");
  EXPECT_EQ(firstLine(around("<systems><Ball name=\"b\" mass=\"1\"/></systems>"
                             "<elements><Stop on=\"b\"><Law/><Law/></Stop></elements>")),
            "m.xml:2:74: error: <Stop>: takes at most 1 law");
}

TEST(ModelLoaderError, UnknownClassAndFaultsInDefaults) {
  EXPECT_EQ(firstLine(around("<defaults><Ball class=\"heavy\" mass=\"9\"/></defaults>"
                             "<systems><Ball class=\"heavi\" mass=\"1\"/></systems>")),
            "m.xml:2:74: error: <Ball>: <defaults> has no <Ball class=\"heavi\"> — did you mean "
            "\"heavy\"?");
  EXPECT_EQ(firstLine(around("<defaults><Ball mas=\"9\"/></defaults>")),
            "m.xml:2:17: error: <Ball>: unknown attribute \"mas\" — did you mean \"mass\"?");
  EXPECT_EQ(firstLine(around("<defaults><Bal mass=\"9\"/></defaults>")),
            "m.xml:2:11: error: <defaults>: unknown element <Bal> — did you mean <Ball>?");
}

TEST(ModelLoaderError, ParametersThatNeedEachOther) {
  EXPECT_EQ(firstLine(around("<parameter name=\"a\" value=\"{b}\"/>"
                             "<parameter name=\"b\" value=\"{a}\"/>")),
            "m.xml:2:61: error: <parameter name=\"b\">: the parameter \"b\" depends on itself");
  EXPECT_EQ(firstLine(around("<parameter name=\"a\" value=\"2\" max=\"1\"/>")),
            "m.xml:2:28: error: <parameter name=\"a\">: must be <= 1, is 2");
}

TEST(ModelLoaderError, SettingsAreChecked) {
  EXPECT_EQ(firstLine(around("<simulation untill=\"5\"/>")),
            "m.xml:2:13: error: <simulation>: unknown attribute \"untill\" — did you mean "
            "\"until\"?");
  EXPECT_EQ(firstLine(around("<simulation><Law/></simulation>")),
            "m.xml:2:13: error: <simulation>: <Law> is a law; it stands inside of another element");
  EXPECT_EQ(firstLine(around("<check signal=\"b.z\" value=\"1\"/>")),
            "m.xml:2:1: error: <check>: needs a tolerance beside the value");
  EXPECT_EQ(firstLine(around("<check signal=\"b.z\" between=\"2 1\"/>")),
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
  EXPECT_EQ(firstLine("<mujoco/>"),
            "m.xml:1:1: error: <mujoco>: a model begins with <dynamy version=\"1\">");
  EXPECT_EQ(firstLine("<dynamy version=\"2\"/>"),
            "m.xml:1:18: error: <dynamy>: the format has version 2, this program reads version 1");
  EXPECT_EQ(firstLine(around("<systems>Hello</systems>")),
            "m.xml:2:10: error: <systems>: text has no meaning here — text for people stands in "
            "<doc>");
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

// ---- Files in files ----

class Includes : public ::testing::Test {
 protected:
  Includes() {
    std::string name = (fs::temp_directory_path() / "dynamy_include_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~Includes() override { fs::remove_all(folder_); }
  void write(const std::string& name, const std::string& inside) const {
    std::ofstream(folder_ / name) << around(inside);
  }
  fs::path folder_;
};

TEST_F(Includes, GetPrefixAndParametersOfTheirOwn) {
  write("part.xml",
        "<parameter name=\"h\" value=\"1\"/><systems><Ball name=\"b\" z=\"{h}\"/></systems>"
        "<elements><Stop on=\"b\"><Law/></Stop></elements><simulation until=\"99\"/>");
  const std::string text = around(
      "<defaults><Ball mass=\"1\"/></defaults><parameter name=\"n\" value=\"3\"/>"
      "<include file=\"part.xml\" prefix=\"left\"/>"
      "<include file=\"part.xml\" prefix=\"right\"><set name=\"h\" value=\"{2*n}\"/></include>"
      "<elements><Stop on=\"right/b\"><Law/></Stop></elements>");
  const Model m = load(text, {}, folder_);
  ASSERT_EQ(m.systems().size(), 2u);
  EXPECT_EQ(ball(m, 1).name(), "right/b");
  EXPECT_EQ(m.initialState().q, Eigen::Vector2d(1, 6));
  EXPECT_EQ(stop(m, 0).on, "left/b");
  EXPECT_EQ(stop(m, 1).on, "right/b");
  EXPECT_EQ(stop(m, 2).on, "right/b");
  EXPECT_EQ(m.simulation.until, 1.0);
  EXPECT_EQ(load(text, {{"left/h", "5"}}, folder_).initialState().q, Eigen::Vector2d(5, 6));
}

TEST_F(Includes, ShowTheChainOfFilesThatIncludeEachOther) {
  write("a.xml", "<include file=\"b.xml\"/>");
  write("b.xml", "<include file=\"a.xml\"/>");
  const std::string error = errors(around("<include file=\"a.xml\"/>"), {}, folder_);
  EXPECT_EQ(error.substr(0, error.find('\n')),
            (folder_ / "b.xml").string() +
                ":2:16: error: <include>: the file includes itself: m.xml → a.xml → b.xml → a.xml");
}

TEST_F(Includes, ErrorsNameTheIncludedFile) {
  write("part.xml", "<systems><Ball name=\"b\" mas=\"1\"/></systems>");
  const std::string error = errors(around("<include file=\"part.xml\"/>"), {}, folder_);
  EXPECT_TRUE(error.starts_with((folder_ / "part.xml").string() + ":2:")) << error;
}

TEST_F(Includes, SayThatAFileOrAParameterIsMissing) {
  write("part.xml", "<parameter name=\"height\" value=\"1\"/>");
  EXPECT_EQ(
      errors(around("<include file=\"part.xml\"><set name=\"heigth\" value=\"1\"/></include>"), {},
             folder_),
      "m.xml:2:37: error: <set name=\"heigth\">: \"" + (folder_ / "part.xml").string() +
          "\" has no parameter \"heigth\" — did you mean \"height\"?\n"
          "    2 | <include file=\"part.xml\"><set name=\"heigth\" value=\"1\"/></include>\n"
          "      |                                     ^~~~~~");
  const std::string error = errors(around("<include file=\"prat.xml\"/>"), {}, folder_);
  EXPECT_TRUE(error.starts_with("m.xml:2:16: error: <include>: \"")) << error;
}

}  // namespace
}  // namespace dynamy
